#include "convex/not_convex.hpp"

#include "core/parallel.hpp"
#include "quadrangulate/paired_mesh.hpp"

namespace quadloom::convex {

std::vector<QuadId> quads_not_convex(const Quadrangulation& mesh) {
  return parallel_find(mesh.quad_count(), [&](QuadId q) {
    const auto at = [&](std::size_t i) {
      return mesh.points[mesh.quad_vertex[4 * std::size_t{q} + i]];
    };
    return quadrangulate::classify_quad(at(0), at(1), at(2), at(3)) !=
           quadrangulate::QuadKind::kStrictlyConvex;
  });
}

}  // namespace quadloom::convex
