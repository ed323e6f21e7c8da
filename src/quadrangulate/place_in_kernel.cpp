// Points that see all of a polygon: the kernel, clipped in floating point, then doubles of it checked
// exactly.
#include "quadrangulate/place_in_kernel.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "kernel/predicates_inline.hpp"
#include "quadrangulate/place_inside.hpp"

namespace quadloom::quadrangulate {
namespace {

/// The polygon moved and scaled to about the unit square, so that products neither overflow nor
/// underflow.
class Frame {
 public:
  explicit Frame(std::span<const Point> polygon) : origin_(polygon[0]) {
    double size = 0;
    for (const Point p : polygon) {
      size =
          std::max({size, std::fabs(p.x / 2 - origin_.x / 2), std::fabs(p.y / 2 - origin_.y / 2)});
    }
    exponent_ = size > 0 ? std::ilogb(size) + 1 : 0;
  }
  Point into(Point p) const {
    return {std::ldexp(p.x / 2 - origin_.x / 2, -exponent_),
            std::ldexp(p.y / 2 - origin_.y / 2, -exponent_)};
  }
  Point out_of(Point p) const {
    return {2 * (origin_.x / 2 + std::ldexp(p.x, exponent_)),
            2 * (origin_.y / 2 + std::ldexp(p.y, exponent_))};
  }

 private:
  Point origin_;
  int exponent_ = 0;
};

double height(Point a, Point b, Point p) {
  return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

/// What of a convex polygon is left of the line a -> b.
std::vector<Point> clip(const std::vector<Point>& convex, Point a, Point b) {
  std::vector<Point> out;
  for (std::size_t i = 0; i < convex.size(); ++i) {
    const Point p = convex[i], q = convex[i + 1 == convex.size() ? 0 : i + 1];
    const double at_p = height(a, b, p), at_q = height(a, b, q);
    if (at_p >= 0) out.push_back(p);
    if ((at_p > 0 && at_q < 0) || (at_p < 0 && at_q > 0)) {
      const double f = at_p / (at_p - at_q);
      out.push_back({p.x + f * (q.x - p.x), p.y + f * (q.y - p.y)});
    }
  }
  return out;
}

Point mean(const std::vector<Point>& points) {
  Point sum;
  for (const Point p : points) sum = {sum.x + p.x, sum.y + p.y};
  const auto n = static_cast<double>(points.size());
  return {sum.x / n, sum.y / n};
}

}  // namespace

std::optional<Point> place_in_kernel(std::span<const Point> polygon) {
  if (polygon.size() == 3) return place_inside(polygon[0], polygon[1], polygon[2]);
  const auto fits = [&](Point s) {
    if (!std::isfinite(s.x) || !std::isfinite(s.y)) return false;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      if (kernel::orient(polygon[i], polygon[i + 1 == polygon.size() ? 0 : i + 1], s) <= 0) {
        return false;
      }
    }
    return true;
  };
  const Frame frame(polygon);
  std::vector<Point> kernel = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point next = polygon[i + 1 == polygon.size() ? 0 : i + 1];
    kernel = clip(kernel, frame.into(polygon[i]), frame.into(next));
  }
  if (kernel.empty()) return std::nullopt;
  const Point middle = frame.out_of(mean(kernel));
  if (fits(middle)) return middle;
  for (std::size_t i = 1; i + 1 < kernel.size(); ++i) {
    const auto s = place_in_triangle(
        {frame.out_of(kernel[0]), frame.out_of(kernel[i]), frame.out_of(kernel[i + 1])}, fits);
    if (s) return s;
  }
  return std::nullopt;
}

}  // namespace quadloom::quadrangulate
