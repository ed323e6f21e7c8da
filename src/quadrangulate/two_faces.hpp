// Two faces that share one path through all points inside the hull.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "quadloom/kernel.hpp"

namespace quadloom::quadrangulate {

/// A simple path within the hull from the hull point hull[from] through all points that are not on
/// the hull to hull[from + steps]; the region right of it has the `steps` hull edges between the
/// two. Both regions are simple polygons.
struct CutPath {
  std::vector<VertexId> vertices;  // the ends included
  std::size_t wide_edge = 0;       // vertices[wide_edge], [wide_edge + 1] and
  VertexId wide_apex = kNone;      // this one: a triangle inside one region, no point in it
};

/// `hull` as convex_hull gives it; there must be points inside. 1 <= steps < hull.size().
CutPath cut_through_all(std::span<const Point> points, std::span<const VertexId> hull,
                        std::size_t from, std::size_t steps);

}  // namespace quadloom::quadrangulate
