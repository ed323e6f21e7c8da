// Convex layers of sorted points.
#pragma once

#include <span>

#include "quadloom/kernel.hpp"

namespace quadloom::kernel {

/// How many points are peeled together at least, and of how many one is in the sample that they are
/// chosen by. For a million uniform points half or twice of either takes at most a tenth longer.
struct PeelingSizes {
  std::size_t band = 8192;
  std::size_t sample = 32;  // at least 2
};

/// The convex layers of distinct points in lexicographic order, by their places in it. O(n log n).
ConvexLayers peel_layers(std::span<const Point> sorted, const Progress& progress = {},
                         PeelingSizes sizes = {});

}  // namespace quadloom::kernel
