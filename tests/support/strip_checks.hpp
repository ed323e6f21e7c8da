// The shortest strips by brute force.
#pragma once

#include <array>
#include <map>
#include <queue>
#include <tuple>
#include <vector>

#include "quadloom/strips.hpp"

namespace quadloom::test {

/// The least number of indices that draws each triangle of a tiny mesh once and nothing else: breadth
/// first over the last two vertices, the turn, and the set of what was drawn.
inline std::size_t brute_force_indices(const Triangulation& mesh, bool restarts) {
  using State = std::tuple<VertexId, VertexId, bool, std::uint32_t>;  // kNone: not sent yet
  std::map<std::array<VertexId, 3>, TriangleId> triangle;
  for (TriangleId t = 0; t < mesh.triangle_count(); ++t) {
    for (int i = 0; i < 3; ++i) {
      const auto corner = [&](int k) { return mesh.tri_vertex[3 * t + (i + k) % 3]; };
      triangle[{corner(0), corner(1), corner(2)}] = t;
    }
  }
  const std::uint32_t all = (1U << mesh.triangle_count()) - 1;
  std::map<State, std::size_t> distance;
  std::queue<State> queue;
  const auto reach = [&](const State& s, std::size_t d) {
    if (distance.emplace(s, d).second) queue.push(s);
  };
  reach({kNone, kNone, false, 0}, 0);
  for (; !queue.empty(); queue.pop()) {
    const State s = queue.front();
    const auto [a, b, odd, drawn] = s;
    const std::size_t d = distance[s];
    if (drawn == all) return d;
    if (restarts && b != kNone) reach({kNone, kNone, false, drawn}, d + 1);
    for (VertexId v = 0; v < mesh.points.size(); ++v) {
      if (b == kNone || a == kNone) {
        reach({b, v, false, drawn}, d + 1);
      } else if (a == b || b == v || a == v) {
        reach({b, v, !odd, drawn}, d + 1);
      } else {
        const auto found = odd ? triangle.find({b, a, v}) : triangle.find({a, b, v});
        if (found == triangle.end() || (drawn >> found->second & 1) != 0) continue;
        reach({b, v, !odd, drawn | 1U << found->second}, d + 1);
      }
    }
  }
  return 0;
}

}  // namespace quadloom::test
