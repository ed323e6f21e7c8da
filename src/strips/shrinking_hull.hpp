// The convex hull of a point set that loses hull points one by one, as a ring.
#pragma once

#include <span>
#include <vector>

#include "kernel/hull_tree.hpp"

namespace quadloom::strips {

/// The points on the hull of what is left, collinear ones included, counter-clockwise. Points are named
/// by their place in a lexicographically sorted sequence. n points and n deletions: O(n log n).
///
/// The ring is only there while the points that are left are not on one line; of a line there are its
/// two ends.
class ShrinkingHull {
 public:
  /// Keeps a view of the points: at least one, distinct.
  explicit ShrinkingHull(std::span<const Point> sorted);

  bool empty() const { return left_ == 0; }
  bool straight() const { return straight_; }
  VertexId least() const { return least_; }        ///< lexicographically
  VertexId greatest() const { return greatest_; }  ///< lexicographically

  /// A point of the ring: the chain, lower or upper, is part of its name.
  struct Spot {
    VertexId point = kNone;
    kernel::HullSide side = kernel::HullSide::kLower;
  };
  Spot spot_of_greatest() const { return {greatest_, kernel::HullSide::kUpper}; }
  Spot after(Spot spot) const;   ///< counter-clockwise
  Spot before(Spot spot) const;  ///< clockwise

  /// Takes a point of the ring out, or an end of the line. Returns what came after it on the ring, of
  /// which only the point counts once the rest is straight (kNone if nothing was a ring before).
  Spot erase(Spot spot);

 private:
  Spot named(VertexId point, kernel::HullSide side) const;
  void erase_from(kernel::HullTree& tree, VertexId point);
  bool rest_is_straight() const;

  std::span<const Point> points_;
  kernel::HullTree lower_, upper_;
  std::vector<char> removed_;
  std::size_t left_;
  VertexId least_ = 0, greatest_;
  bool straight_ = false;
};

}  // namespace quadloom::strips
