#include "strips/ordered_mesh.hpp"

#include <algorithm>
#include <utility>

namespace quadloom::strips {

Triangulation connect_in_order(std::vector<Point> points, std::vector<VertexId> corners) {
  Triangulation mesh{std::move(points), std::move(corners), {}};
  const auto count = static_cast<HalfedgeId>(mesh.tri_vertex.size());
  mesh.twin.assign(count, kNone);
  std::vector<HalfedgeId> sides(count);
  for (HalfedgeId h = 0; h < count; ++h) sides[h] = h;
  const auto ends = [&](HalfedgeId h) { return std::minmax({mesh.origin(h), mesh.target(h)}); };
  std::sort(sides.begin(), sides.end(), [&](HalfedgeId g, HalfedgeId h) {
    const auto a = ends(g), b = ends(h);
    return a != b ? a < b : g < h;
  });
  for (HalfedgeId i = 1; i < count; ++i) {
    const HalfedgeId g = sides[i - 1], h = sides[i];
    if (mesh.origin(g) != mesh.target(h) || mesh.target(g) != mesh.origin(h)) continue;
    mesh.twin[g] = h;
    mesh.twin[h] = g;
  }
  return mesh;
}

}  // namespace quadloom::strips
