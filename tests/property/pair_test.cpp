// Pairing of triangulations: all quads whatever comes, and what must stay stays.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "support/conversion_checks.hpp"

namespace quadloom {
namespace {

using namespace test;

TriangleMesh planar(Triangulation mesh) { return {std::move(mesh), {}, {}, {}, {}}; }

/// The number of parts with an odd number of triangles, counted without the library's parts.
std::size_t odd_parts(const TriangleMesh& input) {
  std::vector<std::uint8_t> seen(input.mesh.triangle_count());
  std::size_t odd = 0;
  for (TriangleId first = 0; first < seen.size(); ++first) {
    if (seen[first] != 0) continue;
    std::vector<TriangleId> todo = {first};
    seen[first] = 1;
    for (std::size_t i = 0; i < todo.size(); ++i) {
      for (HalfedgeId h = 3 * todo[i]; h < 3 * todo[i] + 3; ++h) {
        if (is_kept(input, h) || seen[triangle_of(input.mesh.twin[h])] != 0) continue;
        seen[triangle_of(input.mesh.twin[h])] = 1;
        todo.push_back(triangle_of(input.mesh.twin[h]));
      }
    }
    odd += todo.size() % 2;
  }
  return odd;
}

/// A polygon of any kind, with holes every other time; labels and edges to keep now and then.
TriangleMesh random_mesh(std::uint64_t seed, Random& random) {
  const auto kinds = polygon_generators();
  const PolygonGenerator& kind = kinds[seed % kinds.size()];
  Polygon polygon = kind.make(kind.min_corners + random.below(60), seed);
  if (random.below(2) == 0) polygon = with_holes(polygon, random.below(6), seed);
  TriangleMesh mesh = planar(constrained_delaunay(polygon).mesh);
  if (random.below(3) == 0) {
    mesh.region =
        random_regions(mesh.mesh, 1 + static_cast<std::uint32_t>(random.below(6)), random);
  }
  if (random.below(3) == 0) mesh.keep = random_kept_edges(mesh.mesh, 2 + random.below(20), random);
  return mesh;
}

constexpr OddBoundary kWishes[] = {OddBoundary::kOnEdge, OddBoundary::kOutside,
                                   OddBoundary::kTriangle};

TEST(Pair, PolygonsOfAllKindsWithHolesRegionsAndEdgesToKeep) {
  for (std::uint64_t seed = 1; seed <= 1500; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const TriangleMesh mesh = random_mesh(seed, random);
    TriangleOptions options;
    options.odd_boundary = kWishes[random.below(3)];
    options.leftover = random.below(2) == 0 ? Leftover::kWalk : Leftover::kSteiner;
    options.effort = random.below(2) == 0 ? MatchingEffort::kExact : MatchingEffort::kNear;
    const TriangleResult result = quadrangulate_triangles(mesh, options);
    const std::size_t odd = odd_parts(mesh);
    EXPECT_EQ(result.statistics.odd_parts, odd);
    const bool triangle = options.odd_boundary == OddBoundary::kTriangle;
    check_conversion(mesh, result, triangle ? odd : 0);
    if (mesh.region.empty() && mesh.keep.empty() && !triangle) {
      const auto at_border =
          std::count_if(result.steiner.begin(), result.steiner.end(),
                        [](const auto& s) { return s.kind != SteinerKind::kInner; });
      EXPECT_EQ(static_cast<std::size_t>(at_border), odd);
    }
    if (HasFailure()) return;
  }
}

TEST(Pair, DelaunayTriangulationsOfAllKindsNeedNoInnerPoint) {
  for (const Generator& g : generators()) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      SCOPED_TRACE(std::string(g.name) + ", seed " + std::to_string(seed));
      const TriangleMesh mesh =
          planar(delaunay(generate_points(g.name, 20 + 50 * seed, seed)).mesh);
      const TriangleResult result = quadrangulate_triangles(mesh);
      check_conversion(mesh, result);
      EXPECT_EQ(result.statistics.crossings, 0U);
      EXPECT_EQ(result.steiner.size(), result.statistics.boundary_edges % 2);
      if (HasFailure()) return;
    }
  }
}

TEST(Pair, OnlyEdgesGoIfThereIsAPerfectMatching) {
  std::size_t perfect = 0, refused = 0;
  for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const TriangleMesh mesh = random_mesh(seed, random);
    std::vector<std::uint8_t> forbidden(mesh.mesh.twin.size());
    for (HalfedgeId h = 0; h < forbidden.size(); ++h) forbidden[h] = is_kept(mesh, h) ? 1 : 0;
    const DualGraph graph = dual_graph(mesh.mesh, forbidden);
    const MaximumMatching best = maximum_matching(graph);
    TriangleOptions options;
    options.leftover = Leftover::kTriangle;
    const TriangleResult result = quadrangulate_triangles(mesh, options);
    check_conversion(mesh, result, best.matching.unmatched);
    const std::set<Edge> given = face_edges(to_polygon_mesh(mesh.mesh));
    for (const Edge& e : face_edges(to_polygon_mesh(result.mesh))) ASSERT_TRUE(given.contains(e));
    options.leftover = Leftover::kError;
    if (best.matching.unmatched == 0) {
      ++perfect;
      EXPECT_EQ(quadrangulate_triangles(mesh, options).mesh.quad_vertex, result.mesh.quad_vertex);
    } else {
      ++refused;
      try {
        quadrangulate_triangles(mesh, options);
        ADD_FAILURE() << "no error";
      } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::kGuarantee);
        MaximumMatching witness = best;  // the barrier proves the size of any maximum matching
        witness.barrier.assign(error.culprits().begin(), error.culprits().end());
        EXPECT_TRUE(verify_tutte_berge(graph, witness)) << error.what();
      }
    }
    if (HasFailure()) return;
  }
  EXPECT_GT(perfect, 50U);
  EXPECT_GT(refused, 50U);
}

TEST(Pair, SteinerPointsAreNoMoreThanHalfOfTheTriangles) {
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const TriangleMesh mesh = random_mesh(seed, random);
    TriangleOptions options;
    options.leftover = Leftover::kSteiner;
    const TriangleResult result = quadrangulate_triangles(mesh, options);
    if (mesh.region.empty() && mesh.keep.empty()) {
      EXPECT_LE(result.steiner.size(), mesh.mesh.triangle_count() / 2 + 1);
    }
    if (HasFailure()) return;
  }
}

TEST(Pair, MinimumQualityLeavesTrianglesAndMakesNoWorseQuad) {
  const TriangleMesh mesh = planar(delaunay(generate_points("uniform", 2000, 7)).mesh);
  TriangleOptions options;
  options.leftover = Leftover::kTriangle;
  options.min_quality = 0.4;
  const TriangleResult result = quadrangulate_triangles(mesh, options);
  EXPECT_GT(result.mesh.triangle_count(), 0U);
  check_conversion(mesh, result, result.mesh.triangle_count());
  for (std::size_t q = 0; q < result.mesh.quad_count(); ++q) {
    const auto at = [&](std::size_t i) {
      return result.mesh.points[result.mesh.quad_vertex[4 * q + i]];
    };
    EXPECT_GE(quad_shape(at(0), at(1), at(2), at(3)), 0.4 - 1e-6);
  }
  options.min_quality = 1.5;
  EXPECT_THROW(quadrangulate_triangles(mesh, options), Error);
}

TEST(Pair, GivenWeightsDecide) {
  // The heavier the edges near one diagonal, the sooner they go: with all the weight on edges of one
  // direction of a lattice, just these go.
  const TriangleMesh mesh = planar(delaunay(generate_points("grid", 100, 1)).mesh);
  std::vector<double> weight(mesh.mesh.twin.size());
  for (HalfedgeId h = 0; h < weight.size(); ++h) {
    const Point a = mesh.mesh.points[mesh.mesh.origin(h)],
                b = mesh.mesh.points[mesh.mesh.target(h)];
    weight[h] = a.x != b.x && a.y != b.y ? 1 : 0;
  }
  TriangleOptions options;
  options.weight = PairWeight::kGiven;
  EXPECT_THROW(quadrangulate_triangles(mesh, options), Error);
  options.halfedge_weight = weight;
  const TriangleResult result = quadrangulate_triangles(mesh, options);
  check_conversion(mesh, result);
  const Quality quality = measure_quality(to_polygon_mesh(result.mesh));
  EXPECT_EQ(quality.min_shape, 1);
  weight[3] = -1;
  EXPECT_THROW(quadrangulate_triangles(mesh, options), Error);
}

TEST(Pair, EverythingToKeepLeavesEachTriangleAlone) {
  // Each triangle is a part, and odd: every one gets a point at its border, often one for two.
  const TriangleMesh bare = planar(delaunay(generate_points("uniform", 60, 3)).mesh);
  TriangleMesh mesh = bare;
  mesh.keep.assign(mesh.mesh.twin.size(), 1);
  const TriangleResult result = quadrangulate_triangles(mesh);
  check_conversion(mesh, result);
  EXPECT_EQ(result.statistics.parts, mesh.mesh.triangle_count());
  EXPECT_GE(2 * result.steiner.size(), mesh.mesh.triangle_count());
  EXPECT_LT(result.steiner.size(), mesh.mesh.triangle_count());
}

}  // namespace
}  // namespace quadloom
