// The Delaunay triangulation in memory as it lies in the plane, for methods that go on with it.
#pragma once

#include <span>
#include <vector>

#include "quadloom/core.hpp"

namespace quadloom::kernel {

/// The same triangles as delaunay() gives, other numbers: the vertices follow a Hilbert curve and
/// the triangles their first vertices on it, so that passes over the mesh stream through memory.
struct DelaunayInOrder {
  Triangulation mesh;
  std::vector<VertexId> vertex;           // the number of each vertex in delaunay()
  std::vector<VertexId> input_to_vertex;  // as in delaunay()
};

/// Throws as delaunay(). Cheaper than it by the random access that its numbers cost.
DelaunayInOrder delaunay_in_order(std::span<const Point> input);

}  // namespace quadloom::kernel
