// The serpentine triangulation of a convex spiral, as a path of triangles.
#pragma once

#include <span>
#include <vector>

#include "quadloom/kernel.hpp"

namespace quadloom::quadrangulate {

/// Which end of a diagonal the new corner of a triangle replaces in the next diagonal.
enum class Replaced { kOuter, kInner };

/// Triangle t of the path has the corners outer(t), inner(t), apex(t), counter-clockwise. It is
/// entered through the edge outer -> inner (the first one is the hull edge from the spiral's start
/// to its clockwise last hull point) and left through the edge where the apex takes the place of
/// one of the two. Its third edge is an edge of the spiral.
struct Serpentine {
  std::vector<VertexId> spiral;
  std::size_t hull_points = 0;
  std::vector<VertexId> corner;  // 3 a triangle

  std::size_t size() const { return corner.size() / 3; }
  VertexId outer(std::size_t t) const { return corner[3 * t]; }
  VertexId inner(std::size_t t) const { return corner[3 * t + 1]; }
  VertexId apex(std::size_t t) const { return corner[3 * t + 2]; }
  /// Of all but the last triangle.
  Replaced replaced(std::size_t t) const {
    return outer(t + 1) == outer(t) ? Replaced::kInner : Replaced::kOuter;
  }
};

/// For at least three distinct points that are not all collinear; `start` is a corner of the hull
/// (kNone: the lexicographically smallest point). 2n - 2 - h triangles, all strictly
/// counter-clockwise. O(n).
Serpentine make_serpentine(std::span<const Point> points, const ConvexLayers& layers,
                           VertexId start = kNone);

/// The path as a triangulation, triangles in the order of the path.
Triangulation to_triangulation(std::span<const Point> points, const Serpentine& path);

}  // namespace quadloom::quadrangulate
