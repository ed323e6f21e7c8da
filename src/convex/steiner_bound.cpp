// What the theorems on strictly convex quads promise.
#include "quadloom/convex.hpp"

namespace quadloom {

// Theorem 4.2 of Ramaswami, Ramos and Toussaint, theorem 3.1 of Bremner, Hurtado, Ramaswami and Sacristan.
std::size_t steiner_bound(std::size_t points, const ConvexStatistics& statistics,
                          const ConvexOptions& options) {
  const std::size_t triangles = 2 * points - 2 - statistics.hull_points;
  const std::size_t inner =
      options.method == ConvexMethod::kPentagons ? 7 * ((triangles + 5) / 6) : 3 * (points / 2);
  const bool outer =
      statistics.hull_points % 2 == 1 && options.odd_boundary != OddBoundary::kTriangle;
  return inner + (outer ? 1 : 0);
}

}  // namespace quadloom
