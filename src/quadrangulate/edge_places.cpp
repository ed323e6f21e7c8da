// Places at boundary edges, of the wished kind or the other.
#include "quadrangulate/edge_places.hpp"

#include <string>

#include "kernel/point_on_segment.hpp"
#include "quadrangulate/odd_boundary.hpp"

namespace quadloom::quadrangulate {

std::optional<EdgePlace> EdgePlaces::place_of_kind(HalfedgeId h, SteinerKind kind) {
  const Triangulation& mesh = input_.mesh;
  std::optional<Point> place;
  if (kind == SteinerKind::kOnEdge) {
    place = kernel::point_on_segment(mesh.points[mesh.origin(h)], mesh.points[mesh.target(h)]);
  } else {
    if (!outer_) outer_.emplace(mesh);
    place = outer_->place(h);
  }
  if (!place) return std::nullopt;
  return EdgePlace{*place, 0, kind};
}

std::optional<EdgePlace> EdgePlaces::place(HalfedgeId h) {
  const Triangulation& mesh = input_.mesh;
  if (!input_.z.empty()) {
    const VertexId a = mesh.origin(h), b = mesh.target(h);
    const Point p = mesh.points[a], q = mesh.points[b];
    return EdgePlace{{p.x / 2 + q.x / 2, p.y / 2 + q.y / 2},
                     input_.z[a] / 2 + input_.z[b] / 2,
                     SteinerKind::kOnEdge};
  }
  for (const SteinerKind kind : kinds_by_wish(wish_)) {
    if (const auto found = place_of_kind(h, kind)) return found;
  }
  return std::nullopt;
}

EdgePlace EdgePlaces::place_or_throw(HalfedgeId h) {
  if (const auto found = place(h)) return *found;
  const VertexId a = input_.mesh.origin(h), b = input_.mesh.target(h);
  throw Error(ErrorCode::kGuarantee,
              "there is no place for a Steiner point at the boundary edge from vertex " +
                  std::to_string(a) + " to vertex " + std::to_string(b),
              {a, b});
}

}  // namespace quadloom::quadrangulate
