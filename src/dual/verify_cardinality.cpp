// Checks of matchings and of Tutte and Berge's witness, from the graph alone.
//
// For every set S of nodes a matching leaves at least odd(G - S) - |S| nodes unmatched, since an odd
// component of G - S needs a partner in S (Tutte 1947, Berge 1958). So a matching with exactly that
// many is maximum, and S proves it.
#include "quadloom/dual.hpp"

namespace quadloom {
namespace {

/// The number of nodes in the component of `root`; marks them as seen.
std::size_t component_size(const DualGraph& graph, TriangleId root, std::vector<std::uint8_t>& seen,
                           std::vector<TriangleId>& stack) {
  std::size_t size = 0;
  seen[root] = 1;
  stack.push_back(root);
  while (!stack.empty()) {
    const TriangleId t = stack.back();
    stack.pop_back();
    ++size;
    for (HalfedgeId h = 3 * t; h < 3 * t + 3; ++h) {
      if (graph.twin[h] == kNone || seen[graph.across(h)] != 0) continue;
      seen[graph.across(h)] = 1;
      stack.push_back(graph.across(h));
    }
  }
  return size;
}

}  // namespace

bool is_matching(const DualGraph& graph, const DualMatching& matching) {
  if (matching.mate.size() != graph.node_count()) return false;
  std::size_t unmatched = 0;
  for (TriangleId t = 0; t < graph.node_count(); ++t) {
    const HalfedgeId h = matching.mate[t];
    if (h == kNone) {
      ++unmatched;
      continue;
    }
    if (h >= graph.twin.size() || triangle_of(h) != t || graph.twin[h] == kNone) return false;
    if (matching.mate[graph.across(h)] != graph.twin[h]) return false;
  }
  return unmatched == matching.unmatched;
}

bool verify_tutte_berge(const DualGraph& graph, const MaximumMatching& result) {
  if (!is_matching(graph, result.matching)) return false;
  std::vector<std::uint8_t> seen(graph.node_count());
  for (const TriangleId t : result.barrier) {
    if (t >= graph.node_count() || seen[t] != 0) return false;
    seen[t] = 1;
  }
  std::vector<TriangleId> stack;
  std::size_t odd = 0;
  for (TriangleId t = 0; t < graph.node_count(); ++t) {
    if (seen[t] == 0) odd += component_size(graph, t, seen, stack) % 2;
  }
  return odd == result.matching.unmatched + result.barrier.size();
}

}  // namespace quadloom
