// Every generator, many seeds and sizes, through every method: certified, and the Delaunay method
// never falls back.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/random.hpp"
#include "support/bad_points.hpp"
#include "support/certified.hpp"

namespace quadloom {
namespace {

/// Six, or what the generator asks for.
std::size_t least_points(const std::string& kind) {
  for (const Generator& g : generators()) {
    if (g.name == kind) return std::max<std::size_t>(6, g.min_points);
  }
  return 6;
}

class EveryGenerator : public ::testing::TestWithParam<std::string> {};

TEST_P(EveryGenerator, EveryMethodKeepsItsPromise) {
  constexpr std::uint64_t kSets = 60;
  for (std::uint64_t seed = 1; seed <= kSets; ++seed) {
    const std::size_t n = least_points(GetParam()) + Random(seed).below(seed % 10 == 0 ? 600 : 60);
    SCOPED_TRACE(GetParam() + ", n = " + std::to_string(n) + ", seed " + std::to_string(seed));
    const std::vector<Point> points = generate_points(GetParam(), n, seed);
    for (const PointMethod method : kAllMethods) {
      if (method == PointMethod::kSubdivide)
        continue;  // needs room between the doubles: tested by itself
      for (const OddBoundary odd : kAllOddBoundaries) {
        quadrangulate_checked(points, {.method = method, .odd_boundary = odd, .seed = seed});
        if (HasFailure()) return;
      }
    }
  }
}

TEST_P(EveryGenerator, DelaunayNeverFallsBackOnAThousandSets) {
  for (std::uint64_t seed = 1001; seed <= 2000; ++seed) {
    const std::size_t n = least_points(GetParam()) + Random(seed).below(seed % 10 == 0 ? 300 : 40);
    SCOPED_TRACE(GetParam() + ", n = " + std::to_string(n) + ", seed " + std::to_string(seed));
    quadrangulate_checked(generate_points(GetParam(), n, seed), {});
    if (HasFailure()) return;
  }
}

// More faces than thorough searches are made for; rows leave tens of thousands of triangles to the far walks.
TEST(LargeSets, DelaunayNeverFallsBack) {
  for (const char* kind : {"uniform", "lines"}) {
    SCOPED_TRACE(std::string(kind) + " 120,000, seed 7");
    quadrangulate_checked(generate_points(kind, 120'000, 7), {});
  }
}

std::vector<std::string> generator_names() {
  std::vector<std::string> names;
  for (const Generator& g : generators()) names.emplace_back(g.name);
  return names;
}
std::string test_name(const ::testing::TestParamInfo<std::string>& info) {
  std::string name = info.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}
INSTANTIATE_TEST_SUITE_P(Points, EveryGenerator, ::testing::ValuesIn(generator_names()), test_name);

std::vector<Point> mapped(std::vector<Point> points, Point (*map)(Point)) {
  std::transform(points.begin(), points.end(), points.begin(), map);
  return points;
}

TEST(Points, ExactMapsKeepThePromise) {
  Point (*const maps[])(Point) = {
      [](Point p) {
        return Point{-p.y, p.x};
      },
      [](Point p) {
        return Point{-p.x, p.y};
      },
      [](Point p) {
        return Point{std::ldexp(p.x, -900), std::ldexp(p.y, -900)};
      },
      [](Point p) {
        return Point{std::ldexp(p.x, 900), std::ldexp(p.y, 900)};
      },
      [](Point p) {
        return Point{std::ldexp(p.x, -1000), std::ldexp(p.y, 600)};
      },
  };
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    for (const char* kind : {"uniform", "grid", "lines", "bhrs-ring"}) {
      SCOPED_TRACE(std::string(kind) + ", seed " + std::to_string(seed));
      const std::vector<Point> points = generate_points(kind, 10 + seed, seed);
      for (const auto map : maps) {
        for (const PointMethod method :
             {PointMethod::kDelaunay, PointMethod::kSpiral, PointMethod::kInsertion}) {
          quadrangulate_checked(mapped(points, map), {.method = method});
          if (HasFailure()) return;
        }
      }
    }
  }
}

TEST(Points, SameInputGivesTheSameMesh) {
  const std::vector<Point> points = generate_points("towns-like", 2000, 3);
  for (const PointMethod method : kAllMethods) {
    const PointResult first = quadrangulate_points(points, {.method = method, .seed = 7});
    const PointResult second = quadrangulate_points(points, {.method = method, .seed = 7});
    EXPECT_EQ(first.mesh.quad_vertex, second.mesh.quad_vertex);
    EXPECT_EQ(first.mesh.points, second.mesh.points);
  }
}

TEST(Points, SquaresOfAGridBecomeTheQuads) {
  const PointResult result = quadrangulate_points(generate_points("grid", 400));
  const Quality quality = measure_quality(to_polygon_mesh(result.mesh));
  EXPECT_EQ(quality.quads, 361U);
  EXPECT_DOUBLE_EQ(quality.min_shape, 1.0);
}

TEST(Points, DuplicatesAreMergedAndMapped) {
  const std::vector<Point> points = {{0, 0}, {2, 0}, {0, 0}, {2, 2}, {0, 2}, {2, 0}, {-0.0, 0.0}};
  const PointResult result = quadrangulate_points(points);
  EXPECT_EQ(result.input_to_vertex, (std::vector<VertexId>{0, 1, 0, 2, 3, 1, 0}));
  EXPECT_EQ(result.mesh.quad_count(), 1U);
}

TEST(Points, BadInputIsRefused) {
  testing::expect_bad_points_refused(
      [](const std::vector<Point>& points) { quadrangulate_points(points); });
}

TEST(Points, ProgressCanStopTheWork) {
  const std::vector<Point> points = generate_points("uniform", 1000, 1);
  for (const PointMethod method : kAllMethods) {
    PointOptions options{.method = method};
    options.progress = [](std::string_view, double) { return false; };
    EXPECT_THROW(quadrangulate_points(points, options), Error);
  }
}

}  // namespace
}  // namespace quadloom
