#include "convex/star.hpp"

#include <algorithm>

#include "convex/open_region.hpp"
#include "convex/price.hpp"
#include "kernel/predicates_inline.hpp"
#include "kernel/squareness.hpp"

namespace quadloom::convex {
namespace {

/// Where the centre makes all three quads strictly convex; none if a corner between is not convex.
std::optional<OpenRegion> region_of_star(const std::array<Point, 6>& h, std::size_t parity) {
  for (std::size_t k = parity; k < 6; k += 2) {
    if (kernel::orient(h[k], h[(k + 1) % 6], h[(k + 2) % 6]) <= 0) return std::nullopt;
  }
  OpenRegion region(h);
  for (std::size_t k = parity; k < 6; k += 2) {
    region.add(h[k], h[(k + 1) % 6]);
    region.add(h[(k + 1) % 6], h[(k + 2) % 6]);
    region.add(h[k], h[(k + 2) % 6]);
  }
  return region;
}

}  // namespace

std::optional<Star> place_star(const std::array<Point, 6>& h) {
  std::optional<Star> best;
  double best_worst = -1;
  for (std::size_t parity = 0; parity < 2; ++parity) {
    const auto region = region_of_star(h, parity);
    if (!region) continue;
    const auto first = region->place(Effort::kFloat);
    if (!first) continue;
    const auto consider = [&](Point s) {
      double worst = 1, cost = 0;
      for (std::size_t k = parity; k < 6; k += 2) {
        const double shape = kernel::squareness(s, h[k], h[(k + 1) % 6], h[(k + 2) % 6]);
        worst = std::min(worst, shape);
        cost += price(shape);
      }
      if (worst <= best_worst) return;
      best_worst = worst;
      best = Star{s, static_cast<std::uint8_t>(parity), cost};
    };
    consider(*first);
    for (const Point s : region->places(Effort::kFloat)) consider(s);
  }
  return best;
}

}  // namespace quadloom::convex
