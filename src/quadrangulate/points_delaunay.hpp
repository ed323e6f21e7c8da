// The Delaunay method of quadrangulate_points.
#pragma once

#include <optional>
#include <span>

#include "kernel/delaunay_in_order.hpp"
#include "quadrangulate/quad_mesh.hpp"
#include "quadrangulate/vertex_order.hpp"

namespace quadloom::quadrangulate {

/// The mesh before it is written out, its vertices in an order of its own.
struct DelaunayQuads {
  QuadMesh mesh;
  VertexOrder order;
  std::size_t input_vertices = 0;
  std::optional<SteinerPoint> steiner;
  PointStatistics statistics;
};

/// The quads of the Delaunay triangulation of a point set. If an odd number of points is on the hull
/// one is added of the first of the kinds that has a place; with no kind, or none of one kind, a triangle
/// stays. Empty if a walk could not finish (not seen yet).
std::optional<DelaunayQuads> delaunay_quads(kernel::DelaunayInOrder&& delaunay,
                                            const PointOptions& options,
                                            std::span<const SteinerKind> kinds);

/// Quadrangulates the Delaunay triangulation of a point set; input_to_vertex is left to the caller.
/// Empty if a walk could not finish (not seen yet).
std::optional<PointResult> delaunay_quadrangulation(kernel::DelaunayInOrder&& delaunay,
                                                    const PointOptions& options);

}  // namespace quadloom::quadrangulate
