// The subdivision of quadrangulate_triangles.
#pragma once

#include "quadloom/quadrangulate.hpp"

namespace quadloom::quadrangulate {

/// See quadrangulate_triangles, which has checked the input.
TriangleResult subdivide_triangulation(const TriangleMesh& input, const TriangleOptions& options);

}  // namespace quadloom::quadrangulate
