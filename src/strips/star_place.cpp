#include "strips/star_place.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "convex/exact_region.hpp"
#include "kernel/predicates_inline.hpp"

namespace quadloom::strips {
namespace {

constexpr int kHalvings = 60;               // beyond, the doubles are those at `from`
constexpr std::size_t kMostExactly = 1000;  // sides; the exact search is quadratic

bool sees_all(std::span<const Point> star, Point p) {
  if (!std::isfinite(p.x) || !std::isfinite(p.y)) return false;
  for (std::size_t i = 0; i < star.size(); ++i) {
    if (kernel::orient(star[i], star[i + 1 == star.size() ? 0 : i + 1], p) <= 0) return false;
  }
  return true;
}

std::optional<Point> place_exactly(std::span<const Point> star) {
  std::vector<convex::HalfPlane> sides;
  Point low = star[0], high = star[0];
  for (std::size_t i = 0; i < star.size(); ++i) {
    sides.push_back({star[i], star[i + 1 == star.size() ? 0 : i + 1]});
    low = {std::min(low.x, star[i].x), std::min(low.y, star[i].y)};
    high = {std::max(high.x, star[i].x), std::max(high.y, star[i].y)};
  }
  const auto places = convex::places_exactly(sides, low, high, 1);
  if (places.empty()) return std::nullopt;
  return places.front();
}

}  // namespace

std::optional<Point> place_in_star(std::span<const Point> star, Point from, Point to) {
  double f = 0.5;
  for (int i = 0; i < kHalvings; ++i, f /= 2) {
    const Point p{from.x * (1 - f) + to.x * f, from.y * (1 - f) + to.y * f};
    if (sees_all(star, p)) return p;
  }
  return star.size() <= kMostExactly ? place_exactly(star) : std::nullopt;
}

}  // namespace quadloom::strips
