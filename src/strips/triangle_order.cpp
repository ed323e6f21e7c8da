// The triangles of a triangulation in another order. Cost: linear.
#include <string>

#include "quadloom/strips.hpp"

namespace quadloom {

Triangulation reorder_triangles(const Triangulation& mesh, std::span<const TriangleId> order) {
  const std::size_t count = mesh.triangle_count();
  std::vector<TriangleId> place(count, kNone);
  for (TriangleId i = 0; i < order.size(); ++i) {
    if (order[i] >= count || place[order[i]] != kNone) {
      throw Error(ErrorCode::kBadOption,
                  "triangle " + std::to_string(order[i]) + " is not there, or twice in the order",
                  {order[i]});
    }
    place[order[i]] = i;
  }
  if (order.size() != count) {
    throw Error(ErrorCode::kBadOption, "the order has " + std::to_string(order.size()) + " of " +
                                           std::to_string(count) + " triangles");
  }
  Triangulation out;
  out.points = mesh.points;
  out.tri_vertex.reserve(3 * count);
  out.twin.reserve(3 * count);
  for (const TriangleId t : order) {
    for (HalfedgeId h = 3 * t; h < 3 * t + 3; ++h) {
      const HalfedgeId twin = mesh.twin[h];
      out.tri_vertex.push_back(mesh.tri_vertex[h]);
      out.twin.push_back(twin == kNone ? kNone : 3 * place[triangle_of(twin)] + twin % 3);
    }
  }
  return out;
}

}  // namespace quadloom
