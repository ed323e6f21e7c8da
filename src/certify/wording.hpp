// Faults, and sentences about faces and vertices.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/point_text.hpp"
#include "quadloom/certify.hpp"

namespace quadloom::certify {

using quadloom::point_text;

/// Writes the fault into the verdict; false.
bool fail(Certificate& out, Fault fault, std::string sentence, std::vector<std::size_t> culprits);

/// "vertex 7 (0.5, 1)".
std::string vertex_text(const PolygonMesh& mesh, std::size_t v);

/// "face 3 (vertices 0 4 5 1)", long faces abridged.
std::string face_text(const PolygonMesh& mesh, std::size_t f);

}  // namespace quadloom::certify
