#include "quadrangulate/triangulation_result.hpp"

#include <utility>

namespace quadloom::quadrangulate {
namespace {

/// Both, or the one that both have.
std::array<TriangleId, 2> sources(TriangleId a, TriangleId b) {
  if (a == b) return {a, kNone};
  return {a, b};
}

}  // namespace

TriangleResult to_triangle_result(PairedMesh&& mesh, std::size_t input_vertices) {
  TriangleResult out;
  out.input_vertices = input_vertices;
  for (TriangleId t = 0; t < mesh.mate.size(); ++t) {
    const HalfedgeId h = mesh.mate[t];
    if (h == kNone) {
      out.triangle_source.push_back(mesh.source[t]);
    } else if (h < mesh.tri.twin[h]) {
      out.quad_source.push_back(
          sources(mesh.source[t], mesh.source[triangle_of(mesh.tri.twin[h])]));
    }
  }
  out.z = std::move(mesh.z);
  out.mesh = to_quadrangulation(std::move(mesh));
  return out;
}

}  // namespace quadloom::quadrangulate
