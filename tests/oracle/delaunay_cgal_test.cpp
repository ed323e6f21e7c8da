// The same triangles as CGAL's, cocircular ties included: CGAL perturbs by the same rule.
#include <CGAL/Delaunay_triangulation_2.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "core/random.hpp"
#include "quadloom/generate.hpp"
#include "quadloom/kernel.hpp"
#include "support/cgal_triangles.hpp"
#include "support/delaunay_checks.hpp"

namespace quadloom {
namespace {

using Cgal = CGAL::Delaunay_triangulation_2<CgalKernel>;

TriangleSet cgal_triangles(const std::vector<Point>& points) {
  std::vector<CgalKernel::Point_2> input;
  for (const Point& p : points) input.emplace_back(p.x, p.y);
  const Cgal cgal(input.begin(), input.end());
  return finite_triangles(cgal);
}

TEST(DelaunayAgainstCgal, EveryGenerator) {
  for (const Generator& g : generators()) {
    for (const std::size_t n : {10UL, 50UL, 500UL, 20000UL}) {
      SCOPED_TRACE(std::string(g.name) + " " + std::to_string(n) + ", seed 9");
      const std::vector<Point> points = generate_points(g.name, n, 9);
      ASSERT_EQ(triangle_set(delaunay(points).mesh), cgal_triangles(points));
    }
  }
}

TEST(DelaunayAgainstCgal, RandomSubsetsOfGrids) {
  for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    std::vector<Point> points = {{0, 0}, {1, 0}, {0, 1}};
    const std::uint64_t width = 2 + random.below(12), count = random.below(80);
    for (std::uint64_t i = 0; i < count; ++i) {
      points.push_back(
          {static_cast<double>(random.below(width)), static_cast<double>(random.below(width))});
    }
    ASSERT_EQ(triangle_set(delaunay(points).mesh), cgal_triangles(points));
  }
}

}  // namespace
}  // namespace quadloom
