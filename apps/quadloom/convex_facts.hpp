// What --convex adds to the closing lines and the report.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "quadloom/convex.hpp"
#include "report.hpp"

namespace quadloom::app {

/// The quads of a planar mesh with a flat or reflex corner, exact.
std::vector<QuadId> find_not_convex(const Quadrangulation& mesh);

/// "12 quads were not strictly convex, 3 points added inside\n"; empty if there were none.
std::string mending_line(const MendStatistics& mending, std::size_t added_inside);

/// Says on standard error how many quads had to stay as they are, which, and for which corners (those on
/// the boundary cannot be helped without touching it), and gives the exit code.
/// Quads are the first faces of the mesh.
int tell_not_convex(const PolygonMesh& mesh, std::span<const QuadId> not_convex);

Json mending_json(const MendStatistics& mending);
Json convex_json(const ConvexStatistics& statistics);

/// At most the first thousand, and which of their corners are flat or reflex, and on the boundary.
Json not_convex_json(const PolygonMesh& mesh, std::span<const QuadId> not_convex);

}  // namespace quadloom::app
