// Hexagons in strictly convex quads.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "convex/open_region.hpp"
#include "convex/patch.hpp"

namespace quadloom::convex {

/// The Steiner points that suffice for a pattern (see pattern_of) of a simple hexagon.
int most_points(const char* pattern);

/// The search for quads of one hexagon, which may be what is left of a larger polygon.
class HexagonSearch {
 public:
  /// Steiner points are looked for in the box of the given points. The patch grows as the search
  /// succeeds, and is as it was where it fails.
  HexagonSearch(std::span<const Point> given, Effort effort, Patch& patch)
      : given_(given), effort_(effort), patch_(patch) {}

  /// Exactly that many Steiner points, 0 to 3. See hexagon.cpp for what may be missed.
  bool solve(const Hexagon& hexagon, int points);

 private:
  bool split(const Hexagon& h);
  bool star(const Hexagon& h);
  bool star_of(const Hexagon& h, int first);
  bool cut(const Hexagon& h, int points);
  bool cut_anywhere(const Hexagon& h, int points);
  bool cut_at(const Hexagon& h, int corner, Point s, int points);
  OpenRegion region_of(const Hexagon& h, int corner) const;

  std::span<const Point> given_;
  Effort effort_;
  Patch& patch_;
};

/// The fewest Steiner points that the search finds, at most `most`, for a hexagon that is simple or
/// touches itself in a corner. The patch has been checked. None if the search fails: see hexagon.cpp.
std::optional<Patch> patch_hexagon(const std::array<Point, 6>& corners, int most = 3);

}  // namespace quadloom::convex
