// Greedy orders with a narrow frontier.
//
//   1. grow      from a start, next is always a neighbour of the nodes taken so far whose taking makes the
//                frontier (the edges between those and the rest) smallest; of several the one that became
//                a neighbour first
//   2. far_from  starts are nodes far away from each other, found by breadth-first search, and some at
//                even distances in the numbering
//
// The best order is the one with the least sum of 2^(width / 2), about what a search costs.
#include "strips/frontier_order.hpp"

#include <algorithm>
#include <queue>
#include <tuple>

#include "core/step_reports.hpp"

namespace quadloom::strips {
namespace {

int degree(const DualGraph& graph, TriangleId t) {
  int edges = 0;
  for (HalfedgeId h = 3 * t; h < 3 * t + 3; ++h) edges += graph.twin[h] != kNone ? 1 : 0;
  return edges;
}

struct Grown {
  FrontierOrder order;
  double cost = 0;
};

double cost_of(int width) {
  double cost = width % 2 == 0 ? 1 : 1.4142;
  for (int i = 0; i < std::min(width / 2, 1000); ++i) cost *= 2;
  return cost;
}

Grown grow(const DualGraph& graph, TriangleId start, const Progress& progress) {
  // by growth of the frontier, then by age; an entry is void once its node has been taken or has grown
  // better
  using Entry = std::tuple<int, std::uint32_t, TriangleId>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> waiting;
  std::vector<int> taken_edges(graph.node_count(), 0);
  std::vector<std::uint32_t> age(graph.node_count(), kNone);
  std::vector<std::uint8_t> taken(graph.node_count(), 0);
  Grown out;
  std::uint32_t clock = 0;
  int width = 0;
  age[start] = clock++;
  waiting.push({degree(graph, start), age[start], start});
  StepReports report(progress, "ordering triangles", graph.node_count());
  while (!waiting.empty()) {
    const auto [growth, born, t] = waiting.top();
    waiting.pop();
    if (taken[t] != 0) continue;
    taken[t] = 1;
    report();
    width += growth;
    out.order.node.push_back(t);
    out.order.width = std::max(out.order.width, static_cast<std::size_t>(width));
    out.cost += cost_of(width);
    for (HalfedgeId h = 3 * t; h < 3 * t + 3; ++h) {
      if (graph.twin[h] == kNone || taken[graph.across(h)] != 0) continue;
      const TriangleId u = graph.across(h);
      ++taken_edges[u];
      if (age[u] == kNone) age[u] = clock++;
      waiting.push({degree(graph, u) - 2 * taken_edges[u], age[u], u});
    }
  }
  return out;
}

TriangleId far_from(const DualGraph& graph, TriangleId start) {
  std::vector<std::uint8_t> seen(graph.node_count(), 0);
  std::vector<TriangleId> queue = {start};
  seen[start] = 1;
  for (std::size_t i = 0; i < queue.size(); ++i) {
    for (HalfedgeId h = 3 * queue[i]; h < 3 * queue[i] + 3; ++h) {
      if (graph.twin[h] == kNone || seen[graph.across(h)] != 0) continue;
      seen[graph.across(h)] = 1;
      queue.push_back(graph.across(h));
    }
  }
  return queue.back();
}

}  // namespace

FrontierOrder frontier_order(const DualGraph& graph, const Progress& progress) {
  constexpr TriangleId kSpread = 8;
  const auto count = static_cast<TriangleId>(graph.node_count());
  std::vector<TriangleId> starts = {far_from(graph, 0)};
  starts.push_back(far_from(graph, starts.back()));
  for (TriangleId i = 0; i < kSpread; ++i) {
    starts.push_back(static_cast<TriangleId>(std::uint64_t{count} * i / kSpread));
  }
  Grown best;
  for (const TriangleId start : starts) {
    Grown grown = grow(graph, start, progress);
    if (best.order.node.empty() || grown.cost < best.cost) best = std::move(grown);
  }
  return std::move(best.order);
}

}  // namespace quadloom::strips
