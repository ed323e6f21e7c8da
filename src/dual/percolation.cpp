// Maximum matchings of trees: percolate-up and percolate-up-and-down.
//
// Ramaswami, Ramos and Toussaint, Converting Triangulations to Quadrangulations, section 3:
// percolate_up matches from the lowest level upwards (theorem 3.1: maximum); percolate_up_and_down
// then pushes what stayed unmatched inside the tree down to the leaves (theorem 3.2). For the dual
// tree of a simple polygon the unmatched leaves have an edge on the boundary, and their number is
// the least number of outer Steiner points for that triangulation (theorem 3.3).
//
// Steps: order_from_roots (breadth first, each tree from a leaf), match_upwards, push_down.
//
// What differs from the paper: the levels are one breadth-first order walked backwards; nothing is
// pruned, a node is still there if it is unmatched; a node takes its first unmatched child, which is
// the paper's cases 1 and 2, a second unmatched child is case 3. Cost: O(n), no recursion.
#include "dual/rooted_forest.hpp"
#include "quadloom/dual.hpp"

namespace quadloom {
namespace {

void match(const DualGraph& forest, HalfedgeId h, DualMatching& matching) {
  matching.mate[triangle_of(h)] = h;
  matching.mate[forest.across(h)] = forest.twin[h];
}

DualMatching match_upwards(const DualGraph& forest, const dual::RootedForest& rooted) {
  DualMatching matching{std::vector<HalfedgeId>(forest.node_count(), kNone), forest.node_count()};
  for (std::size_t i = rooted.order.size(); i-- > 0;) {
    const TriangleId t = rooted.order[i];
    for (HalfedgeId h = 3 * t; h < 3 * t + 3 && matching.mate[t] == kNone; ++h) {
      if (forest.twin[h] == kNone || h == rooted.upward[t]) continue;
      if (matching.mate[forest.across(h)] != kNone) continue;
      match(forest, h, matching);
      matching.unmatched -= 2;
    }
  }
  return matching;
}

//     o t                 t         An unmatched inner node takes a child, the child's mate below
//     |                   #         becomes the unmatched one. All children of that mate are matched
//     c      becomes      c         downwards, since it was still unmatched when it was its turn, so
//     #                   |         this goes on until a leaf; no two such ways meet.
//     d                   o d
void push_down(const DualGraph& forest, const dual::RootedForest& rooted, TriangleId t,
               DualMatching& matching) {
  while (dual::degree(forest, t) > 1) {
    HalfedgeId h = 3 * t;
    while (forest.twin[h] == kNone || h == rooted.upward[t]) ++h;
    const TriangleId below = forest.across(matching.mate[forest.across(h)]);
    matching.mate[below] = kNone;
    match(forest, h, matching);
    t = below;
  }
}

}  // namespace

DualMatching percolate_up(const DualGraph& forest) {
  return match_upwards(forest, dual::order_from_roots(forest));
}

DualMatching percolate_up_and_down(const DualGraph& forest) {
  const dual::RootedForest rooted = dual::order_from_roots(forest);
  DualMatching matching = match_upwards(forest, rooted);
  for (const TriangleId t : rooted.order) {
    if (matching.mate[t] == kNone) push_down(forest, rooted, t, matching);
  }
  return matching;
}

}  // namespace quadloom
