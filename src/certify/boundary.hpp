// The boundary of a mesh: one cycle, weakly convex, once around.
#pragma once

#include <string>
#include <vector>

#include "certify/edges.hpp"

namespace quadloom::certify {

struct BoundaryReport {
  std::vector<VertexId> cycle;  ///< from the lexicographically smallest vertex, as the edges go
  std::string sentence;         ///< what is wrong; empty if nothing is
  std::vector<std::size_t> culprits;
};

/// Joins the edges and judges the cycle, exactly. Linear.
BoundaryReport judge_boundary(const PolygonMesh& mesh, const std::vector<DirectedEdge>& edges);

}  // namespace quadloom::certify
