// What hamiltonian_cycle_triangulation promises, checked from the result alone.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <vector>

#include "quadloom/quadloom.hpp"
#include "support/point_triangulations.hpp"

namespace quadloom::testing {

inline void expect_twins(const Triangulation& mesh, std::size_t boundary) {
  ASSERT_EQ(mesh.twin.size(), mesh.tri_vertex.size());
  std::size_t single = 0;
  for (HalfedgeId h = 0; h < mesh.twin.size(); ++h) {
    const HalfedgeId twin = mesh.twin[h];
    if (twin == kNone) {
      ++single;
      continue;
    }
    ASSERT_LT(twin, mesh.twin.size());
    ASSERT_EQ(mesh.twin[twin], h);
    ASSERT_EQ(mesh.origin(h), mesh.target(twin));
    ASSERT_EQ(mesh.target(h), mesh.origin(twin));
  }
  ASSERT_EQ(single, boundary);
}

inline void expect_hamiltonian(const std::vector<Point>& input, const HamiltonianResult& result) {
  const PolygonMesh mesh = to_polygon_mesh(result.mesh);
  CertifyOptions triangles;
  triangles.corners = 3;
  triangles.steiner_at_most = 0;
  const Certificate tiling = certify_points(mesh, input, triangles);
  ASSERT_TRUE(tiling.ok()) << tiling.sentence;
  const Certificate order = certify_order(mesh, result.order);
  ASSERT_TRUE(order.ok()) << order.sentence;
  ASSERT_NE(result.order, OrderKind::kSequential);
  const std::size_t h = convex_hull(result.mesh.points).size();
  ASSERT_EQ(result.statistics.hull_points, h);
  ASSERT_EQ(result.mesh.triangle_count(), 2 * result.mesh.points.size() - 2 - h);
  ASSERT_EQ(result.order == OrderKind::kCycle, result.cycle == Answer::kYes);
  if (h == result.mesh.points.size()) {
    ASSERT_EQ(result.cycle, Answer::kNo);
  }
  expect_twins(result.mesh, h);
  ASSERT_EQ(result.input_to_vertex.size(), input.size());
  for (std::size_t i = 0; i < input.size(); ++i) {
    ASSERT_EQ(result.mesh.points[result.input_to_vertex[i]], input[i]);
  }
}

inline HamiltonianResult hamiltonian_checked(const std::vector<Point>& input,
                                             const HamiltonianOptions& options) {
  HamiltonianResult result = hamiltonian_cycle_triangulation(input, options);
  expect_hamiltonian(input, result);
  return result;
}

/// Whether the dual graph has a Hamiltonian cycle, of at least three triangles. Exponential.
inline bool has_hamiltonian_cycle(const std::vector<std::array<VertexId, 3>>& triangles) {
  const std::size_t count = triangles.size();
  if (count < 3) return false;
  std::vector<std::vector<std::size_t>> neighbours(count);
  for (std::size_t t = 0; t < count; ++t) {
    for (std::size_t u = 0; u < count; ++u) {
      std::size_t shared = 0;
      for (const VertexId v : triangles[t]) {
        for (const VertexId w : triangles[u]) shared += v == w ? 1 : 0;
      }
      if (shared == 2) neighbours[t].push_back(u);
    }
  }
  std::vector<char> visited(count, 0);
  const std::function<bool(std::size_t, std::size_t)> go = [&](std::size_t t, std::size_t length) {
    for (const std::size_t u : neighbours[t]) {
      if (length == count && u == 0) return true;
      if (visited[u]) continue;
      visited[u] = 1;
      if (go(u, length + 1)) return true;
      visited[u] = 0;
    }
    return false;
  };
  visited[0] = 1;
  return go(0, 1);
}

/// Whether some triangulation of the points has one.
inline bool has_hamiltonian_cycle_triangulation(const std::vector<Point>& points) {
  bool found = false;
  test::AllPointTriangulations(points).visit(
      [&](const auto& triangles) { found = found || has_hamiltonian_cycle(triangles); });
  return found;
}

}  // namespace quadloom::testing
