// A double strictly inside an intersection of open half-planes.
#pragma once

#include <boost/container/static_vector.hpp>
#include <cstddef>
#include <optional>
#include <span>

#include "quadloom/core.hpp"

namespace quadloom::convex {

/// What is strictly left of the line from -> to; from != to.
struct HalfPlane {
  Point from;
  Point to;
};

inline constexpr std::size_t kMostSides = 16;

/// How hard to look: in floating point alone, or with big integers where that fails.
enum class Effort { kFloat, kExact };

/// An intersection of at most kMostSides open half-planes, looked at within the open box around a
/// set of points. The half-planes are exact; the polygon kept beside them is their intersection in
/// floating point, and only suggests places.
class OpenRegion {
 public:
  using Places = boost::container::static_vector<Point, 4 * (kMostSides + 4)>;

  explicit OpenRegion(std::span<const Point> box_of);
  void add(Point from, Point to);
  void add(HalfPlane side) { add(side.from, side.to); }
  /// Adds the half-plane if floating point then still sees a double in the region.
  void add_if_room(Point from, Point to);

  /// Whether p is strictly inside all half-planes; exact. The box plays no part.
  bool contains(Point p) const;

  /// A double of the region. The order of the search: the centroid of the floating-point polygon;
  /// doubles beside it in some columns; with Effort::kExact then what places_exactly finds.
  ///
  /// A point that is returned is in the region, exactly. kFloat may miss regions thinner than about
  /// 1e-15 of the box. With kExact the answer none means that the region is empty (this is decided
  /// exactly), or so thin that places_exactly, which see, has found no double in it.
  std::optional<Point> place(Effort effort) const;

  /// Doubles of the region near the middle, the corners and the sides of the floating-point polygon,
  /// for searches in which the best place is not known; with kExact a few others if there are none.
  Places places(Effort effort) const;

 private:
  using Polygon = boost::container::static_vector<Point, kMostSides + 4>;

  Point into_frame(Point p) const;
  Point out_of_frame(Point p) const;
  Point centroid() const;
  Places places_of_polygon() const;
  Places exact_places(std::size_t most) const;
  std::optional<Point> place_in_columns(Point middle) const;

  Point low_, high_;    // the box
  Point origin_;        // half the middle of the box
  int exponent_x_ = 0;  // the frame: the box is about [-1, 1] x [-1, 1]
  int exponent_y_ = 0;
  boost::container::static_vector<HalfPlane, kMostSides> sides_;
  Polygon polygon_;  // in the frame
};

}  // namespace quadloom::convex
