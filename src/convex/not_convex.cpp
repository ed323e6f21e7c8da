#include "convex/not_convex.hpp"

#include "quadrangulate/paired_mesh.hpp"

namespace quadloom::convex {

std::vector<QuadId> quads_not_convex(const Quadrangulation& mesh) {
  std::vector<QuadId> out;
  for (QuadId q = 0; q < mesh.quad_count(); ++q) {
    const auto at = [&](std::size_t i) {
      return mesh.points[mesh.quad_vertex[4 * std::size_t{q} + i]];
    };
    if (quadrangulate::classify_quad(at(0), at(1), at(2), at(3)) !=
        quadrangulate::QuadKind::kStrictlyConvex) {
      out.push_back(q);
    }
  }
  return out;
}

}  // namespace quadloom::convex
