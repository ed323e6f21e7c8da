// Halfedges in buckets by their smaller end, sorted there by the other one: twins are neighbours.
#include "strips/match_twins.hpp"

#include <algorithm>

namespace quadloom::strips {

std::vector<HalfedgeId> match_twins(std::span<const VertexId> tri_vertex, std::size_t vertices) {
  const auto target = [&](HalfedgeId h) { return tri_vertex[next_halfedge(h)]; };
  const auto small = [&](HalfedgeId h) { return std::min(tri_vertex[h], target(h)); };
  const auto large = [&](HalfedgeId h) { return std::max(tri_vertex[h], target(h)); };

  std::vector<std::uint32_t> end(vertices + 1, 0);
  for (HalfedgeId h = 0; h < tri_vertex.size(); ++h) ++end[small(h) + 1];
  for (std::size_t v = 0; v < vertices; ++v) end[v + 1] += end[v];
  std::vector<HalfedgeId> sorted(tri_vertex.size());
  std::vector<std::uint32_t> at(end.begin(), end.end() - 1);
  for (HalfedgeId h = 0; h < tri_vertex.size(); ++h) sorted[at[small(h)]++] = h;

  std::vector<HalfedgeId> twin(tri_vertex.size(), kNone);
  for (std::size_t v = 0; v < vertices; ++v) {
    const auto first = sorted.begin() + end[v], last = sorted.begin() + end[v + 1];
    std::sort(first, last, [&](HalfedgeId a, HalfedgeId b) {
      return large(a) != large(b) ? large(a) < large(b) : a < b;
    });
    for (auto it = first; it != last && it + 1 != last; ++it) {
      if (large(*it) != large(it[1])) continue;
      twin[*it] = it[1];
      twin[it[1]] = *it;
      ++it;
    }
  }
  return twin;
}

}  // namespace quadloom::strips
