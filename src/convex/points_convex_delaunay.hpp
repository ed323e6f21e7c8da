// Strictly convex quads of a point set, Delaunay-shaped, with almost no added points.
#pragma once

#include <optional>

#include "quadloom/convex.hpp"

namespace quadloom::convex {

/// For the Delaunay triangulation of the distinct points; the map of the input is left to the caller. Empty if
/// a walk could not finish (not seen yet).
std::optional<ConvexResult> convex_delaunay_quadrangulation(Triangulation&& delaunay,
                                                            const ConvexOptions& options);

}  // namespace quadloom::convex
