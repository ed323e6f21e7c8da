// Diagonal slides (Nakamoto 1996): the elementary move between quadrangulations of the same points,
// here as a hill climb on shape. Each accepted slide raises the sum of the shapes, so it ends.
//
// Steps:
//   1. find_poor   the quads with a poor shape; slides between two others hardly ever gain
//   2. try_edges   of each of them, and of the quads of each slide, until none is left
//
// Shapes are those of squareness.hpp; a quad that is not strictly convex, exactly, is worse than the
// worst one that is, so that a slide that mends one is always a gain. Each is computed once, kept by
// triangle. Near-linear in practice.
#include "quadrangulate/diagonal_slides.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "kernel/squareness.hpp"

namespace quadloom::quadrangulate {
namespace {

constexpr float kNotAQuad = -1000;
constexpr float kUnknown = -2000;
constexpr float kPoor =
    0.2F;  // below it are 97% of the slides that gain, and a quarter of the quads
constexpr float kEnough = 0.7F;      // sums of two shapes that seldom gain
constexpr float kLeastGain = 1e-5F;  // ends the climb despite rounding in the sums

float worth(Point a, Point b, Point c, Point d) {
  const kernel::QuadEdges edges(a, b, c, d);
  if (edges.proven_convex()) {
    const double worst = edges.worst_squared_cosine();
    return worst < 1 ? 1 - std::sqrt(static_cast<float>(worst)) : 0;
  }
  switch (classify_quad(a, b, c, d)) {
    case QuadKind::kStrictlyConvex:
      return static_cast<float>(kernel::squareness(a, b, c, d));
    case QuadKind::kFlatCorner:
      return -2;
    case QuadKind::kNonConvex:
      return -3;
    case QuadKind::kNotSimple:
      break;
  }
  return kNotAQuad;
}

/// At least what the shapes of either of the other partings sum up to, judged by the corners 0 and 3, at which no
/// diagonal would end; negative if one of them is not convex.
float most_elsewhere(const std::array<Point, 6>& p) {
  using kernel::Pair;
  const Pair x = {p[0].x, p[3].x}, y = {p[0].y, p[3].y};
  const Pair ux = Pair{p[1].x, p[4].x} - x, uy = Pair{p[1].y, p[4].y} - y;
  const Pair vx = Pair{p[5].x, p[2].x} - x, vy = Pair{p[5].y, p[2].y} - y;
  if (kernel::proven_difference(ux * vy, uy * vx).negative != 0) return -1;
  const Pair dot = ux * vx + uy * vy;
  const Pair cosine = dot * dot / ((ux * ux + uy * uy) * (vx * vx + vy * vy));
  return 2 - std::sqrt(static_cast<float>(cosine[0])) - std::sqrt(static_cast<float>(cosine[1]));
}

/// The quad corner[first .. first + 3] into two triangle slots; its fourth side, inside the
/// hexagon, is returned.
HalfedgeId set_quad(PairedMesh& mesh, QuadPair& hexagon, const std::array<HalfedgeId, 6>& outer,
                    std::size_t first, TriangleId t, TriangleId u) {
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
    hexagon.inner[at(0)] = 3 * t;
    hexagon.inner[at(1)] = 3 * t + 1;
    hexagon.inner[at(2)] = 3 * u;
    fourth = 3 * u + 1;
  } else {
    mesh.set_triangle(t, v(1), v(2), v(3));
    mesh.set_triangle(u, v(3), v(0), v(1));
    mesh.link(3 * t, outer[at(1)]);
    mesh.link(3 * t + 1, outer[at(2)]);
    mesh.link(3 * u + 1, outer[at(0)]);
    hexagon.inner[at(0)] = 3 * u + 1;
    hexagon.inner[at(1)] = 3 * t;
    hexagon.inner[at(2)] = 3 * t + 1;
    fourth = 3 * u;
  }
  mesh.link(3 * t + 2, 3 * u + 2);
  mesh.pair(3 * t + 2);
  return fourth;
}

class Slider {
 public:
  explicit Slider(PairedMesh& mesh)
      : mesh_(mesh), worth_(mesh.mate.size(), kUnknown), waiting_(mesh.mate.size(), 0) {}

  /// Looks at the triangle's quad, which goes to the list if it is poor.
  void find_poor(TriangleId t) {
    if (!mesh_.is_free(t) && worth_of(t) < kPoor) wait(t);
  }
  std::size_t run() {
    while (!todo_.empty()) {
      const TriangleId t = todo_.back();
      todo_.pop_back();
      waiting_[t] = 0;
      try_edges(t);
    }
    return slides_;
  }
  const std::vector<TriangleId>& touched() const { return touched_; }

 private:
  float worth_of(TriangleId t) {
    if (worth_[t] != kUnknown) return worth_[t];
    const HalfedgeId h = mesh_.mate[t], twin = mesh_.tri.twin[h];
    const auto& tri = mesh_.tri;
    const float now = worth(mesh_.point(tri.origin(h)), mesh_.point(tri.apex(twin)),
                            mesh_.point(tri.target(h)), mesh_.point(tri.apex(h)));
    worth_[t] = worth_[triangle_of(twin)] = now;
    return now;
  }
  void wait(TriangleId t) {
    if (waiting_[t] != 0) return;
    waiting_[t] = 1;
    todo_.push_back(t);
  }

  /// The edges of t between its quad and others.
  void try_edges(TriangleId t) {
    for (HalfedgeId edge = 3 * t; edge < 3 * t + 3; ++edge) {
      const HalfedgeId twin = mesh_.tri.twin[edge];
      if (mesh_.is_free(t) || edge == mesh_.mate[t] || twin == kNone) continue;
      const TriangleId other = triangle_of(twin);
      // If the neighbour waits too, the edge is looked at from there, when it is its turn.
      if (waiting_[other] != 0 || mesh_.is_free(other)) continue;
      const float mine = worth_of(t), theirs = worth_of(other);
      if (std::min(mine, theirs) >= kPoor || mine + theirs >= kEnough) continue;
      slide_if_better(edge, mine + theirs);
    }
  }

  void slide_if_better(HalfedgeId edge, float now) {
    QuadPair hexagon = quad_pair_at(mesh_, edge);
    if (!hexagon.simple) return;
    std::array<Point, 6> p;
    for (std::size_t k = 0; k < 6; ++k) p[k] = mesh_.point(hexagon.corner[k]);
    float best = now + kLeastGain;
    if (most_elsewhere(p) <= best) return;
    std::size_t parting = 0;
    for (const std::size_t first : {1U, 2U}) {
      const auto at = [&](std::size_t k) { return p[(first + k) % 6]; };
      const float one = worth(at(0), at(1), at(2), at(3));
      if (one + 1 <= best) continue;
      const float sum = one + worth(at(3), at(4), at(5), at(0));
      if (sum <= best) continue;
      best = sum;
      parting = first;
    }
    if (parting == 0) return;
    part_anew(mesh_, hexagon, parting);
    ++slides_;
    touched_.insert(touched_.end(), hexagon.slot.begin(), hexagon.slot.end());
    for (const TriangleId touched : hexagon.slot) worth_[touched] = kUnknown;
    for (const TriangleId touched : hexagon.slot) wait(touched);
  }

  PairedMesh& mesh_;
  std::vector<float> worth_;  // of the triangle's quad
  std::vector<char> waiting_;
  std::vector<TriangleId> todo_;
  std::vector<TriangleId> touched_;  // by slides
  std::size_t slides_ = 0;
};

}  // namespace

QuadPair quad_pair_at(const PairedMesh& mesh, HalfedgeId edge) {
  const QuadBehind above = quad_behind(mesh, edge);
  const QuadBehind below = quad_behind(mesh, mesh.tri.twin[edge]);
  QuadPair pair;
  std::copy(above.side.begin(), above.side.end(), pair.inner.begin());
  std::copy(below.side.begin(), below.side.end(), pair.inner.begin() + 3);
  for (std::size_t k = 0; k < 6; ++k) pair.corner[k] = mesh.tri.origin(pair.inner[k]);
  pair.slot = {above.near, above.far, below.near, below.far};
  for (const std::size_t i : {1U, 2U}) {
    for (const std::size_t j : {4U, 5U}) {
      if (pair.corner[i] == pair.corner[j]) pair.simple = false;
    }
  }
  return pair;
}

void part_anew(PairedMesh& mesh, QuadPair& hexagon, std::size_t first) {
  std::array<HalfedgeId, 6> outer;
  for (std::size_t k = 0; k < 6; ++k) outer[k] = mesh.tri.twin[hexagon.inner[k]];
  const auto [t, u, v, w] = hexagon.slot;
  mesh.link(set_quad(mesh, hexagon, outer, first, t, u),
            set_quad(mesh, hexagon, outer, first + 3, v, w));
}

std::size_t slide_diagonals(PairedMesh& mesh) {
  Slider slider(mesh);
  for (auto t = static_cast<TriangleId>(mesh.mate.size()); t-- > 0;) slider.find_poor(t);
  return slider.run();
}

std::size_t slide_diagonals_at(PairedMesh& mesh, std::vector<TriangleId>& triangles) {
  Slider slider(mesh);
  for (const TriangleId t : triangles) slider.find_poor(t);
  const std::size_t slides = slider.run();
  triangles.insert(triangles.end(), slider.touched().begin(), slider.touched().end());
  return slides;
}

}  // namespace quadloom::quadrangulate
