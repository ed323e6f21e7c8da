// The upper (or lower) hull of a sorted point sequence under deletions.
#pragma once

#include <span>
#include <vector>

#include "quadloom/core.hpp"

namespace quadloom::kernel {

enum class HullSide { kUpper, kLower };

/// The chain of all points on the upper (lower) boundary of the hull, collinear ones included, of a
/// lexicographically sorted sequence of distinct points; points are named by their place in the
/// sequence. Points of the chain can be deleted. n points and n deletions: O(n log n).
class HullTree {
 public:
  /// Keeps a view of the points.
  HullTree(std::span<const Point> sorted, HullSide side);

  /// The first point of the chain; kNone if all points are deleted.
  VertexId first() const { return first_; }
  /// The next point of the chain, to the right; kNone at its end.
  VertexId next(VertexId p) const { return next_[p]; }
  /// The one before it, to the left; kNone at the beginning.
  VertexId previous(VertexId p) const { return previous_[p]; }

  /// Deletes a point of the chain. Returns the chain's next point right of where it was (the first
  /// of those that come to light, if any); kNone at the end.
  VertexId erase(VertexId p);

 private:
  /// A node's chain is its left child's up to `left`, then its right child's from `right` on. What
  /// the bridge hides begins at hidden_left in the left child's chain (going right) and at
  /// hidden_right in the right child's (going left). No bridge (kNone) if a child is empty.
  struct Node {
    VertexId left = kNone;
    VertexId right = kNone;
    VertexId hidden_left = kNone;
    VertexId hidden_right = kNone;
  };
  /// A point p of a node's chain is gone: its neighbours there, and what comes to light between
  /// them.
  struct Gap {
    VertexId before = kNone;
    VertexId after = kNone;
    VertexId first = kNone;  // kNone: nothing comes to light
    VertexId last = kNone;
  };

  void build();
  void build_node(std::size_t node, std::size_t first_of_right);
  void bridge_without_left_end(Node& node, Gap& gap);
  void bridge_without_right_end(Node& node, Gap& gap);
  void show_all_hidden_right(Node& node, Gap& gap);
  void show_all_hidden_left(Node& node, Gap& gap);
  void link(VertexId a, VertexId b);

  /// +1 if c is above the line a -> b (for the lower hull: below), a left of b.
  int above(VertexId a, VertexId b, VertexId c) const;
  /// +1 if the slope of c -> d is larger than that of a -> b (for the lower hull: smaller).
  int steeper(VertexId a, VertexId b, VertexId c, VertexId d) const;

  std::span<const Point> points_;
  int sign_;
  std::size_t leaves_ = 1;  // a power of two; node i has the children 2i and 2i + 1
  std::vector<Node> nodes_;
  std::vector<VertexId> next_;  // in the chain of the highest node whose chain has the point
  std::vector<VertexId> previous_;
  VertexId first_ = kNone;
};

}  // namespace quadloom::kernel
