#include "certify/space.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
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

/// b - a, scaled so that its largest component is about 1.
kernel::Vector3 direction(kernel::Vector3 a, kernel::Vector3 b) {
  kernel::Vector3 d = b - a;
  if (!std::isfinite(d.x) || !std::isfinite(d.y) || !std::isfinite(d.z)) {
    d = {b.x / 2 - a.x / 2, b.y / 2 - a.y / 2, b.z / 2 - a.z / 2};
  }
  const double size = std::max({std::fabs(d.x), std::fabs(d.y), std::fabs(d.z)});
  if (size == 0) return d;
  const int exponent = std::ilogb(size);
  return {std::scalbn(d.x, -exponent), std::scalbn(d.y, -exponent), std::scalbn(d.z, -exponent)};
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

double angle_in_space(kernel::Vector3 a, kernel::Vector3 b, kernel::Vector3 c) {
  const kernel::Vector3 u = direction(b, a), v = direction(b, c), w = kernel::cross(u, v);
  return std::atan2(std::hypot(w.x, w.y, w.z), kernel::dot(u, v)) * (180 / std::numbers::pi);
}

}  // namespace quadloom::certify
