// Doubles in an intersection of half-planes, with big integers.
//
//   1. read_lines     half-planes A x + B y + C > 0 with integers A, B, C, each axis in a unit (a
//                     power of two) of which all coordinates are multiples
//   2. clip           the polygon as its sides in order; a corner is the meeting point of two of the
//                     given lines, so that signs are 3 x 3 determinants and numbers never grow
//   3. columns        doubles x within the polygon; in each the open interval of y, and the double
//                     nearest to its middle: if the interval has a double, it has that one
//   4. the same with x and y exchanged
//
// Cost: some hundred operations on integers of about four times the coordinates' bits.
#include "convex/exact_region.hpp"

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <vector>

#include "kernel/predicates_inline.hpp"

namespace quadloom::convex {
namespace {

using BigInteger = boost::multiprecision::cpp_int;

constexpr int kMantissaBits = 53;
constexpr int kFiner = 64;      // a unit is that many bits finer than the coordinates' last bits
constexpr int kSpread = 48;     // columns spread over the region
constexpr int kStride = 17;     // their order: from the middle on, that many further, around
constexpr int kNeighbours = 4;  // columns on either side of corners and centroid

struct Line {
  BigInteger a, b, c;  // a x + b y + c > 0
};

/// (x / w, y / w), w > 0.
struct Meeting {
  BigInteger x, y, w;
};

struct Fraction {
  BigInteger numerator, denominator;  // denominator > 0
};

int last_exponent(double v) {
  int exponent = 0;
  std::frexp(v, &exponent);
  return exponent - kMantissaBits;
}

BigInteger in_units(double v, int unit) {
  int exponent = 0;
  const double mantissa = std::ldexp(std::frexp(v, &exponent), kMantissaBits);
  BigInteger out = static_cast<long long>(mantissa);
  const int shift = exponent - kMantissaBits - unit;
  if (shift >= 0) return out << static_cast<unsigned>(shift);
  return out >> static_cast<unsigned>(-shift);  // exact for multiples of the unit
}

/// numerator / denominator * 2^unit, within two units of the double's last place.
double to_double(const Fraction& f, int unit) {
  if (f.numerator == 0) return 0;
  const BigInteger magnitude = abs(f.numerator);
  const int shift = 64 + static_cast<int>(msb(f.denominator)) - static_cast<int>(msb(magnitude));
  const BigInteger above = magnitude << static_cast<unsigned>(std::max(shift, 0));
  const BigInteger below = f.denominator << static_cast<unsigned>(std::max(-shift, 0));
  const BigInteger quotient = above / below;
  const double out = std::ldexp(static_cast<double>(quotient), unit - shift);
  return f.numerator < 0 ? -out : out;
}

bool less(const Fraction& a, const Fraction& b) {
  return a.numerator * b.denominator < b.numerator * a.denominator;
}

Meeting meet(const Line& l, const Line& m) {
  Meeting out{l.b * m.c - l.c * m.b, l.c * m.a - l.a * m.c, l.a * m.b - l.b * m.a};
  if (out.w < 0) out = {-out.x, -out.y, -out.w};
  return out;
}

int side_of(const Line& l, const Meeting& p) {
  return BigInteger(l.a * p.x + l.b * p.y + l.c * p.w).sign();
}

class ExactRegion {
 public:
  ExactRegion(std::span<const HalfPlane> sides, Point low, Point high, bool swapped)
      : sides_(sides), swapped_(swapped) {
    if (swapped) {
      std::swap(low.x, low.y);
      std::swap(high.x, high.y);
    }
    const std::array<HalfPlane, 4> box = {{{low, {high.x, low.y}},
                                           {{high.x, low.y}, high},
                                           {high, {low.x, high.y}},
                                           {{low.x, high.y}, low}}};
    find_units(low, high);
    for (const HalfPlane& side : box) polygon_.push_back(line_of(side));
    read_lines();
  }

  /// False if the region is empty.
  bool clip_all() {
    return std::all_of(lines_.begin(), lines_.end(), [&](const Line& line) { return clip(line); });
  }

  OpenRegion::Places places(std::size_t most) const {
    OpenRegion::Places out;
    for (const double column : columns()) {
      if (out.size() == most) break;
      if (const auto p = place_in_column(column)) out.push_back(*p);
    }
    return out;
  }

 private:
  void find_units(Point low, Point high) {
    const auto take = [](int& unit, double v) {
      if (v != 0) unit = std::min(unit, last_exponent(v));
    };
    for (const Point p : {low, high}) {
      take(unit_x_, p.x);
      take(unit_y_, p.y);
    }
    for (const HalfPlane& given : sides_) {
      const HalfPlane side = turned(given);
      for (const Point p : {side.from, side.to}) {
        take(unit_x_, p.x);
        take(unit_y_, p.y);
      }
    }
    unit_x_ -= kFiner;
    unit_y_ -= kFiner;
  }

  /// With x and y exchanged, left is right.
  HalfPlane turned(const HalfPlane& side) const {
    if (!swapped_) return side;
    return {{side.to.y, side.to.x}, {side.from.y, side.from.x}};
  }

  Line line_of(const HalfPlane& side) const {
    const BigInteger x = in_units(side.from.x, unit_x_), y = in_units(side.from.y, unit_y_);
    const BigInteger a = y - in_units(side.to.y, unit_y_);
    const BigInteger b = in_units(side.to.x, unit_x_) - x;
    return {a, b, -(a * x + b * y)};
  }

  void read_lines() {
    for (const HalfPlane& side : sides_) lines_.push_back(line_of(turned(side)));
  }

  Meeting corner(std::size_t i) const { return meet(polygon_[i], polygon_[(i + 1) % size()]); }
  std::size_t size() const { return polygon_.size(); }

  /// Keeps what is left of the line; false if nothing is.
  ///
  ///   side k --- corner k --- side k + 1     a side stays if one of its ends is left of the line;
  ///                                          the line comes after the side on which it leaves
  bool clip(const Line& line) {
    std::vector<int> at(size());
    for (std::size_t k = 0; k < size(); ++k) at[k] = side_of(line, corner(k));
    if (*std::max_element(at.begin(), at.end()) <= 0) return false;
    if (*std::min_element(at.begin(), at.end()) >= 0) return true;
    std::vector<Line> kept;
    for (std::size_t k = 0; k < size(); ++k) {
      const int before = at[k == 0 ? size() - 1 : k - 1];
      if (before > 0 || at[k] > 0) kept.push_back(polygon_[k]);
      if (before > 0 && at[k] <= 0) kept.push_back(line);
    }
    polygon_ = std::move(kept);
    return true;
  }

  /// Doubles between the first and the last corner, the likelier ones first.
  std::vector<double> columns() const {
    std::vector<double> out;
    double least = HUGE_VAL, most = -HUGE_VAL, sum = 0;
    std::vector<double> around;
    for (std::size_t k = 0; k < size(); ++k) {
      const Meeting p = corner(k);
      const double x = to_double({p.x, p.w}, unit_x_);
      around.push_back(x);
      least = std::min(least, x);
      most = std::max(most, x);
      sum += x / static_cast<double>(size());
    }
    around.push_back(sum);
    for (int i = 0; i < kSpread; ++i) {
      const double f = static_cast<double>((kSpread / 2 + i * kStride) % kSpread) / kSpread;
      if (f > 0) out.push_back(least * (1 - f) + most * f);
    }
    for (const double x : around) {
      double up = x, down = x;
      out.push_back(x);
      for (int i = 0; i < kNeighbours; ++i) {
        up = std::nextafter(up, HUGE_VAL);
        down = std::nextafter(down, -HUGE_VAL);
        out.insert(out.end(), {up, down});
      }
    }
    return out;
  }

  bool contains(Point p) const {
    return std::isfinite(p.x) && std::isfinite(p.y) &&
           std::all_of(sides_.begin(), sides_.end(), [&](const HalfPlane& side) {
             return kernel::orient(side.from, side.to, p) > 0;
           });
  }

  std::optional<Point> place_in_column(double x) const {
    if (!std::isfinite(x)) return std::nullopt;
    const BigInteger at = in_units(x, unit_x_);
    std::optional<Fraction> low, high;
    for (const Line& line : polygon_) {
      const BigInteger rest = line.a * at + line.c;
      if (line.b == 0) {
        if (rest <= 0) return std::nullopt;
        continue;
      }
      if (line.b > 0) {
        const Fraction bound{-rest, line.b};
        if (!low || less(*low, bound)) low = bound;
      } else {
        const Fraction bound{rest, -line.b};
        if (!high || less(bound, *high)) high = bound;
      }
    }
    if (!low || !high || !less(*low, *high)) return std::nullopt;
    const Fraction middle{low->numerator * high->denominator + high->numerator * low->denominator,
                          2 * low->denominator * high->denominator};
    double y = to_double(middle, unit_y_);
    for (int i = 0; i < 3; ++i) y = std::nextafter(y, -HUGE_VAL);
    for (int i = -3; i <= 3; ++i, y = std::nextafter(y, HUGE_VAL)) {
      const Point p = swapped_ ? Point{y, x} : Point{x, y};
      if (contains(p)) return p;
    }
    return std::nullopt;
  }

  std::span<const HalfPlane> sides_;
  bool swapped_;
  int unit_x_ = 1024;
  int unit_y_ = 1024;
  std::vector<Line> lines_;
  std::vector<Line> polygon_;  // its sides, counter-clockwise
};

}  // namespace

OpenRegion::Places places_exactly(std::span<const HalfPlane> sides, Point low, Point high,
                                  std::size_t most) {
  if (!(low.x < high.x && low.y < high.y)) return {};
  for (const bool swapped : {false, true}) {
    ExactRegion region(sides, low, high, swapped);
    if (!region.clip_all()) return {};
    const OpenRegion::Places places = region.places(most);
    if (!places.empty()) return places;
  }
  return {};
}

}  // namespace quadloom::convex
