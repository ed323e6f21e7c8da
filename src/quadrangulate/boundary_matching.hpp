// Maximum matchings that leave over what lies at the boundary.
#pragma once

#include <span>

#include "quadloom/dual.hpp"

namespace quadloom::quadrangulate {

/// A maximum matching, and among those one in which no node stays over but those with may_stay[t] !=
/// 0, if there is such a matching. A node that may stay has at most two edges. Near-linear in practice.
DualMatching matching_inside_first(const DualGraph& graph, std::span<const std::uint8_t> may_stay);

}  // namespace quadloom::quadrangulate
