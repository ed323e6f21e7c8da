// Points between nested convex polygons, in a sweep from left to right.
//
//   1. choose_outlines  layers of the sample, so many of its points apart, as upper and lower chains
//   2. heights_at       where the vertical line through a block of points meets them, from below: the
//                       lower chains from the outermost to the innermost, then the upper ones back
//   3. band_at          the number of chains below a point, by binary search without a branch
//
// All in rounded numbers, one line for a whole block: nothing that is decided depends on the bands.
// Cost: O(n log b) for b bands.
#include "kernel/layer_bands.hpp"

#include <algorithm>

namespace quadloom::kernel {
namespace {

/// A chain from left to right that is asked for its height at places from left to right.
struct Chain {
  std::vector<Point> points;
  std::size_t at = 0;

  double height(double x) {
    while (at + 2 < points.size() && points[at + 1].x <= x) ++at;
    const Point a = points[at], b = points[at + 1];
    return b.x > a.x ? a.y + (x - a.x) * ((b.y - a.y) / (b.x - a.x)) : a.y;
  }
};

struct Outline {
  Chain lower, upper;
  bool meets(double x) const { return lower.points[0].x <= x && x <= lower.points.back().x; }
};

Outline outline_of(std::span<const Point> sample, std::span<const VertexId> layer) {
  const auto less = [&](VertexId a, VertexId b) { return lex_less(sample[a], sample[b]); };
  const auto corner = std::max_element(layer.begin(), layer.end(), less);
  Outline outline;
  for (auto v = layer.begin(); v <= corner; ++v) outline.lower.points.push_back(sample[*v]);
  outline.upper.points.push_back(sample[layer[0]]);
  for (auto v = layer.end(); v-- > corner;) outline.upper.points.push_back(sample[*v]);
  return outline;
}

std::vector<Outline> choose_outlines(std::span<const Point> sample, const ConvexLayers& layers,
                                     std::size_t per_band) {
  std::vector<Outline> outlines;
  std::size_t last = 0;
  for (std::size_t i = 1; i < layers.count(); ++i) {
    if (layers.begin[i] - last < per_band || layers.layer(i).size() < 3) continue;
    last = layers.begin[i];
    outlines.push_back(outline_of(sample, layers.layer(i)));
  }
  return outlines;
}

void heights_at(double x, std::vector<Outline>& outlines, std::vector<double>& heights) {
  heights.clear();
  std::size_t met = 0;
  while (met < outlines.size() && outlines[met].meets(x)) ++met;
  for (std::size_t i = 0; i < met; ++i) heights.push_back(outlines[i].lower.height(x));
  for (std::size_t i = met; i-- > 0;) heights.push_back(outlines[i].upper.height(x));
}

std::uint32_t band_at(double y, const std::vector<double>& heights) {
  const double* first = heights.data();
  std::size_t size = heights.size();
  while (size > 1) {
    const std::size_t half = size / 2;
    first += first[half - 1] < y ? half : 0;
    size -= half;
  }
  const auto below =
      static_cast<std::size_t>(first - heights.data()) + (size == 1 && *first < y ? 1U : 0U);
  return static_cast<std::uint32_t>(std::min(below, heights.size() - below));
}

}  // namespace

LayerBands layer_bands(std::span<const Point> sorted, std::span<const Point> sample,
                       const ConvexLayers& layers, std::size_t per_band) {
  std::vector<Outline> outlines = choose_outlines(sample, layers, per_band);
  LayerBands bands;
  bands.count = static_cast<std::uint32_t>(outlines.size()) + 1;
  bands.of_point.reserve(sorted.size());
  const std::size_t block = 16 + 2 * outlines.size();  // a height or less a point
  std::vector<double> heights;
  for (std::size_t begin = 0; begin < sorted.size(); begin += block) {
    const std::size_t end = std::min(begin + block, sorted.size());
    heights_at(sorted[begin + (end - begin) / 2].x, outlines, heights);
    for (std::size_t i = begin; i < end; ++i) {
      bands.of_point.push_back(band_at(sorted[i].y, heights));
    }
  }
  return bands;
}

}  // namespace quadloom::kernel
