// Paths of triangles in convex polygons, flat corners allowed.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "strips/polygon_disc.hpp"

namespace quadloom::strips {

/// A path of triangles through a convex polygon that starts with the triangle at the side from its last
/// corner to its first one: numbers of corners, three a triangle, counter-clockwise. None if and only if
/// both ends of that side are flat corners (all other corners that see the side's inside are then on its
/// other sides, so that its triangle parts the rest). O(n).
std::optional<std::vector<std::uint32_t>> path_from_last_side(std::span<const Point> convex);

/// The same through the whole polygon, from a side that has one. O(n).
std::vector<Position> convex_path(const PolygonDisc& disc);

}  // namespace quadloom::strips
