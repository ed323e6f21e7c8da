// What is true of every result of delaunay(), checked with the exact predicates.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <vector>

#include "quadloom/kernel.hpp"

namespace quadloom {

/// The vertices are the distinct input points in the order of first occurrence.
inline void expect_vertices(const std::vector<Point>& input, const DelaunayResult& result) {
  std::map<std::pair<double, double>, VertexId> number;
  ASSERT_EQ(result.input_to_vertex.size(), input.size());
  for (std::size_t i = 0; i < input.size(); ++i) {
    const auto next = static_cast<VertexId>(number.size());
    const auto [where, fresh] = number.try_emplace({input[i].x + 0.0, input[i].y + 0.0}, next);
    ASSERT_EQ(result.input_to_vertex[i], where->second);
    ASSERT_LT(where->second, result.mesh.points.size());
    ASSERT_EQ(result.mesh.points[where->second], input[i]);
  }
  ASSERT_EQ(result.mesh.points.size(), number.size());
}

/// Positive triangles, twins that match, a boundary that is the hull with every point on it: then
/// the triangles tile the hull once. Every vertex is used.
inline void expect_tiling(const Triangulation& mesh) {
  const std::size_t n = mesh.points.size(), halfedges = mesh.tri_vertex.size();
  ASSERT_EQ(mesh.twin.size(), halfedges);
  ASSERT_EQ(halfedges % 3, 0U);
  std::vector<VertexId> after(n, kNone);
  std::vector<bool> used(n, false);
  std::size_t boundary = 0;
  for (HalfedgeId h = 0; h < halfedges; ++h) {
    ASSERT_LT(mesh.origin(h), n);
    used[mesh.origin(h)] = true;
    if (mesh.twin[h] == kNone) {
      ASSERT_EQ(after[mesh.origin(h)], kNone);
      after[mesh.origin(h)] = mesh.target(h);
      ++boundary;
      continue;
    }
    ASSERT_LT(mesh.twin[h], halfedges);
    ASSERT_EQ(mesh.twin[mesh.twin[h]], h);
    ASSERT_EQ(mesh.origin(mesh.twin[h]), mesh.target(h));
    ASSERT_EQ(mesh.target(mesh.twin[h]), mesh.origin(h));
  }
  for (HalfedgeId h = 0; h < halfedges; h += 3) {
    ASSERT_EQ(orient2d(mesh.points[mesh.origin(h)], mesh.points[mesh.target(h)],
                       mesh.points[mesh.apex(h)]),
              1);
  }
  ASSERT_EQ(std::count(used.begin(), used.end(), false), 0);
  const std::vector<VertexId> hull = convex_hull(mesh.points);
  ASSERT_EQ(boundary, hull.size());
  for (std::size_t i = 0; i < hull.size(); ++i) {
    ASSERT_EQ(after[hull[i]], hull[(i + 1) % hull.size()]);
  }
  ASSERT_EQ(halfedges / 3, 2 * n - 2 - hull.size());
}

/// Every edge is locally Delaunay, so all are. Of four points on a circle the lexicographically
/// largest is not on the diagonal: it is the one that is lifted.
inline void expect_locally_delaunay(const Triangulation& mesh) {
  for (HalfedgeId h = 0; h < mesh.twin.size(); ++h) {
    if (mesh.twin[h] == kNone) continue;
    const Point a = mesh.points[mesh.origin(h)], b = mesh.points[mesh.target(h)];
    const Point c = mesh.points[mesh.apex(h)], d = mesh.points[mesh.apex(mesh.twin[h])];
    const int sign = incircle(a, b, c, d);
    ASSERT_LE(sign, 0);
    if (sign == 0) {
      const Point beside = lex_less(c, d) ? d : c;
      ASSERT_TRUE(lex_less(a, beside) && lex_less(b, beside));
    }
  }
}

inline void expect_delaunay(const std::vector<Point>& input, const DelaunayResult& result) {
  ASSERT_NO_FATAL_FAILURE(expect_vertices(input, result));
  ASSERT_NO_FATAL_FAILURE(expect_tiling(result.mesh));
  ASSERT_NO_FATAL_FAILURE(expect_locally_delaunay(result.mesh));
}

/// The triangles by their corners' coordinates, each from its lexicographically smallest corner, in
/// order: equal for equal sets of triangles.
using TriangleSet = std::vector<std::array<double, 6>>;

inline std::array<double, 6> canonical_triangle(Point a, Point b, Point c) {
  while (lex_less(b, a) || lex_less(c, a)) {
    std::swap(a, b);
    std::swap(b, c);
  }
  return {a.x + 0.0, a.y + 0.0, b.x + 0.0, b.y + 0.0, c.x + 0.0, c.y + 0.0};
}

inline TriangleSet triangle_set(const Triangulation& mesh) {
  TriangleSet out;
  for (HalfedgeId h = 0; h < mesh.tri_vertex.size(); h += 3) {
    out.push_back(canonical_triangle(mesh.points[mesh.origin(h)], mesh.points[mesh.target(h)],
                                     mesh.points[mesh.apex(h)]));
  }
  std::sort(out.begin(), out.end());
  return out;
}

}  // namespace quadloom
