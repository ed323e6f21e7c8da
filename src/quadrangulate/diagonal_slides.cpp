// Diagonal slides (Nakamoto 1996): the elementary move between quadrangulations of the same points,
// here as a hill climb on shape. Each accepted slide raises the sum of the shapes, so it ends; a
// quad is looked at again when a neighbour changed. Near-linear in practice.
#include "quadrangulate/diagonal_slides.hpp"

#include <algorithm>

#include "kernel/squareness.hpp"

namespace quadloom::quadrangulate {
namespace {

constexpr double kNotAQuad = -1000;
constexpr double kBestSum = 1.99;  // two squares cannot be bettered

// A non-convex quad is worse than the worst convex one, so that a slide that mends one is always a
// gain.
double worth(Point a, Point b, Point c, Point d) {
  switch (classify_quad(a, b, c, d)) {
    case QuadKind::kStrictlyConvex:
      return kernel::squareness(a, b, c, d);
    case QuadKind::kFlatCorner:
      return -2;
    case QuadKind::kNonConvex:
      return -3;
    case QuadKind::kNotSimple:
      break;
  }
  return kNotAQuad;
}

constexpr double kLeastGain = 1e-9;  // ends the climb despite rounding in the sums

struct Hexagon {
  std::array<VertexId, 6> corner;   // b, c, d, a, x, y: the edge shared now is corner 0 to corner 3
  std::array<HalfedgeId, 6> inner;  // of the side from corner k to k + 1
  std::array<TriangleId, 4> slot;
  bool simple = true;  // no corner twice
};

Hexagon hexagon_at(const PairedMesh& mesh, HalfedgeId edge) {
  const QuadBehind above = quad_behind(mesh, edge);
  const QuadBehind below = quad_behind(mesh, mesh.tri.twin[edge]);
  Hexagon hexagon;
  std::copy(above.side.begin(), above.side.end(), hexagon.inner.begin());
  std::copy(below.side.begin(), below.side.end(), hexagon.inner.begin() + 3);
  for (std::size_t k = 0; k < 6; ++k) hexagon.corner[k] = mesh.tri.origin(hexagon.inner[k]);
  hexagon.slot = {above.near, above.far, below.near, below.far};
  for (const std::size_t i : {1U, 2U}) {
    for (const std::size_t j : {4U, 5U}) {
      if (hexagon.corner[i] == hexagon.corner[j]) hexagon.simple = false;
    }
  }
  return hexagon;
}

/// The quad corner[first .. first + 3] into two triangle slots; its fourth side, inside the
/// hexagon, is returned.
HalfedgeId set_quad(PairedMesh& mesh, const Hexagon& hexagon,
                    const std::array<HalfedgeId, 6>& outer, std::size_t first, TriangleId t,
                    TriangleId u) {
  const auto at = [&](std::size_t k) { return (first + k) % 6; };
  const auto v = [&](std::size_t k) { return hexagon.corner[at(k)]; };
  HalfedgeId fourth = kNone;
  if (split_by_first_diagonal(mesh.point(v(0)), mesh.point(v(1)), mesh.point(v(2)),
                              mesh.point(v(3)))) {
    mesh.set_triangle(t, v(0), v(1), v(2));
    mesh.set_triangle(u, v(2), v(3), v(0));
    mesh.link(3 * t, outer[at(0)]);
    mesh.link(3 * t + 1, outer[at(1)]);
    mesh.link(3 * u, outer[at(2)]);
    fourth = 3 * u + 1;
  } else {
    mesh.set_triangle(t, v(1), v(2), v(3));
    mesh.set_triangle(u, v(3), v(0), v(1));
    mesh.link(3 * t, outer[at(1)]);
    mesh.link(3 * t + 1, outer[at(2)]);
    mesh.link(3 * u + 1, outer[at(0)]);
    fourth = 3 * u;
  }
  mesh.link(3 * t + 2, 3 * u + 2);
  mesh.pair(3 * t + 2);
  return fourth;
}

/// Parts the hexagon between corner first and first + 3.
void part_hexagon(PairedMesh& mesh, const Hexagon& hexagon, std::size_t first) {
  std::array<HalfedgeId, 6> outer;
  for (std::size_t k = 0; k < 6; ++k) outer[k] = mesh.tri.twin[hexagon.inner[k]];
  const auto [t, u, v, w] = hexagon.slot;
  mesh.link(set_quad(mesh, hexagon, outer, first, t, u),
            set_quad(mesh, hexagon, outer, first + 3, v, w));
}

/// The best of the two other partings, if it is a gain: 1 or 2, else 0.
std::size_t best_parting(const PairedMesh& mesh, const Hexagon& hexagon) {
  std::array<Point, 6> p;
  for (std::size_t k = 0; k < 6; ++k) p[k] = mesh.point(hexagon.corner[k]);
  const auto worth_of = [&](std::size_t first) {
    const auto at = [&](std::size_t k) { return p[(first + k) % 6]; };
    const double one = worth(at(0), at(1), at(2), at(3));
    return one == kNotAQuad ? one : one + worth(at(3), at(4), at(5), at(0));
  };
  double best = worth_of(0) + kLeastGain;
  if (best > kBestSum) return 0;
  std::size_t parting = 0;
  for (const std::size_t first : {1U, 2U}) {
    if (const double sum = worth_of(first); sum > best) {
      best = sum;
      parting = first;
    }
  }
  return parting;
}

}  // namespace

std::size_t slide_diagonals(PairedMesh& mesh) {
  std::vector<TriangleId> todo;
  std::vector<bool> waiting(mesh.mate.size(), true);
  for (TriangleId t = static_cast<TriangleId>(mesh.mate.size()); t-- > 0;) todo.push_back(t);
  std::size_t slides = 0;
  while (!todo.empty()) {
    const TriangleId t = todo.back();
    todo.pop_back();
    waiting[t] = false;
    for (HalfedgeId edge = 3 * t; edge < 3 * t + 3; ++edge) {
      const HalfedgeId twin = mesh.tri.twin[edge];
      if (mesh.is_free(t) || edge == mesh.mate[t] || twin == kNone) continue;
      // If the neighbour waits too, the edge is looked at from there, when it is its turn.
      if (waiting[triangle_of(twin)] || mesh.is_free(triangle_of(twin))) continue;
      const Hexagon hexagon = hexagon_at(mesh, edge);
      if (!hexagon.simple) continue;
      const std::size_t parting = best_parting(mesh, hexagon);
      if (parting == 0) continue;
      part_hexagon(mesh, hexagon, parting);
      ++slides;
      for (const TriangleId touched : hexagon.slot) {
        if (!waiting[touched]) todo.push_back(touched);
        waiting[touched] = true;
      }
    }
  }
  return slides;
}

}  // namespace quadloom::quadrangulate
