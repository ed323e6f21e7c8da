// The inner point of a subdivided triangle.
//
//            c               The quads a p g r, b q g p, c r g q turn left everywhere if and only if
//           / \                - p, q, r turn left, and so do r, a, p and p, b, q and q, c, r,
//         r     q              - g is inside the triangle p q r,
//        /   g   \             - g is to the left of a->p, p->b, b->q, q->c, c->r, r->a.
//       a --- p --- b
//
// That region is open and convex. In a thin triangle rounding can carry the centroid out of it, or it
// holds few doubles; then these are looked for, see place_inside.hpp.
#include "quadrangulate/subdivision_places.hpp"

#include <algorithm>
#include <cmath>

#include "quadloom/kernel.hpp"
#include "quadrangulate/place_inside.hpp"

namespace quadloom::quadrangulate {
namespace {

bool turns_left(Point a, Point b, Point c) { return orient2d(a, b, c) > 0; }

/// What must hold wherever the inner point is.
bool frame_is_open(const SplitTriangle& s) {
  const auto& [a, b, c] = s.corner;
  const auto& [p, q, r] = s.edge;
  return turns_left(p, q, r) && turns_left(r, a, p) && turns_left(p, b, q) && turns_left(q, c, r);
}

bool fits(const SplitTriangle& s, Point g) {
  const auto& [a, b, c] = s.corner;
  const auto& [p, q, r] = s.edge;
  return turns_left(p, q, g) && turns_left(q, r, g) && turns_left(r, p, g) &&  //
         turns_left(a, p, g) && turns_left(p, b, g) && turns_left(b, q, g) && turns_left(q, c, g) &&
         turns_left(c, r, g) && turns_left(r, a, g);
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
