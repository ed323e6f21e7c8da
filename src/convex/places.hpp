// Where points may be added in a small polygon: random places, each likely to be good for something.
#pragma once

#include <span>
#include <vector>

#include "core/random.hpp"
#include "quadloom/core.hpp"

namespace quadloom::convex {

/// At most `count` distinct places strictly inside the simple polygon (exact), none at a point inside.
std::vector<Point> random_places(std::span<const Point> corner, std::span<const Point> inside,
                                 std::size_t count, Random& random);

}  // namespace quadloom::convex
