// Lines over a mesh as edges of it.
#pragma once

#include <span>
#include <vector>

#include "quadloom/core.hpp"

namespace quadloom::app {

/// Finds the edges between vertices.
class EdgePaths {
 public:
  /// Keeps a reference to the mesh.
  explicit EdgePaths(const Triangulation& mesh);

  /// Appends the edge from a to b as a halfedge, either way around, or, if `straight`, the chain of
  /// edges that runs exactly along the straight line from a to b. False if there is none; nothing is
  /// appended then.
  bool follow(VertexId a, VertexId b, bool straight, std::vector<HalfedgeId>& path) const;

 private:
  VertexId other_end(HalfedgeId h, VertexId v) const;
  HalfedgeId edge_to(VertexId a, VertexId b) const;
  HalfedgeId edge_towards(VertexId v, VertexId b) const;

  const Triangulation& mesh_;
  std::vector<std::uint32_t> begin_;  // per vertex: its edges, each once
  std::vector<HalfedgeId> edge_;
};

/// The vertex at each place, kNone where there is none; of several equal ones the first. -0.0 and 0.0
/// are the same coordinate. O(n log n).
std::vector<VertexId> vertices_at(std::span<const Point> vertices, std::span<const Point> places);

}  // namespace quadloom::app
