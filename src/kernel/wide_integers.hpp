// Exact differences of doubles as 62-bit integers, and the sign of sums of their products.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

namespace quadloom::kernel {

__extension__ using Int128 = __int128;
__extension__ using Uint128 = unsigned __int128;

/// The rounded difference p - q and what the rounding lost (Knuth): p - q = high + low exactly,
/// unless the difference overflows.
struct SplitDifference {
  double high, low;
};
inline SplitDifference split_difference(double p, double q) {
  const double high = p - q;
  const double q_part = p - high;
  const double p_part = high + q_part;
  return {high, (p - p_part) + (q_part - q)};
}

/// Writes out[i] = (p[i] - q[i]) * 2^k exactly, |out[i]| < 2^62, for one k common to all i. False
/// if there is no such k: an overflow, or bits further than 61 places below the largest.
template <std::size_t N>
bool difference_integers(const std::array<double, N>& p, const std::array<double, N>& q,
                         std::array<std::int64_t, N>& out) {
  std::array<SplitDifference, N> d;
  double largest = 0;
  bool finite = true;
  for (std::size_t i = 0; i < N; ++i) {
    d[i] = split_difference(p[i], q[i]);
    largest = std::max(largest, std::fabs(d[i].high));
    finite = finite && std::fabs(d[i].high) < 0x1p900;  // false for NaN
  }
  // Below 2^-900 the scale would overflow; the points are then nearly the smallest doubles.
  if (!finite || (largest < 0x1p-900 && largest > 0)) return false;
  // 2^k for the k that brings the largest to [2^60, 2^61), and 2^-k.
  const std::uint64_t exponent = largest > 0 ? std::bit_cast<std::uint64_t>(largest) >> 52 : 1023;
  const auto up = std::bit_cast<double>((2 * 1023 + 60 - exponent) << 52);
  const auto down = std::bit_cast<double>((exponent - 60) << 52);
  bool exact = true;
  for (std::size_t i = 0; i < N; ++i) {
    const auto high = static_cast<std::int64_t>(d[i].high * up);
    const auto low = static_cast<std::int64_t>(d[i].low * up);
    // Truncation, or an underflow to zero on the way up, shows on the way down.
    exact = exact && static_cast<double>(high) * down == d[i].high &&
            static_cast<double>(low) * down == d[i].low;
    out[i] = high + low;
  }
  return exact;
}

/// A signed 256-bit integer, as far as the predicates need it.
struct Int256 {
  Uint128 low = 0;
  Int128 high = 0;
};

inline Int256 operator+(Int256 a, Int256 b) {
  Int256 sum;
  sum.low = a.low + b.low;
  sum.high = a.high + b.high + (sum.low < a.low ? 1 : 0);
  return sum;
}

/// a * b for |a|, |b| < 2^126.
inline Int256 multiply(Int128 a, Int128 b) {
  const bool negative = (a < 0) != (b < 0);
  const auto u = static_cast<Uint128>(a < 0 ? -a : a), v = static_cast<Uint128>(b < 0 ? -b : b);
  constexpr Uint128 kMask = 0xffffffffffffffffU;
  const Uint128 u0 = u & kMask, u1 = u >> 64, v0 = v & kMask, v1 = v >> 64;
  const Uint128 lowest = u0 * v0, cross = u1 * v0 + (lowest >> 64),
                cross2 = u0 * v1 + (cross & kMask);
  Int256 out;
  out.low = (cross2 << 64) | (lowest & kMask);
  Uint128 high = u1 * v1 + (cross >> 64) + (cross2 >> 64);
  if (negative) {
    out.low = ~out.low + 1;
    high = ~high + (out.low == 0 ? 1 : 0);
  }
  out.high = static_cast<Int128>(high);
  return out;
}

inline int sign_of(Int128 v) { return v > 0 ? 1 : v < 0 ? -1 : 0; }
inline int sign_of(Int256 v) { return v.high != 0 ? sign_of(v.high) : v.low != 0 ? 1 : 0; }

}  // namespace quadloom::kernel
