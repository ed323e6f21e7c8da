// Local improvement of a mesh of quads.
#pragma once

#include "core/random.hpp"
#include "quadrangulate/paired_mesh.hpp"

namespace quadloom::quadrangulate {

/// Slides the edges between neighbouring quads as long as that improves the sum of their shapes.
/// Vertices, boundary and counts stay; free triangles are not touched. Returns the number of
/// slides.
///
///      d --- c             d --- c            Two quads that share an edge are a hexagon; it can
///      be parted into quads
///     /       .           /    .  .           by any of its three long diagonals.
///    a ------- b   ->    a    .    b
///     .       /           . .     /
///      x --- y             x --- y
std::size_t slide_diagonals(PairedMesh& mesh);

}  // namespace quadloom::quadrangulate
