// A short walk through all triangles of a small mesh.
#pragma once

#include <vector>

#include "quadloom/strips.hpp"

namespace quadloom::strips {

/// The edges of the graph, by halfedge, of a smallest set that has an odd number of edges at the nodes
/// with odd[t] != 0 and an even one at all others. Each component must have an even number of odd
/// nodes. As maximum_weight_matching.
std::vector<std::uint8_t> minimum_join(const DualGraph& graph,
                                       const std::vector<std::uint8_t>& odd);

/// The order in which the walk of theorem 5.3 first comes to the triangles.
std::vector<TriangleId> christofides_order(const DualGraph& graph);

}  // namespace quadloom::strips
