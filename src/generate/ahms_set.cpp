// The set without a sequential triangulation.
//
// Arkin, Held, Mitchell, Skiena, "Hamiltonian triangulations for fast rendering", theorem 4.1: a triangle
// A B C and six points D, E, F, G, H, I around it (counter-clockwise, the corners of the hull). D, E, F, I
// are right of the line A B, E, F, G, H right of B C, G, H, I, D right of C A: so I and D are beyond A, E
// and F beyond B, G and H beyond C, and A B C is in every triangulation. For n > 9 the other points are on
// the hull between D and E, F and G, H and I; here they too are beyond a corner, next to D, F and H.
#include <array>
#include <string>

#include "generate/elementary.hpp"
#include "generate/sets.hpp"
#include "quadloom/kernel.hpp"

namespace quadloom::generate {
namespace {

constexpr double kSize = 0x1p-4;    // of the triangle, in a circle of radius 1
constexpr double kSpread = 0x1p-4;  // of the points beyond a corner, in turns; the cone has a sixth

/// Point i of `count` beyond corner `k`.
Point beyond(std::size_t k, std::size_t i, std::size_t count) {
  const double part = static_cast<double>(i) / static_cast<double>(count - 1);
  const double turns = 0.25 + static_cast<double>(k) / 3 + kSpread * (part - 0.5);
  return on_unit_circle(turns < 1 ? turns : turns - 1);
}

void require_convex(const std::array<Points, 3>& chain, std::size_t n) {
  Points ring;
  for (const Points& part : chain) ring.insert(ring.end(), part.begin(), part.end());
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i], b = ring[(i + 1) % ring.size()], c = ring[(i + 2) % ring.size()];
    if (orient2d(a, b, c) > 0) continue;
    throw Error(ErrorCode::kBadOption,
                "ahms-nine of " + std::to_string(n) + " points is too fine for double coordinates");
  }
}

}  // namespace

Points make_ahms_nine(std::size_t n, std::uint64_t) {
  Points points;
  std::array<Points, 3> chain;  // beyond A, B, C
  for (std::size_t k = 0; k < 3; ++k) {
    const Point p = on_unit_circle(k < 2 ? 0.25 + static_cast<double>(k) / 3 : 0.25 - 1.0 / 3 + 1);
    points.push_back({kSize * p.x, kSize * p.y});
    const std::size_t count = 2 + (n - 9 + 2 - k) / 3;
    for (std::size_t i = 0; i < count; ++i) chain[k].push_back(beyond(k, i, count));
  }
  require_convex(chain, n);
  const Point d = chain[0][1], i = chain[0][0];
  points.insert(points.end(), {d, chain[1][0], chain[1][1], chain[2][0], chain[2][1], i});
  for (const Points& part : chain) points.insert(points.end(), part.begin() + 2, part.end());
  return points;
}

}  // namespace quadloom::generate
