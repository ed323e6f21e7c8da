// The points that a subdivision adds on its boundary.
#pragma once

#include <optional>
#include <vector>

#include "quadloom/core.hpp"

namespace quadloom::quadrangulate {

/// A convex polygon, counter-clockwise, straight corners allowed, that gets one point for each edge
/// such that the polygon with these points is convex: exactly on the edge, or outside with strict
/// turns.
///
/// Where the polygon is straight or almost straight, and an edge has no double on it and none in the
/// sliver outside, a chain of edges bulges: their points and one more point for each corner between
/// them, its cap, lie on an arc outside.
///
///      u0 --- u1 --- u2 --- u3        m1, m2, m3 belong to the edges, c1 and c2 cap u1 and u2;
///        ` m1        .  m3 '          the quads m1 c1 m2 u1 and m2 c2 m3 u2 are strictly convex
///            c1  m2  c2               and the polygon goes through m1 c1 m2 c2 m3, not u1, u2
class SubdivisionBoundary {
 public:
  explicit SubdivisionBoundary(std::vector<Point> polygon);

  /// Places all points; returns the first edge without a place, if there is one.
  std::optional<std::size_t> place_all();

  std::size_t size() const { return polygon_.size(); }
  /// The point of the edge from corner i to corner i + 1.
  Point edge_place(std::size_t i) const { return *edge_place_[i]; }
  /// The cap of corner i, if it has one.
  const std::optional<Point>& cap(std::size_t i) const { return cap_[i]; }

  struct Chain {
    std::size_t first, count;  ///< edges
  };
  /// Makes the chain about edge i bulge, whether it needs to or not; none and nothing changed if it
  /// cannot.
  std::optional<Chain> bulge_around(std::size_t i);

 private:
  std::size_t before(std::size_t i) const { return i == 0 ? size() - 1 : i - 1; }
  std::size_t after(std::size_t i) const { return i + 1 == size() ? 0 : i + 1; }

  bool fits(std::size_t i, Point m) const;
  std::optional<Point> place_of(std::size_t i) const;
  bool almost_straight(std::size_t i) const;
  bool bulge(Chain chain, double height);

  std::vector<Point> polygon_;
  std::vector<std::optional<Point>> edge_place_;
  std::vector<std::optional<Point>> cap_;
};

}  // namespace quadloom::quadrangulate
