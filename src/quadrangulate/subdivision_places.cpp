// The inner point of a subdivided triangle.
//
//            c               The quads a p g r, b q g p, c r g q turn left everywhere if and only if
//           / \                - p, q, r turn left, and so do r, a, p and p, b, q and q, c, r,
//         r     q              - g is inside the triangle p q r,
//        /   g   \             - g is to the left of a->p, p->b, b->q, q->c, c->r, r->a.
//       a --- p --- b
//
// That region is open and convex. In a thin triangle rounding can carry the centroid out of it, or it
// holds few doubles; then these are looked for one column at a time along the longer axis of p q r.
#include "quadrangulate/subdivision_places.hpp"

#include <algorithm>
#include <cmath>

#include "quadloom/kernel.hpp"

namespace quadloom::quadrangulate {
namespace {

constexpr int kColumns = 32;  // looked at in each of the two scans of inner_place
constexpr int kAround = 2;    // doubles tried on either side of a column's middle

bool turns_left(Point a, Point b, Point c) { return orient2d(a, b, c) > 0; }

/// What must hold wherever the inner point is.
bool frame_is_open(const SplitTriangle& s) {
  const auto& [a, b, c] = s.corner;
  const auto& [p, q, r] = s.edge;
  return turns_left(p, q, r) && turns_left(r, a, p) && turns_left(p, b, q) && turns_left(q, c, r);
}

bool fits(const SplitTriangle& s, Point g) {
  if (!std::isfinite(g.x) || !std::isfinite(g.y)) return false;
  const auto& [a, b, c] = s.corner;
  const auto& [p, q, r] = s.edge;
  return turns_left(p, q, g) && turns_left(q, r, g) && turns_left(r, p, g) &&  //
         turns_left(a, p, g) && turns_left(p, b, g) && turns_left(b, q, g) && turns_left(q, c, g) &&
         turns_left(c, r, g) && turns_left(r, a, g);
}

double third(double a, double b, double c) {
  const double near = a + ((b - a) + (c - a)) / 3;
  return std::isfinite(near) ? near : a / 3 + b / 3 + c / 3;
}

Point centroid(const std::array<Point, 3>& p) {
  return {third(p[0].x, p[1].x, p[2].x), third(p[0].y, p[1].y, p[2].y)};
}

/// The middle of the triangle's cut with the line x = `column`, up to rounding.
double middle_of_column(const std::array<Point, 3>& triangle, double column) {
  double low = HUGE_VAL;
  double high = -HUGE_VAL;
  for (int i = 0; i < 3; ++i) {
    const Point u = triangle[i];
    const Point v = triangle[(i + 1) % 3];
    if (u.x == v.x || std::min(u.x, v.x) > column || std::max(u.x, v.x) < column) continue;
    const double y = u.y + (v.y - u.y) * ((column - u.x) / (v.x - u.x));
    low = std::min(low, y);
    high = std::max(high, y);
  }
  return low + (high - low) / 2;
}

/// The doubles near the middle of one column that fit; `swapped`: x and y have changed places.
std::optional<Point> fit_in_column(const SplitTriangle& split, const std::array<Point, 3>& triangle,
                                   double column, bool swapped) {
  double up = middle_of_column(triangle, column);
  double down = up;
  for (int i = 0; i <= kAround; ++i) {
    for (const double y : {up, down}) {
      const Point place = swapped ? Point{y, column} : Point{column, y};
      if (fits(split, place)) return place;
    }
    up = std::nextafter(up, HUGE_VAL);
    down = std::nextafter(down, -HUGE_VAL);
  }
  return std::nullopt;
}

std::optional<Point> scan_columns(const SplitTriangle& split) {
  std::array<Point, 3> triangle = split.edge;
  const auto [least_x, most_x] = std::minmax({triangle[0].x, triangle[1].x, triangle[2].x});
  const auto [least_y, most_y] = std::minmax({triangle[0].y, triangle[1].y, triangle[2].y});
  const bool swapped = most_y - least_y > most_x - least_x;
  if (swapped) {
    for (Point& p : triangle) std::swap(p.x, p.y);
  }
  const double from = swapped ? least_y : least_x;
  const double to = swapped ? most_y : most_x;

  for (int i = 1; i < kColumns; ++i) {  // evenly over the triangle
    const double column = from + (to - from) * (static_cast<double>(i) / kColumns);
    if (const auto place = fit_in_column(split, triangle, column, swapped)) return place;
  }
  double right = centroid(triangle).x;
  double left = right;
  for (int i = 0; i < kColumns / 2; ++i) {  // one double after the other about the centroid
    for (const double column : {right, left}) {
      if (const auto place = fit_in_column(split, triangle, column, swapped)) return place;
    }
    right = std::nextafter(right, HUGE_VAL);
    left = std::nextafter(left, -HUGE_VAL);
  }
  return std::nullopt;
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
  const Point middle = centroid(split.edge);
  if (fits(split, middle)) return middle;
  return scan_columns(split);
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
