// The first checks of every judge: do the arrays fit, and are the corners right.
#pragma once

#include <cstdint>
#include <vector>

#include "quadloom/certify.hpp"

namespace quadloom::certify {

/// Whether the mesh has faces with the corners that the options ask for, each a vertex, once in its
/// face. Marks the used vertices, counts faces and triangles in `out`, and writes the fault there.
bool judge_corners(const PolygonMesh& mesh, const CertifyOptions& options, Certificate& out,
                   std::vector<std::uint8_t>& used);

/// Throws Error kBadOption.
void check_options(const CertifyOptions& options);

/// Throws Error kTooManyPoints if there are too many vertices for match_edges.
void require_few_vertices(const PolygonMesh& mesh);

/// Writes the fault of a directed edge in two faces.
void report_repeated_edge(const PolygonMesh& mesh, VertexId from, VertexId to, Certificate& out);

}  // namespace quadloom::certify
