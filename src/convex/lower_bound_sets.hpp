// Point sets that need many Steiner points, recognised.
#pragma once

#include <optional>
#include <vector>

#include "quadloom/convex.hpp"

namespace quadloom::convex {

/// The mesh of theorem 2.2 or 2.4 (mesh_of_bhrs_line, mesh_of_bhrs_ring) if the points, whatever their
/// order, are such a set and the theorem's places are there; the map of the input is left to the caller.
/// For at least three distinct points that are not all collinear. O(n log n).
std::optional<ConvexResult> lower_bound_mesh(const std::vector<Point>& points);

}  // namespace quadloom::convex
