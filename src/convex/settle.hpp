// Added points settle: fewer of them do where several are near each other, or where they have wandered.
#pragma once

#include "convex/mending.hpp"
#include "quadloom/convex.hpp"

namespace quadloom::convex {

/// Takes added points out again as long as the quads around can be cut anew without. All quads that were
/// strictly convex stay so.
void settle(Mending& state, MendStatistics& statistics);

}  // namespace quadloom::convex
