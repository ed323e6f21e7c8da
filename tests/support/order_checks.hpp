// Orders of triangles, found and judged in the obvious way.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "quadloom/quadloom.hpp"

namespace quadloom::test {

inline std::optional<HalfedgeId> shared_edge(const Triangulation& mesh, TriangleId t,
                                             TriangleId u) {
  for (HalfedgeId h = 3 * t; h < 3 * t + 3; ++h) {
    if (mesh.twin[h] != kNone && triangle_of(mesh.twin[h]) == u) return h;
  }
  return {};
}

/// The best closure of a sequential order, from every triangle with its corners in every order.
inline std::optional<Closure> brute_sequential(const Triangulation& mesh) {
  std::optional<Closure> best;
  const std::size_t count = mesh.triangle_count();
  for (TriangleId start = 0; start < count; ++start) {
    for (int order = 0; order < 6; ++order) {
      std::array<VertexId, 3> s;
      for (int i = 0; i < 3; ++i) {
        s[i] = mesh.tri_vertex[3 * start + (order % 3 + (order < 3 ? i : 3 - i)) % 3];
      }
      const auto first = s;
      std::vector<bool> seen(count);
      std::size_t reached = 0;
      TriangleId t = start, last = start;
      bool closes = false;
      while (true) {
        if (seen[t]) {
          closes = t == start && s == first;
          break;
        }
        seen[t] = true;
        last = t;
        ++reached;
        HalfedgeId exit = kNone;
        for (HalfedgeId h = 3 * t; h < 3 * t + 3; ++h) {
          if (mesh.apex(h) == s[0]) exit = h;
        }
        if (mesh.twin[exit] == kNone) break;
        t = triangle_of(mesh.twin[exit]);
        s = {s[1], s[2], mesh.apex(mesh.twin[exit])};
      }
      if (reached < count) continue;
      Closure closure = Closure::kOpen;
      if (count >= 3 && closes) {
        closure = Closure::kSequentialCycle;
      } else if (count >= 3 && shared_edge(mesh, start, last)) {
        closure = Closure::kCycle;
      }
      best = std::max(best.value_or(closure), closure);
    }
  }
  return best;
}

/// Gtest failures if `order` is not one of that kind over all triangles.
inline void expect_order(const Triangulation& mesh, std::span<const TriangleId> order,
                         OrderKind kind) {
  ASSERT_EQ(order.size(), mesh.triangle_count());
  const Certificate verdict = certify_order(to_polygon_mesh(reorder_triangles(mesh, order)), kind);
  EXPECT_TRUE(verdict.ok()) << verdict.sentence;
}

}  // namespace quadloom::test
