// Quads that are not strictly convex are mended: by parting clusters around them anew, by walks, and where
// that does not do, with added points.
#pragma once

#include <cstdint>
#include <vector>

#include "quadloom/convex.hpp"
#include "quadrangulate/paired_mesh.hpp"

namespace quadloom::convex {

/// Where shapes are improved when all is mended.
enum class Improve : std::uint8_t {
  kAll,      ///< diagonal slides all over the mesh
  kTouched,  ///< where quads were mended alone: the rest of a given mesh is its owner's
};

/// Vertices, borders and the number of free triangles stay; the added points are inside. Planar meshes alone.
/// The same seed gives the same mesh.
MendStatistics mend_quads(quadrangulate::PairedMesh& mesh, std::uint64_t seed,
                          std::vector<SteinerPoint>& steiner, const Progress& progress,
                          Improve improve);

}  // namespace quadloom::convex
