// The result of a conversion while it grows.
#include "quadrangulate/quad_collector.hpp"

#include <string>

#include "quadrangulate/mesh_parts.hpp"

namespace quadloom::quadrangulate {

QuadCollector::QuadCollector(const TriangleMesh& input) : input_(input) {
  result_.mesh.points = input.mesh.points;
  result_.z = input.z;
  result_.input_vertices = input.mesh.points.size();
  result_.statistics.triangles = input.mesh.triangle_count();
  result_.statistics.boundary_edges = border_size(input.mesh);
}

VertexId QuadCollector::add_steiner(Point place, double z, SteinerKind kind,
                                    std::array<VertexId, 3> parents) {
  if (result_.mesh.points.size() >= kMaxPoints) {
    throw Error(ErrorCode::kTooManyPoints, "with its Steiner points the mesh has more than " +
                                               std::to_string(kMaxPoints) + " vertices");
  }
  const auto vertex = static_cast<VertexId>(result_.mesh.points.size());
  result_.mesh.points.push_back(place);
  if (!input_.z.empty()) result_.z.push_back(z);
  result_.steiner.push_back({vertex, kind, parents});
  return vertex;
}

VertexId QuadCollector::add_steiner(const EdgePlace& at, HalfedgeId h) {
  return add_steiner(at.place, at.z, at.kind,
                     {input_.mesh.origin(h), input_.mesh.target(h), kNone});
}

void QuadCollector::add_quad(std::array<VertexId, 4> corners, TriangleId t, TriangleId other) {
  auto& out = result_.mesh.quad_vertex;
  out.insert(out.end(), corners.begin(), corners.end());
  result_.quad_source.push_back({t, other});
}

void QuadCollector::add_triangle(std::array<VertexId, 3> corners, TriangleId t) {
  auto& out = result_.mesh.tri_vertex;
  out.insert(out.end(), corners.begin(), corners.end());
  result_.triangle_source.push_back(t);
}

void QuadCollector::add_pair(HalfedgeId h) {
  const Triangulation& mesh = input_.mesh;
  const HalfedgeId twin = mesh.twin[h];
  add_quad({mesh.origin(h), mesh.apex(twin), mesh.target(h), mesh.apex(h)}, triangle_of(h),
           triangle_of(twin));
}

void QuadCollector::add_split(HalfedgeId h, VertexId s) {
  const Triangulation& mesh = input_.mesh;
  add_quad({mesh.origin(h), s, mesh.target(h), mesh.apex(h)}, triangle_of(h));
}

}  // namespace quadloom::quadrangulate
