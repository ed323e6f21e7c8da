// Vertices in an order that keeps neighbours in the plane near each other in memory.
#pragma once

#include <utility>
#include <vector>

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
    for (VertexId& v : mesh.quad_vertex) v = given(v);
    for (VertexId& v : mesh.tri_vertex) v = given(v);
    const std::vector<Point> along = mesh.points;
    for (VertexId v = 0; v < order_.size(); ++v) mesh.points[order_[v]] = along[v];
  }

 private:
  std::vector<VertexId> order_;
};

}  // namespace quadloom::quadrangulate
