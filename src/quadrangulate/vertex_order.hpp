// Vertices in an order that keeps neighbours in the plane near each other in memory.
#pragma once

#include <utility>
#include <vector>

#include "core/parallel.hpp"
#include "quadloom/quadrangulate.hpp"

namespace quadloom::quadrangulate {

/// Vertices numbered along a curve (kernel/delaunay_in_order.hpp), and the way back.
class VertexOrder {
 public:
  VertexOrder() = default;
  /// The input's number of each vertex.
  explicit VertexOrder(std::vector<VertexId> order) : order_(std::move(order)) {}

  VertexId given(VertexId v) const { return v < order_.size() ? order_[v] : v; }

  SteinerPoint given(SteinerPoint s) const {
    for (VertexId& parent : s.parents) {
      if (parent != kNone) parent = given(parent);
    }
    return s;
  }

  /// Back to the input's order; Steiner points keep their places behind.
  void restore(Quadrangulation& mesh) const {
    for (auto* corners : {&mesh.quad_vertex, &mesh.tri_vertex}) {
      parallel_for(corners->size(), [&](std::uint32_t i) { (*corners)[i] = given((*corners)[i]); });
    }
    const std::vector<Point> along = mesh.points;
    parallel_for(order_.size(), [&](VertexId v) { mesh.points[order_[v]] = along[v]; });
  }

 private:
  std::vector<VertexId> order_;
};

}  // namespace quadloom::quadrangulate
