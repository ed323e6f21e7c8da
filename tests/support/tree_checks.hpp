// Conversions with Steiner points outside, checked, and random polygons to try them on.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "core/random.hpp"
#include "quadloom/quadloom.hpp"
#include "support/all_triangulations.hpp"
#include "support/conversion_checks.hpp"

namespace quadloom::test {

inline TriangleMesh mesh_of(const Polygon& polygon) {
  return {constrained_delaunay(polygon).mesh, {}, {}, {}, {}};
}

inline std::size_t count_steiner(const TriangleResult& result, SteinerKind kind) {
  std::size_t count = 0;
  for (const SteinerPoint& s : result.steiner) count += s.kind == kind;
  return count;
}

/// Steiner points lie where their kind says, between their parents.
inline void check_steiner_points(const TriangleResult& result) {
  const auto& points = result.mesh.points;
  for (std::size_t i = 0; i < result.steiner.size(); ++i) {
    const SteinerPoint& s = result.steiner[i];
    ASSERT_EQ(s.vertex, result.input_vertices + i);
    const Point p = points[s.vertex], a = points[s.parents[0]], b = points[s.parents[1]];
    if (s.kind == SteinerKind::kInner) {
      const Point c = points[s.parents[2]];
      EXPECT_GE(orient2d(a, b, p), 0);
      EXPECT_GE(orient2d(b, c, p), 0);
      EXPECT_GE(orient2d(c, a, p), 0);
    } else {
      EXPECT_EQ(s.parents[2], kNone);
      EXPECT_EQ(orient2d(a, b, p), s.kind == SteinerKind::kOutside ? -1 : 0);
    }
  }
}

/// Converts and checks what all methods promise, against the polygons (no inner points) or, if there
/// are none, against the source.
inline TriangleResult convert_checked(const TriangleMesh& source,
                                      const std::vector<Polygon>& polygons,
                                      const TriangleOptions& options) {
  TriangleResult result = quadrangulate_triangles(source, options);
  CertifyOptions wanted;
  wanted.outer_steiner = count_steiner(result, SteinerKind::kOutside) > 0;
  wanted.steiner_at_most = result.steiner.size();
  if (options.odd_boundary == OddBoundary::kTriangle) {
    wanted.triangles_allowed = result.mesh.triangle_count();
  }
  const PolygonMesh mesh = to_polygon_mesh(result.mesh);
  const Certificate certificate = polygons.empty()
                                      ? certify_mesh(mesh, to_polygon_mesh(source.mesh), wanted)
                                      : certify_polygons(mesh, polygons, {}, wanted);
  EXPECT_TRUE(certificate.ok()) << certificate.sentence;
  EXPECT_EQ(certificate.steiner, result.steiner.size());
  EXPECT_EQ(result.statistics.triangles, source.mesh.triangle_count());
  check_steiner_points(result);
  check_sources(source, result);
  check_kept_edges(source, result);
  return result;
}

/// Calls `check` with random polygons of every kind, most of them small.
inline void for_random_polygons(std::uint64_t seeds,
                                const std::function<void(const Polygon&, std::uint64_t)>& check) {
  for (const PolygonGenerator& g : polygon_generators()) {
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
      Random random(seed);
      const std::size_t n = g.min_corners + random.below(seed % 40 == 0 ? 300 : 24);
      SCOPED_TRACE(std::string(g.name) + " " + std::to_string(n) + ", seed " +
                   std::to_string(seed));
      check(generate_polygon(g.name, n, seed), seed);
      if (testing::Test::HasFailure()) return;
    }
  }
}

/// A triangle whose edges are to be kept, inside another triangle.
inline TriangleMesh kept_triangle_in_a_ring() {
  TriangleMesh source{connected({{0, 0}, {12, 0}, {0, 12}, {2, 2}, {5, 2}, {2, 5}},
                                {3, 4, 5, 0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4, 2, 0, 3, 2, 3, 5}),
                      {},
                      {},
                      std::vector<std::uint8_t>(21, 0),
                      {}};
  for (HalfedgeId h = 0; h < 3; ++h) source.keep[h] = 1;
  return source;
}

}  // namespace quadloom::test
