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

}  // namespace quadloom::testing
