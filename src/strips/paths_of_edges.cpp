// Paths from the edges that they use. Cost: O(n).
#include "strips/paths_of_edges.hpp"

namespace quadloom::strips {
namespace {

/// The first used halfedge of the node other than `entry`, kNone if there is none.
HalfedgeId way_on(const std::vector<std::uint8_t>& used, TriangleId t, HalfedgeId entry) {
  for (HalfedgeId h = 3 * t; h < 3 * t + 3; ++h) {
    if (used[h] != 0 && h != entry) return h;
  }
  return kNone;
}

bool is_end(const std::vector<std::uint8_t>& used, TriangleId t) {
  return used[3 * t] + used[3 * t + 1] + used[3 * t + 2] < 2;
}

}  // namespace

PathPartition paths_of_edges(const DualGraph& graph, const std::vector<std::uint8_t>& used) {
  PathPartition out;
  out.leave.reserve(graph.node_count());
  std::vector<std::uint8_t> seen(graph.node_count());
  for (TriangleId end = 0; end < graph.node_count(); ++end) {
    if (seen[end] != 0 || !is_end(used, end)) continue;
    TriangleId t = end;
    HalfedgeId entry = kNone;
    for (;;) {
      seen[t] = 1;
      const HalfedgeId on = way_on(used, t, entry);
      if (on == kNone) break;
      out.leave.push_back(on);
      entry = graph.twin[on];
      t = triangle_of(entry);
    }
    out.leave.push_back(entry == kNone ? 3 * t : next_halfedge(entry));
    out.begin.push_back(static_cast<std::uint32_t>(out.leave.size()));
  }
  return out;
}

}  // namespace quadloom::strips
