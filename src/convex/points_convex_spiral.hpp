// Strictly convex quads of a point set along the spiral's path of triangles.
#pragma once

#include <vector>

#include "quadloom/convex.hpp"

namespace quadloom::convex {

/// For at least three distinct points that are not all collinear; the map of the input is left to the
/// caller.
ConvexResult convex_spiral_quadrangulation(const std::vector<Point>& points,
                                           const ConvexOptions& options);

}  // namespace quadloom::convex
