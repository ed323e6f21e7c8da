// Triangles that were made one after the other, as a triangulation.
#pragma once

#include <vector>

#include "quadloom/core.hpp"

namespace quadloom::strips {

/// Triangles given by their corners, counter-clockwise, three a triangle, that overlap nowhere; they
/// keep their order. Edges are matched by their ends. O(n log n).
Triangulation connect_in_order(std::vector<Point> points, std::vector<VertexId> corners);

}  // namespace quadloom::strips
