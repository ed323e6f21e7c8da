// The inner point of a subdivided triangle or quad.
//
//            c               The quads a p g r, b q g p, c r g q turn left everywhere if and only if
//           / \                - p, q, r turn left, and so do r, a, p and p, b, q and q, c, r,
//         r     q              - g is inside the triangle p q r,
//        /   g   \             - g is to the left of a->p, p->b, b->q, q->c, c->r, r->a.
//       a --- p --- b
//
//       d --- r --- c        The quads a p g s, b q g p, c r g q, d s g r of a quad likewise: s, a, p
//       |           |        and so on turn left, g is inside p q r s and on the left of the halves
//       s     g     q        of the edges.
//       |           |
//       a --- p --- b
//
// That region is open and convex. In a thin face rounding can carry the centroid out of it, or it
// holds few doubles; then these are looked for, see place_inside.hpp.
#include "quadrangulate/subdivision_places.hpp"

#include <algorithm>
#include <cmath>

#include "kernel/predicates_inline.hpp"
#include "quadrangulate/place_inside.hpp"

namespace quadloom::quadrangulate {
namespace {

bool turns_left(Point a, Point b, Point c) { return kernel::orient(a, b, c) > 0; }

/// What must hold wherever the inner point is.
template <std::size_t N>
bool frame_is_open(const SplitFace<N>& s) {
  for (std::size_t i = 0; i < N; ++i) {
    if (!turns_left(s.edge[(i + N - 1) % N], s.corner[i], s.edge[i])) return false;
  }
  return turns_left(s.edge[0], s.edge[1], s.edge[2]);
}

template <std::size_t N>
bool fits(const SplitFace<N>& s, Point g) {
  for (std::size_t i = 0; i < N; ++i) {
    const std::size_t next = (i + 1) % N;
    if (!turns_left(s.edge[i], s.edge[next], g) || !turns_left(s.corner[i], s.edge[i], g) ||
        !turns_left(s.edge[i], s.corner[next], g)) {
      return false;
    }
  }
  return true;
}

/// The distance from |value| to the next double.
double last_place(double value) {
  const double size = std::fabs(value);
  return std::nextafter(size, HUGE_VAL) - size;
}

double along(double a, double b, int eighths) {
  if (eighths == 4) return std::isfinite(a + b) ? (a + b) / 2 : a / 2 + b / 2;
  const double t = eighths / 8.0;
  return a * (1 - t) + b * t;
}

}  // namespace

std::optional<Point> inner_place(const SplitTriangle& split) {
  if (!frame_is_open(split)) return std::nullopt;
  return place_in_triangle(split.edge, [&split](Point g) { return fits(split, g); });
}

std::optional<Point> inner_place(const SplitQuad& split) {
  if (!frame_is_open(split)) return std::nullopt;
  const auto& [p, q, r, s] = split.edge;
  const Point middle = along_edge(along_edge(p, r, 4), along_edge(q, s, 4), 4);
  const auto fitting = [&split](Point g) { return fits(split, g); };
  if (std::isfinite(middle.x) && std::isfinite(middle.y) && fitting(middle)) return middle;
  const auto place = place_in_triangle({p, q, r}, fitting);
  return place ? place : place_in_triangle({r, s, p}, fitting);
}

Point along_edge(Point a, Point b, int eighths) {
  return {along(a.x, b.x, eighths), along(a.y, b.y, eighths)};
}

Point nudged_right(Point place, Point a, Point b, int step) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  if (std::fabs(dx) >= std::fabs(dy)) {
    const double unit = std::max(last_place(place.y), last_place(dy));
    place.y += std::copysign(std::ldexp(unit, step), -dx);
  } else {
    const double unit = std::max(last_place(place.x), last_place(dx));
    place.x += std::copysign(std::ldexp(unit, step), dy);
  }
  return place;
}

}  // namespace quadloom::quadrangulate
