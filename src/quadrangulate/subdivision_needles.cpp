// Needles: triangles that have no inner point between their edges' points.
//
// Steps:
//   1. place_in_triangles   tries all; what has no place is stuck, and so is what a stuck one leans on
//   2. straighten_needles   from those whose longest edge has room behind it to those behind them:
//                           straighten moves the points of their edges, until nothing is stuck or
//                           nothing moves any more
//
// Each edge moves once at most. Cost: O(1) a triangle tried; a stack of needles is tried once for each
// of them, so the square of the highest stack at the worst.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "quadrangulate/subdivision.hpp"

namespace quadloom::quadrangulate {
namespace {

using kernel::Vector3;

// A needle's edge point moves by 2^-4 of the edge's length at most, and by 2^-62 at least.
constexpr int kWidest = 4;
constexpr int kThinnest = 62;
constexpr double kThin = 0x1p-24;  // height by longest edge of a triangle that may have to give way

// On the boundary by about 2^-20; then less, then more.
constexpr int kOutside = 20;
int power_outside(int step) {
  const int power = kOutside + step;
  return power < kThinnest ? power : kThinnest - 1 - step;
}

double length_of(Vector3 v) { return std::hypot(v.x, v.y, v.z); }

}  // namespace

void Subdivision::place_in_triangles() {
  is_stuck_.assign(mesh_.triangle_count(), 0);
  settled_.assign(halfedge_.size(), 0);
  for (TriangleId t = 0; t < mesh_.triangle_count(); ++t) {
    if (is_whole(t) || try_place(t)) continue;
    is_stuck_[t] = 1;
    stuck_.push_back(t);
  }
  for (std::size_t i = 0; i < stuck_.size(); ++i) {  // and the thin ones that it leans on
    const HalfedgeId back = mesh_.twin[longest_edge(stuck_[i])];
    if (back == kNone) continue;
    const TriangleId behind = triangle_of(back);
    if (is_stuck_[behind] || is_whole(behind) || !is_thin(behind)) continue;
    is_stuck_[behind] = 1;
    stuck_.push_back(behind);
  }
}

double Subdivision::length(HalfedgeId h) const {
  return planar() ? std::hypot(target(h).x - origin(h).x, target(h).y - origin(h).y)
                  : length_of(places_.at(mesh_.target(h)) - places_.at(mesh_.origin(h)));
}

/// To the right of h in the plane of its triangle, as long as h.
Vector3 Subdivision::outwards(HalfedgeId h) const {
  const Vector3 along = places_.at(mesh_.target(h)) - places_.at(mesh_.origin(h));
  if (planar()) return {along.y, -along.x, 0};
  const Vector3 area = places_.area(mesh_.origin(h), mesh_.target(h), mesh_.apex(h));
  const double size = length_of(area);
  return kernel::cross(along, {area.x / size, area.y / size, area.z / size});
}

bool Subdivision::is_thin(TriangleId t) const {
  const HalfedgeId h = longest_edge(t);
  const Vector3 a = places_.at(mesh_.origin(h));
  const Vector3 along = places_.at(mesh_.target(h)) - a;
  const double side = length(h);
  const Vector3 height = kernel::cross({along.x / side, along.y / side, along.z / side},
                                       places_.at(mesh_.apex(h)) - a);
  return (planar() ? height.z : length_of(height)) < kThin * side;
}

HalfedgeId Subdivision::longest_edge(TriangleId t) const {
  const HalfedgeId h = 3 * t;
  const HalfedgeId longer = length(h) >= length(h + 1) ? h : h + 1;
  return length(longer) >= length(h + 2) ? longer : h + 2;
}

/// The faces across the edges of t that are not stuck themselves are still fine.
bool Subdivision::neighbours_hold(TriangleId t) const {
  for (const HalfedgeId h : sides_of_triangle(t)) {
    const HalfedgeId back = mesh_.twin[h];
    if (back == kNone || is_stuck_[triangle_of(back)]) continue;
    if (!find_inner(triangle_of(back))) return false;
  }
  return true;
}

/// Whether a needle has t behind its longest edge.
bool Subdivision::is_leaned_on(TriangleId t) const {
  return std::ranges::any_of(sides_of_triangle(t), [&](HalfedgeId h) {
    const HalfedgeId back = mesh_.twin[h];
    return back != kNone && is_stuck_[triangle_of(back)] && longest_edge(triangle_of(back)) == back;
  });
}

/// The boundary makes room at e, what is behind the edges that moved is placed again.
void Subdivision::make_room(EdgeId e) {
  for (const EdgeId moved : boundary_->make_room(*this, e)) {
    settled_[moved] = 1;
    const TriangleId t = triangle_of(halfedge_[moved]);
    if (!try_place(t) && !std::exchange(is_stuck_[t], 1)) stuck_.push_back(t);
  }
}

/// The points of the edges of t move in the direction outwards of the longest one, where they may; on
/// the boundary only that of the longest one. False if nothing came of it.
bool Subdivision::move_edges(TriangleId t, HalfedgeId longest, int power) {
  const Vector3 across = outwards(longest);
  for (const HalfedgeId side : sides_of_triangle(t)) {
    const EdgeId e = edge_of_[side];
    if (settled_[e] || (on_boundary(e) && side != longest)) continue;
    const double f =
        std::ldexp(length(side) / length(longest), side == longest ? -power : -power - 2);
    const Vector3 at = middle(side);
    const Vector3 place{at.x + f * across.x, at.y + f * across.y, at.z + f * across.z};
    if (on_boundary(e) && !boundary_->may_move(*this, e, {place.x, place.y})) continue;
    set_edge(e, place);
  }
  return try_place(t) && neighbours_hold(t);
}

/// A needle is flatter than the rounding of its edges' midpoints. The point of its longest edge ab
/// moves into the face behind or outside the boundary, and the two others follow part of the way:
///
///                c                     c
///      a -.------'------.- b      a ---.----.--- b       what is behind ab has room, since only
///                                     .  g  .             faces that are done are asked
///                                      ` m '
///
/// Inner edges move as far as there is room; on the boundary, which should keep its shape, only as far as
/// needles that lie on this one may need too.
bool Subdivision::straighten(TriangleId t) {
  const HalfedgeId h = longest_edge(t);
  const EdgeId e = edge_of_[h];
  const bool outside = on_boundary(e);
  if (!outside && !settled_[e] && is_stuck_[triangle_of(mesh_.twin[h])]) return false;
  if (outside && !settled_[e]) make_room(e);
  const bool may_go_out = outside && !settled_[e];
  if ((outside || settled_[e]) && !(may_go_out && is_leaned_on(t)) && try_place(t)) return true;

  std::array<Vector3, 3> old;
  for (HalfedgeId i = 0; i < 3; ++i) old[i] = edge_at(edge_of_[3 * t + i]);
  for (int step = 0; step < kThinnest - kWidest; ++step) {
    if (!move_edges(t, h, may_go_out ? power_outside(step) : kWidest + step)) continue;
    for (const HalfedgeId side : sides_of_triangle(t)) settled_[edge_of_[side]] = 1;
    if (may_go_out) boundary_->moved(*this, e);
    return true;
  }
  for (HalfedgeId i = 0; i < 3; ++i) set_edge(edge_of_[3 * t + i], old[i]);
  return try_place(t);
}

/// From the triangles whose longest edge has room behind it to those behind them.
void Subdivision::straighten_needles() {
  for (std::size_t before = kNone; stuck_.size() < before;) {
    before = stuck_.size();
    for (const TriangleId t : std::exchange(stuck_, {})) {
      if (!straighten(t)) {
        stuck_.push_back(t);
        continue;
      }
      is_stuck_[t] = 0;
      for (const HalfedgeId h : sides_of_triangle(t)) {
        const HalfedgeId back = mesh_.twin[h];
        if (back != kNone && !is_stuck_[triangle_of(back)]) try_place(triangle_of(back));
      }
    }
  }
  if (!stuck_.empty()) refuse(stuck_[0]);
}

void Subdivision::refuse(TriangleId t) const {
  const VertexId* v = &mesh_.tri_vertex[std::size_t{3} * t];
  throw Error(ErrorCode::kGuarantee,
              "the triangle of points " + std::to_string(v[0]) + ", " + std::to_string(v[1]) +
                  " and " + std::to_string(v[2]) +
                  " is too thin to hold three strictly convex quads in double precision (" +
                  std::to_string(stuck_.size()) + " such triangles)",
              {v[0], v[1], v[2]});
}

}  // namespace quadloom::quadrangulate
