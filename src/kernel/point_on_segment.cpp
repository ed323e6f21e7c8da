// The double points on a segment, and of them the one nearest to the middle.
//
// Take a unit (a power of two) of which every double near the segment is an integer multiple. With
// g = gcd(dx, dy) the integer points of the line through a are a + m (dx/g, dy/g), m an integer,
// and those of the open segment have 0 < m < g. Such a point is a double point if both coordinates
// have at most 53 significant bits: where |x| has q bits, x must be a multiple of 2^(q - 53).
//
//   a |----+----------+-----|------+-------| b        | a coordinate crosses a power of two
//     m = 1    ...          cut           g - 1       + points of the residue class
//
//   1. rounded_middle       the rounded midpoint is very often on the segment already
//   2. cuts                 the m at which a coordinate's number of bits changes
//   3. residue_class        between two cuts both conditions are linear congruences modulo powers
//   of
//                           two, so the good m are one residue class or none
//   4. nearest_in_class     the one of them that is nearest to g/2
//
// The search is complete: if it finds nothing, no double point lies inside the segment. Cost: a few
// operations on integers of about 100 bits, 300 where the segment crosses an axis; 2100 bits and 8400
// pieces only where it passes the origin closer than the last bit of its coordinates (or spans
// hundreds of decades).
#include "kernel/point_on_segment.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <vector>

#include "kernel/exact_integers.hpp"
#include "quadloom/kernel.hpp"

namespace quadloom::kernel {
namespace {

constexpr int kLeastExponent = -1074;  // of the smallest positive double
constexpr unsigned kMantissaBits = 53;

/// m = residue modulo 2^bits.
struct ResidueClass {
  BigInteger residue;
  unsigned bits = 0;
};

/// One coordinate along the segment in units: start + m step.
struct Coordinate {
  BigInteger start;
  BigInteger step;
  BigInteger at(const BigInteger& m) const { return start + m * step; }
};

BigInteger power_of_two(unsigned bits) {
  BigInteger out = 1;
  out <<= bits;
  return out;
}

/// The exponent of a unit that divides every double between a and b.
int unit_exponent(double a, double b) {
  if (a == b && a == 0) return 1023;
  if ((a <= 0) != (b <= 0) || a == 0 || b == 0) return kLeastExponent;
  return std::max(kLeastExponent, std::min(std::ilogb(a), std::ilogb(b)) - 52);
}

BigInteger in_units(double value, int unit) {
  int exponent = 0;
  const double mantissa = std::ldexp(std::frexp(value, &exponent), kMantissaBits);
  BigInteger out = static_cast<long long>(mantissa);
  const int shift = exponent - static_cast<int>(kMantissaBits) - unit;
  if (shift >= 0) return out << static_cast<unsigned>(shift);
  return out / power_of_two(static_cast<unsigned>(-shift));
}

unsigned bit_count(const BigInteger& v) {
  return v == 0 ? 0 : static_cast<unsigned>(msb(BigInteger(abs(v)))) + 1;
}

/// For a value of at most 53 significant bits.
double from_units(const BigInteger& value, int unit) {
  if (value == 0) return 0;
  const auto zeros = static_cast<unsigned>(lsb(BigInteger(abs(value))));
  const BigInteger mantissa = value / power_of_two(zeros);
  return std::ldexp(static_cast<double>(static_cast<long long>(mantissa)),
                    static_cast<int>(zeros) + unit);
}

BigInteger floor_mod(const BigInteger& v, const BigInteger& modulus) {
  const BigInteger r = v % modulus;
  return r < 0 ? BigInteger(r + modulus) : r;
}

BigInteger floor_div(const BigInteger& v, const BigInteger& divisor) {
  const BigInteger magnitude = abs(divisor);
  const BigInteger numerator = divisor < 0 ? BigInteger(-v) : v;
  return (numerator - floor_mod(numerator, magnitude)) / magnitude;
}

/// 1 / odd modulo 2^bits, by Newton's iteration (each step doubles the correct bits).
BigInteger inverse_of_odd(const BigInteger& odd, unsigned bits) {
  const BigInteger modulus = power_of_two(bits);
  BigInteger inverse = 1;
  for (unsigned correct = 1; correct < bits; correct *= 2) {
    inverse = floor_mod(inverse * (2 - odd * inverse), modulus);
  }
  return floor_mod(inverse, modulus);
}

/// The m with c.start + m c.step divisible by 2^bits.
std::optional<ResidueClass> residue_class(const Coordinate& c, unsigned bits) {
  const BigInteger modulus = power_of_two(bits);
  const BigInteger start = floor_mod(c.start, modulus);
  const BigInteger step = floor_mod(c.step, modulus);
  if (step == 0) return start == 0 ? std::optional(ResidueClass{0, 0}) : std::nullopt;
  const auto common = static_cast<unsigned>(lsb(step));
  if (start != 0 && lsb(start) < common) return std::nullopt;
  const unsigned rest = bits - common;
  const BigInteger odd = step >> common;
  const BigInteger target = floor_mod(-(start >> common), power_of_two(rest));
  return ResidueClass{floor_mod(target * inverse_of_odd(odd, rest), power_of_two(rest)), rest};
}

std::optional<ResidueClass> both(const std::optional<ResidueClass>& a,
                                 const std::optional<ResidueClass>& b) {
  if (!a || !b) return std::nullopt;
  const ResidueClass& fine = a->bits >= b->bits ? *a : *b;
  const ResidueClass& coarse = a->bits >= b->bits ? *b : *a;
  if (floor_mod(fine.residue, power_of_two(coarse.bits)) != coarse.residue) return std::nullopt;
  return fine;
}

/// The power of two that must divide the coordinate on a piece [low, high] between two cuts.
unsigned needed_bits(const Coordinate& c, const BigInteger& low, const BigInteger& high) {
  const BigInteger first = c.at(low);
  const BigInteger last = c.at(high);
  if ((first < 0 && last > 0) || (first > 0 && last < 0)) return 0;
  const unsigned bits = std::min(bit_count(first), bit_count(last));
  return bits > kMantissaBits ? bits - kMantissaBits : 0;
}

/// The last m before a coordinate passes a power of two of at least 53 bits, for all of them.
void append_cuts(const Coordinate& c, const BigInteger& g, std::vector<BigInteger>& cuts) {
  if (c.step == 0) return;
  const BigInteger ends[] = {c.start, c.at(g)};
  const unsigned most = std::max(bit_count(ends[0]), bit_count(ends[1]));
  const bool crosses_zero = (ends[0] <= 0) != (ends[1] <= 0) || ends[0] == 0 || ends[1] == 0;
  const unsigned least = crosses_zero ? 0 : std::min(bit_count(ends[0]), bit_count(ends[1]));
  for (unsigned q = std::max(least > 0 ? least - 1 : 0, kMantissaBits); q <= most; ++q) {
    for (const int sign : {-1, 1}) {
      const BigInteger threshold = sign * power_of_two(q);
      const BigInteger m = floor_div(threshold - c.start, c.step);
      if (m >= 1 && m < g - 1) cuts.push_back(m);
    }
  }
}

/// The member of the class in [low, high] nearest to g/2.
std::optional<BigInteger> nearest_in_class(const ResidueClass& wanted, const BigInteger& low,
                                           const BigInteger& high, const BigInteger& g) {
  const BigInteger modulus = power_of_two(wanted.bits);
  const BigInteger aim = std::clamp(BigInteger(g / 2), low, high);
  const BigInteger below = aim - floor_mod(aim - wanted.residue, modulus);
  const BigInteger above = below + modulus;
  const bool below_fits = below >= low;
  const bool above_fits = above <= high;
  if (below_fits && (!above_fits || abs(2 * below - g) <= abs(2 * above - g))) return below;
  if (above_fits) return above;
  return std::nullopt;
}

/// The exponent of the last bit that is set.
int last_bit(double v) {
  if (v == 0) return 1023;
  int exponent = 0;
  const auto mantissa = static_cast<long long>(std::ldexp(std::frexp(v, &exponent), kMantissaBits));
  return exponent - static_cast<int>(kMantissaBits) +
         std::countr_zero(static_cast<std::uint64_t>(mantissa));
}

/// A unit that is fine enough where an axis is crossed and smaller and smaller doubles come into
/// view.
///
/// Let the ends be integers in the unit w and (p, q) the step between the integer points. A point
/// a + (m / 2^s) (p, q), m odd, has coordinates whose last bits are w 2^(v - s), v = the twos in p or
/// in q. If s > 53 + v for both, both coordinates of a double point are smaller than w: only a
/// segment that passes the origin within w has
/// such points, and one through the origin itself has a better one there.
std::optional<int> fine_enough_unit(Point a, Point b) {
  const int w =
      std::min(std::min(last_bit(a.x), last_bit(a.y)), std::min(last_bit(b.x), last_bit(b.y)));
  const BigInteger ax = in_units(a.x, w), ay = in_units(a.y, w);
  const BigInteger dx = in_units(b.x, w) - ax, dy = in_units(b.y, w) - ay;
  const BigInteger cross = ax * dy - ay * dx;
  if (cross != 0 && abs(cross) < abs(dx) + abs(dy)) return std::nullopt;
  const BigInteger g = gcd(dx, dy);
  const auto twos = [&](const BigInteger& d) {
    return d == 0 ? 0 : static_cast<int>(lsb(BigInteger(abs(d) / g)));
  };
  return w - static_cast<int>(kMantissaBits) - std::max(twos(dx), twos(dy)) - 1;
}

std::optional<Point> rounded_middle(Point a, Point b) {
  const Point middle{a.x / 2 + b.x / 2, a.y / 2 + b.y / 2};
  const bool ordered = lex_less(a, b) ? lex_less(a, middle) && lex_less(middle, b)
                                      : lex_less(b, middle) && lex_less(middle, a);
  if (ordered && orient2d(a, b, middle) == 0) return middle;
  return std::nullopt;
}

}  // namespace

std::optional<Point> point_on_segment(Point a, Point b) {
  if (const auto middle = rounded_middle(a, b)) return middle;
  const int finest = std::min(unit_exponent(a.x, b.x), unit_exponent(a.y, b.y));
  const int unit = std::max(finest, fine_enough_unit(a, b).value_or(finest));
  Coordinate x{in_units(a.x, unit), in_units(b.x, unit) - in_units(a.x, unit)};
  Coordinate y{in_units(a.y, unit), in_units(b.y, unit) - in_units(a.y, unit)};
  const BigInteger g = gcd(x.step, y.step);
  if (g <= 1) return std::nullopt;
  x.step /= g;
  y.step /= g;

  std::vector<BigInteger> cuts = {g - 1};
  append_cuts(x, g, cuts);
  append_cuts(y, g, cuts);
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());

  std::optional<BigInteger> best;
  BigInteger low = 1;
  for (const BigInteger& high : cuts) {
    const auto wanted = both(residue_class(x, needed_bits(x, low, high)),
                             residue_class(y, needed_bits(y, low, high)));
    const auto m = wanted ? nearest_in_class(*wanted, low, high, g) : std::nullopt;
    if (m && (!best || abs(2 * *m - g) < abs(2 * *best - g))) best = m;
    low = high + 1;
  }
  if (!best) return std::nullopt;
  return Point{from_units(x.at(*best), unit), from_units(y.at(*best), unit)};
}

}  // namespace quadloom::kernel
