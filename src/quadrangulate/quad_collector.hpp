// The result of a conversion while it grows.
#pragma once

#include <array>

#include "quadloom/quadrangulate.hpp"
#include "quadrangulate/edge_places.hpp"

namespace quadloom::quadrangulate {

/// Collects quads with the source triangles that they are made of, left-over triangles and Steiner
/// points.
class QuadCollector {
 public:
  explicit QuadCollector(const TriangleMesh& input);

  const TriangleResult& result() const { return result_; }
  TriangleStatistics& statistics() { return result_.statistics; }
  TriangleResult take() { return std::move(result_); }

  /// Returns the new vertex.
  VertexId add_steiner(Point place, double z, SteinerKind kind, std::array<VertexId, 3> parents);
  /// The point at the boundary edge h.
  VertexId add_steiner(const EdgePlace& at, HalfedgeId h);

  void add_quad(std::array<VertexId, 4> corners, TriangleId t, TriangleId other = kNone);
  void add_triangle(std::array<VertexId, 3> corners, TriangleId t);
  /// The quad of the two triangles at h.
  void add_pair(HalfedgeId h);
  /// The triangle of h and its edge's Steiner point: a, s, b, c.
  void add_split(HalfedgeId h, VertexId s);

 private:
  const TriangleMesh& input_;
  TriangleResult result_;
};

}  // namespace quadloom::quadrangulate
