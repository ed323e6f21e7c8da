#include "convex/patch.hpp"

#include <algorithm>
#include <functional>
#include <utility>

namespace quadloom::convex {

bool tiles(std::span<const Point> given, std::size_t sides, const Patch& patch) {
  const auto corner = [&](std::uint32_t name) {
    return Corner{name < given.size() ? given[name] : patch.steiner[name - given.size()], name};
  };
  const std::size_t points = given.size() + patch.steiner.size();
  using Edge = std::pair<std::uint32_t, std::uint32_t>;
  boost::container::static_vector<Edge, 4 * 8> edges;
  std::array<bool, 16> used{};
  for (const LocalQuad& q : patch.quads) {
    if (std::any_of(q.begin(), q.end(), [&](std::uint32_t v) { return v >= points; })) return false;
    if (!strictly_convex(corner(q[0]), corner(q[1]), corner(q[2]), corner(q[3]))) return false;
    for (std::size_t i = 0; i < 4; ++i) {
      edges.push_back({q[i], q[(i + 1) % 4]});
      used[q[i]] = true;
    }
  }
  std::sort(edges.begin(), edges.end());
  if (std::adjacent_find(edges.begin(), edges.end()) != edges.end()) return false;
  const auto has = [&](Edge e) { return std::binary_search(edges.begin(), edges.end(), e); };
  std::size_t on_boundary = 0;
  for (const Edge& e : edges) {
    if (has({e.second, e.first})) continue;
    if (e.first >= sides || e.second != (e.first + 1) % sides) return false;
    ++on_boundary;
  }
  return on_boundary == sides && std::all_of(used.begin(), used.begin() + points, std::identity{});
}

}  // namespace quadloom::convex
