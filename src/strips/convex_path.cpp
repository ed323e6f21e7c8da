// A convex polygon is peeled from one of its sides: what is left has the corners i .. j, and either j or
// i goes next.
//
//        j - 1 .----. i + 1         The triangle i, j - 1, j (or i, i + 1, j) must not be flat, and what
//             /      \              is left beyond it must not be a line, if it is more than a side.
//          j .-------. i
//
// Such a step exists from every chord: if what is left without j is on one line and what is left without
// i, too, all of it is. From a side of the polygon both steps fail if and only if both of its ends are
// flat. Of two steps the one with the shorter new chord is taken (in floating point, which decides
// nothing else): the triangles are those of a zigzag, not of a fan.
#include "strips/convex_path.hpp"

#include <cmath>

namespace quadloom::strips {
namespace {

double length_of(Point p, Point q) { return std::hypot(q.x / 2 - p.x / 2, q.y / 2 - p.y / 2); }

}  // namespace

std::optional<std::vector<std::uint32_t>> path_from_last_side(std::span<const Point> convex) {
  std::vector<std::uint32_t> corners;
  std::uint32_t i = 0, j = static_cast<std::uint32_t>(convex.size() - 1);
  const auto turns = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    return orient2d(convex[a], convex[b], convex[c]) > 0;
  };
  while (j - i >= 2) {
    const bool last = j - i == 2;
    const bool end_goes = turns(i, j - 1, j) && (last || turns(i, i + 1, j - 1));
    const bool start_goes = turns(i, i + 1, j) && (last || turns(i + 1, j - 1, j));
    if (!end_goes && !start_goes) return std::nullopt;
    const bool end = end_goes && (!start_goes || length_of(convex[i], convex[j - 1]) <=
                                                     length_of(convex[i + 1], convex[j]));
    corners.insert(corners.end(), {i, end ? j - 1 : i + 1, j});
    if (end) {
      --j;
    } else {
      ++i;
    }
  }
  return corners;
}

std::vector<Position> convex_path(const PolygonDisc& disc) {
  Position last = 0;  // a corner that is not flat
  while (orient2d(disc.at(disc.previous(last)), disc.at(last), disc.at(disc.next(last))) == 0) {
    ++last;
  }
  std::vector<Position> around;
  for (Position i = disc.next(last); i != last; i = disc.next(i)) around.push_back(i);
  around.push_back(last);
  std::vector<Point> points;
  for (const Position i : around) points.push_back(disc.at(i));
  std::vector<Position> corners;
  const auto path = path_from_last_side(points);
  if (path) {  // there is one: the last corner is not flat
    for (const std::uint32_t i : *path) corners.push_back(around[i]);
  }
  return corners;
}

}  // namespace quadloom::strips
