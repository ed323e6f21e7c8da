// Whether a paired mesh is in order: neighbours and partners mutual, and its faces certified.
#pragma once

#include <gtest/gtest.h>

#include "quadloom/quadloom.hpp"
#include "quadrangulate/paired_mesh.hpp"

namespace quadloom::testing {

inline void check_paired_mesh(const quadrangulate::PairedMesh& mesh, std::size_t free) {
  std::size_t counted = 0;
  for (HalfedgeId h = 0; h < mesh.tri.twin.size(); ++h) {
    const HalfedgeId twin = mesh.tri.twin[h];
    if (twin == kNone) continue;
    ASSERT_EQ(mesh.tri.twin[twin], h);
    ASSERT_EQ(mesh.tri.origin(twin), mesh.tri.target(h));
  }
  for (TriangleId t = 0; t < mesh.mate.size(); ++t) {
    if (mesh.is_free(t)) {
      ++counted;
    } else {
      ASSERT_EQ(triangle_of(mesh.mate[t]), t);
      const HalfedgeId theirs = mesh.tri.twin[mesh.mate[t]];
      ASSERT_EQ(mesh.mate[triangle_of(theirs)], theirs);
    }
  }
  EXPECT_EQ(counted, free);
  const Certificate certificate = certify_points(
      to_polygon_mesh(quadrangulate::to_quadrangulation(mesh)), {}, {.triangles_allowed = free});
  EXPECT_TRUE(certificate.ok()) << certificate.sentence;
}

}  // namespace quadloom::testing
