// A greedy matching of a degree-3 graph that is close to a maximum one.
#pragma once

#include "quadloom/dual.hpp"

namespace quadloom::dual {

/// A maximal matching by least degrees (see the source). O(n).
DualMatching sparse_start(const DualGraph& graph);

}  // namespace quadloom::dual
