// The twins of triangles in the order of a cycle.
#pragma once

#include <span>
#include <vector>

#include "quadloom/core.hpp"

namespace quadloom::strips {

/// Per halfedge the one in the other direction, kNone at the hull. Each triangle shares two edges with
/// the one before and the one after it, the last one with the first; its first corner is on both. `from`
/// and `to` are neighbours on the hull, counter-clockwise. O(n), with little memory besides.
std::vector<HalfedgeId> cycle_twins(std::span<const VertexId> tri_vertex, VertexId from,
                                    VertexId to);

}  // namespace quadloom::strips
