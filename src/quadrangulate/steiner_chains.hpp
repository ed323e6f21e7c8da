// Several added points on one edge: inside the mesh, or along the hull.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "quadloom/quadrangulate.hpp"

namespace quadloom::quadrangulate {

/// The added points of directed edges, in order from the first vertex to the second.
using EdgeChains = std::map<std::pair<VertexId, VertexId>, std::vector<VertexId>>;

/// `count` points inside the triangle a, b, c (either orientation) or, if it is too small for the
/// doubles, on its side a b, in order from a to b: the path a, points, b is simple and each ray from c
/// meets it once. None if there is no room either way.
std::optional<std::vector<Point>> chain_in_triangle(Point a, Point b, Point c, std::size_t count);

/// `count` points exactly on the segment, in order from a to b, each time in the middle of the longest
/// piece that has a double in it. None if there are too few doubles.
std::optional<std::vector<Point>> chain_on_segment(Point a, Point b, std::size_t count);

/// Adds `count` points to `points`, near or on the given edges of the hull (directed
/// counter-clockwise; `hull` is the whole cycle), so that the boundary stays convex: each time at
/// the longest piece that admits the wished kind of point, or else the other kind. Records them in
/// `chains` and `steiner`. Throws Error kGuarantee if no place is left among the doubles.
void add_hull_points(std::span<const VertexId> hull,
                     std::span<const std::pair<VertexId, VertexId>> edges, std::size_t count,
                     OddBoundary wish, std::vector<Point>& points, EdgeChains& chains,
                     std::vector<SteinerPoint>& steiner);

}  // namespace quadloom::quadrangulate
