// A cheap stand-in for quad_shape with the same order: no arc cosines, for inner loops.
#pragma once

#include <algorithm>
#include <cmath>

#include "quadloom/core.hpp"

namespace quadloom::kernel {

/// The squared cosine of the corner at b of a, b, c.
inline double squared_cosine(Point a, Point b, Point c) {
  const double ux = a.x - b.x, uy = a.y - b.y, vx = c.x - b.x, vy = c.y - b.y;
  const double dot = ux * vx + uy * vy;
  return dot * dot / ((ux * ux + uy * uy) * (vx * vx + vy * vy));
}

/// In [0, 1]: 1 - max cos^2 over the corners of a convex quad; 1 for a rectangle, 0 towards a flat
/// corner. Orders convex quads as quad_shape does. Not finite input differences give 0.
inline double squareness(Point a, Point b, Point c, Point d) {
  const double worst = std::max(std::max(squared_cosine(d, a, b), squared_cosine(a, b, c)),
                                std::max(squared_cosine(b, c, d), squared_cosine(c, d, a)));
  return worst < 1 ? 1 - std::sqrt(worst) : 0;
}

}  // namespace quadloom::kernel
