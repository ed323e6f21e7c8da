// Triangulations cut into simple faces of at most k corners, to start the transfers from.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "quadloom/core.hpp"

namespace quadloom::quadrangulate {

/// Triangles of one label, 0 ... labels - 1, are a simple polygon of at most k corners.
struct LabelledTriangles {
  Triangulation mesh;
  std::vector<std::uint32_t> label;
  std::size_t labels = 0;
};

/// The Delaunay triangulation; each face grows from a triangle by the nearest triangles that leave
/// it simple: round cells for small k. Distinct points. O(n log n).
LabelledTriangles grow_faces(std::span<const Point> points, std::size_t k);

/// A path through all inner points parts the hull in two simple polygons (two_faces.hpp), from
/// hull[from] to hull[from + steps]; both are triangulated, and since a part of a triangulated simple
/// polygon is simple, their trees of triangles can be cut anywhere: few faces for large k.
/// Distinct points; `hull` as convex_hull gives it, 1 <= steps < h. O(n log n).
LabelledTriangles cut_sides(std::span<const Point> points, std::span<const VertexId> hull,
                            std::size_t from, std::size_t steps, std::size_t k,
                            const Progress& progress = {});

}  // namespace quadloom::quadrangulate
