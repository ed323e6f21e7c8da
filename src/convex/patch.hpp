// A small polygon in strictly convex quads: what the searches of this room build, and its check.
#pragma once

#include <array>
#include <boost/container/static_vector.hpp>
#include <cstddef>
#include <cstdint>
#include <span>

#include "kernel/predicates_inline.hpp"
#include "quadloom/core.hpp"

namespace quadloom::convex {

/// A point with its number in the patch.
struct Corner {
  Point at;
  std::uint32_t name = 0;
};

using Hexagon = std::array<Corner, 6>;  // counter-clockwise
using LocalQuad = std::array<std::uint32_t, 4>;

inline bool turns_left(const Corner& a, const Corner& b, const Corner& c) {
  return kernel::orient(a.at, b.at, c.at) > 0;
}

inline bool strictly_convex(const Corner& a, const Corner& b, const Corner& c, const Corner& d) {
  return turns_left(a, b, c) && turns_left(b, c, d) && turns_left(c, d, a) && turns_left(d, a, b);
}

/// Steiner point i has the number `given` + i, after the corners and inner points given.
struct Patch {
  static constexpr std::size_t kMostSteiner = 4;

  std::uint32_t given = 0;
  boost::container::static_vector<Point, kMostSteiner> steiner;
  boost::container::static_vector<LocalQuad, 8> quads;
  bool as_in_paper = true;  // no place was needed that the paper does not name

  Corner add_steiner(Point p) {
    steiner.push_back(p);
    return {p, given + static_cast<std::uint32_t>(steiner.size()) - 1};
  }
  void add_quad(const Corner& a, const Corner& b, const Corner& c, const Corner& d) {
    quads.push_back({a.name, b.name, c.name, d.name});
  }
};

/// True if the quads of the patch tile the polygon: all strictly convex, each directed edge in one of
/// them, its reverse in another or it is a side of the polygon, all sides there, all given points in
/// use. `given`: the polygon's corners (the first `sides`, counter-clockwise), then inner points.
///
/// The proof that they tile it: glued along their edges the quads make a surface whose boundary is the
/// polygon's, mapped to the plane with positive orientation everywhere (at an inner vertex the quads
/// go around it at least once). So a point is covered as often as the boundary winds around it: once
/// inside, and not at all outside. This holds for polygons that touch themselves in a corner as well.
bool tiles(std::span<const Point> given, std::size_t sides, const Patch& patch);

}  // namespace quadloom::convex
