// Quads that are not strictly convex are mended: by parting clusters around them anew, by walks, and where
// that does not do, with added points.
#pragma once

#include <cstdint>
#include <vector>

#include "quadloom/convex.hpp"
#include "quadrangulate/paired_mesh.hpp"

namespace quadloom::convex {

/// Vertices, borders and the number of free triangles stay; the added points are inside. Planar meshes alone.
/// The same seed gives the same mesh.
MendStatistics mend_quads(quadrangulate::PairedMesh& mesh, std::uint64_t seed,
                          std::vector<SteinerPoint>& steiner, const Progress& progress);

}  // namespace quadloom::convex
