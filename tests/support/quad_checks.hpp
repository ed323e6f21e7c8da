// What a quadrangulation of a point set must be, with the certifier as judge.
#pragma once

#include <gtest/gtest.h>

#include "quadloom/quadloom.hpp"

namespace quadloom::testing {

/// Certified, with the counts of Bose and Toussaint's theorems.
inline void expect_quadrangulation(const PointResult& result, std::span<const Point> input,
                                   OddBoundary wish) {
  const bool odd = result.statistics.hull_points % 2 == 1;
  const bool leave_triangle = odd && wish == OddBoundary::kTriangle;
  CertifyOptions options;
  options.triangles_allowed = leave_triangle ? 1 : 0;
  options.steiner_at_most = odd && !leave_triangle ? 1 : 0;
  const Certificate verdict = certify_points(to_polygon_mesh(result.mesh), input, options);
  ASSERT_TRUE(verdict.ok()) << verdict.sentence;
  ASSERT_EQ(result.mesh.triangle_count(), options.triangles_allowed);
  ASSERT_EQ(result.steiner.size(), options.steiner_at_most);
  ASSERT_EQ(result.input_to_vertex.size(), input.size());
  for (std::size_t i = 0; i < input.size(); ++i) {
    ASSERT_EQ(result.mesh.points[result.input_to_vertex[i]], input[i]);
  }
}

}  // namespace quadloom::testing
