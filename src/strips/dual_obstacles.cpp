// Necessary conditions for a Hamiltonian path or cycle of a graph of degree three.
//
//   1. find_components  there is one
//   2. find_ears        a node with one edge is an end: a path has two, a cycle none
//   3. find_bridges     a cycle has no edge without which the graph falls apart (a bridge). Without its
//                       bridges the graph falls into parts that hang on each other like a tree; a path
//                       goes through each part once, so none has three bridges
//   4. find_pairing     every second edge of a path pairs all nodes, but for one at most. In a graph of
//                       two colours a cycle has as many of each, so an even number
//
// Cost: linear but for the matching. No recursion.
#include "strips/dual_obstacles.hpp"

#include <algorithm>

namespace quadloom::strips {
namespace {

std::optional<DualObstacle> find_components(const DualGraph& graph) {
  const DualGraph forest = spanning_forest(graph);
  std::vector<TriangleId> first;
  std::vector<std::uint8_t> seen(graph.node_count(), 0);
  for (TriangleId root = 0; root < graph.node_count(); ++root) {
    if (seen[root] != 0) continue;
    first.push_back(root);
    std::vector<TriangleId> stack = {root};
    seen[root] = 1;
    while (!stack.empty()) {
      const TriangleId t = stack.back();
      stack.pop_back();
      for (HalfedgeId h = 3 * t; h < 3 * t + 3; ++h) {
        if (forest.twin[h] == kNone || seen[forest.across(h)] != 0) continue;
        seen[forest.across(h)] = 1;
        stack.push_back(forest.across(h));
      }
    }
  }
  if (first.size() == 1) return std::nullopt;
  return DualObstacle{NoOrder::kComponents, std::move(first)};
}

std::optional<DualObstacle> find_ears(const DualGraph& graph, OrderKind kind) {
  std::vector<TriangleId> ears;
  for (TriangleId t = 0; t < graph.node_count(); ++t) {
    int edges = 0;
    for (HalfedgeId h = 3 * t; h < 3 * t + 3; ++h) edges += graph.twin[h] != kNone ? 1 : 0;
    if (edges == 1) ears.push_back(t);
  }
  if (ears.size() <= (kind == OrderKind::kCycle ? 0U : 2U)) return std::nullopt;
  return DualObstacle{NoOrder::kEars, std::move(ears)};
}

/// Per slot, whether its edge is a bridge: by depth-first search, an edge to a child from whose subtree
/// no edge leads back beyond the child. For a connected graph.
std::vector<std::uint8_t> bridges_of(const DualGraph& graph) {
  std::vector<std::uint8_t> bridge(graph.twin.size(), 0);
  std::vector<std::uint32_t> number(graph.node_count(), kNone), low(graph.node_count(), 0);
  struct Visit {
    TriangleId node;
    HalfedgeId entered;  // the slot of `node` that leads back; kNone at the root
    int next = 0;
  };
  std::vector<Visit> stack = {{0, kNone}};
  std::uint32_t count = 0;
  number[0] = low[0] = count++;
  while (!stack.empty()) {
    Visit& at = stack.back();
    if (at.next < 3) {
      const HalfedgeId h = 3 * at.node + static_cast<HalfedgeId>(at.next++);
      if (graph.twin[h] == kNone || h == at.entered) continue;
      const TriangleId u = graph.across(h);
      if (number[u] != kNone) {
        low[at.node] = std::min(low[at.node], number[u]);
        continue;
      }
      number[u] = low[u] = count++;
      stack.push_back({u, graph.twin[h]});
      continue;
    }
    const Visit done = at;
    stack.pop_back();
    if (stack.empty()) break;
    const TriangleId parent = stack.back().node;
    low[parent] = std::min(low[parent], low[done.node]);
    if (low[done.node] == number[done.node]) {
      bridge[done.entered] = bridge[graph.twin[done.entered]] = 1;
    }
  }
  return bridge;
}

std::optional<DualObstacle> find_bridges(const DualGraph& graph, OrderKind kind) {
  const std::vector<std::uint8_t> bridge = bridges_of(graph);
  std::vector<std::uint8_t> seen(graph.node_count(), 0);
  for (TriangleId root = 0; root < graph.node_count(); ++root) {
    if (seen[root] != 0) continue;
    std::vector<TriangleId> part = {root};
    seen[root] = 1;
    int bridges = 0;
    for (std::size_t i = 0; i < part.size(); ++i) {
      for (HalfedgeId h = 3 * part[i]; h < 3 * part[i] + 3; ++h) {
        if (graph.twin[h] == kNone) continue;
        if (bridge[h] != 0) {
          if (kind == OrderKind::kCycle) {
            return DualObstacle{NoOrder::kBridges, {part[i], graph.across(h)}};
          }
          ++bridges;
        } else if (seen[graph.across(h)] == 0) {
          seen[graph.across(h)] = 1;
          part.push_back(graph.across(h));
        }
      }
    }
    if (bridges > 2) return DualObstacle{NoOrder::kBridges, std::move(part)};
  }
  return std::nullopt;
}

bool has_two_colours(const DualGraph& graph) {
  std::vector<std::uint8_t> colour(graph.node_count(), 2);
  std::vector<TriangleId> stack = {0};
  colour[0] = 0;
  while (!stack.empty()) {
    const TriangleId t = stack.back();
    stack.pop_back();
    for (HalfedgeId h = 3 * t; h < 3 * t + 3; ++h) {
      if (graph.twin[h] == kNone) continue;
      const TriangleId u = graph.across(h);
      if (colour[u] == colour[t]) return false;
      if (colour[u] != 2) continue;
      colour[u] = static_cast<std::uint8_t>(1 - colour[t]);
      stack.push_back(u);
    }
  }
  return true;
}

std::optional<DualObstacle> find_pairing(const DualGraph& graph, OrderKind kind) {
  const bool odd_cycle = kind == OrderKind::kCycle && graph.node_count() % 2 == 1;
  if (odd_cycle && has_two_colours(graph)) return DualObstacle{NoOrder::kPairing, {}};
  if (maximum_matching(graph).matching.unmatched <= 1) return std::nullopt;
  return DualObstacle{NoOrder::kPairing, {}};
}

}  // namespace

std::optional<DualObstacle> find_obstacle(const DualGraph& graph, OrderKind kind) {
  if (kind == OrderKind::kCycle && graph.node_count() < 3) {
    return DualObstacle{NoOrder::kTooFew, {}};
  }
  if (auto found = find_components(graph)) return found;
  if (auto found = find_ears(graph, kind)) return found;
  if (auto found = find_bridges(graph, kind)) return found;
  return find_pairing(graph, kind);
}

}  // namespace quadloom::strips
