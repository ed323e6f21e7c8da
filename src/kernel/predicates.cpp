// The public predicates: see predicates_tiers.hpp for the tiers.
#include "kernel/predicates_inline.hpp"

namespace quadloom {

int cross_sign(Point a, Point b, Point c, Point d) {
  const int sign = kernel::cross_filter(a, b, c, d);
  return sign != 0 ? sign : kernel::cross_exact(a, b, c, d);
}

int orient2d(Point a, Point b, Point c) { return kernel::orient(a, b, c); }

int dot_sign(Point a, Point b, Point c, Point d) {
  const int sign = kernel::dot_filter(a, b, c, d);
  return sign != 0 ? sign : kernel::dot_exact(a, b, c, d);
}

int incircle(Point a, Point b, Point c, Point d) {
  const int sign = kernel::incircle_filter(a, b, c, d);
  return sign != 0 ? sign : kernel::incircle_exact(a, b, c, d);
}

}  // namespace quadloom
