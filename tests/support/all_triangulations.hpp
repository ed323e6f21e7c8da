// All triangulations of a small simple polygon.
#pragma once

#include <array>
#include <functional>
#include <utility>
#include <vector>

#include "quadloom/quadloom.hpp"

namespace quadloom::test {

/// Connects triangles given by their corners; quadratic.
inline Triangulation connected(std::vector<Point> points, std::vector<VertexId> corners) {
  Triangulation mesh{std::move(points), std::move(corners), {}};
  mesh.twin.assign(mesh.tri_vertex.size(), kNone);
  for (HalfedgeId h = 0; h < mesh.twin.size(); ++h) {
    for (HalfedgeId g = 0; g < mesh.twin.size(); ++g) {
      if (mesh.origin(h) == mesh.target(g) && mesh.target(h) == mesh.origin(g)) mesh.twin[h] = g;
    }
  }
  return mesh;
}

class AllTriangulations {
 public:
  /// A ring without equal corners, counter-clockwise.
  explicit AllTriangulations(std::vector<Point> ring) : ring_(std::move(ring)) {}

  void visit(const std::function<void(const Triangulation&)>& visitor) {
    todo_ = {{0, static_cast<VertexId>(ring_.size() - 1)}};
    descend(visitor);
  }

 private:
  using Base = std::pair<VertexId, VertexId>;  // what is on the left of the chord first -> second

  VertexId next(VertexId v) const { return v + 1 == ring_.size() ? 0 : v + 1; }

  /// Whether the segment is an edge or a chord that touches no corner but its ends.
  bool sees(VertexId a, VertexId b) const {
    if (next(a) == b || next(b) == a) return true;
    const Point p = ring_[a], q = ring_[b];
    for (VertexId v = 0; v < ring_.size(); ++v) {
      const VertexId w = next(v);
      const Point r = ring_[v], s = ring_[w];
      if (v != a && v != b && orient2d(p, q, r) == 0 && dot_sign(r, p, r, q) <= 0) return false;
      if (v == a || v == b || w == a || w == b) continue;
      if (orient2d(p, q, r) * orient2d(p, q, s) < 0 && orient2d(r, s, p) * orient2d(r, s, q) < 0) {
        return false;
      }
    }
    return true;
  }

  /// Triangulates the polygons first .. second that are still to do.
  void descend(const std::function<void(const Triangulation&)>& visitor) {
    if (todo_.empty()) {
      visitor(connected(ring_, corners_));
      return;
    }
    const auto [a, b] = todo_.back();
    todo_.pop_back();
    if (b - a < 2) {
      descend(visitor);
    } else {
      for (VertexId c = a + 1; c < b; ++c) {
        if (orient2d(ring_[a], ring_[c], ring_[b]) <= 0 || !sees(a, c) || !sees(c, b)) continue;
        corners_.insert(corners_.end(), {a, c, b});
        const auto rest = todo_;
        todo_.emplace_back(a, c);
        todo_.emplace_back(c, b);
        descend(visitor);
        todo_ = rest;
        corners_.resize(corners_.size() - 3);
      }
    }
    todo_.emplace_back(a, b);
  }

  std::vector<Point> ring_;
  std::vector<Base> todo_;
  std::vector<VertexId> corners_;
};

inline void for_all_triangulations(const std::vector<Point>& ring,
                                   const std::function<void(const Triangulation&)>& visitor) {
  AllTriangulations(ring).visit(visitor);
}

}  // namespace quadloom::test
