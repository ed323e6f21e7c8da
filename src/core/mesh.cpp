#include "quadloom/core.hpp"

namespace quadloom {
namespace {

void append_faces(PolygonMesh& out, std::span<const VertexId> corners, std::uint32_t size) {
  auto end = out.face_begin.back();
  for (std::size_t i = 0; i < corners.size(); i += size) out.face_begin.push_back(end += size);
  out.face_vertex.insert(out.face_vertex.end(), corners.begin(), corners.end());
}

}  // namespace

PolygonMesh to_polygon_mesh(const Quadrangulation& mesh) {
  PolygonMesh out;
  out.points = mesh.points;
  append_faces(out, mesh.quad_vertex, 4);
  append_faces(out, mesh.tri_vertex, 3);
  return out;
}

PolygonMesh to_polygon_mesh(const Triangulation& mesh) {
  PolygonMesh out;
  out.points = mesh.points;
  append_faces(out, mesh.tri_vertex, 3);
  return out;
}

}  // namespace quadloom
