// A cheap stand-in for quad_shape with the same order: no arc cosines, for inner loops.
#pragma once

#include <algorithm>
#include <cmath>

#include "kernel/predicates_inline.hpp"
#include "quadloom/core.hpp"

namespace quadloom::kernel {

/// The edges of a quad, two and two side by side: ab and cd, bc and da. Two corners at a time cost hardly
/// more than one.
class QuadEdges {
 public:
  QuadEdges(Point a, Point b, Point c, Point d)
      : x0_(Pair{b.x, d.x} - Pair{a.x, c.x}),
        y0_(Pair{b.y, d.y} - Pair{a.y, c.y}),
        x1_(Pair{c.x, a.x} - Pair{b.x, d.x}),
        y1_(Pair{c.y, a.y} - Pair{b.y, d.y}) {}

  /// The greatest squared cosine of the corners: 0 for a rectangle, 1 towards a flat corner; not a number,
  /// or any, if differences of the input overflow.
  double worst_squared_cosine() const {
    const Pair x2 = swapped(x0_), y2 = swapped(y0_);
    const Pair square0 = x0_ * x0_ + y0_ * y0_, square1 = x1_ * x1_ + y1_ * y1_;
    const Pair at_b_d = x0_ * x1_ + y0_ * y1_, at_c_a = x1_ * x2 + y1_ * y2;
    const Pair b_d = at_b_d * at_b_d / (square0 * square1);
    const Pair c_a = at_c_a * at_c_a / (square1 * swapped(square0));
    return std::max(std::max(c_a[1], b_d[0]), std::max(c_a[0], b_d[1]));
  }
  /// How the corners c and a turn, as far as the floating-point filter proves it.
  PairSigns turns_at_first_and_third() const {
    return proven_difference(x1_ * swapped(y0_), y1_ * swapped(x0_));
  }
  /// Whether the filter proves that all corners turn left.
  bool proven_convex() const {
    const PairSigns b_d = proven_difference(x0_ * y1_, y0_ * x1_);
    return (b_d.positive & turns_at_first_and_third().positive) == 3;
  }

 private:
  static Pair swapped(Pair p) { return Pair{p[1], p[0]}; }
  Pair x0_, y0_, x1_, y1_;
};

inline double worst_squared_cosine(Point a, Point b, Point c, Point d) {
  return QuadEdges(a, b, c, d).worst_squared_cosine();
}

/// In [0, 1]: 1 - max |cos| over the corners of a convex quad; 1 for a rectangle, 0 towards a flat
/// corner. Orders convex quads as quad_shape does. Not finite input differences give 0.
inline double squareness(Point a, Point b, Point c, Point d) {
  const double worst = worst_squared_cosine(a, b, c, d);
  return worst < 1 ? 1 - std::sqrt(worst) : 0;
}

}  // namespace quadloom::kernel
