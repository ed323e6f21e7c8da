// Every simple hexagon, quad, and quad with a point inside on a 5 x 5 grid in strictly convex quads,
// within the bound of its case, certified; and the same squeezed by exact maps.
//
// The environment variable QUADLOOM_EVERY says that every k-th polygon is looked at (1: all of them, as
// scripts/nightly does). The polygons are the same in each run.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <map>
#include <string>

#include "convex/hexagon.hpp"
#include "convex/hexagon_cases.hpp"
#include "core/random.hpp"
#include "support/convex_checks.hpp"
#include "support/grid_polygons.hpp"

namespace quadloom {
namespace {

using Histogram = std::map<std::string, std::size_t>;

constexpr std::uint64_t kSeed = 20261122;

/// True for one of about `k` calls.
class Sample {
 public:
  explicit Sample(std::uint64_t k) : random_(kSeed), every_(k) {
    if (const char* given = std::getenv("QUADLOOM_EVERY")) every_ = std::stoull(given);
  }
  bool next() { return random_.below(every_) == 0; }

 private:
  Random random_;
  std::uint64_t every_;
};

void print(const std::string& title, const Histogram& cases) {
  std::cout << title << " (seed " << kSeed << "):";
  for (const auto& [name, count] : cases) std::cout << "  " << name << " " << count;
  std::cout << "\n";
}

template <std::size_t N>
std::string words(const std::array<Point, N>& ring) {
  std::string out;
  for (const Point p : ring) {
    out += " (" + std::to_string(p.x) + ", " + std::to_string(p.y) + ")";
  }
  return out;
}

std::size_t bound_of(const std::string& case_name) {
  const std::string pattern = case_name.substr(0, 6);
  if (pattern == "cccccc") return 0;
  return pattern == "rccccc" || pattern == "rrcccc" || pattern == "rccrcc" ? 2 : 3;
}

using Map = std::function<Point(Point)>;

template <std::size_t N>
std::array<Point, N> mapped(std::array<Point, N> ring, const Map& map) {
  for (Point& p : ring) p = map(p);
  return ring;
}

Histogram expect_hexagons(int width, std::uint64_t every, const std::vector<Map>& maps) {
  Histogram cases;
  Sample sample(every);
  testing::for_each_grid_polygon<6>(width, [&](const std::array<Point, 6>& plain) {
    if (::testing::Test::HasFailure() || !sample.next()) return;
    for (const Map& map : maps) {
      const std::array<Point, 6> ring = mapped(plain, map);
      SCOPED_TRACE(words(ring));
      const auto patch = convexify_hexagon(ring);
      ASSERT_TRUE(patch.has_value());
      testing::expect_convex_patch(ring, {}, *patch, bound_of(patch->case_name));
      ++cases[patch->case_name];
    }
  });
  return cases;
}

TEST(ConvexHexagon, OnTheFiveByFiveGrid) {
  const Histogram cases = expect_hexagons(5, 20, {[](Point p) { return p; }});
  print("hexagons", cases);
  for (const char* name :
       {"cccccc-0", "rccccc-0", "rccccc-1", "rccccc-2", "rcrccc-1", "rcrccc-3", "rrcccc-2",
        "rccrcc-2", "rcrcrc-1", "rcrcrc-3", "rrcrcc-2", "rrcrcc-3", "rrrccc-3"}) {
    EXPECT_GT(cases.count(name), 0U) << name;
  }
}

TEST(ConvexHexagon, OnTheThreeByThreeGrid) {
  print("hexagons", expect_hexagons(3, 1, {[](Point p) { return p; }}));
}

TEST(ConvexHexagon, Squeezed) {
  const auto squeezed = [](Point p) { return Point{std::ldexp(p.x, -40), p.y}; };
  const auto sheared = [](Point p) { return Point{p.x + 1024 * p.y, p.y}; };
  const auto huge = [](Point p) { return Point{(p.x - 2) * 0x1p1021, (p.y - 2) * 0x1p1021}; };
  const auto tiny = [](Point p) { return Point{p.x * 0x1p-1040, p.y * 0x1p-1040}; };
  const auto far = [](Point p) { return Point{p.x + 0x1p40, p.y - 0x1p40}; };
  const auto slanted = [](Point p) {  // slivers: 2^-44 of their length
    const double e = std::ldexp(p.x, -44);
    return Point{3 * p.y + e, 5 * p.y - e};
  };
  print("hexagons, mapped", expect_hexagons(5, 500, {squeezed, sheared, huge, tiny, far, slanted}));
}

/// A corner of the grid, moved by at most two steps of its doubles in x and in y.
TEST(ConvexHexagon, NearlyFlatCorners) {
  Random random(kSeed);
  const auto moved = [&](double v) {
    for (std::uint64_t steps = random.below(3); steps > 0; --steps) {
      v = std::nextafter(v, random.below(2) == 0 ? -9 : 9);
    }
    return v;
  };
  std::size_t placed = 0, not_placed = 0, not_simple = 0;
  Sample sample(300);
  testing::for_each_grid_polygon<6>(5, [&](const std::array<Point, 6>& plain) {
    if (HasFailure() || !sample.next()) return;
    const auto ring = mapped(plain, [&](Point p) { return Point{moved(p.x + 3), moved(p.y + 3)}; });
    SCOPED_TRACE(words(ring));
    try {
      const auto patch = convexify_hexagon(ring);
      ++(patch ? placed : not_placed);
      if (patch) testing::expect_convex_patch(ring, {}, *patch, bound_of(patch->case_name));
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kBadPolygon);
      ++not_simple;
    }
  });
  std::cout << "nearly flat (seed " << kSeed << "): placed " << placed << ", not placed "
            << not_placed << ", not simple " << not_simple << "\n";
  EXPECT_GT(placed, 1000U);
  EXPECT_LT(not_placed, placed / 100);
}

/// The paper's first cuts, each in the middle of its region, are enough wherever no fewer points than
/// the case's bound do.
TEST(ConvexHexagon, CutAsInThePaper) {
  std::size_t cut = 0;
  testing::for_each_grid_polygon<6>(4, [&](const std::array<Point, 6>& ring) {
    if (HasFailure()) return;
    SCOPED_TRACE(words(ring));
    convex::Hexagon hexagon;
    for (std::uint32_t i = 0; i < 6; ++i) hexagon[i] = {ring[i], i};
    const auto bound = static_cast<std::size_t>(convex::most_points(convex::pattern_of(hexagon)));
    const auto patch = convex::patch_hexagon(ring);
    ASSERT_TRUE(patch.has_value());
    if (patch->steiner.size() < 2 || patch->steiner.size() < bound) return;
    EXPECT_TRUE(patch->as_in_paper);
    ++cut;
  });
  EXPECT_GT(cut, 10'000U);
}

/// A triangle A, B, C around a triangle A, D, E with the same corner A: what is between them is a
/// hexagon that touches itself.
TEST(ConvexHexagon, ThatTouchesItself) {
  std::vector<std::array<Point, 3>> triangles;
  testing::for_each_grid_polygon<3>(6, [&](const std::array<Point, 3>& t) {
    for (std::size_t i = 0; i < 3; ++i) triangles.push_back({t[i], t[(i + 1) % 3], t[(i + 2) % 3]});
  });
  Histogram cases;
  for (const auto& [a, b, c] : triangles) {
    const auto inside = [a = a, b = b, c = c](Point p) {
      return orient2d(a, b, p) > 0 && orient2d(b, c, p) > 0 && orient2d(c, a, p) > 0;
    };
    for (const auto& [hole, d, e] : triangles) {
      if (hole != a || !inside(d) || !inside(e)) continue;
      const std::array<Point, 6> ring = {a, b, c, a, e, d};
      SCOPED_TRACE(words(ring));
      const auto patch = convex::patch_hexagon(ring);
      ASSERT_TRUE(patch.has_value());
      PolygonMesh mesh;
      mesh.points = {a, b, c, e, d};
      mesh.points.insert(mesh.points.end(), patch->steiner.begin(), patch->steiner.end());
      for (const auto& quad : patch->quads) {
        std::array<VertexId, 4> face;
        for (std::size_t i = 0; i < 4; ++i) face[i] = quad[i] == 3 ? 0 : quad[i] - (quad[i] > 3);
        mesh.add_face(face);
      }
      const Polygon polygon{{{a, b, c}, {a, d, e}}};
      CertifyOptions wanted;
      wanted.strictly_convex = wanted.steiner_inside = true;
      const Certificate certificate = certify_polygons(mesh, {&polygon, 1}, {}, wanted);
      EXPECT_TRUE(certificate.ok()) << certificate.sentence;
      ++cases[std::to_string(certificate.steiner)];
      if (HasFailure()) return;
    }
  }
  print("hexagons that touch themselves, by Steiner points", cases);
  EXPECT_FALSE(cases.empty());
}

TEST(ConvexQuad, EveryOneOnTheFiveByFiveGrid) {
  Histogram cases;
  testing::for_each_grid_polygon<4>(5, [&](const std::array<Point, 4>& ring) {
    if (HasFailure()) return;
    SCOPED_TRACE(words(ring));
    const auto patch = convexify_quad(ring);
    ASSERT_TRUE(patch.has_value());
    testing::expect_convex_patch(ring, {}, *patch, 4);
    ++cases[patch->case_name];
  });
  print("quads", cases);
  EXPECT_EQ(cases.size(), 2U);
}

TEST(ConvexQuad, WithEveryInnerPointOfTheFiveByFiveGrid) {
  Histogram cases;
  Sample sample(1);
  testing::for_each_grid_polygon<4>(5, [&](const std::array<Point, 4>& ring) {
    for (int i = 0; i < 25; ++i) {
      if (HasFailure() || !sample.next()) continue;
      const Point inner{static_cast<double>(i / 5), static_cast<double>(i % 5)};
      SCOPED_TRACE(words(ring) + " and" + words(std::array{inner}));
      try {
        const auto patch = convexify_quad_with_point(ring, inner);
        ASSERT_TRUE(patch.has_value());
        testing::expect_convex_patch(ring, {&inner, 1}, *patch, 3);
        ++cases[patch->case_name];
      } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::kBadPolygon);  // not inside
        ++cases["not inside"];
      }
    }
  });
  print("quads with a point", cases);
  EXPECT_EQ(cases.size(), 2U);
}

TEST(ConvexHexagon, RefusesWhatIsNotSimple) {
  const auto code_of = [](const std::array<Point, 6>& ring) {
    try {
      convexify_hexagon(ring);
    } catch (const Error& error) {
      return error.code();
    }
    return ErrorCode::kFile;
  };
  const std::array<Point, 6> good = {{{0, 0}, {2, 0}, {4, 0}, {4, 2}, {2, 3}, {0, 2}}};
  EXPECT_EQ(code_of(good), ErrorCode::kFile);
  auto bad = good;
  bad[2].x = std::nan("");
  EXPECT_EQ(code_of(bad), ErrorCode::kNotFinite);
  bad = good;
  std::swap(bad[3], bad[4]);
  EXPECT_EQ(code_of(bad), ErrorCode::kBadPolygon);
  std::array<Point, 6> clockwise;
  std::reverse_copy(good.begin(), good.end(), clockwise.begin());
  EXPECT_EQ(code_of(clockwise), ErrorCode::kBadPolygon);
  bad = good;
  bad[2] = {1, 0};  // goes back along an edge
  EXPECT_EQ(code_of(bad), ErrorCode::kBadPolygon);
}

}  // namespace
}  // namespace quadloom
