// Sequential triangulations of points of which at most two are inside the hull.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "quadloom/core.hpp"

namespace quadloom::strips {

/// The sequence of vertices of a sequential triangulation; none if there is none. `hull` as convex_hull
/// gives it, `inner` the others, two at most.
std::optional<std::vector<VertexId>> sequence_of_few_inner(std::span<const Point> points,
                                                           std::span<const VertexId> hull,
                                                           std::span<const VertexId> inner);

}  // namespace quadloom::strips
