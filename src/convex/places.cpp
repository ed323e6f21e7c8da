// Random places for added points. Which quads a point can be a corner of depends on the side of each
// line through two other points that it is on; the cells of these lines are many, and those that matter are
// often thin. So a place is one of three kinds:
//
//   1. in_wedges    in the wedges of one to three corners in a row that are not convex (v is convex on both sides
//                   of an edge to a place in its wedge), where they meet
//   2. beside_edge  next to the middle of the segment between two points, as in rows of points
//   3. anywhere     a random mean of three points
#include "convex/places.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "convex/open_region.hpp"
#include "kernel/predicates_inline.hpp"

namespace quadloom::convex {
namespace {

class Places {
 public:
  Places(std::span<const Point> corner, std::span<const Point> inside, Random& random)
      : corner_(corner), random_(random) {
    all_.assign(corner.begin(), corner.end());
    all_.insert(all_.end(), inside.begin(), inside.end());
    const std::size_t n = corner.size();
    for (std::size_t i = 0; i < n; ++i) {
      if (kernel::orient(corner[(i + n - 1) % n], corner[i], corner[(i + 1) % n]) <= 0) {
        not_convex_.push_back(i);
      }
    }
  }

  std::optional<Point> place() {
    const std::uint64_t kind = random_.below(10);
    if (kind < 5 && !not_convex_.empty()) return in_wedges();
    return kind < 8 ? beside_edge() : anywhere();
  }

  /// How many sides a ray to the right crosses is odd; not on a side, nor at a point.
  bool is_new(Point p) const {
    if (!std::isfinite(p.x) || !std::isfinite(p.y)) return false;
    bool inside = false;
    for (std::size_t i = 0; i < corner_.size(); ++i) {
      const Point a = corner_[i], b = corner_[(i + 1) % corner_.size()];
      const bool up = a.y <= p.y && p.y < b.y, down = b.y <= p.y && p.y < a.y;
      if (!up && !down) continue;
      const int side = kernel::orient(a, b, p);
      if (side == 0) return false;
      if (up == (side > 0)) inside = !inside;
    }
    return inside && std::find(all_.begin(), all_.end(), p) == all_.end();
  }

 private:
  Point any_point() { return all_[random_.below(all_.size())]; }

  std::optional<Point> in_wedges() {
    OpenRegion region(corner_);
    const std::size_t n = corner_.size();
    const std::size_t wedges = 1 + random_.below(3);
    const std::size_t first = random_.below(not_convex_.size());
    for (std::size_t i = 0; i < wedges; ++i) {
      const std::size_t v = not_convex_[(first + i) % not_convex_.size()];
      region.add(corner_[(v + n - 1) % n], corner_[v]);
      region.add(corner_[v], corner_[(v + 1) % n]);
    }
    const auto places = region.places(Effort::kFloat);
    if (places.empty()) return std::nullopt;
    return random_.below(3) == 0 ? places.front() : places[random_.below(places.size())];
  }

  std::optional<Point> beside_edge() {
    const std::size_t i = random_.below(all_.size());
    const Point a = all_[i];
    const Point b = i < corner_.size() && random_.below(2) == 0 ? corner_[(i + 1) % corner_.size()]
                                                                : any_point();
    constexpr std::array<double, 3> kParts = {0.02, 0.1, 0.3};
    const double part = kParts[random_.below(kParts.size())];
    const Point middle = {a.x / 2 + b.x / 2, a.y / 2 + b.y / 2}, to = any_point();
    return Point{middle.x + part * (to.x - middle.x), middle.y + part * (to.y - middle.y)};
  }

  std::optional<Point> anywhere() {
    const Point a = any_point(), b = any_point(), c = any_point();
    const double f = random_.uniform(), g = (1 - f) * random_.uniform(), h = 1 - f - g;
    return Point{f * a.x + g * b.x + h * c.x, f * a.y + g * b.y + h * c.y};
  }

  std::span<const Point> corner_;
  Random& random_;
  std::vector<Point> all_;
  std::vector<std::size_t> not_convex_;
};

}  // namespace

std::vector<Point> random_places(std::span<const Point> corner, std::span<const Point> inside,
                                 std::size_t count, Random& random) {
  Places places(corner, inside, random);
  std::vector<Point> out;
  for (std::size_t i = 0; i < 3 * count && out.size() < count; ++i) {
    const auto p = places.place();
    if (p && places.is_new(*p) && std::find(out.begin(), out.end(), *p) == out.end()) {
      out.push_back(*p);
    }
  }
  return out;
}

}  // namespace quadloom::convex
