#include "certify/wording.hpp"

#include <algorithm>
#include <utility>

namespace quadloom::certify {
namespace {

constexpr std::size_t kMostNamed = 8;

}  // namespace

bool fail(Certificate& out, Fault fault, std::string sentence, std::vector<std::size_t> culprits) {
  out.fault = fault;
  out.sentence = std::move(sentence);
  out.culprits = std::move(culprits);
  return false;
}

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
