// The two ways to cut a polygon into convex parts along its diagonals.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "strips/polygon_disc.hpp"

namespace quadloom::strips {

using Cuts = std::vector<std::pair<Position, Position>>;

/// Chords that cut the polygon into as few convex parts as there can be, flat corners allowed. None if
/// that takes more than `most_steps` steps, which look at three orientations or so each.
std::optional<Cuts> fewest_cuts(const PolygonDisc& disc, std::size_t most_steps);

/// The parts between chords that do not cross, each counter-clockwise. O(n log n).
std::vector<std::vector<Position>> parts_between(const PolygonDisc& disc, const Cuts& cuts);

/// Convex unions of the triangles of a planar mesh without inner vertices, such that no two neighbours make a convex one, as
/// corners. O(n log n).
std::vector<std::vector<VertexId>> merge_to_convex(const Triangulation& mesh);

}  // namespace quadloom::strips
