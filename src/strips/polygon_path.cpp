#include "strips/polygon_path.hpp"

#include <utility>

#include "strips/match_twins.hpp"

namespace quadloom::strips {

PolygonOrder order_of_disc(PolygonDisc&& disc, const std::vector<Position>& corners,
                           OrderKind order) {
  PolygonOrder out;
  out.input_vertices = disc.mesh.points.size();
  out.mesh.tri_vertex.reserve(corners.size());
  for (const Position i : corners) out.mesh.tri_vertex.push_back(disc.vertex[i]);
  out.mesh.twin = match_twins(out.mesh.tri_vertex, out.input_vertices);
  out.mesh.points = std::move(disc.mesh.points);
  out.order = order;
  out.input_to_vertex = std::move(disc.input_to_vertex);
  return out;
}

}  // namespace quadloom::strips
