// What a strictly convex patch of a small polygon promises, judged by certify.
#pragma once

#include <gtest/gtest.h>

#include <span>
#include <vector>

#include "quadloom/quadloom.hpp"

namespace quadloom::testing {

/// Gtest failures if the patch is not one of the polygon with its inner points.
inline void expect_convex_patch(std::span<const Point> ring, std::span<const Point> inner,
                                const ConvexPatch& patch, std::size_t most) {
  PolygonMesh mesh;
  mesh.points.assign(ring.begin(), ring.end());
  mesh.points.insert(mesh.points.end(), inner.begin(), inner.end());
  mesh.points.insert(mesh.points.end(), patch.steiner.begin(), patch.steiner.end());
  for (const auto& quad : patch.quads) mesh.add_face(quad);
  const Polygon polygon{{{ring.begin(), ring.end()}}};
  CertifyOptions wanted;
  wanted.strictly_convex = true;
  wanted.steiner_inside = true;
  wanted.steiner_at_most = most;
  const Certificate certificate = certify_polygons(mesh, {&polygon, 1}, inner, wanted);
  EXPECT_TRUE(certificate.ok()) << certificate.sentence;
  EXPECT_EQ(certificate.steiner, patch.steiner.size());
  EXPECT_EQ(certificate.boundary, ring.size());
}

/// Whether there must be doubles for all Steiner points.
enum class Room { kEnough, kScarce };

/// Gtest failures if the strictly convex quads of a point set are not what convex_quadrangulation
/// promises.
inline void expect_convex_quads(const std::vector<Point>& input, const ConvexOptions& options,
                                const ConvexResult& result, Room room = Room::kEnough) {
  const std::size_t n = distinct_points(input).points.size();
  const bool odd = result.statistics.hull_points % 2 == 1;
  const bool outer =
      !result.steiner.empty() && result.steiner.front().kind == SteinerKind::kOutside;
  CertifyOptions wanted;
  wanted.strictly_convex = room == Room::kEnough;
  wanted.steiner_inside = !outer;
  const std::size_t triangles = 2 * n - 2 - result.statistics.hull_points;
  wanted.steiner_at_most =
      options.method == ConvexMethod::kPentagons ? 7 * ((triangles + 5) / 6) : 3 * (n / 2);
  wanted.steiner_at_most += outer ? 1 : 0;
  wanted.triangles_allowed = odd && !outer ? 1 : 0;
  const Certificate certificate = certify_points(to_polygon_mesh(result.mesh), input, wanted);
  EXPECT_TRUE(certificate.ok()) << certificate.sentence;
  EXPECT_EQ(certificate.triangles, wanted.triangles_allowed);
  EXPECT_EQ(certificate.strictly_convex + result.not_convex.size(), result.mesh.quad_count());
  if (room == Room::kEnough) {
    EXPECT_TRUE(result.not_convex.empty());
  }
  EXPECT_TRUE(odd || !outer);
  if (options.odd_boundary == OddBoundary::kTriangle) {
    EXPECT_FALSE(outer);
  }
  EXPECT_EQ(result.input_vertices, n);
  EXPECT_EQ(result.mesh.points.size(), n + result.steiner.size());
  ASSERT_EQ(result.input_to_vertex.size(), input.size());
  for (std::size_t i = 0; i < input.size(); ++i) {
    EXPECT_EQ(result.mesh.points[result.input_to_vertex[i]], input[i]);
  }
  for (std::size_t i = 0; i < result.steiner.size(); ++i) {
    const SteinerPoint& steiner = result.steiner[i];
    EXPECT_EQ(steiner.vertex, n + i);
    const auto at = [&](std::size_t k) { return result.mesh.points[steiner.parents[k]]; };
    const Point s = result.mesh.points[steiner.vertex];
    if (steiner.kind == SteinerKind::kOutside) {
      EXPECT_EQ(orient2d(at(0), at(1), s), -1);
    } else {
      for (std::size_t k = 0; k < 3; ++k) EXPECT_GE(orient2d(at(k), at((k + 1) % 3), s), 0);
    }
  }
}

}  // namespace quadloom::testing
