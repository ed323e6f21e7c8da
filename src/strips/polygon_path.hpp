// A polygon's triangles in an order, as corners.
#pragma once

#include <vector>

#include "quadloom/strips.hpp"
#include "strips/polygon_disc.hpp"

namespace quadloom::strips {

/// The result for triangles given by positions, three a triangle, in their order; takes the disc apart.
PolygonOrder order_of_disc(PolygonDisc&& disc, const std::vector<Position>& corners,
                           OrderKind order);

}  // namespace quadloom::strips
