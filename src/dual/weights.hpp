// What the matchings with weights share.
#pragma once

#include <cstdint>
#include <span>

#include "quadloom/dual.hpp"

namespace quadloom::dual {

/// Throws Error kBadOption unless there is one weight a halfedge, the same on both sides.
void check_weights(const DualGraph& graph, std::span<const std::int32_t> weight);

/// What to add to each weight so that a larger matching always weighs more. Throws Error kBadOption
/// if sums would not fit.
std::int64_t bonus_for_size(const DualGraph& graph, std::span<const std::int32_t> weight);

}  // namespace quadloom::dual
