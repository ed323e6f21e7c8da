// Steps: place_of for each boundary edge; may_move for those that have a needle behind them.
//
// A place exactly on the edge is found by a complete search (kernel/point_on_segment.hpp). About half of
// the edges between arbitrary doubles have none; then places outside are tried, from the midpoint as
// rounded on by doublings of one unit in the last place, then likewise at other eighths of the edge.
// outer_places.hpp, with exact predicates alone, tells whether one is outside and whether what lies
// beyond the edge is far enough.
//
//      a ------. m ----- b        the region is above; the dent is a unit in the last place deep
//
// Cost: O(1) an edge, and O(b log b) for b boundary edges if a point is outside.
#include "quadrangulate/outline_places.hpp"

#include <cmath>
#include <string>

#include "kernel/point_on_segment.hpp"
#include "quadrangulate/subdivision_places.hpp"

namespace quadloom::quadrangulate {
namespace {

constexpr int kNudges = 48;  // doublings of one unit in the last place

bool in_middle_half(Point a, Point b, Point p) {
  const double from = std::hypot(p.x - a.x, p.y - a.y), to = std::hypot(b.x - p.x, b.y - p.y);
  return from <= 3 * to && to <= 3 * from;
}

}  // namespace

void OutlinePlaces::place_all(Subdivision& s) {
  for (EdgeId e = 0; e < s.edge_count(); ++e) {
    if (!s.on_boundary(e)) continue;
    ++size_;
    if (s.planar()) {
      s.set_place(e, place_of(s.halfedge(e)));
    } else {
      s.place_in_the_middle(e);
    }
  }
}

Point OutlinePlaces::place_of(HalfedgeId h) {
  const VertexId a = mesh_.origin(h), b = mesh_.target(h);
  const auto on_edge = kernel::point_on_segment(mesh_.points[a], mesh_.points[b]);
  if (on_edge && in_middle_half(mesh_.points[a], mesh_.points[b], *on_edge)) return *on_edge;
  if (const auto place = place_outside(h)) return *place;
  if (on_edge) return *on_edge;
  throw Error(ErrorCode::kGuarantee,
              "no double lies on the boundary edge from vertex " + std::to_string(a) +
                  " to vertex " + std::to_string(b) + " or just outside it",
              {a, b});
}

std::optional<Point> OutlinePlaces::place_outside(HalfedgeId h) {
  const Point a = mesh_.points[mesh_.origin(h)], b = mesh_.points[mesh_.target(h)];
  for (const int eighths : {4, 3, 5, 2, 6}) {
    const Point middle = along_edge(a, b, eighths);
    Point place = middle;
    for (int step = 0; step <= kNudges; ++step) {
      if (outside().allows(h, place)) {
        outside().take(h, place);
        return place;
      }
      place = nudged_right(middle, a, b, step);
    }
  }
  return std::nullopt;
}

OuterPlaces& OutlinePlaces::outside() {
  if (!outside_) outside_.emplace(mesh_);
  return *outside_;
}

bool OutlinePlaces::may_move(const Subdivision& s, EdgeId e, Point place) {
  return !s.planar() || outside().allows(s.halfedge(e), place);
}

void OutlinePlaces::moved(const Subdivision& s, EdgeId e) {
  if (s.planar() && outside().allows(s.halfedge(e), s.place(e))) {
    outside().take(s.halfedge(e), s.place(e));
  }
}

}  // namespace quadloom::quadrangulate
