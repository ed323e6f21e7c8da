// Point sets large enough for rounds in ranges of the curve: the same bytes on any number of threads,
// and Delaunay, which their triangles are in one way only.
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "core/random.hpp"
#include "kernel/delaunay_builder.hpp"
#include "kernel/delaunay_in_order.hpp"
#include "kernel/input_points.hpp"
#include "quadloom/generate.hpp"
#include "quadloom/kernel.hpp"
#include "support/delaunay_checks.hpp"
#include "support/on_threads.hpp"

namespace quadloom {
namespace {

constexpr std::size_t kMany = 90000;

/// Shuffled, and some of them repeated.
std::vector<Point> many_points(const std::string& kind, std::uint64_t seed) {
  std::vector<Point> points = generate_points(kind, kMany, seed);
  Random random(seed);
  for (int i = 0; i < 500; ++i) points.push_back(points[random.below(kMany)]);
  for (std::size_t i = points.size(); i > 1; --i) std::swap(points[i - 1], points[random.below(i)]);
  return points;
}

const std::vector<std::string> kKinds = {"uniform", "clusters", "grid",      "rotated-grid",
                                         "circle",  "lines",    "near-line", "collinear-but-one",
                                         "decades", "offset"};

TEST(DelaunayThreads, TheSameBytes) {
  for (const std::string& kind : kKinds) {
    SCOPED_TRACE(kind + " 90500, seed 1");
    const std::vector<Point> points = many_points(kind, 1);
    const DelaunayResult one = on_threads(1, [&] { return delaunay(points); });
    const kernel::DelaunayInOrder one_in_order =
        on_threads(1, [&] { return kernel::delaunay_in_order(points); });
    for (const int threads : {2, 4}) {
      const DelaunayResult more = on_threads(threads, [&] { return delaunay(points); });
      ASSERT_EQ(more.mesh.points, one.mesh.points);
      ASSERT_EQ(more.mesh.tri_vertex, one.mesh.tri_vertex);
      ASSERT_EQ(more.mesh.twin, one.mesh.twin);
      ASSERT_EQ(more.input_to_vertex, one.input_to_vertex);
      const kernel::DelaunayInOrder in_order =
          on_threads(threads, [&] { return kernel::delaunay_in_order(points); });
      ASSERT_EQ(in_order.mesh.points, one_in_order.mesh.points);
      ASSERT_EQ(in_order.mesh.tri_vertex, one_in_order.mesh.tri_vertex);
      ASSERT_EQ(in_order.mesh.twin, one_in_order.mesh.twin);
      ASSERT_EQ(in_order.vertex, one_in_order.vertex);
    }
  }
}

TEST(DelaunayThreads, TheTrianglesAreDelaunay) {
  for (const std::string& kind : kKinds) {
    SCOPED_TRACE(kind + " 90500, seed 2");
    const std::vector<Point> points = many_points(kind, 2);
    const DelaunayResult result = delaunay(points);
    ASSERT_NO_FATAL_FAILURE(expect_delaunay(points, result));
    ASSERT_EQ(triangle_set(kernel::delaunay_in_order(points).mesh), triangle_set(result.mesh));
  }
}

/// How many of the points are put off.
std::size_t put_off(const std::vector<Point>& points) {
  kernel::DelaunayBuilder builder(kernel::gather(points, spatial_order(points)));
  EXPECT_TRUE(builder.build());
  return builder.put_off();
}

// Few points reach out of their range, the fewer the more there are.
TEST(DelaunayThreads, FewPointsArePutOff) {
  struct Few {
    const char* kind;
    std::size_t points, most, least;  // how many are put off: one in so many
  };
  for (const Few& few : {Few{"uniform", kMany, 9, 13}, Few{"uniform", 1000000, 25, 33},
                         Few{"clusters", 1000000, 21, 28}, Few{"grid", 1000000, 25, 33}}) {
    SCOPED_TRACE(::testing::Message() << few.kind << " " << few.points);
    const std::size_t some = put_off(generate_points(few.kind, few.points, 4));
    EXPECT_LT(some, few.points / few.most);
    EXPECT_GT(some, few.points / few.least);
  }
}

// On rows most points are put off.
TEST(DelaunayThreads, OnRowsMostPointsArePutOff) {
  for (const char* kind : {"circle", "lines", "cross", "collinear-but-one"}) {
    SCOPED_TRACE(kind);
    EXPECT_GT(put_off(distinct_points(generate_points(kind, kMany, 4)).points), kMany / 2);
  }
}

}  // namespace
}  // namespace quadloom
