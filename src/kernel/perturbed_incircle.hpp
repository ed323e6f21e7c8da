// How cocircular points are triangulated: see "Ties" in delaunay.cpp.
#pragma once

#include "kernel/predicates_inline.hpp"

namespace quadloom::kernel {

/// incircle(a, b, c, p) for a cocircular tie of distinct points, a, b, c counter-clockwise: the
/// sign when the lexicographically largest of the four is lifted a little off the paraboloid.
inline int perturbed_incircle(Point a, Point b, Point c, Point p) {
  const auto largest = [&](Point q, Point r, Point s, Point t) {
    return lex_less(r, q) && lex_less(s, q) && lex_less(t, q);
  };
  if (largest(p, a, b, c)) return -1;
  if (largest(c, a, b, p)) return orient(a, b, p);
  if (largest(b, a, c, p)) return orient(a, p, c);
  return orient(p, b, c);
}

/// Whether p is inside the circle of a, b, c (counter-clockwise), ties decided; all distinct.
inline bool inside_circle(Point a, Point b, Point c, Point p) {
  int sign = incircle_filter(a, b, c, p);
  if (sign == 0) sign = incircle_exact(a, b, c, p);
  return (sign != 0 ? sign : perturbed_incircle(a, b, c, p)) > 0;
}

}  // namespace quadloom::kernel
