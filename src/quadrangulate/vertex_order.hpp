// Vertices in an order that keeps neighbours in the plane near each other in memory.
#pragma once

#include <algorithm>
#include <vector>

#include "quadloom/quadrangulate.hpp"

namespace quadloom::quadrangulate {

/// The input's vertices in the order in which the triangles name them, so that neighbours in the
/// plane are neighbours in memory: the triangles are in spatial order already, the input need not
/// be. Takes a third off the time of the walks.
class VertexOrder {
 public:
  VertexOrder() = default;
  /// Renames the vertices of the mesh.
  explicit VertexOrder(Triangulation& mesh) : given_(mesh.points) {
    std::vector<VertexId> place(given_.size(), kNone);
    for (VertexId& v : mesh.tri_vertex) {
      if (place[v] == kNone) {
        place[v] = static_cast<VertexId>(order_.size());
        mesh.points[place[v]] = given_[v];
        order_.push_back(v);
      }
      v = place[v];
    }
  }

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
    std::copy(given_.begin(), given_.end(), mesh.points.begin());
  }

 private:
  std::vector<Point> given_;
  std::vector<VertexId> order_;
};

}  // namespace quadloom::quadrangulate
