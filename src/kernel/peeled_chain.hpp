// The upper (or lower) hull of a set, for peeling one hull after the other.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "kernel/hull_tree.hpp"
#include "quadloom/core.hpp"

namespace quadloom::kernel {

/// The chain of all points on the upper (lower) boundary of the hull of some places, collinear points
/// included. Fast where what lies under an edge is spread well; there is no bound but the work counted.
class PeeledChain {
 public:
  /// Keeps a view of the points, of which start() takes some.
  PeeledChain(std::span<const Point> points, HullSide side);

  /// The chain of these places, which are in lexicographic order.
  void start(std::span<const VertexId> places);
  /// The chain of what is left: all places of the chain have been removed, others may have been.
  void peel(const std::vector<char>& removed);

  std::size_t size() const { return chain_.size(); }
  /// From left to right.
  VertexId operator[](std::size_t i) const { return chain_[i].place; }
  /// Places that were looked at since start().
  std::size_t work() const { return work_; }

 private:
  /// A place of the chain, and the tree of all that is under the edge that ends there.
  struct Stop {
    Point at;
    VertexId place, under;
  };
  /// In a tree: a place parts what is under an edge into what is under its edge to the left end and
  /// what is under its edge to the right end.
  struct Parts {
    VertexId left = kNone, right = kNone;
  };
  struct Visit {
    VertexId place;
    bool removed, right_end_removed;
  };

  bool below(Point q, Point a, Point c) const;
  void append(VertexId place, VertexId under);
  void uncover(VertexId under, const std::vector<char>& removed);

  std::span<const Point> points_;
  double up_;       // -1 for the lower boundary: it is the upper one upside down
  double certain_;  // the sign of a larger determinant is certain
  std::vector<Parts> parts_;
  std::vector<Stop> chain_, before_;
  std::vector<Visit> visits_;
  std::size_t work_ = 0;
};

}  // namespace quadloom::kernel
