// Hamiltonian paths and cycles of a dual graph by a search over its frontier.
#pragma once

#include <cstdint>
#include <vector>

#include "quadloom/dual.hpp"
#include "quadloom/strips.hpp"
#include "strips/frontier_order.hpp"

namespace quadloom::strips {

struct FrontierLimits {
  std::size_t beam = 0;    // the most states kept at a node; 0: all
  std::uint64_t work = 0;  // the most states made
};

struct FrontierResult {
  Answer answer = Answer::kUnknown;  // kNo only if no state was let go
  std::vector<TriangleId> order;     // kYes
  std::uint64_t work = 0;            // states made
};

/// Of a connected graph of at least three nodes, without two edges between the same nodes; kind is
/// kPath or kCycle.
FrontierResult frontier_search(const DualGraph& graph, const FrontierOrder& order, OrderKind kind,
                               const FrontierLimits& limits, const Progress& progress);

}  // namespace quadloom::strips
