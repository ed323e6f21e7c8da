// Sentences about faces and vertices.
#pragma once

#include <span>
#include <string>

#include "core/point_text.hpp"
#include "quadloom/core.hpp"

namespace quadloom::certify {

using quadloom::point_text;

/// "vertex 7 (0.5, 1)".
std::string vertex_text(const PolygonMesh& mesh, std::size_t v);

/// "face 3 (vertices 0 4 5 1)", long faces abridged.
std::string face_text(const PolygonMesh& mesh, std::size_t f);

}  // namespace quadloom::certify
