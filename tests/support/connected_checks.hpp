// What connect_triangles promises, checked from the result alone.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "quadloom/kernel.hpp"

namespace quadloom::test {

inline bool on_a_line(const TriangleMesh& mesh, TriangleId t) {
  std::array<Point, 3> p;
  std::array<double, 3> z{};
  for (std::size_t i = 0; i < 3; ++i) {
    const VertexId v = mesh.mesh.tri_vertex[3 * t + i];
    p[i] = mesh.mesh.points[v];
    if (!mesh.z.empty()) z[i] = mesh.z[v];
  }
  return orient2d(p[0], p[1], p[2]) == 0 &&
         orient2d({p[0].x, z[0]}, {p[1].x, z[1]}, {p[2].x, z[2]}) == 0 &&
         orient2d({p[0].y, z[0]}, {p[1].y, z[1]}, {p[2].y, z[2]}) == 0;
}

inline void check_connected(const ConnectedMesh& out, std::size_t input_vertices) {
  const Triangulation& mesh = out.triangles.mesh;
  ASSERT_EQ(mesh.tri_vertex.size() % 3, 0U);
  ASSERT_EQ(mesh.twin.size(), mesh.tri_vertex.size());
  ASSERT_EQ(out.source_face.size(), mesh.triangle_count());
  ASSERT_EQ(out.input_to_vertex.size(), input_vertices);
  ASSERT_GT(mesh.triangle_count(), 0U);
  ASSERT_NE(out.space, Space::kAuto);
  ASSERT_EQ(out.triangles.z.size(), out.space == Space::kPlane ? 0 : mesh.points.size());
  const auto& pair = out.triangles.given_pair;
  ASSERT_TRUE(pair.empty() || pair.size() == mesh.triangle_count());
  std::set<std::pair<VertexId, VertexId>> sides;
  std::set<VertexId> used;
  std::size_t boundary = 0;
  for (HalfedgeId h = 0; h < mesh.twin.size(); ++h) {
    const HalfedgeId twin = mesh.twin[h];
    used.insert(mesh.origin(h));
    ASSERT_LT(mesh.origin(h), mesh.points.size());
    const bool diagonal = !pair.empty() && pair[triangle_of(h)] == h;
    if (!diagonal) {
      ASSERT_TRUE(sides.emplace(mesh.origin(h), mesh.target(h)).second);
    }
    if (twin == kNone) {
      ASSERT_FALSE(diagonal);
      ++boundary;
      continue;
    }
    ASSERT_NE(triangle_of(twin), triangle_of(h));
    ASSERT_EQ(mesh.twin[twin], h);
    ASSERT_EQ(mesh.origin(twin), mesh.target(h));
    ASSERT_EQ(mesh.target(twin), mesh.origin(h));
    if (!diagonal) continue;
    ASSERT_EQ(pair[triangle_of(twin)], twin);
    ASSERT_EQ(out.source_face[triangle_of(twin)], out.source_face[triangle_of(h)]);
  }
  ASSERT_EQ(boundary, out.boundary_edges);
  ASSERT_EQ(used.size() + out.unused_vertices, mesh.points.size());
  for (TriangleId t = 0; t < mesh.triangle_count(); ++t) {
    ASSERT_FALSE(on_a_line(out.triangles, t)) << t;
    if (out.space != Space::kPlane) continue;
    const VertexId* v = &mesh.tri_vertex[3 * t];
    ASSERT_GT(orient2d(mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]]), 0) << t;
  }
}

/// vertices - edges + triangles, of used vertices.
inline long euler_characteristic(const ConnectedMesh& out) {
  const auto triangles = static_cast<long>(out.triangles.mesh.triangle_count());
  const auto edges = (3 * triangles + static_cast<long>(out.boundary_edges)) / 2;
  return static_cast<long>(out.triangles.mesh.points.size() - out.unused_vertices) - edges +
         triangles;
}

}  // namespace quadloom::test
