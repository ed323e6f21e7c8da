// The boundary of all faces together, in the sense of chains.
#pragma once

#include <vector>

#include "certify/edges.hpp"
#include "quadloom/core.hpp"

namespace quadloom::certify {

/// The sides of all faces, where a side and one in the opposite direction cancel each other: an edge that
/// is a side of m more faces in one direction than in the other is there m times in that direction. In
/// the order of the smaller ends, then of the larger. Conditions as for match_edges. It sees no edge
/// that is in two faces on either side, but is faster.
std::vector<DirectedEdge> boundary_chain(const PolygonMesh& mesh);

}  // namespace quadloom::certify
