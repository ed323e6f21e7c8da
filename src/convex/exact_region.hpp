// The last resort for regions that floating point cannot see.
#pragma once

#include <cstddef>
#include <span>

#include "convex/open_region.hpp"

namespace quadloom::convex {

/// Doubles strictly inside all half-planes and the open box low to high, at most `most` of them. Whether
/// the region is empty is decided exactly, and so is every column of doubles that is looked at: 47
/// spread evenly over the region and those next to its corners and its middle, in x and, if none has a
/// double, in y. In a column the double nearest to the middle is taken; if that is outside there is no
/// other. So none is certain for an empty region; otherwise it says that no column that was looked at
/// has a double, which needs a region thinner than the spacing of the doubles nearly everywhere.
OpenRegion::Places places_exactly(std::span<const HalfPlane> sides, Point low, Point high,
                                  std::size_t most);

}  // namespace quadloom::convex
