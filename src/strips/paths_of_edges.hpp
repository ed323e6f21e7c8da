// Paths from the edges that they use.
#pragma once

#include <cstdint>
#include <vector>

#include "quadloom/strips.hpp"

namespace quadloom::strips {

/// The paths made of the edges with used[h] != 0 (on both sides), at most two a node and without
/// cycles; ordered by their first node, which is the smaller of their ends. O(n).
PathPartition paths_of_edges(const DualGraph& graph, const std::vector<std::uint8_t>& used);

}  // namespace quadloom::strips
