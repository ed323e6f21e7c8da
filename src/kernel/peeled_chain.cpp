// Hulls of what is left under a hull, by what Graham's scan has hidden.
//
//          a ---------------- c         The scan from left to right drops q when it comes to c: q is strictly
//           \ \            /  |         below a c. So the triangle a q c is noted: under the edge a c is
//            \  q --------    |         q, under a q and q c is what was under them. What is under an edge
//             o   \     o     c'        is a binary tree in the order of the places.
//
//   1. start    the scan over all places: O(n)
//   2. peel     when all places of the chain are gone, the triangles at them are open. Their other corners,
//               from left to right, are scanned again; the edges between them keep what is under them
//   3. uncover  finds them below an edge whose ends are gone: the tree from its root along the left and
//               the right spine, and around every place that has been removed from elsewhere
//   4. append   one step of the scan
//
// A place can only come to light with its triangle, so nothing is missed: what stays under an edge is
// strictly below it. Cost: with points in a random order of heights a spine has about ln n places, as in a
// treap, and a dozen places are looked at for each one that is peeled, most of them again and again, so
// they are in the cache. In a hull tree a place rises through all levels: four times as slow. But
// where all triangles under a long edge share an end (the columns of a grid) each peel opens them all:
// the caller looks at the work and goes on with hull trees. Degenerate input: as in hull_tree.cpp.
#include "kernel/peeled_chain.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "kernel/predicates_inline.hpp"

namespace quadloom::kernel {

PeeledChain::PeeledChain(std::span<const Point> points, HullSide side)
    : points_(points), up_(side == HullSide::kUpper ? 1 : -1), parts_(points.size()) {
  Point low = {HUGE_VAL, HUGE_VAL}, high = {-HUGE_VAL, -HUGE_VAL};
  for (const Point p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  certain_ = cross_bound(low, high);
}

void PeeledChain::start(std::span<const VertexId> places) {
  chain_.clear();
  work_ = 0;
  for (const VertexId place : places) append(place, kNone);
}

void PeeledChain::peel(const std::vector<char>& removed) {
  std::swap(chain_, before_);
  chain_.clear();
  for (const Stop& stop : before_) uncover(stop.under, removed);
}

/// Whether q is strictly below a c, for which it is between a and c. One bound for all points
/// (cross_bound: upside down the extents are the same).
bool PeeledChain::below(Point q, Point a, Point c) const {
  const double det = (q.x - a.x) * (c.y - a.y) - (q.y - a.y) * (c.x - a.x);
  if (std::fabs(det) > certain_) return det > 0;
  return orient(a, q, c) > 0;
}

void PeeledChain::append(VertexId place, VertexId under) {
  const Point c = {points_[place].x, up_ * points_[place].y};
  while (chain_.size() >= 2) {
    const Stop q = chain_.back();
    if (!below(q.at, chain_.end()[-2].at, c)) break;
    parts_[q.place] = {q.under, under};
    under = q.place;
    chain_.pop_back();
  }
  chain_.push_back({c, place, under});
}

/// In the order of the tree, without what is under an edge both of whose ends are left.
void PeeledChain::uncover(VertexId under, const std::vector<char>& removed) {
  bool left_end_removed = true, right_end_removed = true;
  VertexId kept = kNone;
  while (true) {
    while (under != kNone) {
      if (!left_end_removed && !right_end_removed) {
        kept = under;
        break;
      }
      const bool gone = removed[under] != 0;
      visits_.push_back({under, gone, right_end_removed});
      right_end_removed = gone;
      under = parts_[under].left;
    }
    if (visits_.empty()) return;
    const Visit visit = visits_.back();
    visits_.pop_back();
    ++work_;
    under = parts_[visit.place].right;
    if (!visit.removed) append(visit.place, std::exchange(kept, kNone));
    left_end_removed = visit.removed;
    right_end_removed = visit.right_end_removed;
  }
}

}  // namespace quadloom::kernel
