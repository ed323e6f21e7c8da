#include <array>
#include <cmath>

#include "kernel/exact_integers.hpp"
#include "quadloom/kernel.hpp"

namespace quadloom {
namespace {

using kernel::BigInteger;
using kernel::common_integers;

int sign_of(const BigInteger& v) { return v.sign(); }

}  // namespace

int cross_sign(Point a, Point b, Point c, Point d) {
  const double l = (b.x - a.x) * (d.y - c.y);
  const double r = (b.y - a.y) * (d.x - c.x);
  const double det = l - r;
  const double bound = 1e-15 * (std::fabs(l) + std::fabs(r)) + 1e-290;
  if (std::fabs(det) > bound && std::isfinite(bound)) return det > 0 ? 1 : -1;
  const auto v = common_integers<8>({a.x, a.y, b.x, b.y, c.x, c.y, d.x, d.y});
  return sign_of((v[2] - v[0]) * (v[7] - v[5]) - (v[3] - v[1]) * (v[6] - v[4]));
}

int orient2d(Point a, Point b, Point c) { return cross_sign(a, b, a, c); }

int dot_sign(Point a, Point b, Point c, Point d) {
  return cross_sign(a, b, {-c.y, c.x}, {-d.y, d.x}) * 1;
}

int incircle(Point a, Point b, Point c, Point d) {
  const auto v = common_integers<8>({a.x, a.y, b.x, b.y, c.x, c.y, d.x, d.y});
  const BigInteger ax = v[0] - v[6], ay = v[1] - v[7], bx = v[2] - v[6], by = v[3] - v[7],
                   cx = v[4] - v[6], cy = v[5] - v[7];
  return sign_of((ax * ax + ay * ay) * (bx * cy - by * cx) -
                 (bx * bx + by * by) * (ax * cy - ay * cx) +
                 (cx * cx + cy * cy) * (ax * by - ay * bx));
}

}  // namespace quadloom
