// Convex layers in O(n log n): lex_order, then peel_layers.
#include "kernel/lex_order.hpp"
#include "kernel/peel_layers.hpp"
#include "quadloom/kernel.hpp"

namespace quadloom {

ConvexLayers convex_layers(std::span<const Point> points, const Progress& progress) {
  report_progress(progress, "convex layers", 0);
  const kernel::LexOrder order = kernel::lex_order(points);
  ConvexLayers layers = kernel::peel_layers(order.points, progress);
  for (VertexId& v : layers.vertex) v = order.index[v];
  return layers;
}

}  // namespace quadloom
