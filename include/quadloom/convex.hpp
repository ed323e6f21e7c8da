// Strictly convex quadrilaterals: every corner turns, none is flat or reflex.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "quadloom/core.hpp"

namespace quadloom {

/// A small polygon in strictly convex quads that tile it, counter-clockwise. Its points are numbered:
/// the corners as given, an inner point that was given, then the Steiner points, which lie strictly
/// inside. The quads' edges along the polygon are the polygon's.
struct ConvexPatch {
  std::vector<Point> steiner;
  std::vector<std::array<VertexId, 4>> quads;
  std::string
      case_name;  ///< the paper's, as in "rcrccc-1": reflex and convex corners up to rotation
                  ///< and reflection, flat ones counting as reflex; Steiner points
};

/// A hexagon, theorem 3.2 of Bremner, Hurtado, Ramaswami and Sacristan: at most 0 Steiner points for
/// cccccc, 2 for rccccc, rrcccc and rccrcc, 3 for the others, as few as are found (no more than
/// necessary where none or one is enough). None if its doubles are so close that no places were
/// found; never a wrong patch, each is checked exactly. Throws Error kNotFinite, kBadPolygon (not
/// simple, or clockwise). Constant time.
std::optional<ConvexPatch> convexify_hexagon(const std::array<Point, 6>& corners);

/// The same for a quad with a point strictly inside (theorem 3.8): 3 Steiner points, which is the
/// fewest. Throws also kBadPolygon for a point that is not inside.
std::optional<ConvexPatch> convexify_quad_with_point(const std::array<Point, 4>& corners,
                                                     Point inner);

/// The same for a quad: no Steiner points if it is strictly convex, else 4, which is the fewest.
std::optional<ConvexPatch> convexify_quad(const std::array<Point, 4>& corners);

}  // namespace quadloom
