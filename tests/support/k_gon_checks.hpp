// What a mesh of k-gons of a point set must be.
#pragma once

#include <gtest/gtest.h>

#include "quadloom/quadloom.hpp"

namespace quadloom::testing {

/// Certified: simple k-gons that tile a convex region, every point a vertex; the count of faces that
/// Euler's formula gives.
inline void expect_k_angulation(const KAngulationResult& result, std::span<const Point> points,
                                std::size_t k) {
  CertifyOptions options;
  options.corners = k;
  options.steiner_at_most = result.steiner.size();
  const Certificate verdict = certify_points(result.mesh, points, options);
  ASSERT_TRUE(verdict.ok()) << verdict.sentence;
  ASSERT_EQ(result.mesh.points.size(), result.input_vertices + result.steiner.size());
  std::size_t inner = 0;
  for (const SteinerPoint& s : result.steiner) inner += s.kind == SteinerKind::kInner ? 1 : 0;
  const std::size_t n = result.input_vertices;
  const std::size_t h = verdict.boundary - (result.steiner.size() - inner);
  ASSERT_EQ((k - 2) * result.mesh.face_count(), 2 * n - 2 - h + result.steiner.size() + inner);
  ASSERT_EQ(result.input_to_vertex.size(), points.size());
}

}  // namespace quadloom::testing
