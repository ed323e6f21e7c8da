#include "certify/space.hpp"

#include <vector>

#include "certify/polygon.hpp"
#include "quadloom/kernel.hpp"

namespace quadloom::certify {
namespace {

bool same_place(kernel::Vector3 a, kernel::Vector3 b) {
  return a.x == b.x && a.y == b.y && a.z == b.z;
}

bool collinear(kernel::Vector3 a, kernel::Vector3 b, kernel::Vector3 c) {
  return orient2d({a.x, a.y}, {b.x, b.y}, {c.x, c.y}) == 0 &&
         orient2d({a.y, a.z}, {b.y, b.z}, {c.y, c.z}) == 0 &&
         orient2d({a.z, a.x}, {b.z, b.x}, {c.z, c.x}) == 0;
}

}  // namespace

kernel::Vector3 area_of(const kernel::Places& places, std::span<const VertexId> face) {
  kernel::Vector3 area;
  for (std::size_t i = 2; i < face.size(); ++i) {
    area = area + places.area(face[0], face[i - 1], face[i]);
  }
  return area;
}

bool on_a_line(const kernel::Places& places, std::span<const VertexId> face) {
  const kernel::Vector3 a = places.at(face[0]);
  std::size_t i = 1;
  while (i < face.size() && same_place(places.at(face[i]), a)) ++i;
  if (i == face.size()) return true;
  const kernel::Vector3 b = places.at(face[i]);
  while (++i < face.size()) {
    if (!collinear(a, b, places.at(face[i]))) return false;
  }
  return true;
}

int smallest_turn_in_chart(const kernel::Places& places, std::span<const VertexId> face) {
  const kernel::Chart chart(area_of(places, face));
  std::vector<Point> seen;
  seen.reserve(face.size());
  for (const VertexId v : face) seen.push_back(places.seen(chart, v));
  const PolygonVerdict verdict = judge_polygon(seen);
  return verdict.simple ? verdict.smallest_turn : -1;
}

}  // namespace quadloom::certify
