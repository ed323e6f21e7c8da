// The convex spiral of a point set (Bose and Toussaint, section 4; from the layers in O(n) after
// Preparata and Shamos).
//
// The paper turns a ray clockwise from point to point. Until a layer is used up, the next point the
// ray meets is the layer's next one (the inner layers lie strictly inside the hull of what is
// left), so the spiral is layer after layer, each one clockwise from the point that the ray meets
// first:
//
//   1. the outermost layer from the start
//   2. entry_point   of each next layer: the clockwise-first point of the layer as seen from the
//                    last point, the nearest of them if several are on the ray
//   3. append_layer  the layer clockwise from there
//
// Degenerate input: points on a straight run are met nearest first, which is the layer's own order.
// The innermost layer may be a point or a segment; the ray meets one of its ends first, and goes on
// to the other. Cost: O(n), after the layers.
#include <algorithm>

#include "kernel/predicates_inline.hpp"
#include "quadloom/kernel.hpp"

namespace quadloom {
namespace {

/// All points of the layer lie on the ray from `eye` through it or right of it; the nearest there.
/// The layer lies in an open half-plane as seen from `eye`, so that "left of" is an order.
std::size_t entry_point(std::span<const Point> points, std::span<const VertexId> layer, Point eye) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < layer.size(); ++i) {
    const Point first = points[layer[best]];
    const Point other = points[layer[i]];
    const int side = kernel::orient(eye, first, other);
    const bool nearer = lex_less(eye, first) ? lex_less(other, first) : lex_less(first, other);
    if (side > 0 || (side == 0 && nearer)) best = i;
  }
  return best;
}

/// Only the first layer of a collinear set and the innermost layer can be segments.
bool is_segment(std::span<const Point> points, std::span<const VertexId> layer) {
  return layer.size() < 3 ||
         orient2d(points[layer[0]], points[layer[1]], points[layer.back()]) == 0;
}

/// Clockwise from layer[from]; a segment from the end nearer to that position to the other end.
void append_layer(std::span<const Point> points, std::span<const VertexId> layer, std::size_t from,
                  std::vector<VertexId>& spiral) {
  if (is_segment(points, layer) && from == 0) {
    spiral.insert(spiral.end(), layer.begin(), layer.end());
    return;
  }
  for (std::size_t i = 0; i < layer.size(); ++i) {
    spiral.push_back(layer[from]);
    from = from == 0 ? layer.size() - 1 : from - 1;
  }
}

std::size_t position_of_start(std::span<const VertexId> hull, VertexId start) {
  if (start == kNone) return 0;
  const auto found = std::find(hull.begin(), hull.end(), start);
  if (found == hull.end()) {
    throw Error(ErrorCode::kBadOption, "the spiral must start at a corner of the hull", {start});
  }
  return static_cast<std::size_t>(found - hull.begin());
}

}  // namespace

std::vector<VertexId> convex_spiral(std::span<const Point> points, const ConvexLayers& layers,
                                    VertexId start) {
  std::vector<VertexId> spiral;
  spiral.reserve(points.size());
  for (std::size_t i = 0; i < layers.count(); ++i) {
    const auto layer = layers.layer(i);
    const std::size_t from = i == 0 ? position_of_start(layer, start)
                                    : entry_point(points, layer, points[spiral.back()]);
    append_layer(points, layer, from, spiral);
  }
  return spiral;
}

std::vector<VertexId> convex_spiral(std::span<const Point> points, VertexId start) {
  return convex_spiral(points, convex_layers(points), start);
}

}  // namespace quadloom
