// The check of a triangle mesh at the public doors.
#pragma once

#include "quadloom/core.hpp"

namespace quadloom::quadrangulate {

/// Throws as quadrangulate_triangles for a mesh whose parts do not agree.
void check_triangle_mesh(const TriangleMesh& input);

}  // namespace quadloom::quadrangulate
