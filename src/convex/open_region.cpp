// A double strictly inside an intersection of open half-planes: clipped in floating point, checked
// exactly, and where that fails found with big integers (exact_region.cpp).
#include "convex/open_region.hpp"

#include <algorithm>
#include <cmath>

#include "convex/exact_region.hpp"
#include "kernel/predicates_inline.hpp"

namespace quadloom::convex {
namespace {

constexpr std::size_t kMostExact = 6;  // places of a region that floating point cannot see
constexpr int kColumns = 4;            // doubles on either side of the middle, in x and in y

double height(Point a, Point b, Point p) {
  return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

Point between(Point a, Point b, double f) { return {a.x + f * (b.x - a.x), a.y + f * (b.y - a.y)}; }

int exponent_of(double half_width) { return half_width > 0 ? std::ilogb(half_width) + 1 : 0; }

}  // namespace

OpenRegion::OpenRegion(std::span<const Point> box_of) : low_(box_of[0]), high_(box_of[0]) {
  for (const Point p : box_of) {
    low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
    high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y)};
  }
  origin_ = {low_.x / 4 + high_.x / 4, low_.y / 4 + high_.y / 4};
  exponent_x_ = exponent_of(high_.x / 4 - low_.x / 4);
  exponent_y_ = exponent_of(high_.y / 4 - low_.y / 4);
  const Point low = into_frame(low_), high = into_frame(high_);
  polygon_ = {low, {high.x, low.y}, high, {low.x, high.y}};
}

/// Halves first: differences of coordinates near the largest double do not overflow.
Point OpenRegion::into_frame(Point p) const {
  return {std::ldexp(p.x / 2 - origin_.x, -exponent_x_),
          std::ldexp(p.y / 2 - origin_.y, -exponent_y_)};
}

Point OpenRegion::out_of_frame(Point p) const {
  return {2 * (origin_.x + std::ldexp(p.x, exponent_x_)),
          2 * (origin_.y + std::ldexp(p.y, exponent_y_))};
}

/// Keeps what is left of the line, Sutherland and Hodgman's way.
void OpenRegion::add(Point from, Point to) {
  sides_.push_back({from, to});
  const Point a = into_frame(from), b = into_frame(to);
  Polygon kept;
  for (std::size_t i = 0; i < polygon_.size(); ++i) {
    const Point p = polygon_[i], q = polygon_[i + 1 == polygon_.size() ? 0 : i + 1];
    const double at_p = height(a, b, p), at_q = height(a, b, q);
    const bool crosses = (at_p > 0 && at_q < 0) || (at_p < 0 && at_q > 0);
    if (kept.size() + (crosses ? 2 : 1) > kept.capacity()) break;  // only if rounding made a mess
    if (at_p >= 0) kept.push_back(p);
    if (crosses) kept.push_back(between(p, q, at_p / (at_p - at_q)));
  }
  polygon_ = kept;
}

void OpenRegion::add_if_room(Point from, Point to) {
  OpenRegion smaller = *this;
  smaller.add(from, to);
  if (smaller.place(Effort::kFloat)) *this = smaller;
}

bool OpenRegion::contains(Point p) const {
  return std::isfinite(p.x) && std::isfinite(p.y) &&
         std::all_of(sides_.begin(), sides_.end(), [&](const HalfPlane& side) {
           return kernel::orient(side.from, side.to, p) > 0;
         });
}

/// In the frame. The mean of the corners where the area is too small to divide by.
Point OpenRegion::centroid() const {
  const Point first = polygon_[0];
  double area = 0;
  Point sum, mean;
  for (std::size_t i = 0; i < polygon_.size(); ++i) {
    mean = {mean.x + polygon_[i].x, mean.y + polygon_[i].y};
    if (i < 2) continue;
    const Point p = polygon_[i - 1], q = polygon_[i];
    const double part = height(first, p, q);
    area += part;
    sum = {sum.x + part * ((p.x - first.x) + (q.x - first.x)),
           sum.y + part * ((p.y - first.y) + (q.y - first.y))};
  }
  if (area > 1e-12) return {first.x + sum.x / (3 * area), first.y + sum.y / (3 * area)};
  const auto n = static_cast<double>(polygon_.size());
  return {mean.x / n, mean.y / n};
}

/// The doubles around one that rounding has moved out of the region.
std::optional<Point> OpenRegion::place_in_columns(Point middle) const {
  Point low = middle;
  for (int i = 0; i < kColumns; ++i) {
    low = {std::nextafter(low.x, -HUGE_VAL), std::nextafter(low.y, -HUGE_VAL)};
  }
  double x = low.x;
  for (int i = -kColumns; i <= kColumns; ++i, x = std::nextafter(x, HUGE_VAL)) {
    double y = low.y;
    for (int j = -kColumns; j <= kColumns; ++j, y = std::nextafter(y, HUGE_VAL)) {
      if (contains({x, y})) return Point{x, y};
    }
  }
  return std::nullopt;
}

std::optional<Point> OpenRegion::place(Effort effort) const {
  if (polygon_.size() >= 3) {
    const Point middle = out_of_frame(centroid());
    if (contains(middle)) return middle;
    if (effort == Effort::kExact) {
      if (const auto p = place_in_columns(middle)) return p;
    }
  }
  if (effort == Effort::kFloat) return std::nullopt;
  const Places exact = exact_places(1);
  return exact.empty() ? std::nullopt : std::optional(exact.front());
}

OpenRegion::Places OpenRegion::exact_places(std::size_t most) const {
  return places_exactly({sides_.data(), sides_.size()}, low_, high_, most);
}

OpenRegion::Places OpenRegion::places(Effort effort) const {
  Places out = places_of_polygon();
  return out.empty() && effort == Effort::kExact ? exact_places(kMostExact) : out;
}

OpenRegion::Places OpenRegion::places_of_polygon() const {
  Places out;
  if (polygon_.size() < 3) return out;
  const auto add_place = [&](Point p) {
    const Point place = out_of_frame(p);
    if (contains(place)) out.push_back(place);
  };
  const Point middle = centroid();
  add_place(middle);
  for (std::size_t i = 0; i < polygon_.size() && out.size() + 3 < out.capacity(); ++i) {
    const Point p = polygon_[i], q = polygon_[i + 1 == polygon_.size() ? 0 : i + 1];
    add_place(between(middle, p, 0.5));
    add_place(between(middle, p, 0.95));
    add_place(between(middle, between(p, q, 0.5), 0.9));
  }
  return out;
}

}  // namespace quadloom::convex
