// The boundary of the triangles is walked from corner to corner around the triangles at each: so a
// vertex where the ring touches itself is one corner for each of the angles that the inside has there.
#include "strips/polygon_disc.hpp"

#include <algorithm>

namespace quadloom::strips {
namespace {

//       i        The triangles at corner i, from the side that leaves it to the side that arrives; the
//   ^  /|\  |    latter is the side of corner i - 1.
//   | / | \ v
HalfedgeId side_before(const Triangulation& mesh, HalfedgeId side) {
  HalfedgeId arriving = previous_halfedge(side);
  while (mesh.twin[arriving] != kNone) arriving = previous_halfedge(mesh.twin[arriving]);
  return arriving;
}

HalfedgeId first_side(const Triangulation& mesh) {
  HalfedgeId first = kNone;
  for (HalfedgeId h = 0; h < mesh.twin.size(); ++h) {
    if (mesh.twin[h] == kNone && (first == kNone || mesh.origin(h) < mesh.origin(first))) first = h;
  }
  return first;
}

/// The sides of one circle of corners, counter-clockwise.
std::vector<HalfedgeId> walk_around(const Triangulation& mesh) {
  const HalfedgeId first = first_side(mesh);
  std::vector<HalfedgeId> sides;
  HalfedgeId side = first;
  do {
    sides.push_back(side);
    side = side_before(mesh, side);
  } while (side != first);
  std::reverse(sides.begin() + 1, sides.end());
  return sides;
}

void name_corners(PolygonDisc& disc) {
  disc.position_of.assign(disc.mesh.tri_vertex.size(), kNone);
  for (Position i = 0; i < disc.side.size(); ++i) {
    disc.vertex.push_back(disc.mesh.origin(disc.side[i]));
    for (HalfedgeId h = disc.side[i]; h != kNone; h = disc.mesh.twin[previous_halfedge(h)]) {
      disc.position_of[h] = i;
    }
  }
}

}  // namespace

/// All sides are in one circle, so that there is one piece, without holes.
bool is_disc(const Triangulation& mesh) {
  const auto sides = std::count(mesh.twin.begin(), mesh.twin.end(), kNone);
  return walk_around(mesh).size() == static_cast<std::size_t>(sides);
}

PolygonDisc disc_of(ConstrainedResult triangulation) {
  PolygonDisc disc;
  disc.mesh = std::move(triangulation.mesh);
  disc.input_to_vertex = std::move(triangulation.input_to_vertex);
  disc.side = walk_around(disc.mesh);
  name_corners(disc);
  return disc;
}

PolygonDisc polygon_disc(const Polygon& polygon) {
  ConstrainedResult triangulation = constrained_delaunay(polygon);
  if (!is_disc(triangulation.mesh)) {
    throw Error(
        ErrorCode::kBadPolygon,
        polygon.rings.size() > 1
            ? "the polygon has holes: whether it has triangles one beside the other is an "
              "NP-complete question, which is not answered here"
            : "the inside of the polygon is in parts, or goes around a place where the ring "
              "touches itself; only polygons in one piece without holes are looked at");
  }
  return disc_of(std::move(triangulation));
}

}  // namespace quadloom::strips
