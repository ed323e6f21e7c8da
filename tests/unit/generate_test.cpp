#include "quadloom/generate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <set>
#include <string>

#include "generate/elementary.hpp"
#include "quadloom/kernel.hpp"

namespace quadloom {
namespace {

std::uint64_t bits_hash(const std::vector<Point>& points) {
  std::uint64_t h = 1469598103934665603U;
  for (const Point& p : points) {
    for (const double v : {p.x, p.y}) h = (h ^ std::bit_cast<std::uint64_t>(v)) * 1099511628211U;
  }
  return h;
}

std::size_t count_distinct(std::vector<Point> points) {
  std::sort(points.begin(), points.end(), lex_less);
  return static_cast<std::size_t>(std::unique(points.begin(), points.end()) - points.begin());
}

bool all_collinear(const std::vector<Point>& points) {
  const auto other =
      std::find_if(points.begin(), points.end(), [&](const Point& p) { return !(p == points[0]); });
  if (other == points.end()) return true;
  return std::all_of(points.begin(), points.end(),
                     [&](const Point& p) { return orient2d(points[0], *other, p) == 0; });
}

TEST(Generate, EveryKindGivesAboutNFinitePointsNotAllOnALine) {
  for (const Generator& g : generators()) {
    for (const std::size_t n :
         {g.min_points, g.min_points + 4, std::size_t{50}, std::size_t{1000}}) {
      for (const std::uint64_t seed : {1U, 2U, 3U}) {
        SCOPED_TRACE(std::string(g.name) + " n=" + std::to_string(n) +
                     " seed=" + std::to_string(seed));
        const auto points = generate_points(g.name, n, seed);
        const double off = std::abs(static_cast<double>(points.size()) - static_cast<double>(n));
        EXPECT_LE(off, std::max(2.0, std::sqrt(static_cast<double>(n))));
        EXPECT_GE(points.size(), 3U);
        EXPECT_TRUE(std::all_of(points.begin(), points.end(), [](const Point& p) {
          return std::isfinite(p.x) && std::isfinite(p.y);
        }));
        EXPECT_FALSE(all_collinear(points));
        const std::size_t distinct = count_distinct(points);
        if (g.name == "duplicates") {
          EXPECT_EQ(distinct, std::max<std::size_t>(3, n / 3));
        } else {
          EXPECT_EQ(distinct, points.size());
        }
      }
    }
  }
}

TEST(Generate, TheSameSeedGivesTheSamePointsAndAnotherOneOthers) {
  EXPECT_EQ(generate_points("uniform", 100, 7), generate_points("uniform", 100, 7));
  EXPECT_NE(generate_points("uniform", 100, 7), generate_points("uniform", 100, 8));
}

// The bits of the kinds that use a series or a root: a change on any platform shows here.
TEST(Generate, BitsAreTheSameOnEveryPlatform) {
  const std::pair<const char*, std::uint64_t> known[] = {
      {"gaussian", 226140302874165858U},      {"towns-like", 14989827960725250026U},
      {"rotated-grid", 2217663215442720208U}, {"hex-grid", 10513079416008960187U},
      {"circle", 4683287888933853074U},       {"spiral", 11534805168987898339U},
      {"decades", 8327736933759463760U},      {"bhrs-ring", 4449207414986010052U},
      {"ahms-nine", 2160158114291154572U}};
  for (const auto& [kind, hash] : known) {
    EXPECT_EQ(bits_hash(generate_points(kind, 500, 1)), hash) << kind;
  }
}

TEST(Generate, NamesWhatIsThereWhenAKindIsUnknown) {
  try {
    generate_points("squares", 10);
    FAIL();
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), ErrorCode::kBadOption);
    EXPECT_NE(std::string(e.what()).find("rotated-grid"), std::string::npos);
  }
  for (const Generator& g : generators()) {
    EXPECT_THROW(generate_points(g.name, g.min_points - 1), Error) << g.name;
  }
  EXPECT_THROW(generate_points("uniform", kMaxPoints + 1), Error);
}

TEST(Generate, CocircularIsExactlyCocircular) {
  const auto points = generate_points("cocircular", 3000);
  ASSERT_EQ(points.size(), 3000U);
  for (std::size_t i = 3; i < points.size(); ++i) {
    ASSERT_EQ(incircle(points[0], points[1], points[2], points[i]), 0) << i;
  }
  EXPECT_EQ(generate_points("cocircular", 1000000).size(), 995328U);
}

TEST(Generate, ConvexHasStrictCornersOnly) {
  for (const std::size_t n : {3U, 4U, 5U, 12U, 101U, 2000U}) {
    auto points = generate_points("convex", n, 5);
    ASSERT_EQ(points.size(), n);
    // By angle about the lexicographically smallest point, decided exactly.
    std::iter_swap(points.begin(), std::min_element(points.begin(), points.end(), lex_less));
    std::sort(points.begin() + 1, points.end(),
              [&](Point a, Point b) { return orient2d(points[0], a, b) > 0; });
    for (std::size_t i = 0; i < n; ++i) {
      ASSERT_EQ(orient2d(points[i], points[(i + 1) % n], points[(i + 2) % n]), 1) << n << " " << i;
    }
  }
}

TEST(Generate, LinesAreExactlyStraight) {
  const auto points = generate_points("lines", 1000, 3);
  for (std::size_t i = 10; i < points.size(); ++i) {
    ASSERT_EQ(orient2d(points[i % 5], points[i % 5 + 5], points[i]), 0) << i;
  }
}

// The defining property of theorem 4.1: A, B, C turn left, and every other point is right of exactly two
// of their lines, D, E, F, G, H, I of those that the theorem says; the others are on the hull.
TEST(Generate, AhmsNineHasItsDefiningProperty) {
  for (const std::size_t n : {9U, 10U, 11U, 12U, 31U, 1000U}) {
    const auto p = generate_points("ahms-nine", n);
    ASSERT_EQ(p.size(), n);
    EXPECT_EQ(orient2d(p[0], p[1], p[2]), 1);
    const auto right_of = [&](std::size_t i) {
      std::string lines;
      for (std::size_t k = 0; k < 3; ++k) {
        if (orient2d(p[k], p[(k + 1) % 3], p[i]) < 0) lines += "ABC"[k];
      }
      return lines;
    };
    const std::string wanted[] = {"AC", "AB", "AB", "BC", "BC", "AC"};  // D, E, F, G, H, I
    for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(right_of(3 + i), wanted[i]) << i;
    for (std::size_t i = 3; i < n; ++i) EXPECT_EQ(right_of(i).size(), 2U) << i;
    const auto hull = convex_hull(p);
    EXPECT_EQ(hull.size(), n - 3);
    // No other point on the arcs E-F, G-H, I-D.
    for (std::size_t i = 0; i < hull.size(); ++i) {
      const VertexId next = hull[(i + 1) % hull.size()];
      if (hull[i] == 4) {
        EXPECT_EQ(next, 5U);
      }
      if (hull[i] == 6) {
        EXPECT_EQ(next, 7U);
      }
      if (hull[i] == 8) {
        EXPECT_EQ(next, 3U);
      }
    }
  }
}

TEST(Generate, CollinearButOneIsWhatItSays) {
  auto points = generate_points("collinear-but-one", 200);
  EXPECT_FALSE(all_collinear(points));
  points.pop_back();
  EXPECT_TRUE(all_collinear(points));
}

TEST(Generate, NearLineHasBothTurnsAndIsNearlyStraight) {
  const auto points = generate_points("near-line", 1000, 1);
  std::set<int> turns;
  for (std::size_t i = 2; i < points.size(); ++i) {
    turns.insert(orient2d(points[0], points[1], points[i]));
    EXPECT_NEAR(points[i].y, points[i].x / 3, 1e-15);
  }
  EXPECT_TRUE(turns.contains(1) && turns.contains(-1));
}

TEST(Generate, DecadesCoverEighteen) {
  double low = 1, high = 1;
  for (const Point& p : generate_points("decades", 10000, 1)) {
    low = std::min(low, std::fabs(p.x));
    high = std::max(high, std::fabs(p.x));
  }
  EXPECT_LT(low, 1.1e-9);
  EXPECT_GT(high, 9e8);
}

TEST(Generate, BhrsLineHasAHullOfFour) {
  const auto points = generate_points("bhrs-line", 43);
  ASSERT_EQ(points.size(), 43U);
  const Point first = points[0], last = points[40], top = points[41], bottom = points[42];
  for (std::size_t i = 1; i < 40; ++i) {
    EXPECT_EQ(orient2d(first, last, points[i]), 0);
    EXPECT_EQ(orient2d(first, bottom, points[i]), 1);
    EXPECT_EQ(orient2d(bottom, last, points[i]), 1);
    EXPECT_EQ(orient2d(last, top, points[i]), 1);
    EXPECT_EQ(orient2d(top, first, points[i]), 1);
  }
}

TEST(Generate, BhrsRingFulfilsThePapersConditions) {
  for (const std::size_t k : {3U, 4U, 5U, 6U, 37U, 1000U, 200000U}) {
    const auto points = generate_points("bhrs-ring", 2 * k);
    ASSERT_EQ(points.size(), 2 * k);
    const auto a = [&](std::size_t i) { return points[i % k]; };
    for (std::size_t i = 0; i < k; ++i) {
      const Point b = points[k + i];
      ASSERT_EQ(orient2d(a(i), a(i + 1), a(i + 2)), 1) << k << " " << i;
      ASSERT_EQ(orient2d(a(i), a(i + 1), b), 1) << k << " " << i;
      ASSERT_EQ(orient2d(a(i), b, a(i + 2)), 1) << k << " " << i;
      ASSERT_EQ(orient2d(a(i + 1), b, a(i + k - 1)), -1) << k << " " << i;
    }
  }
}

TEST(Elementary, AgreesWithTheLibraryToAFewUnits) {
  using namespace generate;
  for (double t = -2; t < 2; t += 0.00137) {
    const Point p = on_unit_circle(t);
    EXPECT_NEAR(p.x, std::cos(2 * std::numbers::pi * t), 3e-15) << t;
    EXPECT_NEAR(p.y, std::sin(2 * std::numbers::pi * t), 3e-15) << t;
    EXPECT_NEAR(power_of_two(40 * t) / std::exp2(40 * t), 1, 1e-15) << t;
    EXPECT_NEAR(natural_log(std::exp2(40 * t)) / (40 * t * std::numbers::ln2), 1, 1e-14) << t;
  }
  EXPECT_EQ(on_unit_circle(0.25), (Point{0, 1}));
  EXPECT_EQ(on_unit_circle(-0.5), (Point{-1, 0}));
}

}  // namespace
}  // namespace quadloom
