// The last resort for regions that floating point cannot see.
#pragma once

#include <optional>
#include <span>

#include "convex/open_region.hpp"

namespace quadloom::convex {

/// A double strictly inside all half-planes and the open box low to high. Whether the region is empty
/// is decided exactly, and so is every column of doubles that is looked at: 48 spread evenly over the
/// region and those next to its corners and its centroid, in x and in y. In a column the double nearest
/// to the middle is taken, and there is no other if it is outside. So none is certain for an empty
/// region; otherwise it says that no column that was looked at has a double, which needs a region
/// about as thin as the spacing of the doubles.
std::optional<Point> place_exactly(std::span<const HalfPlane> sides, Point low, Point high);

}  // namespace quadloom::convex
