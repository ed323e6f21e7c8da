// The first tier of the predicates: floating-point filters, inlined where the time goes.
//
// A filter returns the sign only when it is proven, otherwise 0. The proofs count roundings, so the
// project is compiled without contraction to fused multiply-adds. e = 2^-53.
//   cross      the differences, the products and the subtraction round: the error is at most
//              (3e + 12e^2)(|l| + |r|) (Shewchuk 1997, bound A), and at most 2^-1074 more for each
//              product that underflows. A sum or difference never underflows with an error.
//   incircle   (10e + 80e^2) times the permanent (Shewchuk 1997, bound A). An underflow inside adds
//              at most 2^-1074 times a lift, or times a 2 x 2 minor, which is at most a sum of
//              lifts; hence the test of the lifts against 2^400: the sum of these errors is then
//              below 2^-660.
//   in a box   (cross_bound) Rounding is monotone. So for points in a box no difference is larger than
//              the rounded extents, no product than theirs, p, and no bound of `cross`, which grows with
//              |l| + |r|, than that for l = r = p, for which the sum 2 p is exact. An overflow of any
//              l, r or l - r means that of 2 p.
//   by lifts   (incircle_pair_filter) |bx cy| + |cx by| is at most half the sum of b's and c's lift,
//              so the permanent is at most a third of the square of the sum of the lifts: the error
//              is at most (10e + 80e^2) / 3 times that, and 4e leaves room for the few roundings in
//              the sum, its square and the bound.
// An overflow makes the bound infinite, or the determinant or the bound a NaN; then no comparison
// with the bound is true. Points with NaN coordinates thus always come out as "not proven"
// (delaunay.cpp relies on this for its point at infinity).
#pragma once

#include <bit>
#include <cmath>
#include <limits>

#include "kernel/predicates_tiers.hpp"
#include "quadloom/kernel.hpp"

namespace quadloom::kernel {

inline constexpr double kCrossError = (3 + 16 * 0x1p-53) * 0x1p-53;
inline constexpr double kCrossUnderflow = 0x1p-1000;
inline constexpr double kIncircleError = (10 + 96 * 0x1p-53) * 0x1p-53;
inline constexpr double kIncircleLiftError = 4 * 0x1p-53;
inline constexpr double kIncircleUnderflow = 0x1p-660;
inline constexpr double kIncircleLargestLift = 0x1p400;

/// The sign of l - r if that is certain from two products of rounded differences; else 0.
inline int proven_difference(double l, double r) {
  const double det = l - r;
  const double bound = kCrossError * (std::fabs(l) + std::fabs(r)) + kCrossUnderflow;
  if (det > bound) return 1;
  if (-det > bound) return -1;
  return 0;
}

/// What |l - r| must be above for the sign to be certain, l and r as in proven_difference, of differences
/// of points in the box.
inline double cross_bound(Point low, Point high) {
  return kCrossError * (2 * ((high.x - low.x) * (high.y - low.y))) + kCrossUnderflow;
}

inline int cross_filter(Point a, Point b, Point c, Point d) {
  return proven_difference((b.x - a.x) * (d.y - c.y), (b.y - a.y) * (d.x - c.x));
}

inline int dot_filter(Point a, Point b, Point c, Point d) {
  return proven_difference((b.x - a.x) * (d.x - c.x), -((b.y - a.y) * (d.y - c.y)));
}

inline int incircle_filter(Point a, Point b, Point c, Point d) {
  const double ax = a.x - d.x, ay = a.y - d.y, bx = b.x - d.x, by = b.y - d.y, cx = c.x - d.x,
               cy = c.y - d.y;
  const double bc = bx * cy, cb = cx * by, ca = cx * ay, ac = ax * cy, ab = ax * by, ba = bx * ay;
  const double a_lift = ax * ax + ay * ay, b_lift = bx * bx + by * by, c_lift = cx * cx + cy * cy;
  const double det = a_lift * (bc - cb) + b_lift * (ca - ac) + c_lift * (ab - ba);
  const double permanent = (std::fabs(bc) + std::fabs(cb)) * a_lift +
                           (std::fabs(ca) + std::fabs(ac)) * b_lift +
                           (std::fabs(ab) + std::fabs(ba)) * c_lift;
  const double bound = kIncircleError * permanent + kIncircleUnderflow;
  if (!(a_lift + b_lift + c_lift < kIncircleLargestLift)) return 0;
  if (det > bound) return 1;
  if (-det > bound) return -1;
  return 0;
}

/// Two doubles that one instruction works on, where the machine has it; and two comparisons.
using Pair [[gnu::vector_size(16)]] = double;
using PairMask [[gnu::vector_size(16)]] = long long;

/// A bit a lane.
inline unsigned bits(PairMask mask) {
#ifdef __SSE2__
  return static_cast<unsigned>(__builtin_ia32_movmskpd(std::bit_cast<Pair>(mask)));
#else
  return static_cast<unsigned>((mask[0] & 1) | (mask[1] & 2));
#endif
}

/// What a filter says of two calls: -1 (all bits) in a lane that is proven, inside.
struct PairVerdict {
  PairMask proven, inside;
};

/// Signs that are certain, a bit a lane.
struct PairSigns {
  unsigned positive, negative;
};

/// proven_difference for two calls at once.
inline PairSigns proven_difference(Pair l, Pair r) {
  const Pair det = l - r;
  const auto magnitude = [](Pair p) {  // without the bit of the sign
    return std::bit_cast<Pair>(std::bit_cast<PairMask>(p) & std::numeric_limits<long long>::max());
  };
  const Pair bound = kCrossError * (magnitude(l) + magnitude(r)) + kCrossUnderflow;
  const PairMask positive = det > bound, negative = -det > bound;
  return {bits(positive), bits(negative)};
}

/// A cheaper incircle filter for two calls at once, the points' differences to d given.
inline PairVerdict incircle_pair_filter(Pair ax, Pair ay, Pair bx, Pair by, Pair cx, Pair cy) {
  const Pair a_lift = ax * ax + ay * ay, b_lift = bx * bx + by * by, c_lift = cx * cx + cy * cy;
  const Pair det =
      a_lift * (bx * cy - cx * by) + b_lift * (cx * ay - ax * cy) + c_lift * (ax * by - bx * ay);
  const Pair lifts = a_lift + b_lift + c_lift;
  const Pair bound = kIncircleLiftError * (lifts * lifts) + kIncircleUnderflow;
  const PairMask inside = det > bound, outside = -det > bound;
  return {(inside | outside) & (lifts < kIncircleLargestLift), inside};
}

/// cross_sign with the filter inlined.
inline int cross(Point a, Point b, Point c, Point d) {
  const int sign = cross_filter(a, b, c, d);
  return sign != 0 ? sign : cross_exact(a, b, c, d);
}

/// orient2d with the filter inlined.
inline int orient(Point a, Point b, Point c) { return cross(a, b, a, c); }

}  // namespace quadloom::kernel
