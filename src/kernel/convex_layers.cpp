// Convex layers ("onion peeling") in O(n log n).
//
//   1. sort the points lexicographically
//   2. an upper and a lower HullTree over them
//   3. peel until no point is left: shed_removed in both trees (a point that left with the other
//      tree's chain is deleted from this tree when it comes to light, for until then it hides
//      nothing that matters); append_layer: the lower chain to the right, the upper one back; mark
//      its points as removed
//
// Every point is deleted once from each tree and passed O(1) times as a chain's point between two
// deletions around it, so the trees' O(n log n) is the bound (Chazelle 1985 gives the same for the
// layers; Hershberger and Suri 1992 for the use of a deletion-only hull).
//
// Degenerate input: both chains keep collinear points, vertical runs included, so every boundary
// point belongs to the layer. If the rest lies on a line, both chains are the whole rest.
#include <algorithm>
#include <numeric>

#include "kernel/hull_tree.hpp"
#include "quadloom/kernel.hpp"

namespace quadloom {
namespace {

using kernel::HullSide;
using kernel::HullTree;

/// Deletes the removed points from the tree's chain until none is left in it.
void shed_removed(HullTree& tree, const std::vector<char>& removed) {
  VertexId p = tree.first();
  while (p != kNone) p = removed[p] ? tree.erase(p) : tree.next(p);
}

/// Appends the boundary of what both chains enclose, by places in the sorted sequence.
void append_layer(const HullTree& lower, const HullTree& upper, std::vector<VertexId>& out) {
  const std::size_t begin = out.size();
  for (VertexId p = lower.first(); p != kNone; p = lower.next(p)) out.push_back(p);
  const std::size_t corner = out.size() - 1;  // the lexicographically largest point
  if (corner == begin || lower.next(out[begin]) == upper.next(out[begin])) return;
  for (VertexId p = upper.next(out[begin]); p != out[corner]; p = upper.next(p)) out.push_back(p);
  std::reverse(out.begin() + static_cast<std::ptrdiff_t>(corner) + 1, out.end());
}

}  // namespace

ConvexLayers convex_layers(std::span<const Point> points, const Progress& progress) {
  report_progress(progress, "convex layers", 0);
  std::vector<VertexId> order(points.size());
  std::iota(order.begin(), order.end(), VertexId{0});
  std::sort(order.begin(), order.end(),
            [&](VertexId a, VertexId b) { return lex_less(points[a], points[b]); });
  std::vector<Point> sorted(points.size());
  for (std::size_t i = 0; i < order.size(); ++i) sorted[i] = points[order[i]];

  HullTree lower(sorted, HullSide::kLower);
  HullTree upper(sorted, HullSide::kUpper);
  std::vector<char> removed(points.size(), 0);
  ConvexLayers layers;
  layers.vertex.reserve(points.size());
  while (layers.vertex.size() < points.size()) {
    report_progress(progress, "convex layers",
                    static_cast<double>(layers.vertex.size()) / static_cast<double>(points.size()));
    shed_removed(lower, removed);
    shed_removed(upper, removed);
    append_layer(lower, upper, layers.vertex);
    for (std::size_t i = layers.begin.back(); i < layers.vertex.size(); ++i) {
      removed[layers.vertex[i]] = 1;
    }
    layers.begin.push_back(static_cast<std::uint32_t>(layers.vertex.size()));
  }
  for (VertexId& v : layers.vertex) v = order[v];
  return layers;
}

}  // namespace quadloom
