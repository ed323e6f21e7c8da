// The best parting of a small polygon into quads.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "convex/cluster.hpp"

namespace quadloom::convex {

/// What the faces of a parting cost. A parting with fewer bad quads (not strictly convex), and then
/// fewer stars, is always better.
inline constexpr double kBadQuad = 1e6;
inline constexpr double kStar = 1e3;

struct Parting {
  double cost = 0;
  std::vector<ClusterQuad> quads;
  std::vector<Point> added;  ///< the centres of stars, numbered from the number of corners on

  std::size_t bad_quads() const { return static_cast<std::size_t>(cost / kBadQuad); }
};

/// Whether stars may be used: a hexagon (of corners of the polygon) with an added point that is joined to
/// every other corner, three strictly convex quads.
enum class Stars { kNone, kAllowed };

/// The cheapest parting of a simple polygon (counter-clockwise, an even number of corners, at most
/// kMostCorners) into quads with corners of the polygon: first the fewest bad quads, then the fewest stars, then
/// the sum of the prices of the quads by their squareness. None if there is no parting at all, or if it would cost
/// `limit` or more. The exact predicates decide what fits in. O(n^4), with stars O(n^6) in theory.
inline constexpr std::size_t kMostCorners = 20;
std::optional<Parting> best_parting(std::span<const Point> polygon, double limit, Stars stars,
                                    const std::function<double(double)>& price_of);

}  // namespace quadloom::convex
