// Which points are peeled at about the same time.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "quadloom/kernel.hpp"

namespace quadloom::kernel {

/// A band for each point, 0 the outermost.
struct LayerBands {
  std::vector<std::uint32_t> of_point;
  std::uint32_t count = 1;
};

/// Bands between some convex layers of a sample, of about `per_band` points of the sample. `sorted` and
/// `sample` are in lexicographic order. A guess: nearly all points are in the band that they should be.
LayerBands layer_bands(std::span<const Point> sorted, std::span<const Point> sample,
                       const ConvexLayers& layers, std::size_t per_band);

}  // namespace quadloom::kernel
