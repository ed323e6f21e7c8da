// The edges of a polygon mesh, matched from the faces alone.
#pragma once

#include <cstdint>
#include <vector>

#include "quadloom/core.hpp"

namespace quadloom::certify {

struct DirectedEdge {
  VertexId from = kNone;
  VertexId to = kNone;
};

struct EdgeReport {
  DirectedEdge repeated;  ///< a directed edge of two faces; from is kNone if there is none
  std::vector<DirectedEdge> alone;  ///< the edges whose reverse is in no face (if none is repeated)
};

/// Every edge must have valid, different ends, and vertices be fewer than 2^31. O(edges + vertices)
/// and a sort of the edges at each vertex.
EdgeReport match_edges(const PolygonMesh& mesh);

/// Per corner (a place in PolygonMesh::face_vertex), whose edge goes to the next corner of its face:
/// the corner whose edge is the reverse, kNone if there is none. Under the conditions of match_edges,
/// if no edge is repeated.
std::vector<std::uint32_t> reverse_edges(const PolygonMesh& mesh);

}  // namespace quadloom::certify
