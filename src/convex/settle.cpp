// Added points settle.
//
// For each added point, again and again: a random cluster with the point inside, and perhaps others,
//   1. is cut anew with fewer points (recutter.hpp), or else
//   2. with as many, at random: so points wander until they meet, or come to where they are not needed.
//
// The rounds end some time after the last point was taken out. Degenerate input: nothing special. Cost: limited
// for each added point, and in all.
#include "convex/settle.hpp"

#include <algorithm>
#include <cstdint>

#include "convex/recutter.hpp"

namespace quadloom::convex {
namespace {

constexpr std::size_t kMostTries = 60'000;              // clusters, about 10 us each
constexpr std::size_t kLeastMostTries = 1'000;          // on large meshes
constexpr std::uint64_t kTryTriangles = 1'000'000'000;  // triangles times tries, between the two
constexpr std::size_t kLeastPatience = 6'000;           // tries without a point less
constexpr std::size_t kRoundsOfPatience = 100;          // the same, for each point
constexpr std::size_t kMostMoreQuads = 5;               // than those around the point
constexpr std::size_t kMostMoreIfLarge = 12;
constexpr std::size_t kLargeEvery = 3;  // tries

/// Whether there is a point less.
bool try_around(Mending& state, Recutter& recutter, VertexId v, Recutter::Size size) {
  const bool large = size == Recutter::Size::kLarge;
  const std::size_t more = state.random.below(1 + (large ? kMostMoreIfLarge : kMostMoreQuads));
  if (!recutter.grow_around(v, more, size) || !recutter.look() || recutter.bad() > 0) return false;
  if (recutter.cut(recutter.points() - 1, RecutOrder::kShape)) return true;
  return !large && recutter.cut(recutter.points(), RecutOrder::kRandom) && recutter.fewer() > 0;
}

}  // namespace

void settle(Mending& state, MendStatistics& statistics) {
  Recutter recutter(state);
  std::vector<VertexId> points = state.inner_points();
  const std::size_t before = points.size();
  const std::size_t patience =
      std::min(std::max(kLeastPatience, kRoundsOfPatience * before), state.tries_at_most());
  const std::size_t most = std::clamp<std::uint64_t>(kTryTriangles / (state.mesh.mate.size() + 1),
                                                     kLeastMostTries, kMostTries);
  std::size_t since = 0;
  for (std::size_t i = 0; i < most && since < patience && !points.empty(); ++i, ++since) {
    const VertexId v = points[i % points.size()];
    const auto size = i % kLargeEvery == 0 ? Recutter::Size::kLarge : Recutter::Size::kUsual;
    if (!try_around(state, recutter, v, size)) continue;
    since = 0;
    points = state.inner_points();
  }
  statistics.settled += before - points.size();
}

}  // namespace quadloom::convex
