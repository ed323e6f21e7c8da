// The twins of triangles that are known to make a manifold mesh.
#pragma once

#include <span>
#include <vector>

#include "quadloom/core.hpp"

namespace quadloom::strips {

/// Per halfedge the one in the other direction, kNone if there is none. No direction is there twice.
/// Linear, but for sorting the edges at a vertex.
std::vector<HalfedgeId> match_twins(std::span<const VertexId> tri_vertex, std::size_t vertices);

}  // namespace quadloom::strips
