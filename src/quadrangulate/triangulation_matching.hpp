// The matching that kPair starts with.
#pragma once

#include "quadloom/dual.hpp"
#include "quadloom/quadrangulate.hpp"

namespace quadloom::quadrangulate {

struct TriangleMatching {
  std::vector<HalfedgeId> mate;     ///< given pairs included
  std::vector<TriangleId> barrier;  ///< see MaximumMatching
  std::size_t unmatched = 0;
  std::size_t parted = 0;  ///< pairs that were parted again
  double weight_gap = 0;   ///< kNear: at most this share of the weight is lost
};

/// Matches the triangles of `cut` (input.mesh without the twins of edges that must stay) as the options
/// say. Throws Error kBadOption for weights that are missing, negative or not finite, and for a
/// min_quality that is not in [0, 1].
TriangleMatching match_triangles(const TriangleMesh& input, const Triangulation& cut,
                                 const TriangleOptions& options);

}  // namespace quadloom::quadrangulate
