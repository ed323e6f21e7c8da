// Parts with an odd number of border edges, which no mesh of quads alone fills, become even.
#pragma once

#include <vector>

#include "quadrangulate/mesh_parts.hpp"
#include "quadrangulate/paired_mesh.hpp"
#include "quadrangulate/steiner_crossing.hpp"
#include "quadrangulate/walk.hpp"

namespace quadloom::quadrangulate {

/// Adds points at borders so that every part has an even number of free triangles: one outside the
/// boundary or on it for a part alone, one on the border between two parts for both. A free
/// triangle of the part walks to the border where the point makes a good quad of it; where no walk
/// goes there it crosses quads. Throws Error kGuarantee if no border edge has a place.
std::vector<SteinerPoint> make_parts_even(PairedMesh& mesh, const TriangleMesh& input,
                                          const MeshParts& parts, Walker& walker,
                                          SteinerCrossing& crossing, OddBoundary wish);

}  // namespace quadloom::quadrangulate
