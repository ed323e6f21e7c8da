// The inside of a polygon without holes, and its corners in one circle.
#pragma once

#include <cstdint>
#include <vector>

#include "quadloom/kernel.hpp"

namespace quadloom::strips {

/// A place in the circle of a polygon's corners. Where the ring touches itself a vertex has several.
using Position = std::uint32_t;

/// A triangulated polygon whose inside is a disc. Position i is a corner of the inside, i + 1 (modulo the
/// size) the next one counter-clockwise; positions do not wrap by themselves. Where corners lie on edges
/// of the ring, those are cut there.
struct PolygonDisc {
  Triangulation mesh;
  std::vector<VertexId> input_to_vertex;
  std::vector<VertexId> vertex;  ///< per position
  std::vector<HalfedgeId> side;  ///< per position: the halfedge on the boundary to the next one
  std::vector<Position> position_of;  ///< per halfedge: of the corner that it starts at

  Position size() const { return static_cast<Position>(vertex.size()); }
  Position next(Position i) const { return i + 1 == size() ? 0 : i + 1; }
  Position previous(Position i) const { return i == 0 ? size() - 1 : i - 1; }
  /// How many sides are between i and j, counter-clockwise from i.
  Position length(Position i, Position j) const { return j >= i ? j - i : j + size() - i; }
  Point at(Position i) const { return mesh.points[vertex[i]]; }
  /// The inside has more than half a turn at i. Exact.
  bool reflex(Position i) const { return orient2d(at(previous(i)), at(i), at(next(i))) < 0; }
};

/// Whether the triangles are one piece without holes. Linear.
bool is_disc(const Triangulation& mesh);

/// Those of a polygon of which is_disc is true. Linear.
PolygonDisc disc_of(ConstrainedResult triangulation);

/// The constrained Delaunay triangulation of the polygon as a disc. Throws Error kBadPolygon if the
/// inside is none (holes, or parts that touch only at corners), and as constrained_delaunay. As that, and
/// linear.
PolygonDisc polygon_disc(const Polygon& polygon);

}  // namespace quadloom::strips
