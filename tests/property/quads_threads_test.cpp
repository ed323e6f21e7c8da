// Point sets large enough for walks and slides in ranges of the faces: the same bytes on any number of threads, certified.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "quadloom/quadloom.hpp"
#include "quadrangulate/face_range.hpp"
#include "support/on_threads.hpp"

namespace quadloom {
namespace {

constexpr std::size_t kMany = 140'000;

TEST(QuadsThreads, TheSetsAreLargeEnoughForRanges) {
  EXPECT_GT(quadrangulate::face_ranges(kMany).size(), 2U);
  EXPECT_TRUE(quadrangulate::face_ranges(100'000).empty());
}

TEST(QuadsThreads, RangesAreAllFacesOnce) {
  std::size_t next = 0;
  for (const quadrangulate::FaceRange& range : quadrangulate::face_ranges(kMany)) {
    EXPECT_EQ(range.begin, next);
    EXPECT_FALSE(range.is_all());
    EXPECT_TRUE(range.has(range.begin));
    EXPECT_FALSE(range.has(range.end));
    next = range.end;
  }
  EXPECT_EQ(next, kMany);
}

TEST(QuadsThreads, TheSameBytes) {
  for (const char* kind : {"uniform", "jittered-grid", "towns-like"}) {
    SCOPED_TRACE(std::string(kind) + " 140,000, seed 3");
    const std::vector<Point> points = generate_points(kind, kMany, 3);
    const PointResult one = on_threads(1, [&] { return quadrangulate_points(points); });
    EXPECT_TRUE(certify_points(to_polygon_mesh(one.mesh), points).ok());
    EXPECT_FALSE(one.statistics.fell_back_to_spiral);
    for (const int threads : {2, 4}) {
      const PointResult more = on_threads(threads, [&] { return quadrangulate_points(points); });
      ASSERT_EQ(more.mesh.points, one.mesh.points);
      ASSERT_EQ(more.mesh.quad_vertex, one.mesh.quad_vertex);
      ASSERT_EQ(more.mesh.tri_vertex, one.mesh.tri_vertex);
      ASSERT_EQ(more.statistics.walk_steps, one.statistics.walk_steps);
      ASSERT_EQ(more.statistics.slides, one.statistics.slides);
    }
  }
}

TEST(QuadsThreads, TheSameBytesStrictlyConvex) {
  SCOPED_TRACE("uniform 140,000, seed 4");
  const std::vector<Point> points = generate_points("uniform", kMany, 4);
  const ConvexResult one = on_threads(1, [&] { return convex_quadrangulation(points); });
  EXPECT_TRUE(one.not_convex.empty());
  const ConvexResult more = on_threads(4, [&] { return convex_quadrangulation(points); });
  EXPECT_EQ(more.mesh.points, one.mesh.points);
  EXPECT_EQ(more.mesh.quad_vertex, one.mesh.quad_vertex);
}

}  // namespace
}  // namespace quadloom
