// Parts of a polygon that one point sees.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "strips/part_sides.hpp"

namespace quadloom::strips {

/// The sides around some parts that hang together, in their order counter-clockwise, and corners that
/// follow the last one, if they are not all around. `place` sees all of it, see place_in_star.
struct PartStar {
  std::vector<SideId> sides;
  std::vector<Point> closing;
  std::vector<PartId> parts;
  std::optional<Point> place;
};

/// The corners of a star.
std::vector<Point> corners_of(const PartSides& sides, const PartStar& star);

/// Takes neighbours of the parts in, one after the other, as long as some double sees all; those that
/// taken[part] != 0 are left out, those that come in are marked there. Stops at a few dozen sides. The
/// star has a place.
void grow_star(const PartSides& sides, std::vector<std::uint8_t>& taken, PartStar& star);

}  // namespace quadloom::strips
