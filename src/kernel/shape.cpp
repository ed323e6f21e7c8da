#include <algorithm>
#include <array>
#include <cmath>

#include "quadloom/kernel.hpp"

namespace quadloom {
namespace {

struct Vector {
  double x, y;
};

/// An edge's direction with components that can be multiplied without overflow or underflow.
Vector tame(Vector v) {
  const double m = std::max(std::fabs(v.x), std::fabs(v.y));
  if (m > 1e-70 && m < 1e70) return v;
  return m > 0 ? Vector{v.x / m, v.y / m} : v;
}

/// (2 / pi) atan(t) for t in [0, 1], by two halvings of the angle and Taylor's series (error below
/// 1e-12). From correctly rounded operations alone, so that it is the same on every platform.
double arctangent_of_quarter(double t) {
  const auto halve = [](double s) { return s / (1 + std::sqrt(1 + s * s)); };
  const double s = halve(halve(t)), q = s * s;
  double sum = 0;
  for (int k = 15; k >= 1; k -= 2) sum = 1.0 / k - q * sum;
  return 2.5464790894703255 * (s * sum);  // 4 angles, 2 / pi
}

}  // namespace

double quad_shape(Point a, Point b, Point c, Point d) {
  if (orient2d(a, b, c) <= 0 || orient2d(b, c, d) <= 0 || orient2d(c, d, a) <= 0 ||
      orient2d(d, a, b) <= 0) {
    return 0;
  }
  std::array<Point, 4> p = {a, b, c, d};
  double extent = 0;
  for (const Point& q : p) extent = std::max({extent, std::fabs(q.x), std::fabs(q.y)});
  if (extent > 1e307) {
    for (Point& q : p) q = {q.x * 0.125, q.y * 0.125};
  }
  std::array<Vector, 4> edge{};
  for (std::size_t i = 0; i < 4; ++i) {
    const Point& from = p[i];
    const Point& to = p[(i + 1) % 4];
    edge[i] = tame({to.x - from.x, to.y - from.y});
  }
  // |tan(pi/2 - angle)| = |dot| / cross grows with the deviation from a right angle.
  double worst = 0, best_inverse = HUGE_VAL;
  for (std::size_t i = 0; i < 4; ++i) {
    const Vector u = edge[i], v = edge[(i + 1) % 4];
    const double cross = u.x * v.y - u.y * v.x;
    const double dot = std::fabs(u.x * v.x + u.y * v.y);
    if (!(cross > 0)) return 0;  // strictly convex, yet flat in floating point
    worst = std::max(worst, dot / cross);
    best_inverse = std::min(best_inverse, cross / dot);
  }
  return worst <= 1 ? 1 - arctangent_of_quarter(worst) : arctangent_of_quarter(best_inverse);
}

}  // namespace quadloom
