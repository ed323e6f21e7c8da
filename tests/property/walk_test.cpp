// Walks and slides on paired meshes.
#include "quadrangulate/walk.hpp"

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "quadrangulate/diagonal_slides.hpp"
#include "support/paired_checks.hpp"

namespace quadloom::quadrangulate {
namespace {

PairedMesh unpaired(const std::vector<Point>& points) {
  Triangulation tri = delaunay(points).mesh;
  const std::size_t count = tri.triangle_count();
  return {std::move(tri), std::vector<HalfedgeId>(count, kNone)};
}

/// Pairs triangles in random order, whatever the shape; returns how many stay free.
std::size_t pair_at_random(PairedMesh& mesh, Random& random) {
  std::size_t free = mesh.mate.size();
  for (std::size_t i = 0; i < 2 * mesh.tri.twin.size(); ++i) {
    const auto h = static_cast<HalfedgeId>(random.below(mesh.tri.twin.size()));
    const HalfedgeId twin = mesh.tri.twin[h];
    if (twin == kNone || !mesh.is_free(triangle_of(h)) || !mesh.is_free(triangle_of(twin)))
      continue;
    mesh.pair(h);
    free -= 2;
  }
  return free;
}

std::size_t non_convex(const PairedMesh& mesh) {
  const Quality quality = measure_quality(to_polygon_mesh(to_quadrangulation(mesh)));
  return quality.flat_cornered + quality.non_convex;
}

double total_shape(const PairedMesh& mesh) {
  const Quality quality = measure_quality(to_polygon_mesh(to_quadrangulation(mesh)));
  return quality.mean_shape * static_cast<double>(quality.quads);
}

TEST(Walk, BringsRandomLeftOversTogetherAndKeepsTheMeshInOrder) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    for (const char* kind : {"uniform", "grid", "lines", "bhrs-line", "duplicates"}) {
      SCOPED_TRACE(std::string(kind) + ", seed " + std::to_string(seed));
      Random random(seed);
      PairedMesh mesh = unpaired(generate_points(kind, 5 + random.below(80), seed));
      std::size_t free = pair_at_random(mesh, random);
      Walker walker(mesh);
      for (TriangleId t = 0; t < mesh.mate.size() && free >= 2; ++t) {
        if (!mesh.is_free(t)) continue;
        ASSERT_TRUE(walker.merge(t, {WalkQuads::kAny, kNone, 16}));
        free -= 2;
        testing::check_paired_mesh(mesh, free);
        if (::testing::Test::HasFailure()) return;
      }
      EXPECT_LE(free, 1U);
    }
  }
}

TEST(Walk, LeavesOnlyConvexQuadsWhenAskedTo) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    PairedMesh mesh = unpaired(generate_points("uniform", 200, seed));
    Random random(seed);
    pair_at_random(mesh, random);
    const std::size_t before = non_convex(mesh);
    Walker walker(mesh);
    for (TriangleId t = 0; t < mesh.mate.size(); ++t) {
      if (mesh.is_free(t)) walker.merge(t, {WalkQuads::kStrictlyConvex, 400, 1});
    }
    EXPECT_GT(walker.walks(), 0U);
    EXPECT_LE(non_convex(mesh), before);
  }
}

//     3           The free triangle 0 1 3 is wrapped by the quad 1 2 3 ... about the inner point;
//     it can only turn
//    /|.          the wheel to get out.
//   / 4 .
//  0-----2
TEST(Walk, TurnsAWheelAboutAnInnerPoint) {
  const std::vector<Point> points = {{0, 0}, {4, 0}, {2, 4}, {2, 1}, {5, 5}, {0, 5}};
  PairedMesh mesh = unpaired(points);
  Random random(5);
  for (int round = 0; round < 200; ++round) {
    std::fill(mesh.mate.begin(), mesh.mate.end(), kNone);
    std::size_t free = pair_at_random(mesh, random);
    Walker walker(mesh);
    for (TriangleId t = 0; t < mesh.mate.size() && free >= 2; ++t) {
      if (!mesh.is_free(t)) continue;
      ASSERT_TRUE(walker.merge(t, {WalkQuads::kAny, kNone, 16}));
      free -= 2;
    }
    testing::check_paired_mesh(mesh, free);
  }
}

TEST(Walk, ReachesTheBoundary) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    PairedMesh mesh = unpaired(generate_points("uniform", 50, seed));
    const std::size_t free = pair_at_random(mesh, random);
    if (free == 0) continue;
    TriangleId start = 0;
    while (!mesh.is_free(start)) ++start;
    Walker walker(mesh);
    const HalfedgeId end = walker.reach_boundary(
        {&start, 1},
        {[](VertexId, VertexId, VertexId) { return 1; }, [](VertexId, VertexId) { return true; }},
        {WalkQuads::kAny, kNone, 4});
    ASSERT_NE(end, kNone);
    EXPECT_EQ(mesh.tri.twin[end], kNone);
    EXPECT_TRUE(mesh.is_free(triangle_of(end)));
    testing::check_paired_mesh(mesh, free);
  }
}

TEST(Slides, ImproveTheShapesAndKeepTheMeshInOrder) {
  std::size_t slides = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    for (const char* kind : {"uniform", "grid", "lines", "bhrs-ring"}) {
      SCOPED_TRACE(std::string(kind) + ", seed " + std::to_string(seed));
      Random random(seed);
      PairedMesh mesh = unpaired(generate_points(kind, 40, seed));
      const std::size_t free = pair_at_random(mesh, random);
      const std::size_t bad = non_convex(mesh);
      const double shape = total_shape(mesh);
      slides += slide_diagonals(mesh);
      testing::check_paired_mesh(mesh, free);
      EXPECT_LE(non_convex(mesh), bad);
      if (non_convex(mesh) == bad) {
        EXPECT_GE(total_shape(mesh), shape * 0.9);
      }
    }
  }
  EXPECT_GT(slides, 100U);
}

}  // namespace
}  // namespace quadloom::quadrangulate
