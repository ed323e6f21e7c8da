// Triangles in order: Hamiltonian and sequential triangulations, strips, spiral polygons.
#pragma once

#include <span>
#include <vector>

#include "quadloom/core.hpp"
#include "quadloom/kernel.hpp"

namespace quadloom {

// ---- Point sets. ----

// ---- Polygons. ----

// ---- Triangulations. ----

/// The same triangulation, its triangle order[i] now triangle i; the corners keep their turn. Throws
/// Error kBadOption if `order` has not each triangle once. O(n).
Triangulation reorder_triangles(const Triangulation& mesh, std::span<const TriangleId> order);

// ---- Strips and their encodings. ----

}  // namespace quadloom
