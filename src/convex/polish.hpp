// Better shapes for strictly convex quads that mending has left poor.
#pragma once

#include <span>
#include <vector>

#include "core/random.hpp"
#include "quadrangulate/paired_mesh.hpp"

namespace quadloom::convex {

/// Parts clusters around the poor ones among the quads of the triangles anew, as long as that is better; strictly
/// convex quads stay strictly convex.
void polish_quads(quadrangulate::PairedMesh& mesh, std::vector<TriangleId> triangles,
                  Random& random);

/// Moves each inner point to where the worst of its quads is better, as long as all of them are strictly
/// convex (exactly); those at a quad that is not strictly convex stay. Then each has parents: three vertices that are
/// no inner points, with the point in their triangle. O(1) a point, after O(n).
void smooth_points(quadrangulate::PairedMesh& mesh, std::span<SteinerPoint> points);

}  // namespace quadloom::convex
