// The fewest paths that part a forest, and the test of a partition.
//
// Arkin, Held, Mitchell and Skiena, Hamiltonian Triangulations for Fast Rendering, lemma 5.1: a
// minimum path partition of the dual tree of a triangulated polygon in O(n).
//
// Steps: dual::order_from_roots (children after their parents), join_upwards (leaves first: a node joins
// the paths of two of its children, or goes on with that of one, which its parent may then go on
// with), paths_of_edges.
//
// What differs from the paper: its proof counts nodes of odd degree, half of which must be ends of
// paths. That bound holds where the paths share nodes and part the edges. Where they part the nodes,
// as strips must part the triangles, fewer do: two nodes of degree 3 next to each other with two
// leaves each have six odd nodes and two paths. The greedy choice here is the optimum: a node whose
// children offer two ends loses nothing by joining both, since a path that it would offer to its
// parent instead saves one join at most, which is what it gives up.
//
// Degenerate input: nodes without edges are paths of one. Cost: O(n), no recursion.
#include "dual/rooted_forest.hpp"
#include "quadloom/strips.hpp"
#include "strips/paths_of_edges.hpp"

namespace quadloom {
namespace {

/// Which edges the paths use, by halfedge.
//
//        t            t            t
//       / \    two   / \    one   /      none: t begins a path
//      o   o  ends  o   .   end  o
std::vector<std::uint8_t> join_upwards(const DualGraph& forest, const dual::RootedForest& tree) {
  std::vector<std::uint8_t> used(forest.twin.size());
  std::vector<std::uint8_t> joins(forest.node_count());
  for (std::size_t i = tree.order.size(); i-- > 0;) {
    const TriangleId t = tree.order[i];
    const HalfedgeId up = tree.upward[t];
    if (up == kNone || joins[t] == 2) continue;
    const TriangleId parent = forest.across(up);
    if (joins[parent] == 2) continue;
    ++joins[parent];
    used[up] = used[forest.twin[up]] = 1;
  }
  return used;
}

}  // namespace

PathPartition minimum_path_partition(const DualGraph& forest) {
  const dual::RootedForest tree = dual::order_from_roots(forest);
  return strips::paths_of_edges(forest, join_upwards(forest, tree));
}

bool is_path_partition(const DualGraph& graph, const PathPartition& partition) {
  if (partition.begin.empty() || partition.begin.front() != 0 ||
      partition.begin.back() != partition.leave.size() ||
      partition.leave.size() != graph.node_count()) {
    return false;
  }
  std::vector<std::uint8_t> seen(graph.node_count());
  for (std::size_t p = 0; p < partition.count(); ++p) {
    if (partition.begin[p] >= partition.begin[p + 1] ||
        partition.begin[p + 1] > partition.leave.size()) {
      return false;
    }
    HalfedgeId entry = kNone;
    for (std::uint32_t i = partition.begin[p]; i < partition.begin[p + 1]; ++i) {
      const HalfedgeId h = partition.leave[i];
      if (h >= graph.twin.size() || h == entry || seen[triangle_of(h)] != 0) return false;
      if (entry != kNone && triangle_of(h) != triangle_of(entry)) return false;
      seen[triangle_of(h)] = 1;
      entry = graph.twin[h];
      if (i + 1 < partition.begin[p + 1] && entry == kNone) return false;
    }
  }
  return true;
}

}  // namespace quadloom
