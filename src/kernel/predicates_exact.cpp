// The exact tiers of the predicates: wide, then big integers; see predicates_tiers.hpp.
#include <array>

#include "kernel/exact_integers.hpp"
#include "kernel/predicates_tiers.hpp"
#include "kernel/wide_integers.hpp"

namespace quadloom::kernel {

std::optional<int> cross_wide(Point a, Point b, Point c, Point d) {
  std::array<std::int64_t, 4> v;
  if (!difference_integers<4>({b.x, b.y, d.x, d.y}, {a.x, a.y, c.x, c.y}, v)) return {};
  return sign_of(Int128{v[0]} * v[3] - Int128{v[1]} * v[2]);
}

std::optional<int> dot_wide(Point a, Point b, Point c, Point d) {
  std::array<std::int64_t, 4> v;
  if (!difference_integers<4>({b.x, b.y, d.x, d.y}, {a.x, a.y, c.x, c.y}, v)) return {};
  return sign_of(Int128{v[0]} * v[2] + Int128{v[1]} * v[3]);
}

std::optional<int> incircle_wide(Point a, Point b, Point c, Point d) {
  std::array<std::int64_t, 6> v;
  if (!difference_integers<6>({a.x, a.y, b.x, b.y, c.x, c.y}, {d.x, d.y, d.x, d.y, d.x, d.y}, v)) {
    return {};
  }
  const auto minor = [&](std::size_t i, std::size_t j) {
    return Int128{v[2 * i]} * v[2 * j + 1] - Int128{v[2 * j]} * v[2 * i + 1];
  };
  const auto lift = [&](std::size_t i) {
    return Int128{v[2 * i]} * v[2 * i] + Int128{v[2 * i + 1]} * v[2 * i + 1];
  };
  // Each factor is below 2^125, each product below 2^250.
  return sign_of(multiply(lift(0), minor(1, 2)) + multiply(lift(1), minor(2, 0)) +
                 multiply(lift(2), minor(0, 1)));
}

int cross_big(Point a, Point b, Point c, Point d) {
  const auto v = common_integers<8>({a.x, a.y, b.x, b.y, c.x, c.y, d.x, d.y});
  const BigInteger l = (v[2] - v[0]) * (v[7] - v[5]), r = (v[3] - v[1]) * (v[6] - v[4]);
  return l.compare(r) > 0 ? 1 : l.compare(r) < 0 ? -1 : 0;
}

int dot_big(Point a, Point b, Point c, Point d) {
  const auto v = common_integers<8>({a.x, a.y, b.x, b.y, c.x, c.y, d.x, d.y});
  const BigInteger sum = (v[2] - v[0]) * (v[6] - v[4]) + (v[3] - v[1]) * (v[7] - v[5]);
  return sum.sign();
}

int incircle_big(Point a, Point b, Point c, Point d) {
  const auto v = common_integers<8>({a.x, a.y, b.x, b.y, c.x, c.y, d.x, d.y});
  const BigInteger ax = v[0] - v[6], ay = v[1] - v[7], bx = v[2] - v[6], by = v[3] - v[7],
                   cx = v[4] - v[6], cy = v[5] - v[7];
  const BigInteger det = (ax * ax + ay * ay) * (bx * cy - by * cx) -
                         (bx * bx + by * by) * (ax * cy - ay * cx) +
                         (cx * cx + cy * cy) * (ax * by - ay * bx);
  return det.sign();
}

int cross_exact(Point a, Point b, Point c, Point d) {
  const auto sign = cross_wide(a, b, c, d);
  return sign ? *sign : cross_big(a, b, c, d);
}

int dot_exact(Point a, Point b, Point c, Point d) {
  const auto sign = dot_wide(a, b, c, d);
  return sign ? *sign : dot_big(a, b, c, d);
}

int incircle_exact(Point a, Point b, Point c, Point d) {
  const auto sign = incircle_wide(a, b, c, d);
  return sign ? *sign : incircle_big(a, b, c, d);
}

}  // namespace quadloom::kernel
