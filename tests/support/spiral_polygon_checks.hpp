// What spiral_polygon promises, checked from the result alone, and against the paper's procedure.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>

#include "quadloom/quadloom.hpp"
#include "support/literal_spiral_polygon.hpp"

namespace quadloom::testing {

inline std::vector<Point> ring_points(const SpiralPolygon& spiral) {
  std::vector<Point> ring;
  for (const VertexId v : spiral.ring) ring.push_back(spiral.mesh.points[v]);
  return ring;
}

inline void expect_spiral_polygon(const std::vector<Point>& input, const SpiralPolygon& spiral) {
  const Polygon polygon{{ring_points(spiral)}};
  const std::size_t n = spiral.mesh.points.size();
  const Certificate ring = certify_spiral_polygon(polygon.rings[0], input);
  ASSERT_TRUE(ring.ok()) << ring.sentence;
  ASSERT_EQ(ring.boundary, n);
  CertifyOptions triangles;
  triangles.corners = 3;
  triangles.steiner_at_most = 0;
  const PolygonMesh mesh = to_polygon_mesh(spiral.mesh);
  const Certificate tiling = certify_polygons(mesh, {&polygon, 1}, {}, triangles);
  ASSERT_TRUE(tiling.ok()) << tiling.sentence;
  const Certificate order = certify_order(mesh, OrderKind::kPath);
  ASSERT_TRUE(order.ok()) << order.sentence;
  ASSERT_EQ(spiral.mesh.triangle_count(), n - 2);
  ASSERT_EQ(std::count(spiral.mesh.twin.begin(), spiral.mesh.twin.end(), kNone),
            static_cast<std::ptrdiff_t>(n));
  ASSERT_LE(spiral.statistics.iterations, 2 * n);
  ASSERT_EQ(spiral.input_to_vertex.size(), input.size());
  for (std::size_t i = 0; i < input.size(); ++i) {
    ASSERT_EQ(spiral.mesh.points[spiral.input_to_vertex[i]], input[i]);
  }
}

/// For distinct points.
inline void expect_paper_procedure(const std::vector<Point>& points, const SpiralPolygon& spiral) {
  const std::vector<VertexId> flats = inside_first_edge(points);
  const LiteralSpiralPolygon expected = literal_spiral_polygon(points, flats);
  ASSERT_FALSE(expected.stuck);
  ASSERT_EQ(spiral.statistics.iterations, expected.iterations);
  std::vector<VertexId> ring = ring_of_path(expected.triangles);
  ring.insert(ring.begin() + 1, flats.begin(), flats.end());
  ASSERT_EQ(spiral.ring, ring);
  if (!flats.empty()) return;
  std::vector<VertexId> corners;
  for (const auto& t : expected.triangles) corners.insert(corners.end(), t.begin(), t.end());
  ASSERT_EQ(spiral.mesh.tri_vertex, corners);
}

}  // namespace quadloom::testing
