#include "quadrangulate/quick_walk.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "core/random.hpp"
#include "quadloom/kernel.hpp"
#include "quadloom/quadloom.hpp"
#include "quadrangulate/pentagon.hpp"
#include "quadrangulate/walk_rounds.hpp"
#include "support/paired_checks.hpp"

namespace quadloom::quadrangulate {
namespace {

PairedMesh greedily_paired(const std::vector<Point>& points) {
  Triangulation mesh = delaunay(points).mesh;
  std::vector<HalfedgeId> mate = greedy_shape_matching(mesh).mate;
  return {std::move(mesh), std::move(mate), {}, {}};
}

/// The mesh to walk on, and a look at it as triangles in pairs.
template <class Mesh>
Mesh mesh_of(PairedMesh mesh);
template <>
PairedMesh mesh_of(PairedMesh mesh) {
  return mesh;
}
template <>
QuadMesh mesh_of(PairedMesh mesh) {
  return to_quad_mesh(std::move(mesh));
}
const PairedMesh& pairs_of(const PairedMesh& mesh) { return mesh; }
PairedMesh pairs_of(QuadMesh mesh) { return to_paired_mesh(std::move(mesh)); }

std::size_t not_strictly_convex(const PairedMesh& mesh) {
  const Quadrangulation quads = to_quadrangulation(mesh);
  std::size_t count = 0;
  for (std::size_t q = 0; q < quads.quad_count(); ++q) {
    std::array<Point, 4> p;
    for (std::size_t i = 0; i < 4; ++i) p[i] = quads.points[quads.quad_vertex[4 * q + i]];
    if (classify_quad(p[0], p[1], p[2], p[3]) != QuadKind::kStrictlyConvex) ++count;
  }
  return count;
}

/// The faces, each from its smallest corner on, in order.
std::vector<std::vector<VertexId>> faces_of(const PairedMesh& mesh) {
  const Quadrangulation quads = to_quadrangulation(mesh);
  std::vector<std::vector<VertexId>> faces;
  const auto add = [&](const std::vector<VertexId>& corner, std::size_t k) {
    for (std::size_t i = 0; i < corner.size(); i += k) {
      const auto begin = corner.begin() + static_cast<std::ptrdiff_t>(i);
      std::vector<VertexId> face(begin, begin + static_cast<std::ptrdiff_t>(k));
      std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
      faces.push_back(face);
    }
  };
  add(quads.quad_vertex, 4);
  add(quads.tri_vertex, 3);
  std::sort(faces.begin(), faces.end());
  return faces;
}

const std::vector<std::string> kKinds = {"uniform", "grid",      "lines",
                                         "circle",  "bhrs-line", "bhrs-ring"};

template <class Mesh>
class QuickWalkOn : public ::testing::Test {};
using Meshes = ::testing::Types<PairedMesh, QuadMesh>;
TYPED_TEST_SUITE(QuickWalkOn, Meshes);

TYPED_TEST(QuickWalkOn, StrictlyConvexWalksLeaveNoOtherQuads) {
  std::size_t over_quad = 0, longer = 0, after_slide = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    for (const std::string& kind : kKinds) {
      SCOPED_TRACE(kind + ", seed " + std::to_string(seed));
      auto mesh = mesh_of<TypeParam>(greedily_paired(generate_points(kind, 150, seed)));
      QuickWalker walker(mesh);
      std::size_t free = free_triangles(mesh).size();
      for (std::uint32_t t = 0; t < mesh.face_count(); ++t) {
        if (!mesh.is_free(t)) continue;
        const auto before = faces_of(pairs_of(mesh));
        if (walker.merge_over_quad(t)) {
          ++over_quad;
        } else if (walker.merge(t, WalkQuads::kStrictlyConvex, 300)) {
          ++longer;
        } else if (walker.merge_after_slide(t, 300)) {
          ++after_slide;
        } else {
          EXPECT_EQ(faces_of(pairs_of(mesh)), before);
          continue;
        }
        free -= 2;
        testing::check_paired_mesh(pairs_of(mesh), free);
        EXPECT_EQ(not_strictly_convex(pairs_of(mesh)), 0U);
        if (::testing::Test::HasFailure()) return;
      }
    }
  }
  EXPECT_GT(over_quad, 100U);
  EXPECT_GT(longer, 100U);
  EXPECT_GT(after_slide, 10U);
}

TEST(QuadMesh, HoldsTheSameFacesAsPairs) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    for (const std::string& kind : kKinds) {
      SCOPED_TRACE(kind + ", seed " + std::to_string(seed));
      const PairedMesh given = greedily_paired(generate_points(kind, 100, seed));
      const std::size_t free = free_triangles(given).size();
      const QuadMesh mesh = to_quad_mesh(PairedMesh(given));
      for (HalfedgeId h = 0; h < 4 * mesh.face_count(); ++h) {
        if (mesh.is_free(QuadMesh::face_of(h)) && h % 4 == 3) continue;
        const HalfedgeId twin = mesh.twin(h);
        if (twin == kNone) continue;
        ASSERT_EQ(mesh.twin(twin), h);
        ASSERT_EQ(mesh.origin(twin), mesh.origin(mesh.next(h)));
      }
      EXPECT_EQ(free_triangles(mesh).size(), free);
      EXPECT_EQ(faces_of(pairs_of(mesh)), faces_of(given));
      testing::check_paired_mesh(pairs_of(mesh), free);
      const Quadrangulation quads = to_quadrangulation(QuadMesh(mesh));
      EXPECT_EQ(quads.tri_vertex.size(), 3 * free);
      EXPECT_EQ(quads.quad_count(), mesh.face_count() - free);
    }
  }
}

TEST(QuickWalk, TheSweepsLeaveNextToNothing) {
  std::size_t left = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    for (const std::string& kind : kKinds) {
      SCOPED_TRACE(kind + ", seed " + std::to_string(seed));
      QuadMesh mesh = to_quad_mesh(greedily_paired(generate_points(kind, 200, seed)));
      walk_convexly(mesh, {});
      EXPECT_EQ(not_strictly_convex(pairs_of(mesh)), 0U);
      walk_anyhow(mesh);
      const std::size_t free = free_triangles(mesh).size();
      testing::check_paired_mesh(pairs_of(mesh), free);
      if (::testing::Test::HasFailure()) return;
      left += free / 2;
    }
  }
  EXPECT_LT(left, 60U);  // walks that only the last rounds of walk_rounds.hpp find
}

// So several walkers may go over a mesh at once.
TEST(QuickWalk, AWalkerKeepsToItsRange) {
  std::size_t walks = 0, met = 0;
  for (const std::string& kind : kKinds) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      SCOPED_TRACE(kind + ", seed " + std::to_string(seed));
      QuadMesh mesh = to_quad_mesh(greedily_paired(generate_points(kind, 400, seed)));
      const auto third = static_cast<FaceId>(mesh.face_count() / 3);
      const FaceRange range{third, 2 * third};
      const QuadMesh given = mesh;
      QuickWalker quick(mesh, range);
      for (FaceId t = range.begin; t < range.end; ++t) {
        if (mesh.is_free(t)) quick.merge_over_quad(t);
        if (mesh.is_free(t)) quick.merge(t, WalkQuads::kStrictlyConvex, 1000);
        if (mesh.is_free(t)) quick.merge_after_slide(t, 200);
        if (mesh.is_free(t)) quick.merge(t, WalkQuads::kAny, 1000);
        met += quick.take_met_border() ? 1 : 0;
      }
      walks += quick.walks();
      for (FaceId f = 0; f < mesh.face_count(); ++f) {
        if (range.has(f) && given.may_change(f, range)) continue;
        ASSERT_EQ(mesh.faces[f].corner, given.faces[f].corner);
        if (range.has(f)) continue;  // the links of its border may change
        ASSERT_EQ(mesh.faces[f].twin, given.faces[f].twin);
      }
      testing::check_paired_mesh(pairs_of(mesh), free_triangles(mesh).size());
      if (::testing::Test::HasFailure()) return;
    }
  }
  EXPECT_GT(walks, 100U);
  EXPECT_GT(met, 100U);
}

TEST(QuickWalk, TurnsOfPentagonsAreExact) {
  Random random(1);
  SCOPED_TRACE("seed 1");
  std::size_t zeros = 0;
  for (int i = 0; i < 20'000; ++i) {
    std::array<Point, 5> p;
    for (Point& q : p) {
      q = {static_cast<double>(random.below(5)), static_cast<double>(random.below(5))};
      if (i % 2 == 1) q = {q.x * 1e-3 + 0.1, q.y / 3};  // collinear up to rounding
    }
    const PentagonTurns turns(p);
    for (std::size_t k = 0; k < 5; ++k) {
      const auto at = [&](std::size_t step) { return p[(k + step) % 5]; };
      const int turn = orient2d(at(4), at(0), at(1));
      zeros += turn == 0 ? 1U : 0U;
      ASSERT_EQ(turns.at(k), turn);
      const QuadKind kind = classify_quad(at(1), at(2), at(3), at(4));
      ASSERT_EQ(turns.without(k), kind);
      ASSERT_EQ((turns.convex_cuts() >> k & 1U) != 0,
                turn > 0 && kind == QuadKind::kStrictlyConvex);
    }
  }
  EXPECT_GT(zeros, 1'000U);
}

}  // namespace
}  // namespace quadloom::quadrangulate
