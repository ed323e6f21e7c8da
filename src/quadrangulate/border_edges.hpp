// Boundary edges of a planar mesh, and the best one for an outer Steiner point.
#pragma once

#include <span>
#include <vector>

#include "quadloom/core.hpp"
#include "quadrangulate/outer_places.hpp"

namespace quadloom::quadrangulate {

/// Throws Error kBadMesh for a surface in space, which has no outside to put points into.
void require_planar(const TriangleMesh& input);

/// The halfedges without a twin, ascending.
std::vector<HalfedgeId> boundary_edges(const Triangulation& mesh);

struct OuterPlace {
  HalfedgeId edge = kNone;
  Point place;
};

/// The longest boundary edge of the triangles that has a place, and the place. Throws Error kGuarantee
/// if there is none (culprits: the triangles).
OuterPlace longest_with_place(const Triangulation& mesh, std::span<const TriangleId> triangles,
                              OuterPlaces& places);

}  // namespace quadloom::quadrangulate
