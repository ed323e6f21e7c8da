// What a converted mesh carries over from its source.
#pragma once

#include <array>
#include <span>
#include <string>

#include "mesh_input.hpp"

namespace quadloom::app {

/// The quads and left-over triangles with: z and vertex data (added points: interpolated), face data
/// (the value if the two sources of a quad agree, else their mean), lines (in pieces where they were
/// split), and "added" per vertex, "shape", "source0" and "source1" per face (numbers of source faces,
/// -1 for none). Triangles that were cut from two have both in `triangle_sources`, one entry each, which
/// then counts instead of TriangleResult::triangle_source.
io::MeshFile carry_data(const SourceMesh& source, const TriangleResult& result,
                        std::span<const std::array<TriangleId, 2>> triangle_sources = {});

/// Proves from the result alone that what had to stay has stayed: each kept edge is an edge of the
/// mesh or a chain of edges over added points, and no face has sources of two regions. Empty, or a
/// sentence that names the first one that has not.
std::string lost_feature(const SourceMesh& source, const TriangleResult& result);

/// quad_shape of a quad in space, seen along its normal.
double shape_in_space(const PolygonMesh& mesh, std::span<const double> z, std::size_t face);

}  // namespace quadloom::app
