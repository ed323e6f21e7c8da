// What rules out a Hamiltonian path or cycle of a dual graph in linear time, or nearly.
#pragma once

#include <optional>
#include <vector>

#include "quadloom/dual.hpp"
#include "quadloom/strips.hpp"

namespace quadloom::strips {

struct DualObstacle {
  NoOrder reason = NoOrder::kNoReason;
  std::vector<TriangleId> culprits;
};

/// Empty if none of these rules it out: components, ears, bridges, pairing. `kind` is kPath or kCycle.
std::optional<DualObstacle> find_obstacle(const DualGraph& graph, OrderKind kind);

}  // namespace quadloom::strips
