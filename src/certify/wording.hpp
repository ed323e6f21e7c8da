// Sentences about faces and vertices.
#pragma once

#include <span>
#include <string>

#include "quadloom/core.hpp"

namespace quadloom::certify {

/// "(0.5, 1e+300)", digits that read back the same.
std::string point_text(Point p);

/// "vertex 7 (0.5, 1)".
std::string vertex_text(const PolygonMesh& mesh, std::size_t v);

/// "face 3 (vertices 0 4 5 1)", long faces abridged.
std::string face_text(const PolygonMesh& mesh, std::size_t f);

}  // namespace quadloom::certify
