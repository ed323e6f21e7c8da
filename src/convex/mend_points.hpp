// Added points for quads that no move has made strictly convex.
#pragma once

#include "convex/mending.hpp"
#include "quadloom/convex.hpp"

namespace quadloom::convex {

/// For each bad quad the best of many clusters with stars, each with one added point.
void add_stars(Mending& state, MendStatistics& statistics);

/// For each bad quad the union with a neighbour, or the quad alone, as in the paper's cases: at most three, or
/// four, points. Those for which no doubles are found stay.
void add_cases(Mending& state, MendStatistics& statistics);

}  // namespace quadloom::convex
