// The public door for single polygons: check, search, name the case.
#include <algorithm>
#include <cmath>
#include <span>

#include "convex/hexagon.hpp"
#include "convex/hexagon_cases.hpp"
#include "convex/quad.hpp"
#include "kernel/ring_direction.hpp"
#include "kernel/segments.hpp"
#include "quadloom/convex.hpp"

namespace quadloom {

using namespace convex;

namespace {

bool is_finite(Point p) { return std::isfinite(p.x) && std::isfinite(p.y); }

/// Neighbouring edges may share their corner alone, other edges nothing.
bool edges_apart(std::span<const Point> ring, std::size_t i, std::size_t j) {
  const std::size_t n = ring.size();
  const Point a = ring[i], b = ring[(i + 1) % n], c = ring[j], d = ring[(j + 1) % n];
  const auto turns_back = [](Point p, Point q, Point r) {
    return kernel::orient(p, q, r) == 0 && dot_sign(p, q, q, r) <= 0;
  };
  if (j == i + 1) return !turns_back(a, b, d);
  if (i == 0 && j == n - 1) return !turns_back(c, a, b);
  return !kernel::segments_meet(a, b, c, d);
}

void check_polygon(std::span<const Point> ring) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (!is_finite(ring[i])) throw Error(ErrorCode::kNotFinite, "a corner is not finite", {i});
  }
  for (std::size_t i = 0; i < ring.size(); ++i) {
    for (std::size_t j = i + 1; j < ring.size(); ++j) {
      if (!edges_apart(ring, i, j)) {
        throw Error(ErrorCode::kBadPolygon, "the polygon's edges meet", {i, j});
      }
    }
  }
  if (!kernel::goes_counter_clockwise(ring)) {
    throw Error(ErrorCode::kBadPolygon, "the polygon is clockwise");
  }
}

/// For a point that is on no edge: how many edges a ray to the right of it crosses is odd.
bool is_inside(std::span<const Point> ring, Point p) {
  bool inside = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i], b = ring[(i + 1) % ring.size()];
    if (kernel::segments_meet(a, b, p, p)) return false;
    const bool up = a.y <= p.y && p.y < b.y, down = b.y <= p.y && p.y < a.y;
    if ((up && kernel::orient(a, b, p) > 0) || (down && kernel::orient(a, b, p) < 0)) {
      inside = !inside;
    }
  }
  return inside;
}

std::optional<ConvexPatch> to_public(const std::optional<Patch>& patch, const std::string& name) {
  if (!patch) return std::nullopt;
  ConvexPatch out;
  out.steiner.assign(patch->steiner.begin(), patch->steiner.end());
  out.quads.assign(patch->quads.begin(), patch->quads.end());
  out.case_name = name + "-" + std::to_string(out.steiner.size());
  return out;
}

}  // namespace

std::optional<ConvexPatch> convexify_hexagon(const std::array<Point, 6>& corners) {
  check_polygon(corners);
  Hexagon hexagon;
  for (std::uint32_t i = 0; i < 6; ++i) hexagon[i] = {corners[i], i};
  const char* pattern = pattern_of(hexagon);
  return to_public(patch_hexagon(corners, most_points(pattern)), pattern);
}

std::optional<ConvexPatch> convexify_quad_with_point(const std::array<Point, 4>& corners,
                                                     Point inner) {
  check_polygon(corners);
  if (!is_finite(inner)) throw Error(ErrorCode::kNotFinite, "the inner point is not finite", {4});
  if (!is_inside(corners, inner)) {
    throw Error(ErrorCode::kBadPolygon, "the inner point is not inside the quad", {4});
  }
  return to_public(patch_quad_with_point(corners, inner), "quad with a point");
}

std::optional<ConvexPatch> convexify_quad(const std::array<Point, 4>& corners) {
  check_polygon(corners);
  return to_public(patch_quad(corners), "quad");
}

}  // namespace quadloom
