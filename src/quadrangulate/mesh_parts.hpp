// The parts of a triangle mesh that stay apart: what edges to keep and borders of regions cut off.
#pragma once

#include <cstdint>
#include <vector>

#include "quadloom/core.hpp"

namespace quadloom::quadrangulate {

/// Whether no face may reach over the halfedge: an edge to keep, or another region behind it. Not true of
/// the edge inside a given quad.
bool must_stay(const TriangleMesh& input, HalfedgeId h);

/// The triangulation without the twins of the edges that must stay.
Triangulation cut_along_kept_edges(const TriangleMesh& input);

/// The triangles connected over twins.
struct MeshParts {
  std::vector<std::uint32_t> part;       ///< per triangle
  std::vector<std::uint32_t> triangles;  ///< per part, how many

  std::size_t count() const { return triangles.size(); }
  /// An odd number of triangles, and thus of border edges.
  bool is_odd(std::uint32_t p) const { return triangles[p] % 2 == 1; }
  std::size_t odd_count() const;
};
MeshParts parts_of(const Triangulation& mesh);

/// How many halfedges have no twin.
std::size_t border_size(const Triangulation& mesh);

}  // namespace quadloom::quadrangulate
