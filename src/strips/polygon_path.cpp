#include "strips/polygon_path.hpp"

#include <utility>

#include "strips/ordered_mesh.hpp"

namespace quadloom::strips {

PolygonOrder order_of_disc(PolygonDisc&& disc, const std::vector<Position>& corners,
                           OrderKind order) {
  std::vector<VertexId> vertices;
  vertices.reserve(corners.size());
  for (const Position i : corners) vertices.push_back(disc.vertex[i]);
  PolygonOrder out;
  out.input_vertices = disc.mesh.points.size();
  out.mesh = connect_in_order(std::move(disc.mesh.points), std::move(vertices));
  out.order = order;
  out.input_to_vertex = std::move(disc.input_to_vertex);
  return out;
}

}  // namespace quadloom::strips
