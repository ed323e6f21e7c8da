// Strictly convex quads of a point set, six triangles of a path at a time.
#pragma once

#include <vector>

#include "quadloom/convex.hpp"

namespace quadloom::convex {

/// For at least three distinct points that are not all collinear; the map of the input is left to the
/// caller.
ConvexResult convex_pentagon_quadrangulation(const std::vector<Point>& points,
                                             const ConvexOptions& options);

}  // namespace quadloom::convex
