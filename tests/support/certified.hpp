// What every quadrangulation of a point set promises, checked from the result alone.
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "quadloom/quadloom.hpp"

namespace quadloom {

/// The promise of quadrangulate_points; gtest failures if it is broken.
inline void check_promise(const std::vector<Point>& input, const PointOptions& options,
                          const PointResult& result) {
  const std::vector<Point> distinct = distinct_points(input).points;
  const std::size_t hull = convex_hull(distinct).size();
  const bool odd = hull % 2 == 1;
  const bool triangle_stays = odd && options.odd_boundary == OddBoundary::kTriangle;
  const bool subdivided = options.method == PointMethod::kSubdivide;

  CertifyOptions wanted;
  wanted.triangles_allowed = triangle_stays && !subdivided ? 1 : 0;
  wanted.strictly_convex = subdivided;
  if (!subdivided) wanted.steiner_at_most = odd && !triangle_stays ? 1 : 0;
  const Certificate certificate = certify_points(to_polygon_mesh(result.mesh), input, wanted);
  ASSERT_TRUE(certificate.ok()) << certificate.sentence;
  EXPECT_EQ(certificate.triangles, wanted.triangles_allowed);
  EXPECT_EQ(certificate.steiner, result.steiner.size());
  EXPECT_EQ(result.mesh.points.size(), distinct.size() + result.steiner.size());
  EXPECT_EQ(result.input_vertices, distinct.size());
  EXPECT_EQ(result.statistics.hull_points, hull);
  EXPECT_FALSE(result.statistics.fell_back_to_spiral);
  if (!subdivided) {
    EXPECT_EQ(certificate.steiner, wanted.steiner_at_most);
  }

  ASSERT_EQ(result.input_to_vertex.size(), input.size());
  for (std::size_t i = 0; i < input.size(); ++i) {
    EXPECT_EQ(result.mesh.points[result.input_to_vertex[i]], input[i]);
  }
  for (std::size_t i = 0; i < result.steiner.size(); ++i) {
    const SteinerPoint& steiner = result.steiner[i];
    EXPECT_EQ(steiner.vertex, distinct.size() + i);
    const auto at = [&](std::size_t k) { return result.mesh.points[steiner.parents[k]]; };
    if (steiner.kind == SteinerKind::kInner) continue;
    const int side = orient2d(at(0), at(1), result.mesh.points[steiner.vertex]);
    EXPECT_EQ(side, steiner.kind == SteinerKind::kOutside ? -1 : 0);
  }
}

/// Runs the method and checks its promise.
inline PointResult quadrangulate_checked(const std::vector<Point>& input,
                                         const PointOptions& options) {
  PointResult result = quadrangulate_points(input, options);
  check_promise(input, options, result);
  return result;
}

inline constexpr PointMethod kAllMethods[] = {PointMethod::kDelaunay, PointMethod::kSpiral,
                                              PointMethod::kInsertion, PointMethod::kSubdivide};
inline constexpr OddBoundary kAllOddBoundaries[] = {OddBoundary::kOutside, OddBoundary::kOnEdge,
                                                    OddBoundary::kTriangle};

}  // namespace quadloom
