// Q-percolation: the bounds on inner and boundary points, all results certified.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "kernel/chart.hpp"
#include "quadloom/quadloom.hpp"
#include "support/all_triangulations.hpp"
#include "support/tree_checks.hpp"

namespace quadloom {
namespace {

using namespace test;

constexpr TriangleMethod kMethods[] = {TriangleMethod::kQPercolate, TriangleMethod::kQuarter};
constexpr OddBoundary kWishes[] = {OddBoundary::kOutside, OddBoundary::kOnEdge,
                                   OddBoundary::kTriangle};

/// The bounds for one part of t triangles (theorem 3.4, and the full paper's).
void expect_bounds(const TriangleResult& result, TriangleMethod method, OddBoundary wish) {
  const std::size_t t = result.statistics.triangles, odd = t % 2;
  ASSERT_EQ(result.statistics.parts, 1U);
  EXPECT_EQ(result.statistics.odd_parts, odd);
  const std::size_t inner = count_steiner(result, SteinerKind::kInner);
  EXPECT_EQ(result.steiner.size() - inner, wish == OddBoundary::kTriangle ? 0 : odd);
  EXPECT_EQ(result.mesh.triangle_count(), wish == OddBoundary::kTriangle ? odd : 0);
  EXPECT_EQ(result.statistics.crowded, 0U);
  const std::size_t n = t + 2;
  if (method == TriangleMethod::kQuarter) {
    EXPECT_LE(inner, (t - odd) / 4);
    EXPECT_LE(inner, n / 4);
  } else {
    EXPECT_LE(inner, t < 2 ? 0 : (t - 2 - odd) / 2);
  }
  if (t > 1) {
    EXPECT_LE(result.steiner.size(), t / 2);
  }
}

void expect_q_percolation(const TriangleMesh& source, const Polygon& polygon) {
  for (const TriangleMethod method : kMethods) {
    for (const OddBoundary wish : kWishes) {
      TriangleOptions options;
      options.method = method;
      options.odd_boundary = wish;
      SCOPED_TRACE("method " + std::to_string(static_cast<int>(method)) + ", odd boundary " +
                   std::to_string(static_cast<int>(wish)));
      const TriangleResult result = convert_checked(source, {polygon}, options);
      expect_bounds(result, method, wish);
    }
  }
}

void expect_q_percolation(const Polygon& polygon) {
  expect_q_percolation(mesh_of(polygon), polygon);
}

TEST(QPercolation, AllTriangulationsOfSmallPolygons) {
  for (const PolygonGenerator& g : polygon_generators()) {
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
      const std::size_t n = std::max<std::size_t>(g.min_corners, 4 + seed % 9);
      SCOPED_TRACE(std::string(g.name) + " " + std::to_string(n) + ", seed " +
                   std::to_string(seed));
      const Polygon polygon = generate_polygon(g.name, n, seed);
      for_all_triangulations(polygon.rings[0], [&](const Triangulation& mesh) {
        expect_q_percolation({mesh, {}, {}, {}, {}}, polygon);
      });
      if (HasFailure()) return;
    }
  }
}

TEST(QPercolation, RandomPolygons) {
  for_random_polygons(400,
                      [](const Polygon& polygon, std::uint64_t) { expect_q_percolation(polygon); });
}

TEST(QPercolation, RandomPolygonsWithHoles) {
  for_random_polygons(200, [](const Polygon& polygon, std::uint64_t seed) {
    expect_q_percolation(with_holes(polygon, 1 + seed % 4, seed));
  });
}

// Corners on straight sides, corners that touch, two parts that touch at a corner.
TEST(QPercolation, DegeneratePolygons) {
  const Polygon straight{{{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 3}, {2, 3}, {1, 3}, {0, 3}}}};
  const Polygon flat_triangle{{{{0, 0}, {1, 0}, {2, 0}, {4, 0}, {0, 3}}}};
  const Polygon touching{{{{0, 0}, {8, 0}, {8, 8}, {4, 4}, {0, 8}}, {{4, 4}, {5, 2}, {3, 2}}}};
  const Polygon pinched{{{{0, 0}, {4, 2}, {8, 0}, {9, 4}, {4, 2}, {4, 9}, {-1, 4}}}};
  for (const Polygon& polygon : {straight, flat_triangle, touching}) {
    expect_q_percolation(polygon);
  }
  for (const TriangleMethod method : kMethods) {
    TriangleOptions options;
    options.method = method;
    const TriangleResult result = convert_checked(mesh_of(pinched), {pinched}, options);
    EXPECT_EQ(result.statistics.parts, 2U);
    EXPECT_EQ(result.statistics.odd_parts, 1U);
    EXPECT_EQ(result.steiner.size(), 1U);
  }
}

TEST(QPercolation, EveryMagnitude) {
  for (const int exponent : {-1000, -900, -300, 300, 900, 990}) {
    for (const PolygonGenerator& g : polygon_generators()) {
      SCOPED_TRACE(std::string(g.name) + " times 2^" + std::to_string(exponent));
      Polygon polygon = with_holes(generate_polygon(g.name, 40, 3), 3, 3);
      for (auto& ring : polygon.rings) {
        for (Point& p : ring) p = {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent)};
      }
      expect_q_percolation(polygon);
      if (HasFailure()) return;
    }
  }
}

Polygon outline_of(const Triangulation& mesh) {
  HalfedgeId h = 0;
  while (mesh.twin[h] != kNone) ++h;
  const HalfedgeId start = h;
  std::vector<Point> ring;
  do {
    ring.push_back(mesh.points[mesh.origin(h)]);
    for (h = next_halfedge(h); mesh.twin[h] != kNone;) h = next_halfedge(mesh.twin[h]);
  } while (h != start);
  return {{std::move(ring)}};
}

TriangleResult convert(const Triangulation& mesh, TriangleMethod method) {
  TriangleOptions options;
  options.method = method;
  return convert_checked({mesh, {}, {}, {}, {}}, {outline_of(mesh)}, options);
}

// The bounds are reached: a triangle with three others around it.
TEST(QPercolation, AStarOfFourTrianglesNeedsItsPoint) {
  const Triangulation star = connected({{0, 0}, {4, 0}, {2, 3}, {2, -3}, {5, 3}, {-1, 3}},
                                       {0, 1, 2, 1, 0, 3, 2, 1, 4, 0, 2, 5});
  for (const TriangleMethod method : kMethods) {
    const TriangleResult result = convert(star, method);
    EXPECT_EQ(result.steiner.size(), 1U);
    EXPECT_EQ(result.mesh.quad_count(), 3U);
    EXPECT_EQ(result.statistics.unmatched, 2U);
  }
}

// Two whole numbers fit into the two triangles of a fork and its parent, but none where it would serve both.
TEST(QPercolation, CrowdedForksGetTwoPoints) {
  constexpr double k = 0x1p52 + 64;  // from here on doubles are whole
  std::vector<Point> points = {{1, 0},   {-10, 3}, {0, 0},    {-10, -4},
                               {0, -10}, {-11, 1}, {-11, -2}, {0, 10}};
  const std::vector<VertexId> corners = {1, 0, 7, 0, 1, 2, 0, 2, 3, 2, 1, 5, 3, 2, 6, 0, 3, 4};
  const TriangleResult roomy = convert(connected(points, corners), TriangleMethod::kQuarter);
  EXPECT_EQ(roomy.steiner.size(), 1U);
  EXPECT_EQ(roomy.statistics.crowded, 0U);
  for (Point& p : points) p = {p.x + k, p.y + k};
  const TriangleResult crowded = convert(connected(points, corners), TriangleMethod::kQuarter);
  EXPECT_EQ(crowded.steiner.size(), 2U);
  EXPECT_EQ(crowded.statistics.crowded, 1U);
}

TEST(QPercolation, ATriangleWithoutADoubleInside) {
  const double next = 1 + 0x1p-52;
  const Triangulation star = connected({{1, 1}, {next, 1}, {1, next}, {1.2, 0}, {2, 2}, {0, 1.2}},
                                       {0, 1, 2, 1, 0, 3, 2, 1, 4, 0, 2, 5});
  for (const TriangleMethod method : kMethods) {
    try {
      convert(star, method);
      FAIL() << "no double lies in triangle 0";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kGuarantee);
      EXPECT_EQ(error.culprits(), std::vector<std::size_t>{0});
    }
  }
}

// Parts: nothing reaches over an edge to keep or from one polygon into another; each odd part has its own
// boundary point.
TEST(QPercolation, SeveralParts) {
  const PlanarInput input{{{{{{0, 0}, {8, 0}, {8, 8}, {0, 8}}, {{2, 2}, {3, 2}, {3, 3}}}},
                           {{{{8, 0}, {12, 3}, {8, 8}}}}},
                          {{5, 5}, {6, 2}},
                          {},
                          {},
                          {}};
  PlanarInput with_segment = input;
  with_segment.segments = {{0, 1}};
  for (const TriangleMethod method : kMethods) {
    for (const PlanarInput& planar : {input, with_segment}) {
      TriangleOptions options;
      options.method = method;
      const PlanarResult result = quadrangulate_polygons(planar, options);
      CertifyOptions wanted;
      const Certificate certificate = certify_polygons(to_polygon_mesh(result.quads.mesh),
                                                       planar.polygons, planar.points, wanted);
      ASSERT_TRUE(certificate.ok()) << certificate.sentence;
      EXPECT_EQ(result.quads.statistics.parts, 2U);
      EXPECT_EQ(result.quads.statistics.odd_parts, 2U);
      EXPECT_EQ(count_steiner(result.quads, SteinerKind::kOnEdge), 2U);
    }
  }
}

// An odd part that edges to keep cut off from the boundary: a triangle inside another.
TEST(QPercolation, AnOddPartWithoutBoundary) {
  TriangleMesh source = kept_triangle_in_a_ring();
  TriangleOptions options;
  options.method = TriangleMethod::kQPercolate;
  try {
    quadrangulate_triangles(source, options);
    FAIL() << "one triangle is no mesh of quads";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kGuarantee);
    EXPECT_EQ(error.culprits(), std::vector<std::size_t>{0});
  }
  options.odd_boundary = OddBoundary::kTriangle;
  const TriangleResult result = convert_checked(source, {}, options);
  EXPECT_EQ(result.triangle_source, std::vector<TriangleId>{0});
}

TEST(QPercolation, PointSetsWithAPerfectMatchingNeedNoPoint) {
  std::size_t perfect = 0;
  for (const Generator& g : generators()) {
    SCOPED_TRACE(std::string(g.name) + " 300, seed 5");
    const std::vector<Point> points = generate_points(g.name, 300, 5);
    const Triangulation mesh = delaunay(points).mesh;
    for (const TriangleMethod method : kMethods) {
      TriangleOptions options;
      options.method = method;
      const TriangleResult result = convert_checked({mesh, {}, {}, {}, {}}, {}, options);
      if (result.statistics.unmatched < 2) {
        ++perfect;
        EXPECT_EQ(result.steiner.size(), mesh.triangle_count() % 2);
      }
      if (HasFailure()) return;
      EXPECT_LE(result.steiner.size(), mesh.triangle_count() / 2);
    }
  }
  EXPECT_GT(perfect, 20U);
}

/// A torus of 2 x rows x columns triangles in space, with edges to keep at random.
TriangleMesh random_torus(VertexId rows, VertexId columns, Random& random) {
  TriangleMesh out;
  std::vector<VertexId> corners;
  for (VertexId i = 0; i < rows; ++i) {
    for (VertexId j = 0; j < columns; ++j) {
      const double u = 2 * M_PI * i / rows, v = 2 * M_PI * j / columns, r = 3 + std::cos(u);
      out.mesh.points.push_back({r * std::cos(v), r * std::sin(v)});
      out.z.push_back(std::sin(u));
      const VertexId up = (i + 1) % rows, right = (j + 1) % columns;
      const VertexId a = i * columns + j, b = i * columns + right, c = up * columns + right,
                     d = up * columns + j;
      corners.insert(corners.end(), {a, b, c, a, c, d});
    }
  }
  out.mesh = connected(std::move(out.mesh.points), std::move(corners));
  out.keep.resize(out.mesh.twin.size());
  for (auto& keep : out.keep) keep = random.below(5) == 0;
  return out;
}

TEST(QPercolation, SurfacesInSpace) {
  std::size_t inner = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const TriangleMesh torus = random_torus(9, 12, random);
    for (const TriangleMethod method : kMethods) {
      TriangleOptions options;
      options.method = method;
      options.odd_boundary = OddBoundary::kTriangle;
      const TriangleResult result = quadrangulate_triangles(torus, options);
      EXPECT_EQ(result.mesh.triangle_count(), result.statistics.odd_parts);
      EXPECT_EQ(result.z.size(), result.mesh.points.size());
      check_sources(torus, result);
      check_kept_edges(torus, result);
      CertifyOptions wanted;
      wanted.triangles_allowed = result.mesh.triangle_count();
      const Certificate certificate = certify_surface(to_polygon_mesh(result.mesh), result.z,
                                                      to_polygon_mesh(torus.mesh), torus.z, wanted);
      ASSERT_TRUE(certificate.ok()) << certificate.sentence;
      // Steiner points are in the plane of their parents, up to rounding.
      for (const SteinerPoint& s : result.steiner) {
        const kernel::Places places{result.mesh.points, result.z};
        const auto [a, b, c] = s.parents;
        const kernel::Vector3 area = places.area(a, b, c);
        EXPECT_NEAR(kernel::dot(area, places.at(s.vertex) - places.at(a)), 0, 1e-12);
      }
      inner += result.steiner.size();
    }
  }
  EXPECT_GT(inner, 1000U);
}

// Two triangles back to back are no quad: its corners would not be distinct.
TEST(QPercolation, TrianglesWithTheSameCorners) {
  const TriangleMesh pillow{
      connected({{0, 0}, {1, 0}, {0, 1}}, {0, 1, 2, 1, 0, 2}), {0, 0, 0}, {}, {}, {}};
  TriangleOptions options;
  options.method = TriangleMethod::kQPercolate;
  EXPECT_THROW(quadrangulate_triangles(pillow, options), Error);
  options.odd_boundary = OddBoundary::kTriangle;
  EXPECT_EQ(quadrangulate_triangles(pillow, options).mesh.triangle_count(), 2U);
}

}  // namespace
}  // namespace quadloom
