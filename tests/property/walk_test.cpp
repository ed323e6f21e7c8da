// Walks and slides on paired meshes.
#include "quadrangulate/walk.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "core/random.hpp"
#include "kernel/squareness.hpp"
#include "quadrangulate/diagonal_slides.hpp"
#include "support/paired_checks.hpp"

namespace quadloom::quadrangulate {
namespace {

PairedMesh unpaired(const std::vector<Point>& points) {
  Triangulation tri = delaunay(points).mesh;
  const std::size_t count = tri.triangle_count();
  return {std::move(tri), std::vector<HalfedgeId>(count, kNone), {}, {}};
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

/// What the slides climb: squareness, and less than nothing for quads that are not strictly convex.
double total_worth(const PairedMesh& mesh) {
  const Quadrangulation quads = to_quadrangulation(mesh);
  double sum = 0;
  for (std::size_t q = 0; q < quads.quad_count(); ++q) {
    std::array<Point, 4> p;
    for (std::size_t i = 0; i < 4; ++i) p[i] = quads.points[quads.quad_vertex[4 * q + i]];
    const QuadKind kind = classify_quad(p[0], p[1], p[2], p[3]);
    sum += kind == QuadKind::kStrictlyConvex ? kernel::squareness(p[0], p[1], p[2], p[3])
           : kind == QuadKind::kFlatCorner   ? -2
                                             : -3;
  }
  return sum;
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

//         2-------4       The quad 1 2 0 3 wraps around the free triangle 0 1 3, which can only turn
//        /|.     /        the wheel about point 3 to get next to the other free triangle, 1 4 2.
//       / 3 .   /
//      / . . . /
//     0-------1
TEST(Walk, TurnsAWheelAboutAnInnerPoint) {
  PairedMesh mesh = unpaired({{0, 0}, {4, 0}, {2, 4}, {2, 1}, {6, 4}});
  const auto triangle = [&](VertexId a, VertexId b, VertexId c) {
    for (TriangleId t = 0; t < mesh.mate.size(); ++t) {
      const auto* v = &mesh.tri.tri_vertex[3 * t];
      if (std::is_permutation(v, v + 3, std::array{a, b, c}.begin())) return t;
    }
    return kNone;
  };
  const TriangleId wrapped = triangle(0, 1, 3), right = triangle(1, 2, 3);
  ASSERT_NE(triangle(1, 4, 2), kNone);
  for (HalfedgeId h = 3 * right; h < 3 * right + 3; ++h) {
    if (mesh.tri.twin[h] != kNone && triangle_of(mesh.tri.twin[h]) == triangle(0, 2, 3))
      mesh.pair(h);
  }
  testing::check_paired_mesh(mesh, 2);
  Walker walker(mesh);
  EXPECT_FALSE(walker.merge(wrapped, {WalkQuads::kStrictlyConvex, kNone, 16}));
  EXPECT_TRUE(walker.merge(wrapped, {WalkQuads::kAny, kNone, 1}));
  EXPECT_EQ(walker.steps(), 1U);
  testing::check_paired_mesh(mesh, 0);
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
      const double before = total_worth(mesh);
      const auto check = [&](const PairedMesh& after, std::size_t slid) {
        testing::check_paired_mesh(after, free);
        if (slid > 0) {
          EXPECT_GT(total_worth(after), before);
        } else {
          EXPECT_EQ(total_worth(after), before);
        }
        slides += slid;
      };
      QuadMesh quads = to_quad_mesh(PairedMesh(mesh));
      const std::size_t slid_quads = slide_diagonals(quads);
      EXPECT_EQ(slide_diagonals(quads), 0U);  // it was at the top
      check(to_paired_mesh(std::move(quads)), slid_quads);
      const std::size_t slid = slide_diagonals(mesh);
      EXPECT_EQ(slide_diagonals(mesh), 0U);
      check(mesh, slid);
    }
  }
  EXPECT_GT(slides, 100U);
}

}  // namespace
}  // namespace quadloom::quadrangulate
