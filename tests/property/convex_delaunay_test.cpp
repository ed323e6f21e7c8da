// Strictly convex quads with almost no added points: of point sets, triangulations and polygons.
#include <gtest/gtest.h>

#include <string>

#include "support/conversion_checks.hpp"

namespace quadloom {
namespace {

using namespace test;

ConvexResult convex_checked(const std::vector<Point>& input, OddBoundary odd) {
  ConvexOptions options;
  options.odd_boundary = odd;
  ConvexResult result = convex_quadrangulation(input, options);
  const std::vector<Point> distinct = distinct_points(input).points;
  const bool odd_hull = convex_hull(distinct).size() % 2 == 1;
  const auto outside = static_cast<std::size_t>(
      std::count_if(result.steiner.begin(), result.steiner.end(),
                    [](const SteinerPoint& s) { return s.kind == SteinerKind::kOutside; }));
  EXPECT_EQ(outside + result.mesh.triangle_count(), odd_hull ? 1U : 0U);
  if (odd == OddBoundary::kTriangle) {
    EXPECT_EQ(outside, 0U);
  }
  EXPECT_LE(result.steiner.size(), 3 * (distinct.size() / 2) + outside);

  CertifyOptions wanted;
  wanted.triangles_allowed = result.mesh.triangle_count();
  wanted.strictly_convex = result.not_convex.empty();
  wanted.steiner_inside = outside == 0;
  const Certificate certificate = certify_points(to_polygon_mesh(result.mesh), input, wanted);
  EXPECT_TRUE(certificate.ok()) << certificate.sentence;
  EXPECT_EQ(certificate.faces - certificate.triangles - certificate.strictly_convex,
            result.not_convex.size());
  for (std::size_t i = 0; i < result.steiner.size(); ++i) {
    EXPECT_EQ(result.steiner[i].vertex, distinct.size() + i);
  }
  return result;
}

TEST(ConvexDelaunay, EveryGenerator) {
  for (const Generator& g : generators()) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      SCOPED_TRACE(std::string(g.name) + ", seed " + std::to_string(seed));
      const auto points = generate_points(g.name, g.min_points + 40 * seed, seed);
      const ConvexResult result =
          convex_checked(points, seed % 2 == 0 ? OddBoundary::kTriangle : OddBoundary::kOutside);
      if (g.name != "near-line") {
        EXPECT_TRUE(result.not_convex.empty());
      }
      if (HasFailure()) return;
    }
  }
}

TEST(ConvexDelaunay, AlmostNoPointsOnUniformSets) {
  const ConvexResult result =
      convex_checked(generate_points("uniform", 20'000, 5), OddBoundary::kTriangle);
  EXPECT_TRUE(result.not_convex.empty());
  EXPECT_LE(result.steiner.size(), 40U);  // n / 500; 4 to 24 on six sets
}

// More than 100,000 triangles: searches are smaller, and far walks aim.
TEST(ConvexDelaunay, LargeSets) {
  const ConvexResult uniform =
      convex_checked(generate_points("uniform", 60'000, 6), OddBoundary::kTriangle);
  EXPECT_TRUE(uniform.not_convex.empty());
  EXPECT_LE(uniform.steiner.size(), 60U);  // n / 1,000
  const ConvexResult rows =
      convex_checked(generate_points("lines", 52'000, 6), OddBoundary::kTriangle);
  EXPECT_TRUE(rows.not_convex.empty());
  EXPECT_LE(rows.steiner.size(), 26'000U);  // n / 2, a third of the spiral's bound
}

// The mesh is four long corridors, in which a walk may be as long as the mesh and passes quads twice.
TEST(ConvexDelaunay, LongCorridors) {
  const ConvexResult cross =
      convex_checked(generate_points("cross", 30'000, 6), OddBoundary::kTriangle);
  EXPECT_TRUE(cross.not_convex.empty());
  EXPECT_LE(cross.steiner.size(), 10U);  // 3 on sets of 20,000 to 100,000
}

// Here less effort goes into each bad quad.
TEST(ConvexDelaunay, VeryLargeSets) {
  const ConvexResult uniform =
      convex_checked(generate_points("uniform", 260'000, 6), OddBoundary::kTriangle);
  EXPECT_TRUE(uniform.not_convex.empty());
  EXPECT_LE(uniform.steiner.size(), 130U);  // n / 2,000
}

TEST(ConvexDelaunay, TheSameSeedTheSameMesh) {
  const auto points = generate_points("lines", 400, 2);
  const auto first = convex_quadrangulation(points), second = convex_quadrangulation(points);
  EXPECT_EQ(first.mesh.points, second.mesh.points);
  EXPECT_EQ(first.mesh.quad_vertex, second.mesh.quad_vertex);
}

TEST(ConvexDelaunay, NeverMorePointsThanTheSpiralWhereThoseAreMany) {
  for (const char* kind : {"bhrs-line", "bhrs-ring"}) {
    for (const std::size_t n : {20U, 60U, 196U}) {
      SCOPED_TRACE(std::string(kind) + " " + std::to_string(n));
      const auto points = generate_points(kind, n, 1);
      ConvexOptions spiral;
      spiral.method = ConvexMethod::kSpiral;
      spiral.odd_boundary = OddBoundary::kTriangle;
      EXPECT_LE(convex_checked(points, OddBoundary::kTriangle).steiner.size(),
                std::max(n / 10, convex_quadrangulation(points, spiral).steiner.size()));
      if (HasFailure()) return;
    }
  }
}

TEST(ConvexTriangulation, PolygonsWithHolesRegionsAndEdgesToKeep) {
  std::size_t added = 0, triangles = 0;
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const auto kinds = polygon_generators();
    const PolygonGenerator& kind = kinds[seed % kinds.size()];
    Polygon polygon = kind.make(kind.min_corners + random.below(60), seed);
    if (random.below(2) == 0) polygon = with_holes(polygon, random.below(5), seed);
    TriangleMesh mesh{constrained_delaunay(polygon).mesh, {}, {}, {}, {}};
    if (seed % 3 == 0) mesh.region = random_regions(mesh.mesh, 3, random);
    if (seed % 4 == 0) mesh.keep = random_kept_edges(mesh.mesh, 12, random);
    TriangleOptions options;
    options.odd_boundary = seed % 2 == 0 ? OddBoundary::kOutside : OddBoundary::kOnEdge;
    const ConvexMeshResult result = convex_quadrangulation(mesh, options, seed);
    EXPECT_TRUE(result.not_convex.empty());
    check_conversion(mesh, result.quads);
    const Certificate certificate =
        certify_mesh(to_polygon_mesh(result.quads.mesh), to_polygon_mesh(mesh.mesh),
                     {.outer_steiner = true, .strictly_convex = true});
    EXPECT_TRUE(certificate.ok()) << certificate.sentence;
    added += result.quads.steiner.size();
    triangles += mesh.mesh.triangle_count();
    if (HasFailure()) return;
  }
  EXPECT_LT(2 * added, triangles);
}

TEST(ConvexTriangulation, WhatItIsNotFor) {
  TriangleMesh mesh{delaunay(generate_points("uniform", 30, 1)).mesh, {}, {}, {}, {}};
  TriangleOptions options;
  options.leftover = Leftover::kTriangle;
  EXPECT_THROW(convex_quadrangulation(mesh, options), Error);
  options = {};
  options.method = TriangleMethod::kFans;
  EXPECT_THROW(convex_quadrangulation(mesh, options), Error);
  mesh.z.assign(30, 1);
  EXPECT_THROW(convex_quadrangulation(mesh), Error);
}

}  // namespace
}  // namespace quadloom
