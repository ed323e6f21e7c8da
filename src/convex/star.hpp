// A hexagon as three strictly convex quads around one added point.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "quadloom/core.hpp"

namespace quadloom::convex {

///        e --- d            The centre is joined to corner `parity` and every other one from there;
///       /   .   .           the corners between must be strictly convex.
///      f      s.. c
///       .   .   /           (s, a, b, c), (s, c, d, e), (s, e, f, a)
///        a --- b
struct Star {
  Point centre;
  std::uint8_t parity = 0;
  double cost = 0;  ///< the sum of the prices
};

/// The star whose worst quad is best among the places that were tried, for a simple hexagon
/// (counter-clockwise); none if none was found.
std::optional<Star> place_star(const std::array<Point, 6>& hexagon);

}  // namespace quadloom::convex
