// What a serpentine triangulation of a point set must be.
#pragma once

#include <gtest/gtest.h>

#include "quadloom/kernel.hpp"
#include "quadloom/quadrangulate.hpp"

namespace quadloom::testing {

/// Twice the signed area, for points with small integer coordinates.
inline long long double_area(const std::vector<Point>& points, std::span<const VertexId> polygon) {
  long long area = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point a = points[polygon[i]];
    const Point b = points[polygon[(i + 1) % polygon.size()]];
    area += static_cast<long long>(a.x) * static_cast<long long>(b.y) -
            static_cast<long long>(a.y) * static_cast<long long>(b.x);
  }
  return area;
}

/// Counts, orientation, adjacency along the path and twins. Exact for all doubles.
inline void expect_serpentine(const SerpentineResult& result) {
  const Triangulation& mesh = result.mesh;
  const std::size_t n = mesh.points.size();
  const std::vector<VertexId> hull = convex_hull(mesh.points);
  ASSERT_EQ(result.spiral, convex_spiral(mesh.points));
  ASSERT_EQ(mesh.triangle_count(), 2 * n - 2 - hull.size());
  ASSERT_EQ(mesh.twin.size(), mesh.tri_vertex.size());
  std::size_t boundary = 0;
  for (HalfedgeId h = 0; h < mesh.twin.size(); ++h) {
    const HalfedgeId twin = mesh.twin[h];
    if (twin == kNone) {
      ++boundary;
      continue;
    }
    ASSERT_EQ(mesh.twin[twin], h);
    ASSERT_EQ(mesh.origin(h), mesh.target(twin));
    ASSERT_EQ(mesh.target(h), mesh.origin(twin));
  }
  ASSERT_EQ(boundary, hull.size());
  for (TriangleId t = 0; t < mesh.triangle_count(); ++t) {
    const VertexId* v = mesh.tri_vertex.data() + 3 * t;
    ASSERT_EQ(orient2d(mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]]), 1) << t;
    if (t == 0) continue;
    const HalfedgeId before = mesh.twin[3 * t];
    ASSERT_NE(before, kNone);
    ASSERT_EQ(triangle_of(before), t - 1);
  }
  ASSERT_EQ(mesh.origin(0), result.spiral[0]);
  ASSERT_EQ(mesh.target(0), result.spiral[hull.size() - 1]);
  ASSERT_EQ(mesh.twin[0], kNone);
}

/// With positive triangles whose edges match, the right sum of areas proves the tiling.
inline void expect_area_of_hull(const Triangulation& mesh) {
  long long sum = 0;
  for (TriangleId t = 0; t < mesh.triangle_count(); ++t) {
    sum += double_area(mesh.points, {mesh.tri_vertex.data() + 3 * t, 3});
  }
  ASSERT_EQ(sum, double_area(mesh.points, convex_hull(mesh.points)));
}

}  // namespace quadloom::testing
