// Diagonal slides (Nakamoto 1996): the elementary move between quadrangulations of the same points,
// here as a hill climb on shape. Each accepted slide raises the sum of the shapes, so it ends.
//
// Steps:
//   1. find_poor   the quads with a poor shape; slides between two others hardly ever gain
//   2. try_edges   of each of them, and of the quads of each slide, until none is left
//
// Large meshes: within ranges of the faces, on several threads, then from the poor quads at their borders on.
//
// Shapes are those of squareness.hpp; a quad that is not strictly convex, exactly, is worse than the
// worst one that is, so that a slide that mends one is always a gain. Each is computed once, kept by
// face. Near-linear in practice.
#include "quadrangulate/diagonal_slides.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <vector>

#include "core/parallel.hpp"
#include "kernel/squareness.hpp"

namespace quadloom::quadrangulate {
namespace {

constexpr float kNotAQuad = -1000;
constexpr float kUnknown = -2000;
constexpr float kPoor =
    0.2F;  // below it are 97% of the slides that gain, and a quarter of the quads
constexpr float kEnough = 0.7F;      // sums of two shapes that seldom gain
constexpr float kLeastGain = 1e-5F;  // ends the climb despite rounding in the sums

[[gnu::noinline]] float worth_exactly(Point a, Point b, Point c, Point d) {
  switch (classify_quad_exactly(a, b, c, d)) {
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

inline float worth(Point a, Point b, Point c, Point d) {
  const kernel::QuadEdges edges(a, b, c, d);
  if (!edges.proven_convex()) return worth_exactly(a, b, c, d);
  const double worst = edges.worst_squared_cosine();
  return worst < 1 ? 1 - std::sqrt(static_cast<float>(worst)) : 0;
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
HalfedgeId set_quad(PairedMesh& mesh, QuadPair<PairedMesh>& hexagon,
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

template <class Mesh>
class Slider {
 public:
  explicit Slider(Mesh& mesh, const FaceRange& range = {})
      : mesh_(mesh),
        range_(range),
        worth_(range.size(mesh.face_count()), kUnknown),
        waiting_(worth_.size(), 0) {}

  /// Looks at the face's quad, which goes to the list if it is poor.
  void find_poor(std::uint32_t face) {
    if (mesh_.is_quad(face) && worth_of(face) < kPoor) wait(face);
  }
  std::size_t run() {
    while (!todo_.empty()) {
      const std::uint32_t face = todo_.back();
      todo_.pop_back();
      waiting_[face - range_.begin] = 0;
      // Slides of a face that may be changed bring it neighbours of neighbours at most, in the range as well.
      met_border_ = !mesh_.may_change(face, range_);
      if (!met_border_) {
        for (const HalfedgeId edge : mesh_.sides_of_quad(face)) try_edge(edge);
      }
      if (met_border_) at_border_.push_back(face);
    }
    return slides_;
  }
  const std::vector<std::uint32_t>& touched() const { return touched_; }
  /// Faces at the border of the range, of which not all edges were looked at; some of them more than once.
  const std::vector<std::uint32_t>& at_border() const { return at_border_; }

 private:
  float worth_of(std::uint32_t face) {
    if (worth_[face - range_.begin] != kUnknown) return worth_[face - range_.begin];
    const std::array<VertexId, 4> corner = mesh_.corners_of_quad(face);
    const auto at = [&](std::size_t i) { return mesh_.point(corner[i]); };
    const float now = worth(at(0), at(1), at(2), at(3));
    for (const std::uint32_t slot : mesh_.slots_of_quad(face)) worth_[slot - range_.begin] = now;
    return now;
  }
  void wait(std::uint32_t face) {
    if (waiting_[face - range_.begin] != 0) return;
    waiting_[face - range_.begin] = 1;
    todo_.push_back(face);
  }

  /// Slides the edge if it lies between two quads and that is better. Where a slide before has made it the inner
  /// edge of a quad, or another edge, that edge is looked at now or later as well.
  void try_edge(HalfedgeId edge) {
    const HalfedgeId twin = mesh_.twin(edge);
    if (twin == kNone) return;
    const std::uint32_t face = Mesh::face_of(edge), other = Mesh::face_of(twin);
    // If the neighbour waits too, the edge is looked at from there, when it is its turn.
    if (waiting_[other - range_.begin] != 0 || mesh_.is_free(other) || mesh_.is_inside(edge))
      return;
    const float mine = worth_of(face), theirs = worth_of(other);
    if (std::min(mine, theirs) >= kPoor || mine + theirs >= kEnough) return;
    if (!mesh_.may_change(other, range_)) {
      met_border_ = true;
      return;
    }
    slide_if_better(edge, mine + theirs);
  }

  void slide_if_better(HalfedgeId edge, float now) {
    QuadPair<Mesh> hexagon = quad_pair_at(mesh_, edge);
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
    for (const std::uint32_t touched : hexagon.slot) worth_[touched - range_.begin] = kUnknown;
    for (const std::uint32_t touched : hexagon.slot) wait(touched);
  }

  Mesh& mesh_;
  const FaceRange range_;
  std::vector<float> worth_;  // of the face's quad, from the range's begin on, as the next
  std::vector<char> waiting_;
  std::vector<std::uint32_t> todo_;
  std::vector<std::uint32_t> touched_;  // by slides
  std::vector<std::uint32_t> at_border_;
  bool met_border_ = false;
  std::size_t slides_ = 0;
};

template <class Mesh>
std::size_t slide_all(Mesh& mesh) {
  Slider<Mesh> slider(mesh);
  for (auto face = static_cast<std::uint32_t>(mesh.face_count()); face-- > 0;) {
    slider.find_poor(face);
  }
  return slider.run();
}

/// Within each range, on several threads, then at their borders.
std::size_t slide_in_ranges(QuadMesh& mesh, std::span<const FaceRange> ranges) {
  std::vector<std::vector<FaceId>> at_border(ranges.size());
  std::vector<std::size_t> slides(ranges.size());
  parallel_tasks(ranges.size(), [&](std::size_t i) {
    Slider<QuadMesh> slider(mesh, ranges[i]);
    for (FaceId face = ranges[i].end; face-- > ranges[i].begin;) slider.find_poor(face);
    slides[i] = slider.run();
    at_border[i] = slider.at_border();
  });
  Slider<QuadMesh> slider(mesh);
  for (const std::vector<FaceId>& list : at_border) {
    for (const FaceId face : list) slider.find_poor(face);
  }
  return std::accumulate(slides.begin(), slides.end(), slider.run());
}

}  // namespace

void part_anew(PairedMesh& mesh, QuadPair<PairedMesh>& hexagon, std::size_t first) {
  std::array<HalfedgeId, 6> outer;
  for (std::size_t k = 0; k < 6; ++k) outer[k] = mesh.tri.twin[hexagon.inner[k]];
  const auto [t, u, v, w] = hexagon.slot;
  mesh.link(set_quad(mesh, hexagon, outer, first, t, u),
            set_quad(mesh, hexagon, outer, first + 3, v, w));
}

void part_anew(QuadMesh& mesh, QuadPair<QuadMesh>& hexagon, std::size_t first) {
  std::array<HalfedgeId, 6> outer;
  for (std::size_t k = 0; k < 6; ++k) outer[k] = mesh.twin(hexagon.inner[k]);
  for (std::size_t k = 0; k < 6; ++k) {
    const std::size_t at = (first + k) % 6;
    const HalfedgeId side = 4 * hexagon.slot[k / 3] + static_cast<HalfedgeId>(k % 3);
    mesh.faces[side / 4].corner[side % 4] = hexagon.corner[at];
    mesh.link(side, outer[at]);
    hexagon.inner[at] = side;
  }
  for (const std::size_t half : {0U, 1U}) {
    mesh.faces[hexagon.slot[half]].corner[3] = hexagon.corner[(first + 3 * half + 3) % 6];
  }
  mesh.link(4 * hexagon.slot[0] + 3, 4 * hexagon.slot[1] + 3);
}

std::size_t slide_diagonals(PairedMesh& mesh) { return slide_all(mesh); }
std::size_t slide_diagonals(QuadMesh& mesh) {
  const std::vector<FaceRange> ranges = face_ranges(mesh.face_count());
  return ranges.empty() ? slide_all(mesh) : slide_in_ranges(mesh, ranges);
}

std::size_t slide_diagonals_at(PairedMesh& mesh, std::vector<TriangleId>& triangles) {
  Slider<PairedMesh> slider(mesh);
  for (const TriangleId t : triangles) slider.find_poor(t);
  const std::size_t slides = slider.run();
  triangles.insert(triangles.end(), slider.touched().begin(), slider.touched().end());
  return slides;
}

}  // namespace quadloom::quadrangulate
