// From a paired mesh to the result of a conversion.
#pragma once

#include "quadrangulate/paired_mesh.hpp"

namespace quadloom::quadrangulate {

/// Faces in the order of the triangles, with their sources; the mesh's vectors move. Steiner points are left
/// to the caller.
TriangleResult to_triangle_result(PairedMesh&& mesh, std::size_t input_vertices);

}  // namespace quadloom::quadrangulate
