// Local improvement of a mesh of quads.
#pragma once

#include <array>
#include <vector>

#include "quadrangulate/paired_mesh.hpp"

namespace quadloom::quadrangulate {

/// Two quads that share an edge; it can be parted into quads by any of its three long diagonals.
///
///      d --- c             d --- c
///     /       .           /    .  .
///    a ------- b   ->    a    .    b
///     .       /           . .     /
///      x --- y             x --- y
struct QuadPair {
  std::array<VertexId, 6> corner;   // b, c, d, a, x, y: the edge shared now is corner 0 to corner 3
  std::array<HalfedgeId, 6> inner;  // of the side from corner k to k + 1
  std::array<TriangleId, 4> slot;
  bool simple = true;  // no corner twice
};

/// The two quads at an edge that is a side of both.
QuadPair quad_pair_at(const PairedMesh& mesh, HalfedgeId edge);

/// Parts the hexagon between corner first and first + 3. Its corners keep their names, so that parting it at
/// corner 0 again takes that back.
void part_anew(PairedMesh& mesh, QuadPair& hexagon, std::size_t first);

/// Slides the edges between neighbouring quads as long as that improves the sum of their shapes, where
/// one of the two is poor. Vertices, boundary and counts stay; free triangles are not touched. Returns the
/// number of slides.
std::size_t slide_diagonals(PairedMesh& mesh);
/// The same, starting from these triangles' quads alone; those of the slides are added to them.
std::size_t slide_diagonals_at(PairedMesh& mesh, std::vector<TriangleId>& triangles);

}  // namespace quadloom::quadrangulate
