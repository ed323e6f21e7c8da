// All triangles and quads that have few points as corners and no other point: the search's faces.
#pragma once

#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "quadloom/core.hpp"

namespace quadloom::convex {

inline constexpr std::size_t kMostExactPoints = 20;

/// A set of undirected edges between the points.
using EdgeSet = std::bitset<kMostExactPoints*(kMostExactPoints - 1) / 2>;

/// A simple quad, or a triangle (corner 3 is then unused), that has an area, counter-clockwise, without
/// any point but its corners in it or on its sides.
struct EmptyFace {
  std::array<std::uint8_t, 4> corner{};
  bool triangle = false;
  bool convex = false;  // a quad whose four corners turn left
  EdgeSet apart;        // edges that cross a side or run through the inside: none of a mesh with it

  std::size_t size() const { return triangle ? 3 : 4; }
};

/// Decided by exact predicates once; afterwards only sets are compared.
class EmptyFaces {
 public:
  /// The points are distinct, in lexicographic order, at most kMostExactPoints. O(n^5).
  explicit EmptyFaces(std::span<const Point> points);

  /// Those with the side a -> b, which are corners 0 and 1: strictly convex quads, other quads, then
  /// triangles.
  std::span<const EmptyFace> at(std::size_t a, std::size_t b) const {
    const std::size_t side = a * kMostExactPoints + b;
    return {faces_.data() + begin_[side], faces_.data() + begin_[side + 1]};
  }
  static std::size_t edge(std::size_t a, std::size_t b) {
    return a < b ? b * (b - 1) / 2 + a : a * (a - 1) / 2 + b;
  }

 private:
  static constexpr std::size_t kSides = kMostExactPoints * kMostExactPoints;

  int turn(std::size_t a, std::size_t b, std::size_t c) const {
    return turn_[(a * kMostExactPoints + b) * kMostExactPoints + c];
  }
  bool is_edge(std::size_t a, std::size_t b) const { return edges_[edge(a, b)]; }
  bool in_triangle(std::size_t a, std::size_t b, std::size_t c, std::size_t p) const;
  bool crossing(std::size_t a, std::size_t b, std::size_t c, std::size_t d) const;
  void find_turns(std::span<const Point> points);
  void find_edges();
  void add_faces_at(std::size_t a, std::size_t b);
  void add_quad(std::size_t a, std::size_t b, std::size_t c, std::size_t d, bool convex);
  void add_triangle(std::size_t a, std::size_t b, std::size_t c);
  void add(EmptyFace face);

  std::size_t n_;
  std::array<std::int8_t, kSides * kMostExactPoints> turn_{};
  EdgeSet edges_;                // segments without a point between their ends
  std::vector<EdgeSet> across_;  // per edge: the edges that cross it
  std::vector<EmptyFace> faces_;
  std::array<std::uint32_t, kSides + 1> begin_{};
};

}  // namespace quadloom::convex
