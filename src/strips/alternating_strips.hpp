// Strips that alternate, to start from.
#pragma once

#include <vector>

#include "quadloom/dual.hpp"
#include "strips/way_tables.hpp"

namespace quadloom::strips {

/// The ways of paths that turn left and right in turn: from each triangle that no path has, in order,
/// the longest of the three that go through it. O(n).
std::vector<Way> alternating_strips(const DualGraph& graph);

}  // namespace quadloom::strips
