// Two HullTrees, one for the lower and one for the upper chain.
//
//              upper               The least point belongs to the lower chain, the greatest to the
//          o <---- o               upper one: so each point of the ring has one name. A point that is
//        /           \.            taken out leaves the tree of its chain (the least and the greatest
//    least           greatest      both trees). The other tree keeps it until it would come to light
//        \           /             there; then it is deleted, and what lies under it comes to light.
//          o ----> o
//              lower
//
// When the rest is on one line both chains are the whole rest, and the trees are given up.
#include "strips/shrinking_hull.hpp"

#include "kernel/predicates_inline.hpp"

namespace quadloom::strips {

using kernel::HullSide;
using kernel::HullTree;

ShrinkingHull::ShrinkingHull(std::span<const Point> sorted)
    : points_(sorted),
      lower_(sorted, HullSide::kLower),
      upper_(sorted, HullSide::kUpper),
      removed_(sorted.size(), 0),
      left_(sorted.size()),
      greatest_(static_cast<VertexId>(sorted.size()) - 1) {
  straight_ = rest_is_straight();
}

ShrinkingHull::Spot ShrinkingHull::named(VertexId point, HullSide side) const {
  if (point == least_) return {point, HullSide::kLower};
  if (point == greatest_) return {point, HullSide::kUpper};
  return {point, side};
}

ShrinkingHull::Spot ShrinkingHull::after(Spot spot) const {
  return spot.side == HullSide::kLower ? named(lower_.next(spot.point), HullSide::kLower)
                                       : named(upper_.previous(spot.point), HullSide::kUpper);
}

ShrinkingHull::Spot ShrinkingHull::before(Spot spot) const {
  if (spot.point == least_) return named(upper_.next(least_), HullSide::kUpper);
  if (spot.point == greatest_) return named(lower_.previous(greatest_), HullSide::kLower);
  return spot.side == HullSide::kLower ? named(lower_.previous(spot.point), HullSide::kLower)
                                       : named(upper_.next(spot.point), HullSide::kUpper);
}

/// Deletes a point of the chain, and all points removed before that come to light.
void ShrinkingHull::erase_from(HullTree& tree, VertexId point) {
  const VertexId end = tree.next(point);
  for (VertexId p = tree.erase(point); p != end;) p = removed_[p] ? tree.erase(p) : tree.next(p);
}

bool ShrinkingHull::rest_is_straight() const {
  if (least_ == greatest_) return true;
  const Point a = points_[least_], b = points_[greatest_];
  return kernel::orient(a, points_[lower_.next(least_)], b) == 0 &&
         kernel::orient(a, points_[upper_.next(least_)], b) == 0;
}

ShrinkingHull::Spot ShrinkingHull::erase(Spot spot) {
  const VertexId p = spot.point;
  const Spot next = straight_ ? Spot{} : after(spot);
  removed_[p] = 1;
  --left_;
  const bool end = p == least_ || p == greatest_;
  if (!straight_) {
    if (end || spot.side == HullSide::kLower) erase_from(lower_, p);
    if (end || spot.side == HullSide::kUpper) erase_from(upper_, p);
  }
  if (left_ == 0) return {};
  while (removed_[least_]) ++least_;
  while (removed_[greatest_]) --greatest_;
  straight_ = straight_ || rest_is_straight();
  return straight_ ? next : named(next.point, next.side);
}

}  // namespace quadloom::strips
