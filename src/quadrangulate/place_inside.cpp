// Doubles in small triangles: the centroid, then one column after the other along the longer axis.
#include "quadrangulate/place_inside.hpp"

#include <algorithm>
#include <cmath>

#include "kernel/predicates_inline.hpp"

namespace quadloom::quadrangulate {
namespace {

using Fits = std::function<bool(Point)>;

constexpr int kColumns = 32;  // looked at in each of the two scans
constexpr int kAround = 2;    // doubles tried on either side of a column's middle

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
std::optional<Point> fit_in_column(const Fits& fits, const std::array<Point, 3>& triangle,
                                   double column, bool swapped) {
  double up = middle_of_column(triangle, column);
  double down = up;
  for (int i = 0; i <= kAround; ++i) {
    for (const double y : {up, down}) {
      const Point place = swapped ? Point{y, column} : Point{column, y};
      if (std::isfinite(place.x) && std::isfinite(place.y) && fits(place)) return place;
    }
    up = std::nextafter(up, HUGE_VAL);
    down = std::nextafter(down, -HUGE_VAL);
  }
  return std::nullopt;
}

std::optional<Point> scan_columns(std::array<Point, 3> triangle, const Fits& fits) {
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
    if (const auto place = fit_in_column(fits, triangle, column, swapped)) return place;
  }
  double right = centroid(triangle).x;
  double left = right;
  for (int i = 0; i < kColumns / 2; ++i) {  // one double after the other about the centroid
    for (const double column : {right, left}) {
      if (const auto place = fit_in_column(fits, triangle, column, swapped)) return place;
    }
    right = std::nextafter(right, HUGE_VAL);
    left = std::nextafter(left, -HUGE_VAL);
  }
  return std::nullopt;
}

}  // namespace

std::optional<Point> place_in_triangle(const std::array<Point, 3>& triangle, const Fits& fits) {
  const Point middle = centroid(triangle);
  if (std::isfinite(middle.x) && std::isfinite(middle.y) && fits(middle)) return middle;
  return scan_columns(triangle, fits);
}

std::optional<Point> place_inside(Point a, Point b, Point c) {
  return place_in_triangle({a, b, c}, [=](Point p) {
    return kernel::orient(a, b, p) > 0 && kernel::orient(b, c, p) > 0 &&
           kernel::orient(c, a, p) > 0;
  });
}

}  // namespace quadloom::quadrangulate
