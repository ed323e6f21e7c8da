// Places of a Hamiltonian refinement: floating point suggests, exact predicates decide.
#include "strips/refinement_places.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "convex/open_region.hpp"
#include "kernel/point_on_segment.hpp"
#include "kernel/predicates_inline.hpp"
#include "quadrangulate/inner_place.hpp"
#include "quadrangulate/subdivision_places.hpp"

namespace quadloom::strips {
namespace {

using kernel::Chart;
using kernel::Places;
using kernel::Vector3;

bool turns_left(Point a, Point b, Point c) { return kernel::orient(a, b, c) > 0; }

Vector3 scaled(Vector3 v, double by) { return {v.x * by, v.y * by, v.z * by}; }
bool is_finite(Vector3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

double length(Vector3 v) {
  const double most = std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
  if (!(most > 0 && std::isfinite(most))) return most;
  const Vector3 unit = {v.x / most, v.y / most, v.z / most};
  return most * std::sqrt(kernel::dot(unit, unit));
}

/// The mean of the corners, each weighed with the length of the side across from it.
Vector3 incentre(Vector3 a, Vector3 b, Vector3 c) {
  const double at_a = length(c - b), at_b = length(a - c), at_c = length(b - a);
  const double most = std::max({at_a, at_b, at_c});
  const double sum = at_a / most + at_b / most + at_c / most;
  return a + (scaled(b - a, at_b / most / sum) + scaled(c - a, at_c / most / sum));
}

bool fits_inside(const Chart& chart, const std::array<Point, 3>& seen, Vector3 place) {
  if (!is_finite(place)) return false;
  const Point p = chart(place);
  return turns_left(seen[0], seen[1], p) && turns_left(seen[1], seen[2], p) &&
         turns_left(seen[2], seen[0], p);
}

std::optional<Vector3> searched(const Places& places, const Chart& chart,
                                const std::array<VertexId, 3>& v,
                                const std::array<Point, 3>& seen) {
  if (const auto found = quadrangulate::place_in_face(places, v[0], v[1], v[2])) return found;
  convex::OpenRegion region(seen);
  for (std::size_t i = 0; i < 3; ++i) region.add(seen[i], seen[(i + 1) % 3]);
  const auto found = region.place(convex::Effort::kExact);
  if (!found) return std::nullopt;
  if (places.planar()) return Vector3{found->x, found->y, 0};
  return chart.lift(*found, {places.at(v[0]), places.at(v[1]), places.at(v[2])});
}

/// The chart of the two triangles at h together.
Chart chart_of_two(const Triangulation& mesh, const Places& places, HalfedgeId h) {
  if (places.planar()) return {};
  const HalfedgeId g = mesh.twin[h];
  return Chart(places.area(mesh.origin(h), mesh.target(h), mesh.apex(h)) +
               places.area(mesh.origin(g), mesh.target(g), mesh.apex(g)));
}

bool splits(const Kite& k, Point m) {
  return turns_left(k.a, m, k.c) && turns_left(m, k.b, k.c) && turns_left(k.b, m, k.d) &&
         turns_left(m, k.a, k.d);
}

/// In the plane alone: on the edge if a double is, else anywhere in the kite.
std::optional<Point> searched(const Kite& k) {
  if (const auto on_it = kernel::point_on_segment(k.a, k.b); on_it && splits(k, *on_it)) {
    return on_it;
  }
  const std::array<Point, 4> around = {k.a, k.d, k.b, k.c};
  convex::OpenRegion region(around);
  for (std::size_t i = 0; i < 4; ++i) region.add(around[i], around[(i + 1) % 4]);
  return region.place(convex::Effort::kExact);
}

}  // namespace

InnerPlace inner_place(const Triangulation& mesh, const Places& places, TriangleId t) {
  const std::array<VertexId, 3> v = {mesh.tri_vertex[3 * t], mesh.tri_vertex[3 * t + 1],
                                     mesh.tri_vertex[3 * t + 2]};
  const Chart chart = places.chart(v[0], v[1], v[2]);
  const std::array<Point, 3> seen = {places.seen(chart, v[0]), places.seen(chart, v[1]),
                                     places.seen(chart, v[2])};
  const Vector3 centre = incentre(places.at(v[0]), places.at(v[1]), places.at(v[2]));
  if (fits_inside(chart, seen, centre)) return {centre, true};
  const auto found = searched(places, chart, v, seen);
  if (found && fits_inside(chart, seen, *found)) return {*found, false};
  throw Error(ErrorCode::kGuarantee,
              "there is no place for a Steiner point in triangle " + std::to_string(t), {t});
}

Kite kite(const Triangulation& mesh, const Places& places, HalfedgeId h, const Vector3& c,
          const Vector3& d) {
  const Chart chart = chart_of_two(mesh, places, h);
  return {places.seen(chart, mesh.origin(h)), places.seen(chart, mesh.target(h)), chart(c),
          chart(d)};
}

bool can_flip(const Kite& k) {
  return turns_left(k.a, k.b, k.c) && turns_left(k.b, k.a, k.d) && turns_left(k.a, k.d, k.c) &&
         turns_left(k.b, k.c, k.d);
}

std::optional<Vector3> middle_place(const Triangulation& mesh, const Places& places, HalfedgeId h,
                                    const Vector3& c, const Vector3& d) {
  const Vector3 a = places.at(mesh.origin(h)), b = places.at(mesh.target(h));
  const auto half = [](double p, double q) {
    return quadrangulate::along_edge({p, 0}, {q, 0}, 4).x;
  };
  const Vector3 middle = {half(a.x, b.x), half(a.y, b.y), half(a.z, b.z)};
  const Kite in_plane = kite(mesh, places, h, c, d);
  if (places.planar()) {
    const Point m = {middle.x, middle.y};
    const auto found = splits(in_plane, m) ? std::optional(m) : searched(in_plane);
    if (!found) return std::nullopt;
    return Vector3{found->x, found->y, 0};
  }
  // On a surface each side is judged in its own triangle's chart.
  const auto side_holds = [&](HalfedgeId side, const Vector3& inner) {
    const Chart chart = places.chart(mesh.origin(side), mesh.target(side), mesh.apex(side));
    const Point m = chart(middle), p = places.seen(chart, mesh.origin(side)),
                q = places.seen(chart, mesh.target(side)), i = chart(inner);
    return turns_left(p, m, i) && turns_left(m, q, i);
  };
  if (!side_holds(h, c) || !side_holds(mesh.twin[h], d)) return std::nullopt;
  return middle;
}

double sharpness(const Vector3& a, const Vector3& b, const Vector3& c) {
  const Vector3 u = b - a, v = c - b, w = a - c;
  const Vector3 plain = kernel::cross(u, v);
  const double square = kernel::dot(plain, plain);
  if (square > 1e-200 && square < 1e200) {  // far from underflow and overflow
    return std::max({-kernel::dot(w, u), -kernel::dot(u, v), -kernel::dot(v, w)}) /
           std::sqrt(square);
  }
  const double most = std::max({length(u), length(v), length(w)});
  const Vector3 s = scaled(u, 1 / most), t = scaled(v, 1 / most), r = scaled(w, 1 / most);
  const double area = length(kernel::cross(s, t));
  const double dot = std::max({-kernel::dot(r, s), -kernel::dot(s, t), -kernel::dot(t, r)});
  const double found = dot / area;
  return std::isfinite(found) ? found : std::numeric_limits<double>::infinity();
}

}  // namespace quadloom::strips
