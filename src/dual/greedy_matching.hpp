// Greedy matchings of the dual graph by more than shape.
#pragma once

#include <cstdint>

#include "quadloom/dual.hpp"

namespace quadloom::dual {

enum class GreedyOrder : std::uint8_t {
  kShape,             // the best shape first
  kShapeAndScarcity,  // triangles with few strictly convex pairs sooner: a third fewer are left over
};

/// As greedy_shape_matching, in one of the orders.
DualMatching greedy_matching(const Triangulation& mesh, GreedyOrder order);

}  // namespace quadloom::dual
