// Strictly convex quads of a point set, Delaunay-shaped, with almost no added points.
#pragma once

#include <optional>

#include "kernel/delaunay_in_order.hpp"
#include "quadloom/convex.hpp"

namespace quadloom::convex {

/// For the Delaunay triangulation of the distinct points; the map of the input is left to the caller. Empty if
/// a walk could not finish (not seen yet).
std::optional<ConvexResult> convex_delaunay_quadrangulation(kernel::DelaunayInOrder&& delaunay,
                                                            const ConvexOptions& options);

}  // namespace quadloom::convex
