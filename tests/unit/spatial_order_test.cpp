#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "core/random.hpp"
#include "kernel/hilbert.hpp"
#include "quadloom/kernel.hpp"

namespace quadloom {
namespace {

TEST(Hilbert, TheCurveVisitsNeighbouringCells) {
  for (const std::uint32_t corner : {0U, 0x5a40U}) {
    std::map<std::uint32_t, std::pair<int, int>> cell_at;
    for (std::uint32_t x = 0; x < 64; ++x) {
      for (std::uint32_t y = 0; y < 64; ++y) {
        cell_at[kernel::hilbert_position(corner + x, corner + y)] = {static_cast<int>(x),
                                                                     static_cast<int>(y)};
      }
    }
    ASSERT_EQ(cell_at.size(), 64U * 64U);
    EXPECT_EQ(cell_at.rbegin()->first - cell_at.begin()->first, 64U * 64U - 1);
    for (auto i = cell_at.begin(), j = std::next(i); j != cell_at.end(); ++i, ++j) {
      ASSERT_EQ(std::abs(i->second.first - j->second.first) +
                    std::abs(i->second.second - j->second.second),
                1);
    }
  }
}

/// A permutation with equal points next to each other, ordered by index.
void expect_spatial_order(const std::vector<Point>& points) {
  const std::vector<VertexId> order = spatial_order(points);
  std::vector<VertexId> sorted = order;
  std::sort(sorted.begin(), sorted.end());
  ASSERT_EQ(sorted.size(), points.size());
  for (VertexId i = 0; i < sorted.size(); ++i) ASSERT_EQ(sorted[i], i);

  std::map<std::pair<double, double>, std::vector<VertexId>> expected;
  for (VertexId i = 0; i < points.size(); ++i) {
    expected[{points[i].x + 0.0, points[i].y + 0.0}].push_back(i);
  }
  for (std::size_t i = 0; i < order.size();) {
    const Point p = points[order[i]];
    for (const VertexId v : expected.at({p.x + 0.0, p.y + 0.0})) ASSERT_EQ(order[i++], v);
  }
}

std::vector<Point> sample(std::size_t n, std::uint64_t seed, double (*coordinate)(Random&)) {
  Random random(seed);
  std::vector<Point> points(n);
  for (Point& p : points) {
    p.x = coordinate(random);
    p.y = coordinate(random);
  }
  return points;
}

double any_exponent(Random& r) {
  const double m = r.uniform() - 0.5;
  return std::ldexp(m, static_cast<int>(r.below(2098)) - 1074);
}

TEST(SpatialOrder, IsAPermutationWithEqualPointsTogether) {
  expect_spatial_order({});
  expect_spatial_order({{1, 2}});
  expect_spatial_order({{1, 2}, {1, 2}});
  expect_spatial_order(std::vector<Point>(5000, Point{3, 4}));
  expect_spatial_order({{0.0, -0.0}, {1, 1}, {-0.0, 0.0}, {0.0, 0.0}});
  for (const std::size_t n : {10UL, 100UL, 6000UL}) {
    SCOPED_TRACE("n " + std::to_string(n) + ", seed 3");
    expect_spatial_order(sample(n, 3, [](Random& r) { return r.uniform(); }));
    expect_spatial_order(sample(n, 3, [](Random& r) { return static_cast<double>(r.below(20)); }));
    expect_spatial_order(sample(n, 3, any_exponent));
    expect_spatial_order(
        sample(n, 3, [](Random& r) { return 0x1p-1074 * static_cast<double>(r.below(40)); }));
    expect_spatial_order(sample(n, 3, [](Random& r) { return r.below(2) ? 1.7e308 : -1.7e308; }));
    expect_spatial_order(sample(n, 3, [](Random& r) { return 1.7e308 * (2 * r.uniform() - 1); }));
    // Clusters in clusters: runs of equal keys, and again within them.
    expect_spatial_order(sample(n, 3, [](Random& r) {
      return static_cast<double>(r.below(3)) + 1e-9 * static_cast<double>(r.below(3)) +
             1e-15 * static_cast<double>(r.below(9));
    }));
  }
}

// More points than two digits of the radix sort are used for; cells of a grid, many repeated.
TEST(SpatialOrder, MoreThanAMillionPoints) {
  SCOPED_TRACE("seed 4");
  const std::vector<Point> points =
      sample(1100000, 4, [](Random& r) { return static_cast<double>(r.below(1000)); });
  const std::vector<VertexId> order = spatial_order(points);
  ASSERT_EQ(order.size(), points.size());
  std::vector<bool> seen(points.size()), closed(1000 * 1000);
  std::size_t last_cell = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    ASSERT_FALSE(seen.at(order[i]));
    seen[order[i]] = true;
    const Point p = points[order[i]];
    const std::size_t cell = static_cast<std::size_t>(p.x) * 1000 + static_cast<std::size_t>(p.y);
    ASSERT_FALSE(closed[cell]);
    if (i > 0 && cell == last_cell) {
      ASSERT_LT(order[i - 1], order[i]);
    }
    if (i > 0 && cell != last_cell) closed[last_cell] = true;
    last_cell = cell;
  }
}

/// The length of the path along the order, over the length of a random one.
double path_ratio(const std::vector<Point>& points) {
  const std::vector<VertexId> order = spatial_order(points);
  double path = 0, random = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const auto distance = [](Point p, Point q) { return std::hypot(p.x - q.x, p.y - q.y); };
    path += distance(points[order[i]], points[order[i - 1]]);
    random += distance(points[i], points[i - 1]);
  }
  return path / random;
}

TEST(SpatialOrder, IsLocal) {
  EXPECT_LT(path_ratio(sample(10000, 1, [](Random& r) { return r.uniform(); })), 0.05);
  // All but two of the points are in one cell of the box: the order must be local in there too.
  std::vector<Point> cluster = sample(10000, 1, [](Random& r) { return 1e-12 * r.uniform(); });
  cluster.push_back({1e9, 0});
  cluster.push_back({0, -1e9});
  const std::vector<VertexId> order = spatial_order(cluster);
  std::vector<Point> inside;
  for (const VertexId v : order) {
    if (v < 10000) inside.push_back(cluster[v]);
  }
  double path = 0;
  for (std::size_t i = 1; i < inside.size(); ++i) {
    path += std::hypot(inside[i].x - inside[i - 1].x, inside[i].y - inside[i - 1].y);
  }
  EXPECT_LT(path, 0.05 * 0.52e-12 * 10000);
}

TEST(DistinctPoints, NumbersByFirstOccurrence) {
  const std::vector<Point> input = {{5, 5}, {1, 1}, {5, 5}, {0.0, 1}, {1, 1}, {-0.0, 1}, {7, 0}};
  const DistinctPoints out = distinct_points(input);
  EXPECT_EQ(out.points, (std::vector<Point>{{5, 5}, {1, 1}, {0, 1}, {7, 0}}));
  EXPECT_EQ(out.input_to_vertex, (std::vector<VertexId>{0, 1, 0, 2, 1, 2, 3}));
  EXPECT_TRUE(distinct_points({}).points.empty());
}

TEST(DistinctPoints, ManyRepetitions) {
  SCOPED_TRACE("seed 8");
  const std::vector<Point> input =
      sample(20000, 8, [](Random& r) { return static_cast<double>(r.below(50)); });
  const DistinctPoints out = distinct_points(input);
  std::map<std::pair<double, double>, VertexId> number;
  for (std::size_t i = 0; i < input.size(); ++i) {
    const auto next = static_cast<VertexId>(number.size());
    const VertexId v = number.try_emplace({input[i].x, input[i].y}, next).first->second;
    ASSERT_EQ(out.input_to_vertex[i], v);
    ASSERT_EQ(out.points[v], input[i]);
  }
  EXPECT_EQ(out.points.size(), number.size());
}

TEST(DistinctPoints, NamesTheFirstPointThatIsNotFinite) {
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), HUGE_VAL, -HUGE_VAL}) {
    const std::vector<Point> input = {{0, 0}, {1, 0}, {0, bad}, {bad, 1}};
    try {
      distinct_points(input);
      FAIL();
    } catch (const Error& e) {
      EXPECT_EQ(e.code(), ErrorCode::kNotFinite);
      EXPECT_EQ(e.culprits(), std::vector<std::size_t>{2});
      EXPECT_NE(std::string(e.what()).find("point 2"), std::string::npos);
    }
  }
}

}  // namespace
}  // namespace quadloom
