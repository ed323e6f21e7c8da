#include "certify/wording.hpp"

#include <algorithm>

namespace quadloom::certify {
namespace {

constexpr std::size_t kMostNamed = 8;

}  // namespace

std::string vertex_text(const PolygonMesh& mesh, std::size_t v) {
  std::string out = "vertex ";
  out += std::to_string(v);
  out += ' ';
  return out += point_text(mesh.points[v]);
}

std::string face_text(const PolygonMesh& mesh, std::size_t f) {
  const auto corners = mesh.face(f);
  std::string out = "face " + std::to_string(f) + " (vertices";
  for (const VertexId v : corners.first(std::min(kMostNamed, corners.size()))) {
    out += ' ';
    out += std::to_string(v);
  }
  return out + (corners.size() > kMostNamed ? " ...)" : ")");
}

}  // namespace quadloom::certify
