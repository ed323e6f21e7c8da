// The Q-percolations of quadrangulate_triangles: inner Steiner points.
#pragma once

#include "quadloom/quadrangulate.hpp"

namespace quadloom::quadrangulate {

/// See quadrangulate_triangles, which has checked the input.
TriangleResult q_percolate_triangulation(const TriangleMesh& input, const TriangleOptions& options);

}  // namespace quadloom::quadrangulate
