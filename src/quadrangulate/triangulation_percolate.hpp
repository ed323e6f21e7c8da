// The percolation of quadrangulate_triangles: the fewest outer Steiner points.
#pragma once

#include "quadloom/quadrangulate.hpp"

namespace quadloom::quadrangulate {

/// See quadrangulate_triangles, which has checked the input.
TriangleResult percolate_triangulation(const TriangleMesh& input, const TriangleOptions& options);

}  // namespace quadloom::quadrangulate
