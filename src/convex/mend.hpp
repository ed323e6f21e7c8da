// Quads that are not strictly convex are mended: by parting clusters around them anew, by walks, and where
// that does not do, with added points.
#pragma once

#include <cstdint>
#include <vector>

#include "quadloom/quadrangulate.hpp"
#include "quadrangulate/paired_mesh.hpp"

namespace quadloom::convex {

struct MendStatistics {
  std::size_t bad = 0;              ///< quads that were not strictly convex
  std::size_t bad_after_moves = 0;  ///< that were left when moves without added points ended
  std::size_t clusters = 0;         ///< parted anew
  std::size_t stars = 0;            ///< clusters mended by one added point, or several stars
  std::size_t cases = 0;            ///< unions of two quads mended as in the paper's cases
  std::size_t left = 0;             ///< quads that could not be mended among the doubles
};

/// Vertices, borders and the number of free triangles stay; the added points are inside. Planar meshes alone.
/// The same seed gives the same mesh.
MendStatistics mend_quads(quadrangulate::PairedMesh& mesh, std::uint64_t seed,
                          std::vector<SteinerPoint>& steiner, const Progress& progress);

}  // namespace quadloom::convex
