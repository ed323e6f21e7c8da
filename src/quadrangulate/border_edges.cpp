#include "quadrangulate/border_edges.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace quadloom::quadrangulate {

void require_planar(const TriangleMesh& input) {
  if (input.z.empty()) return;
  throw Error(ErrorCode::kBadMesh,
              "a surface in space has no outside: this method's Steiner points are for planar "
              "meshes");
}

std::vector<HalfedgeId> boundary_edges(const Triangulation& mesh) {
  std::vector<HalfedgeId> out;
  for (HalfedgeId h = 0; h < mesh.twin.size(); ++h) {
    if (mesh.twin[h] == kNone) out.push_back(h);
  }
  return out;
}

OuterPlace longest_with_place(const Triangulation& mesh, std::span<const TriangleId> triangles,
                              OuterPlaces& places) {
  std::vector<std::pair<double, HalfedgeId>> edges;
  for (const TriangleId t : triangles) {
    for (HalfedgeId h = 3 * t; h < 3 * t + 3; ++h) {
      if (mesh.twin[h] != kNone) continue;
      const Point a = mesh.points[mesh.origin(h)], b = mesh.points[mesh.target(h)];
      const double x = b.x - a.x, y = b.y - a.y;
      edges.emplace_back(-(x * x + y * y), h);
    }
  }
  std::sort(edges.begin(), edges.end());
  for (const auto& [length, h] : edges) {
    if (const auto place = places.place(h)) return {h, *place};
  }
  throw Error(ErrorCode::kGuarantee,
              (edges.empty() ? "there is no boundary edge for a Steiner point at triangle "
                             : "there is no place for a Steiner point outside triangle ") +
                  std::to_string(triangles[0]),
              {triangles.begin(), triangles.end()});
}

}  // namespace quadloom::quadrangulate
