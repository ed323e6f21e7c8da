// The predicates against GMP rationals, every tier on its own, and the laws they obey.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <array>
#include <cfloat>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "core/random.hpp"
#include "kernel/predicates_inline.hpp"
#include "kernel/predicates_tiers.hpp"
#include "quadloom/kernel.hpp"

namespace quadloom {
namespace {

using Points = std::array<Point, 4>;

int rational_cross(const Points& p) {
  const mpq_class ux = mpq_class(p[1].x) - mpq_class(p[0].x), uy = mpq_class(p[1].y) - p[0].y;
  const mpq_class vx = mpq_class(p[3].x) - mpq_class(p[2].x), vy = mpq_class(p[3].y) - p[2].y;
  return sgn(mpq_class(ux * vy - uy * vx));
}

int rational_dot(const Points& p) {
  const mpq_class ux = mpq_class(p[1].x) - mpq_class(p[0].x), uy = mpq_class(p[1].y) - p[0].y;
  const mpq_class vx = mpq_class(p[3].x) - mpq_class(p[2].x), vy = mpq_class(p[3].y) - p[2].y;
  return sgn(mpq_class(ux * vx + uy * vy));
}

int rational_incircle(const Points& p) {
  std::array<mpq_class, 3> x, y, lift;
  for (std::size_t i = 0; i < 3; ++i) {
    x[i] = mpq_class(p[i].x) - p[3].x;
    y[i] = mpq_class(p[i].y) - p[3].y;
    lift[i] = x[i] * x[i] + y[i] * y[i];
  }
  return sgn(mpq_class(lift[0] * (x[1] * y[2] - x[2] * y[1]) +
                       lift[1] * (x[2] * y[0] - x[0] * y[2]) +
                       lift[2] * (x[0] * y[1] - x[1] * y[0])));
}

// ---- Families of hard inputs: each makes four points. ----

double ulps(double v, int count) {
  for (; count > 0; --count) v = std::nextafter(v, DBL_MAX);
  for (; count < 0; ++count) v = std::nextafter(v, -DBL_MAX);
  return v;
}

double jitter(double v, Random& r) { return ulps(v, static_cast<int>(r.below(5)) - 2); }

/// Any finite double, each exponent as likely as any other.
double any_double(Random& r) {
  const double m = 1 + r.uniform();
  const int e = static_cast<int>(r.below(2098)) - 1074;
  return std::ldexp(r.below(2) ? m : -m, e);
}

/// p + t (q - p), rounded, and a few ulps beside it.
Point near_line(Point p, Point q, Random& r) {
  const double t = 3 * r.uniform() - 1;
  return {jitter(p.x + t * (q.x - p.x), r), jitter(p.y + t * (q.y - p.y), r)};
}

struct Family {
  std::string name;
  std::function<Points(Random&)> make;
};

void add_coordinate_families(std::vector<Family>& out) {
  const auto add = [&out](const std::string& name, auto coordinate) {
    out.push_back({name, [coordinate](Random& r) {
                     Points p;
                     for (Point& q : p) q = {coordinate(r), coordinate(r)};
                     return p;
                   }});
  };
  const auto whole = [](Random& r, std::uint64_t n) { return static_cast<double>(r.below(n)); };
  add("uniform", [](Random& r) { return r.uniform(); });
  add("tiny grid", [=](Random& r) { return whole(r, 4); });
  add("grid far away", [=](Random& r) { return 4e15 + whole(r, 8); });
  add("decimal grid", [=](Random& r) { return 500000 + 0.1 * whole(r, 9); });
  add("any exponent", any_double);
  add("some zero", [](Random& r) { return r.below(3) ? any_double(r) : 0.0; });
  add("around 1e300", [](Random& r) { return 1e300 * (r.uniform() - 0.5); });
  add("largest", [](Random& r) { return r.below(2) ? jitter(1.7e308, r) : -1.7e308; });
  add("around 1e-300", [](Random& r) { return 1e-300 * (r.uniform() - 0.5); });
  add("denormal", [=](Random& r) { return 0x1p-1074 * whole(r, 9); });
  add("two scales", [](Random& r) { return r.uniform() * (r.below(2) ? 1e9 : 1e-9); });
  add("five scales",
      [=](Random& r) { return (r.uniform() - 0.5) * std::pow(10.0, 150.0 * (whole(r, 5) - 2)); });
  add("one ulp", [](Random& r) { return jitter(0.7, r); });
}

void add_special_positions(std::vector<Family>& out, double scale) {
  const auto add = [&](const std::string& name, auto make) {
    out.push_back({name + " at 1e" + std::to_string(std::log10(scale)), make});
  };
  const auto anywhere = [scale](Random& r) {
    const double x = scale * r.uniform();
    return Point{x, scale * r.uniform()};
  };
  add("near a line", [=](Random& r) {
    const Point p = anywhere(r), q = anywhere(r), s = near_line(p, q, r);
    return Points{p, q, s, near_line(p, q, r)};
  });
  add("near a circle", [=](Random& r) {
    const Point centre = anywhere(r);
    Points p;
    for (Point& q : p) {
      const double a = 6.2831853 * r.uniform();
      q.x = jitter(centre.x + scale * std::cos(a), r);
      q.y = jitter(centre.y + scale * std::sin(a), r);
    }
    return p;
  });
  add("rectangle", [=](Random& r) {
    const Point p = anywhere(r), q = anywhere(r);
    Points out_points = {p, Point{q.x, p.y}, q, Point{p.x, q.y}};
    if (r.below(4) == 0) out_points[r.below(4)].x = jitter(q.x, r);
    return out_points;
  });
  add("parallel or normal", [=](Random& r) {
    const double x = scale * std::floor(1e6 * r.uniform());
    const double y = scale * std::floor(1e6 * r.uniform());
    const Point to = r.below(2) ? Point{4 * x, 12 * y} : Point{-3 * x - 7 * y, 5 * y + 7 * x};
    return Points{Point{0, 0}, Point{x, y}, Point{-3 * x, 5 * y},
                  Point{r.below(2) ? to.x : jitter(to.x, r), to.y}};
  });
}

std::vector<Family> families() {
  std::vector<Family> out;
  add_coordinate_families(out);
  for (const double scale : {1.0, 1e-160, 1e-300, 1e-310, 1e150, 1e300}) {
    add_special_positions(out, scale);
  }
  return out;
}

kernel::PairVerdict pair_filter(const Points& p, const Points& q) {
  const auto x = [&](std::size_t i) { return kernel::Pair{p[i].x - p[3].x, q[i].x - q[3].x}; };
  const auto y = [&](std::size_t i) { return kernel::Pair{p[i].y - p[3].y, q[i].y - q[3].y}; };
  return kernel::incircle_pair_filter(x(0), y(0), x(1), y(1), x(2), y(2));
}

TEST(Predicates, AgreeWithRationalsOnEveryTier) {
  for (const Family& family : families()) {
    Random random(20261122);
    SCOPED_TRACE(family.name + ", seed 20261122");
    Points previous{};
    int previous_circle = 0;
    for (int i = 0; i < 1000; ++i) {
      const Points p = family.make(random);
      const auto [a, b, c, d] = p;
      const int cross = rational_cross(p), dot = rational_dot(p), circle = rational_incircle(p);
      ASSERT_EQ(cross_sign(a, b, c, d), cross) << i;
      ASSERT_EQ(dot_sign(a, b, c, d), dot) << i;
      ASSERT_EQ(incircle(a, b, c, d), circle) << i;
      ASSERT_EQ(orient2d(a, b, c), rational_cross({a, b, a, c})) << i;
      // Each tier alone: silent or right.
      using namespace kernel;
      const int cross_f = cross_filter(a, b, c, d), dot_f = dot_filter(a, b, c, d);
      const int circle_f = incircle_filter(a, b, c, d);
      ASSERT_TRUE(cross_f == 0 || cross_f == cross) << i;
      ASSERT_TRUE(dot_f == 0 || dot_f == dot) << i;
      ASSERT_TRUE(circle_f == 0 || circle_f == circle) << i;
      const auto [proven, inside] = pair_filter(p, previous);
      ASSERT_TRUE(proven[0] == 0 || circle == (inside[0] != 0 ? 1 : -1)) << i;
      ASSERT_TRUE(proven[1] == 0 || previous_circle == (inside[1] != 0 ? 1 : -1)) << i;
      previous = p;
      previous_circle = circle;
      ASSERT_EQ(cross_wide(a, b, c, d).value_or(cross), cross) << i;
      ASSERT_EQ(dot_wide(a, b, c, d).value_or(dot), dot) << i;
      ASSERT_EQ(incircle_wide(a, b, c, d).value_or(circle), circle) << i;
      ASSERT_EQ(cross_big(a, b, c, d), cross) << i;
      ASSERT_EQ(dot_big(a, b, c, d), dot) << i;
      ASSERT_EQ(incircle_big(a, b, c, d), circle) << i;
    }
  }
}

TEST(Predicates, TheFamiliesContainTiesAndBothSigns) {
  std::array<int, 3> cross{}, dot{}, circle{};
  for (const Family& family : families()) {
    Random random(5);
    for (int i = 0; i < 300; ++i) {
      const Points p = family.make(random);
      ++cross[static_cast<std::size_t>(rational_cross(p) + 1)];
      ++dot[static_cast<std::size_t>(rational_dot(p) + 1)];
      ++circle[static_cast<std::size_t>(rational_incircle(p) + 1)];
    }
  }
  for (const int count : cross) EXPECT_GT(count, 300);
  for (const int count : dot) EXPECT_GT(count, 300);
  for (const int count : circle) EXPECT_GT(count, 300);
}

TEST(Predicates, EveryTierIsReached) {
  using namespace kernel;
  const Point o{0, 0}, x{1, 0}, y{0, 1}, xy{1, 1};
  EXPECT_EQ(cross_filter(o, x, o, y), 1);
  EXPECT_EQ(dot_filter(o, x, y, {3, 5}), 1);
  EXPECT_EQ(incircle_filter(o, x, y, {0.5, 0.5}), 1);
  const PairVerdict verdict = pair_filter({o, x, y, {0.5, 0.5}}, {o, x, y, {2, 2}});
  EXPECT_TRUE(verdict.proven[0] && verdict.inside[0] && verdict.proven[1] && !verdict.inside[1]);
  // Ties: the filter is silent, the wide integers decide.
  EXPECT_EQ(cross_filter(o, xy, o, {3, 3}), 0);
  EXPECT_EQ(cross_wide(o, xy, o, {3, 3}), 0);
  EXPECT_EQ(dot_filter(o, x, o, y), 0);
  EXPECT_EQ(dot_wide(o, x, o, y), 0);
  EXPECT_EQ(incircle_filter(o, x, xy, y), 0);
  EXPECT_EQ(incircle_wide(o, x, xy, y), 0);
  // Exponents out of range, or bits spread too far: the big integers decide.
  for (const double s : {0x1p1000, 0x1p-1070}) {
    const Point p{s, s}, px{s, 0}, py{0, s};
    EXPECT_EQ(cross_filter(o, p, o, xy), 0);
    EXPECT_FALSE(cross_wide(o, p, o, xy));
    EXPECT_EQ(cross_sign(o, p, o, xy), 0);
    EXPECT_FALSE(dot_wide(o, px, o, y));
    EXPECT_EQ(dot_sign(o, px, o, y), 0);
    EXPECT_EQ(incircle_filter(o, px, p, py), 0);
    EXPECT_FALSE(incircle_wide(o, px, p, py));
    EXPECT_EQ(incircle(o, px, p, py), 0);
  }
  const Point spread{1, 0x1p-80}, more{3, 0x3p-80};
  EXPECT_EQ(cross_filter(o, spread, o, more), 0);
  EXPECT_FALSE(cross_wide(o, spread, o, more));
  EXPECT_EQ(cross_sign(o, spread, o, more), 0);
}

TEST(Predicates, SpecialNumbersAreNeverProven) {
  using namespace kernel;
  const Point a{0, 0}, b{1, 0}, c{0, 1}, d{0.2, 0.2};
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), HUGE_VAL, -HUGE_VAL}) {
    for (const Point p : {Point{bad, bad}, Point{bad, 0.3}, Point{0.3, bad}}) {
      EXPECT_EQ(cross_filter(a, {1, 1}, a, p), 0);
      EXPECT_EQ(incircle_filter(a, b, c, p), 0);
      EXPECT_EQ(incircle_filter(p, b, c, d), 0);
      EXPECT_EQ(incircle_filter(a, p, c, d), 0);
      EXPECT_EQ(incircle_filter(a, b, p, d), 0);
      EXPECT_EQ(pair_filter({a, b, c, p}, {a, b, c, d}).proven[0], 0);
      EXPECT_EQ(pair_filter({p, b, c, d}, {a, b, p, d}).proven[1], 0);
      EXPECT_NE(pair_filter({a, b, c, p}, {a, b, c, d}).proven[1], 0);
    }
  }
}

TEST(Predicates, SymmetryLaws) {
  for (const Family& family : families()) {
    Random random(11);
    SCOPED_TRACE(family.name + ", seed 11");
    for (int i = 0; i < 300; ++i) {
      const auto [a, b, c, d] = family.make(random);
      const int turn = orient2d(a, b, c);
      ASSERT_EQ(orient2d(b, c, a), turn);
      ASSERT_EQ(orient2d(b, a, c), -turn);
      ASSERT_EQ(orient2d(a, b, b), 0);
      const int circle = incircle(a, b, c, d);
      ASSERT_EQ(incircle(b, a, c, d), -circle);
      ASSERT_EQ(incircle(a, c, b, d), -circle);
      ASSERT_EQ(incircle(a, b, d, c), -circle);
      ASSERT_EQ(incircle(b, c, d, a), -circle);
      ASSERT_EQ(incircle(c, d, a, b), circle);
      ASSERT_EQ(incircle(d, a, b, c), -circle);
      ASSERT_EQ(incircle(a, b, c, c), 0);
      const int cross = cross_sign(a, b, c, d);
      ASSERT_EQ(cross_sign(c, d, a, b), -cross);
      ASSERT_EQ(cross_sign(b, a, c, d), -cross);
      ASSERT_EQ(dot_sign(c, d, a, b), dot_sign(a, b, c, d));
      ASSERT_EQ(dot_sign(b, a, c, d), -dot_sign(a, b, c, d));
    }
  }
}

TEST(Predicates, ExactMaps) {
  const auto quarter = [](Point p) { return Point{-p.y, p.x}; };
  const auto mirror = [](Point p) { return Point{-p.x, p.y}; };
  for (const Family& family : families()) {
    Random random(13);
    SCOPED_TRACE(family.name + ", seed 13");
    for (int i = 0; i < 300; ++i) {
      const auto [a, b, c, d] = family.make(random);
      const int turn = orient2d(a, b, c), circle = incircle(a, b, c, d);
      ASSERT_EQ(orient2d(quarter(a), quarter(b), quarter(c)), turn);
      ASSERT_EQ(incircle(quarter(a), quarter(b), quarter(c), quarter(d)), circle);
      ASSERT_EQ(orient2d(mirror(a), mirror(b), mirror(c)), -turn);
      ASSERT_EQ(incircle(mirror(a), mirror(b), mirror(c), mirror(d)), -circle);
    }
  }
  // Powers of two: the same signs in every tier's range.
  for (int e = -1000; e <= 1000; e += 50) {
    const auto at = [e](double x, double y) { return Point{std::ldexp(x, e), std::ldexp(y, e)}; };
    EXPECT_EQ(orient2d(at(0, 0), at(3, 1), at(6, 2)), 0) << e;
    EXPECT_EQ(orient2d(at(0, 0), at(3, 1), at(6, 2 + 0x1p-50)), 1) << e;
    EXPECT_EQ(incircle(at(0, 0), at(3, 0), at(3, 1), at(0, 1)), 0) << e;
    EXPECT_EQ(incircle(at(0, 0), at(3, 0), at(3, 1), at(0, 1 - 0x1p-53)), 1) << e;
    EXPECT_EQ(incircle(at(0, 0), at(3, 0), at(3, 1), at(0, 1 + 0x1p-52)), -1) << e;
  }
}

}  // namespace
}  // namespace quadloom
