// The hull of a sorted sequence under deletions, after Overmars and van Leeuwen (1981) and
// Hershberger and Suri (1992), with plain linked lists.
//
// A balanced binary tree over the sequence; each node's chain is a prefix of its left child's chain
// and a suffix of its right child's, joined by a bridge. A point stores its neighbours only in the
// chain of the highest node that has it; a node stores its bridge and where the two parts that the
// bridge hides begin, so the chain of any node can be walked from its parent's.
//
//                 l ____ bridge ____ r               node's chain: ... l r ...
//          ___---x                    x---___
//        x        \                  /        x
//       /          x hidden_left    x hidden_right
//      /            \              /
//
//   1. build         bottom-up; a bridge is found from the gap outwards, so each point is passed
//                    once before it is hidden: O(n)
//   2. erase         the point's neighbours in the chains of all its ancestors, top-down; then
//                    bottom-up at each ancestor, where the point was an end of the bridge:
//   3. bridge_without_left_end (or right): deleting the left end l lets the bridge turn only
//      counter-clockwise. So the new right end is r or left of it, among the hidden points, and the
//      new left end lies between l's old neighbours: one of them or one of the points that came to
//      light in the left child. The slope grows; the end whose next edge has the smaller slope
//      moves first. Each point that is passed has just risen into the child's chain or now rises
//      into the node's, and a point rises at most once a level: O(n log n) in all.
//
// Collinear points stay in the chain: the bridge touches the left child's chain in the rightmost
// and the right child's in the leftmost possible point. Equal abscissas: the lexicographic order is
// that of the abscissas after a symbolic shear, which changes no orientation, and all comparisons
// of slopes are between directions that are lexicographically positive. What differs from the
// papers: no concatenable queues (chains only grow upwards), and every decision is an exact sign of
// degree two.
#include "kernel/hull_tree.hpp"

#include <array>

#include "kernel/predicates_inline.hpp"

namespace quadloom::kernel {

HullTree::HullTree(std::span<const Point> sorted, HullSide side)
    : points_(sorted), sign_(side == HullSide::kUpper ? 1 : -1) {
  while (leaves_ < sorted.size()) leaves_ *= 2;
  nodes_.resize(leaves_);
  next_.assign(sorted.size(), kNone);
  previous_.assign(sorted.size(), kNone);
  if (!sorted.empty()) first_ = 0;
  build();
}

int HullTree::above(VertexId a, VertexId b, VertexId c) const {
  return sign_ * orient(points_[a], points_[b], points_[c]);
}

int HullTree::steeper(VertexId a, VertexId b, VertexId c, VertexId d) const {
  return sign_ * cross_sign(points_[a], points_[b], points_[c], points_[d]);
}

void HullTree::link(VertexId a, VertexId b) {
  if (a != kNone) next_[a] = b;
  if (b != kNone) previous_[b] = a;
}

void HullTree::build() {
  for (std::size_t width = 1; width < leaves_; width *= 2) {
    const std::size_t first_node = leaves_ / (2 * width);
    for (std::size_t i = 0; i < first_node; ++i) {
      const std::size_t first_of_right = (2 * i + 1) * width;
      if (first_of_right < points_.size()) build_node(first_node + i, first_of_right);
    }
  }
}

void HullTree::build_node(std::size_t node, std::size_t first_of_right) {
  auto r = static_cast<VertexId>(first_of_right);
  VertexId l = r - 1;
  while (true) {
    if (previous_[l] != kNone && above(l, r, previous_[l]) > 0) {
      l = previous_[l];
    } else if (next_[r] != kNone && above(l, r, next_[r]) > 0) {
      r = next_[r];
    } else {
      break;
    }
  }
  nodes_[node] = {l, r, next_[l], previous_[r]};
  link(l, r);
}

/// The left end of the bridge is gone (gap: in the left child's chain; on return: in the node's).
void HullTree::bridge_without_left_end(Node& node, Gap& gap) {
  const VertexId old_right = node.right;
  const VertexId shown = gap.first != kNone ? gap.first : gap.after;
  VertexId l = gap.after != kNone ? gap.after : gap.last != kNone ? gap.last : gap.before;
  VertexId r = old_right;
  while (true) {
    const VertexId further_l = l == gap.before ? kNone : previous_[l];
    const VertexId further_r = r == old_right ? node.hidden_right : previous_[r];
    const bool move_l = further_l != kNone && above(l, r, further_l) > 0;
    const bool move_r = further_r != kNone && above(l, r, further_r) >= 0;
    if (!move_l && !move_r) break;
    if (move_l && (!move_r || steeper(further_l, l, further_r, r) >= 0)) {
      l = further_l;
    } else {
      next_[further_r] = r;
      r = further_r;
    }
  }
  const VertexId last_shown_right = node.hidden_right;
  node.left = l;
  node.hidden_left = next_[l];
  if (r != old_right) {
    node.right = r;
    node.hidden_right = previous_[r];
  }
  const bool left_part = l != gap.before;
  const bool right_part = r != old_right;
  if (left_part && right_part) link(l, r);
  gap.first = left_part ? shown : right_part ? r : kNone;
  gap.last = right_part ? last_shown_right : left_part ? l : kNone;
  gap.after = old_right;
}

/// The mirror image: the right end of the bridge is gone.
void HullTree::bridge_without_right_end(Node& node, Gap& gap) {
  const VertexId old_left = node.left;
  const VertexId shown = gap.last != kNone ? gap.last : gap.before;
  VertexId r = gap.before != kNone ? gap.before : gap.first != kNone ? gap.first : gap.after;
  VertexId l = old_left;
  while (true) {
    const VertexId further_r = r == gap.after ? kNone : next_[r];
    const VertexId further_l = l == old_left ? node.hidden_left : next_[l];
    const bool move_r = further_r != kNone && above(l, r, further_r) > 0;
    const bool move_l = further_l != kNone && above(l, r, further_l) >= 0;
    if (!move_l && !move_r) break;
    if (move_r && (!move_l || steeper(r, further_r, l, further_l) <= 0)) {
      r = further_r;
    } else {
      previous_[further_l] = l;
      l = further_l;
    }
  }
  const VertexId first_shown_left = node.hidden_left;
  node.right = r;
  node.hidden_right = previous_[r];
  if (l != old_left) {
    node.left = l;
    node.hidden_left = next_[l];
  }
  const bool left_part = l != old_left;
  const bool right_part = r != gap.after;
  if (left_part && right_part) link(l, r);
  gap.first = left_part ? first_shown_left : right_part ? r : kNone;
  gap.last = right_part ? shown : left_part ? l : kNone;
  gap.before = old_left;
}

/// The left child is empty: the right child's chain is the node's.
void HullTree::show_all_hidden_right(Node& node, Gap& gap) {
  gap = {kNone, node.right, kNone, node.hidden_right};
  for (VertexId r = node.hidden_right, after = node.right; r != kNone; r = previous_[r]) {
    next_[r] = after;
    gap.first = after = r;
  }
  node = {};
}

void HullTree::show_all_hidden_left(Node& node, Gap& gap) {
  gap = {node.left, kNone, node.hidden_left, kNone};
  for (VertexId l = node.hidden_left, before = node.left; l != kNone; l = next_[l]) {
    previous_[l] = before;
    gap.last = before = l;
  }
  node = {};
}

VertexId HullTree::erase(VertexId p) {
  // Its neighbours in the chains on the path, from the root (height `height`) to the leaf.
  std::array<VertexId, 33> before{};
  std::array<VertexId, 33> after{};
  const std::size_t leaf = leaves_ + p;
  unsigned height = 0;
  while ((leaf >> height) > 1) ++height;
  before[height] = previous_[p];
  after[height] = next_[p];
  for (unsigned level = height; level > 0; --level) {
    const Node& node = nodes_[leaf >> level];
    before[level - 1] = node.right == p ? node.hidden_right : before[level];
    after[level - 1] = node.left == p ? node.hidden_left : after[level];
  }
  Gap gap;
  for (unsigned level = 1; level <= height; ++level) {
    Node& node = nodes_[leaf >> level];
    gap.before = before[level - 1];
    gap.after = after[level - 1];
    if (node.left != p && node.right != p) continue;
    const bool child_empty = gap.before == kNone && gap.after == kNone && gap.first == kNone;
    if (!child_empty) {
      link(gap.before, gap.first != kNone ? gap.first : gap.after);
      link(gap.last != kNone ? gap.last : gap.before, gap.after);
    }
    if (node.left == p) {
      child_empty ? show_all_hidden_right(node, gap) : bridge_without_left_end(node, gap);
    } else {
      child_empty ? show_all_hidden_left(node, gap) : bridge_without_right_end(node, gap);
    }
  }
  gap.before = before[height];
  gap.after = after[height];
  const VertexId shown = gap.first != kNone ? gap.first : gap.after;
  link(gap.before, shown);
  link(gap.last != kNone ? gap.last : gap.before, gap.after);
  if (gap.before == kNone) first_ = shown;
  return shown;
}

}  // namespace quadloom::kernel
