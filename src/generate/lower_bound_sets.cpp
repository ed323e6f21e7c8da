// The two configurations that need many Steiner points for strictly convex quads.
//
// Bremner, Hurtado, Ramaswami, Sacristan, "Small strictly convex quadrilateral meshes of point
// sets", section 2. bhrs-line (theorem 2.1): m + 1 points on a line and one on each side of it,
// n = m + 3; at least ceil(m / 2) - 1 Steiner points. bhrs-ring (theorem 2.3): k = n / 2 points in
// convex position and one just inside the middle of each hull edge; at least n / 4.
#include <string>

#include "generate/elementary.hpp"
#include "generate/sets.hpp"
#include "quadloom/kernel.hpp"

namespace quadloom::generate {
namespace {

/*  a(i+2)             b = b(i) must be so near to its edge that a(i+2) is left of a(i) -> b and
        `.             a(i-1) right of a(i+1) -> b: the corner at each end cut by the next chord.
          `. a(i+1)
             /
         b  /
           /
    _____ a(i)
a(i-1)                                                                                         */
bool near_enough(Point before, Point a0, Point a1, Point after, Point b) {
  return orient2d(a0, a1, b) > 0 && orient2d(a0, b, after) > 0 && orient2d(a1, b, before) < 0;
}

// From the middle of the edge some part of the way to the centre: the first part, halved each time,
// that the exact predicates accept. In the real plane every part below (pi / k)^2 will do.
Point inside_the_edge(Point before, Point a0, Point a1, Point after, std::size_t k) {
  const Point middle = {(a0.x + a1.x) / 2, (a0.y + a1.y) / 2};
  const double half_angle = 3.14 / static_cast<double>(k);
  for (double part = half_angle * half_angle / 4; part > 0x1p-53; part /= 2) {
    const Point b = {middle.x - part * middle.x, middle.y - part * middle.y};
    if (near_enough(before, a0, a1, after, b)) return b;
  }
  throw Error(ErrorCode::kBadOption, "bhrs-ring of " + std::to_string(2 * k) +
                                         " points is too fine for double coordinates");
}

}  // namespace

Points make_bhrs_line(std::size_t n, std::uint64_t) {
  const std::size_t m = n - 3;
  Points points;
  points.reserve(n);
  for (std::size_t i = 0; i <= m; ++i) points.push_back({static_cast<double>(i), 0});
  const double half = static_cast<double>(m) / 2;
  points.push_back({half, half});
  points.push_back({half, -half});
  return points;
}

Points make_bhrs_ring(std::size_t n, std::uint64_t) {
  const std::size_t k = n / 2;
  Points points;
  points.reserve(2 * k);
  for (std::size_t i = 0; i < k; ++i) {
    points.push_back(on_unit_circle(static_cast<double>(i) / static_cast<double>(k)));
  }
  for (std::size_t i = 0; i < k; ++i) {
    const Point before = points[(i + k - 1) % k], after = points[(i + 2) % k];
    points.push_back(inside_the_edge(before, points[i], points[(i + 1) % k], after, k));
  }
  return points;
}

}  // namespace quadloom::generate
