// The dual graph of a triangulation and its matchings.
#pragma once

#include <vector>

#include "quadloom/core.hpp"

namespace quadloom {

/// A matching of the dual graph: mate[t] is the halfedge of triangle t that it shares with its
/// partner, kNone if t is unmatched. twin[mate[t]] is the partner's halfedge.
struct DualMatching {
  std::vector<HalfedgeId> mate;
  std::size_t unmatched = 0;
};

/// Pairs of triangles in order of shape, the best first (see quad_shape); pairs whose quad is not
/// strictly convex stay unmatched. At least half of the maximum weight. Ties go to the smaller
/// halfedge.
DualMatching greedy_shape_matching(const Triangulation& mesh);

}  // namespace quadloom
