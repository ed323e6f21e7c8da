// Local improvement of a mesh of quads.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "quadrangulate/quad_mesh.hpp"

namespace quadloom::quadrangulate {

/// Two quads that share an edge; it can be parted into quads by any of its three long diagonals.
///
///      d --- c             d --- c
///     /       .           /    .  .
///    a ------- b   ->    a    .    b
///     .       /           . .     /
///      x --- y             x --- y
template <class Mesh>
struct QuadPair {
  std::array<VertexId, 6> corner;   // b, c, d, a, x, y: the edge shared now is corner 0 to corner 3
  std::array<HalfedgeId, 6> inner;  // of the side from corner k to k + 1
  std::array<std::uint32_t, 2 * Mesh::kSlots> slot;  // the faces
  bool simple = true;                                // no corner twice
};

/// The two quads at an edge that is a side of both.
template <class Mesh>
QuadPair<Mesh> quad_pair_at(const Mesh& mesh, HalfedgeId edge) {
  const auto above = quad_behind(mesh, edge), below = quad_behind(mesh, mesh.twin(edge));
  QuadPair<Mesh> pair;
  std::copy(above.side.begin(), above.side.end(), pair.inner.begin());
  std::copy(below.side.begin(), below.side.end(), pair.inner.begin() + 3);
  for (std::size_t k = 0; k < 6; ++k) pair.corner[k] = mesh.origin(pair.inner[k]);
  const auto slots_above = above.slots(), slots_below = below.slots();
  std::copy(slots_above.begin(), slots_above.end(), pair.slot.begin());
  std::copy(slots_below.begin(), slots_below.end(), pair.slot.begin() + Mesh::kSlots);
  for (const std::size_t i : {1U, 2U}) {
    for (const std::size_t j : {4U, 5U}) {
      if (pair.corner[i] == pair.corner[j]) pair.simple = false;
    }
  }
  return pair;
}

/// Parts the hexagon between corner first and first + 3. Its corners keep their names, so that parting it at
/// corner 0 again takes that back.
void part_anew(PairedMesh& mesh, QuadPair<PairedMesh>& hexagon, std::size_t first);
void part_anew(QuadMesh& mesh, QuadPair<QuadMesh>& hexagon, std::size_t first);

/// Slides the edges between neighbouring quads as long as that improves the sum of their shapes, where
/// one of the two is poor. Vertices, boundary and counts stay; free triangles are not touched. Returns the
/// number of slides.
std::size_t slide_diagonals(PairedMesh& mesh);
std::size_t slide_diagonals(QuadMesh& mesh);
/// The same, starting from these triangles' quads alone; those of the slides are added to them.
std::size_t slide_diagonals_at(PairedMesh& mesh, std::vector<TriangleId>& triangles);

}  // namespace quadloom::quadrangulate
