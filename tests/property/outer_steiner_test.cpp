// The methods that add outer Steiner points: percolation and fans.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "quadloom/quadloom.hpp"
#include "support/all_triangulations.hpp"
#include "support/matching_checks.hpp"
#include "support/tree_checks.hpp"

namespace quadloom {
namespace {

using namespace test;

constexpr TriangleMethod kMethods[] = {TriangleMethod::kPercolate, TriangleMethod::kFans};

TriangleResult convert(const Triangulation& mesh, const std::vector<Polygon>& polygons,
                       TriangleMethod method) {
  TriangleOptions options;
  options.method = method;
  const TriangleResult result = convert_checked({mesh, {}, {}, {}, {}}, polygons, options);
  EXPECT_EQ(count_steiner(result, SteinerKind::kOutside), result.steiner.size());
  EXPECT_EQ(result.mesh.triangle_count(), 0U);
  EXPECT_EQ(result.statistics.unmatched, result.steiner.size());
  return result;
}

// Theorems 2.1 and 3.3.
TEST(OuterSteiner, AtMostAThirdOfTheCorners) {
  for_random_polygons(500, [](const Polygon& polygon, std::uint64_t) {
    const Triangulation mesh = constrained_delaunay(polygon).mesh;
    const std::size_t n = mesh.triangle_count() + 2;
    const std::size_t fewest = convert(mesh, {polygon}, TriangleMethod::kPercolate).steiner.size();
    const std::size_t fans = convert(mesh, {polygon}, TriangleMethod::kFans).steiner.size();
    EXPECT_LE(fans, n / 3);
    EXPECT_LE(fewest, fans);
    EXPECT_EQ(fewest, maximum_matching(dual_graph(mesh)).matching.unmatched);
  });
}

/// The triangles that stay over, each with a boundary edge of its own, if the matching is the best such
/// one; kNone if there is none. By brute force.
std::size_t brute_force_outer(const Triangulation& mesh) {
  const std::size_t t = mesh.triangle_count();
  std::vector<std::size_t> best(std::size_t{1} << t, kNone);  // points for the triangles of the set
  best[0] = 0;
  for (std::size_t set = 1; set < best.size(); ++set) {
    const auto first = static_cast<TriangleId>(__builtin_ctzll(set));
    const std::size_t rest = set & (set - 1);
    for (HalfedgeId h = 3 * first; h < 3 * first + 3; ++h) {
      if (mesh.twin[h] == kNone) {
        if (best[rest] != kNone) best[set] = std::min(best[set], best[rest] + 1);
        continue;
      }
      const std::size_t other = std::size_t{1} << triangle_of(mesh.twin[h]);
      if ((rest & other) != 0) best[set] = std::min(best[set], best[rest & ~other]);
    }
  }
  return best.back();
}

TEST(OuterSteiner, TheFewestOnAllTriangulations) {
  std::size_t triangulations = 0;
  for (const PolygonGenerator& g : polygon_generators()) {
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
      const std::size_t n = std::max<std::size_t>(g.min_corners, 4 + seed % 9);
      SCOPED_TRACE(std::string(g.name) + " " + std::to_string(n) + ", seed " +
                   std::to_string(seed));
      const Polygon polygon = generate_polygon(g.name, n, seed);
      std::vector<Point> ring = polygon.rings[0];
      if (ring.size() > 12) continue;
      for_all_triangulations(ring, [&](const Triangulation& mesh) {
        ++triangulations;
        const TriangleResult result = convert(mesh, {polygon}, TriangleMethod::kPercolate);
        EXPECT_EQ(result.steiner.size(), brute_force_unmatched({mesh.twin}));
        EXPECT_LE(convert(mesh, {polygon}, TriangleMethod::kFans).steiner.size(), ring.size() / 3);
      });
      if (HasFailure()) return;
    }
  }
  EXPECT_GT(triangulations, 3000U);
}

// Figure 2.1 of the paper.
TEST(OuterSteiner, FiskPolygonsNeedAThirdOnTheirOnlyTriangulation) {
  for (std::size_t n = 3; n <= 15; n += 3) {
    SCOPED_TRACE("n = " + std::to_string(n));
    const Polygon polygon = generate_polygon("fisk", n);
    ASSERT_EQ(polygon.rings[0].size(), n);
    std::size_t triangulations = 0;
    for_all_triangulations(polygon.rings[0], [&](const Triangulation& mesh) {
      ++triangulations;
      EXPECT_EQ(brute_force_outer(mesh), n / 3);
    });
    EXPECT_EQ(triangulations, 1U);
  }
  for (const std::size_t n : {3U, 6U, 9U, 33U, 300U, 3000U}) {
    const Polygon polygon = generate_polygon("fisk", n);
    const Triangulation mesh = constrained_delaunay(polygon).mesh;
    for (const TriangleMethod method : kMethods) {
      EXPECT_EQ(convert(mesh, {polygon}, method).steiner.size(), n / 3) << n;
    }
  }
}

/// How many outer points, or kNone where the error says that it cannot be.
std::size_t points_or_none(const Triangulation& mesh, const std::vector<Polygon>& polygons) {
  try {
    return convert(mesh, polygons, TriangleMethod::kPercolate).steiner.size();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kGuarantee);
    EXPECT_EQ(error.culprits().size(), 1U);
    return kNone;
  }
}

TEST(OuterSteiner, HolesAndInnerPoints) {
  for_random_polygons(200, [](const Polygon& polygon, std::uint64_t seed) {
    const Polygon pierced = with_holes(polygon, 1 + seed % 4, seed);
    const Triangulation mesh = constrained_delaunay(pierced).mesh;
    const std::size_t points = points_or_none(mesh, {pierced});
    if (mesh.triangle_count() <= 16) {
      EXPECT_EQ(points, brute_force_outer(mesh));
    }
  });
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const std::size_t n = 4 + seed % 8;
    const Triangulation mesh = delaunay(generate_points("uniform", n, seed)).mesh;
    const std::size_t points = points_or_none(mesh, {});
    EXPECT_EQ(points, brute_force_outer(mesh));
    if (HasFailure()) return;
  }
}

// Opened up along a spanning tree the t triangles of any mesh are a polygon of t + 2 corners.
TEST(OuterSteiner, FansOfMeshesWithHolesAndInnerPoints) {
  for_random_polygons(300, [](const Polygon& polygon, std::uint64_t seed) {
    const Polygon pierced = with_holes(polygon, 1 + seed % 4, seed);
    const Triangulation mesh = constrained_delaunay(pierced).mesh;
    const std::size_t points = convert(mesh, {pierced}, TriangleMethod::kFans).steiner.size();
    EXPECT_LE(points, (mesh.triangle_count() + 2) / 3);
  });
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Triangulation mesh = delaunay(generate_points("uniform", 4 + seed % 60, seed)).mesh;
    TriangleOptions options;
    options.method = TriangleMethod::kFans;
    const TriangleResult result = convert_checked({mesh, {}, {}, {}, {}}, {}, options);
    EXPECT_LE(result.steiner.size(), (mesh.triangle_count() + 2) / 3);
    if (HasFailure()) return;
  }
}

// Edges to keep part a triangle from the ring around it.
TEST(OuterSteiner, NoBoundaryNear) {
  TriangleMesh source = kept_triangle_in_a_ring();
  TriangleOptions options;
  options.method = TriangleMethod::kPercolate;
  try {
    quadrangulate_triangles(source, options);
    FAIL() << "triangle 0 stays over";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kGuarantee);
    EXPECT_EQ(error.culprits(), std::vector<std::size_t>{0});
  }
  source.keep.assign(21, 0);
  EXPECT_EQ(convert_checked(source, {}, options).steiner.size(), 1U);
}

// A segment that parts a polygon: nothing reaches over it.
TEST(OuterSteiner, Segments) {
  const PlanarInput input{
      {{{{{0, 0}, {6, 0}, {9, 5}, {5, 8}, {1, 6}}}}}, {{0, 0}, {5, 8}}, {{0, 1}}, {}, {}};
  for (const TriangleMethod method : kMethods) {
    TriangleOptions options;
    options.method = method;
    const PlanarResult result = quadrangulate_polygons(input, options);
    EXPECT_EQ(result.quads.statistics.parts, 2U);
    EXPECT_EQ(result.quads.steiner.size(), 1U);
    CertifyOptions wanted;
    wanted.outer_steiner = true;
    const Certificate certificate =
        certify_polygons(to_polygon_mesh(result.quads.mesh), input.polygons, input.points, wanted);
    EXPECT_TRUE(certificate.ok()) << certificate.sentence;
  }
}

// Corners on straight sides, corners that touch.
TEST(OuterSteiner, DegeneratePolygons) {
  const Polygon straight{{{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 3}, {2, 3}, {1, 3}, {0, 3}}}};
  const Polygon flat_triangle{{{{0, 0}, {1, 0}, {2, 0}, {4, 0}, {0, 3}}}};
  const Polygon touching{{{{0, 0}, {8, 0}, {8, 8}, {4, 4}, {0, 8}}, {{4, 4}, {5, 2}, {3, 2}}}};
  for (const Polygon& polygon : {straight, flat_triangle, touching}) {
    const Triangulation mesh = constrained_delaunay(polygon).mesh;
    const std::size_t n = mesh.triangle_count() + 2;
    for (const TriangleMethod method : kMethods) {
      EXPECT_LE(convert(mesh, {polygon}, method).steiner.size(), n / 3);
    }
  }
}

TEST(OuterSteiner, EveryMagnitude) {
  for (const int exponent : {-1000, -900, -300, 300, 900, 990}) {
    for (const PolygonGenerator& g : polygon_generators()) {
      SCOPED_TRACE(std::string(g.name) + " times 2^" + std::to_string(exponent));
      Polygon polygon = generate_polygon(g.name, 40, 3);
      for (Point& p : polygon.rings[0]) {
        p = {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent)};
      }
      const Triangulation mesh = constrained_delaunay(polygon).mesh;
      for (const TriangleMethod method : kMethods) convert(mesh, {polygon}, method);
      if (HasFailure()) return;
    }
  }
}

void expect_bad_mesh(const TriangleMesh& input, TriangleMethod method, const char* word) {
  TriangleOptions options;
  options.method = method;
  try {
    quadrangulate_triangles(input, options);
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kBadMesh);
    EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
  }
}

TEST(OuterSteiner, WhatTheMethodsAreNotFor) {
  const Polygon square{{{{0, 0}, {9, 0}, {9, 9}, {0, 9}}}};
  for (const TriangleMethod method : kMethods) {
    expect_bad_mesh({constrained_delaunay(square).mesh, {0, 1, 0, 1}, {}, {}, {}}, method,
                    "surface");
  }
}

}  // namespace
}  // namespace quadloom
