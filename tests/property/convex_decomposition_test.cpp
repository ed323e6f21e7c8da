// Convex parts of polygons: that they are parts and convex, and the fewest against brute force.
#include <gtest/gtest.h>

#include <bit>

#include "quadloom/quadloom.hpp"
#include "strips/convex_path.hpp"
#include "support/all_triangulations.hpp"
#include "support/small_polygons.hpp"

namespace quadloom {
namespace {

/// The least number of parts over all sets of edges of all triangulations.
class FewestParts {
 public:
  std::size_t find(const std::vector<Point>& ring) {
    best_ = ring.size() - 2;
    test::for_all_triangulations(ring, [&](const Triangulation& mesh) { try_all(mesh); });
    return best_;
  }

 private:
  void try_all(const Triangulation& mesh) {
    mesh_ = &mesh;
    inner_.clear();
    for (HalfedgeId h = 0; h < mesh.twin.size(); ++h) {
      if (mesh.twin[h] != kNone && h < mesh.twin[h]) inner_.push_back(h);
    }
    for (std::uint32_t set = 0; set < (1U << inner_.size()); ++set) {
      const std::size_t parts = static_cast<std::size_t>(std::popcount(set)) + 1;
      if (parts < best_ && convex_between(set)) best_ = parts;
    }
  }

  /// Whether the edges in the set leave convex parts: at each corner, from side to side, no angle
  /// between two edges that stay is more than half a turn.
  bool convex_between(std::uint32_t set) const {
    std::vector<std::uint8_t> stays(mesh_->twin.size(), 0);
    for (std::size_t i = 0; i < inner_.size(); ++i) {
      stays[inner_[i]] = stays[mesh_->twin[inner_[i]]] = (set >> i) & 1U;
    }
    for (HalfedgeId side = 0; side < mesh_->twin.size(); ++side) {
      if (mesh_->twin[side] != kNone) continue;
      const Point corner = mesh_->points[mesh_->origin(side)];
      Point right = mesh_->points[mesh_->target(side)];
      for (HalfedgeId h = side;;) {
        const HalfedgeId left = previous_halfedge(h);
        const bool last = mesh_->twin[left] == kNone;
        if (last || stays[left] != 0) {
          const Point to = mesh_->points[mesh_->origin(left)];
          if (orient2d(to, corner, right) < 0) return false;
          right = to;
        }
        if (last) break;
        h = mesh_->twin[left];
      }
    }
    return true;
  }

  const Triangulation* mesh_ = nullptr;
  std::vector<HalfedgeId> inner_;
  std::size_t best_ = 0;
};

/// Convex, and together the polygon: their triangles are certified.
void expect_convex_parts(const Polygon& polygon, const ConvexDecomposition& made) {
  PolygonMesh triangles;
  triangles.points = made.parts.points;
  for (std::size_t f = 0; f < made.parts.face_count(); ++f) {
    const auto part = made.parts.face(f);
    std::vector<VertexId> corners(part.begin(), part.end());
    const auto at = [&](std::size_t i) { return triangles.points[corners[i % corners.size()]]; };
    std::ptrdiff_t last = 0;  // a corner that is not flat goes last
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const int turn = orient2d(at(i + corners.size() - 1), at(i), at(i + 1));
      ASSERT_GE(turn, 0) << "part " << f;
      if (turn > 0) last = static_cast<std::ptrdiff_t>(i);
    }
    std::rotate(corners.begin(), corners.begin() + last, corners.end());
    std::rotate(corners.begin(), corners.begin() + 1, corners.end());
    std::vector<Point> convex;
    for (const VertexId v : corners) convex.push_back(triangles.points[v]);
    const auto path = strips::path_from_last_side(convex);
    ASSERT_TRUE(path.has_value());
    ASSERT_EQ(path->size(), 3 * (convex.size() - 2));
    for (std::size_t i = 0; i < path->size(); i += 3) {
      triangles.add_face(
          std::array{corners[(*path)[i]], corners[(*path)[i + 1]], corners[(*path)[i + 2]]});
    }
  }
  CertifyOptions options;
  options.corners = 3;
  options.steiner_at_most = 0;
  const Certificate verdict = certify_polygons(triangles, std::span(&polygon, 1), {}, options);
  EXPECT_TRUE(verdict.ok()) << verdict.sentence;
}

ConvexDecomposition merged(const Polygon& polygon) {
  DecompositionOptions options;
  options.exact_steps = 0;
  return convex_decomposition(polygon, options);
}

void expect_fewest(const std::vector<Point>& ring) {
  const Polygon polygon{{ring}};
  const std::size_t fewest = FewestParts().find(ring);
  const ConvexDecomposition exact = convex_decomposition(polygon);
  EXPECT_EQ(exact.parts.face_count(), fewest);
  EXPECT_TRUE(exact.is_fewest());
  expect_convex_parts(polygon, exact);
  const ConvexDecomposition rough = merged(polygon);
  EXPECT_LE(rough.parts.face_count(), 4 * fewest);
  EXPECT_LE(rough.at_least, fewest);
  expect_convex_parts(polygon, rough);
}

TEST(ConvexDecomposition, FewestPartsOfRandomPolygons) {
  const std::uint64_t seed = 121;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  for (int trial = 0; trial < 1500 && !HasFailure(); ++trial) {
    const std::vector<Point> ring = test::random_ring(random, 4 + random.below(8));
    SCOPED_TRACE(test::text_of(ring));
    expect_fewest(ring);
  }
}

TEST(ConvexDecomposition, FewestPartsOfPolygonsOfGrids) {
  const std::uint64_t seed = 122;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  std::size_t polygons = 0;
  for (int trial = 0; trial < 4000 && !HasFailure(); ++trial) {
    const int width = 3 + static_cast<int>(random.below(3));
    const std::size_t most = width == 3 ? 8 : 11;
    const auto ring = test::random_grid_ring(random, 4 + random.below(most - 3), width);
    if (ring.empty()) continue;
    SCOPED_TRACE(test::text_of(ring));
    expect_fewest(ring);
    ++polygons;
  }
  EXPECT_GT(polygons, 2000U);
}

TEST(ConvexDecomposition, BigPolygonsAreCutIntoConvexParts) {
  for (const auto& generator : polygon_generators()) {
    SCOPED_TRACE(generator.name);
    const Polygon polygon = generator.make(300, 7);
    const ConvexDecomposition exact = convex_decomposition(polygon);
    const ConvexDecomposition rough = merged(polygon);
    expect_convex_parts(polygon, exact);
    expect_convex_parts(polygon, rough);
    EXPECT_TRUE(exact.is_fewest());
    EXPECT_LE(exact.parts.face_count(), rough.parts.face_count());
    EXPECT_LE(rough.parts.face_count(), 4 * exact.parts.face_count());
    EXPECT_LE(rough.at_least, exact.at_least);
    const Polygon holed = with_holes(polygon, 9, 3);
    const ConvexDecomposition around = convex_decomposition(holed);
    expect_convex_parts(holed, around);
    EXPECT_LE(around.at_least, around.parts.face_count());
  }
}

}  // namespace
}  // namespace quadloom
