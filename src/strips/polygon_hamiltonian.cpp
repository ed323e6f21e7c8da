// Whether a polygon has a triangulation whose triangles are a path: Arkin, Held, Mitchell and Skiena,
// theorem 2.1. O(E) after the visibility graph, E its chords.
//
// D(i, j) says that the part of the polygon with the corners i, i + 1 .. j has such a triangulation whose
// last triangle has the chord i-j as a side. Then
//
//                 j - 1         D(i, j) = D(i, j - 1) and i sees j - 1  (the last triangle is i, j - 1, j)
//      i + 1  .--'  \.                 or D(i + 1, j) and i + 1 sees j  (the last triangle is i, i + 1, j),
//          . /       \.
//         i --------- j         and D(i, i + 2) wherever i-(i + 2) is a chord. The polygon has such a
//                               triangulation if D(i, j) and D(j, i) for some chord.
//
//   1. polygon_disc       the polygon's corners in a circle, its constrained Delaunay triangles
//   2. visibility_graph   the chords of each corner in order around the polygon
//   3. find_mates         where each chord is in the list of its other end
//   4. decide             D of all chords, the shorter ones (in corners between) first
//   5. find_middle        a chord with D both ways
//   6. unroll             the triangles on both sides of it, from the far end of one to that of the other
//
// What we do differently. A convex polygon is answered at once (convex_path), without its n^2 / 2 chords.
// Where both ways lead on, unroll takes the one whose new chord is the shorter (in floating point, which
// decides nothing else), so that convex stretches do not become fans.
//
// Degenerate input. A chord touches no corner but its ends and runs along no side. So i-(i + 2) is none
// where i + 1 is a flat corner, and no triangle of the recursion is flat: two of its corners see each
// other past none. Rings that touch themselves are treated as PolygonDisc says.
//
// Cost: visibility_graph, then O(E log n) for find_mates and O(E) for the rest; 13 bytes a chord and
// end, E <= n (n - 3) / 2.
#include <algorithm>
#include <cmath>
#include <optional>

#include "strips/convex_path.hpp"
#include "strips/polygon_path.hpp"
#include "strips/visibility.hpp"

namespace quadloom {
namespace strips {
namespace {

/// A chord seen from one of its ends: a place in VisibilityGraph::other.
using Chord = std::size_t;

class HamiltonianPath {
 public:
  explicit HamiltonianPath(const PolygonDisc& disc) : disc_(disc), graph_(visibility_graph(disc)) {}

  /// Corners, three a triangle; none if there is no such triangulation.
  std::optional<std::vector<Position>> find() {
    if (disc_.size() == 3) return std::vector<Position>{0, 1, 2};
    find_mates();
    decide();
    const auto middle = find_middle();
    if (!middle) return std::nullopt;
    return unroll(*middle);
  }

 private:
  struct Step {                        // to the chords that D(i, j) may rest on
    bool ends = false;                 // i, i + 1, j is the last triangle: there are none
    std::optional<Chord> nearer_end;   // i-(j - 1), if D
    std::optional<Chord> later_start;  // (i + 1)-j, if D
  };

  void find_mates();
  void decide();
  Step step(Position i, Chord chord) const;
  std::optional<Chord> find_middle() const;
  std::vector<Position> unroll(Chord middle) const;
  void unroll_side(Position i, Chord chord, std::vector<Position>& corners) const;
  double length_of(Position i, Position j) const {
    const Point p = disc_.at(i), q = disc_.at(j);
    return std::hypot(q.x / 2 - p.x / 2, q.y / 2 - p.y / 2);
  }

  const PolygonDisc& disc_;
  VisibilityGraph graph_;
  std::vector<std::uint32_t> mate_;  // its place among the chords of its other end
  std::vector<std::uint8_t> path_;   // D
};

void HamiltonianPath::find_mates() {
  mate_.resize(graph_.other.size());
  for (Position i = 0; i < disc_.size(); ++i) {
    for (Chord c = graph_.begin[i]; c < graph_.begin[i + 1]; ++c) {
      const Position j = graph_.other[c];
      const auto from = graph_.other.begin() + static_cast<std::ptrdiff_t>(graph_.begin[j]);
      const auto to = graph_.other.begin() + static_cast<std::ptrdiff_t>(graph_.begin[j + 1]);
      const auto it = std::lower_bound(
          from, to, disc_.length(j, i),
          [&](Position k, Position wanted) { return disc_.length(j, k) < wanted; });
      mate_[c] = static_cast<std::uint32_t>(it - from);
    }
  }
}

/// Chords of one length after the other: each corner waits in the list of its next chord's length.
void HamiltonianPath::decide() {
  path_.assign(graph_.other.size(), 0);
  const Position n = disc_.size();
  std::vector<Chord> next(graph_.begin.begin(), graph_.begin.end() - 1);
  std::vector<Position> first_waiting(n, kNone), behind(n, kNone);
  const auto wait = [&](Position i) {
    if (next[i] == graph_.begin[i + 1]) return;
    Position& first = first_waiting[disc_.length(i, graph_.other[next[i]])];
    behind[i] = first;
    first = i;
  };
  for (Position i = 0; i < n; ++i) wait(i);
  for (Position length = 2; length < n; ++length) {
    for (Position i = first_waiting[length]; i != kNone;) {
      const Position then = behind[i];
      const Step from = step(i, next[i]);
      path_[next[i]] = from.ends || from.nearer_end || from.later_start ? 1 : 0;
      ++next[i];
      wait(i);
      i = then;
    }
  }
}

HamiltonianPath::Step HamiltonianPath::step(Position i, Chord chord) const {
  const Position j = graph_.other[chord];
  Step out;
  out.ends = disc_.length(i, j) == 2;
  if (out.ends) return out;
  if (chord > graph_.begin[i] && graph_.other[chord - 1] == disc_.previous(j) &&
      path_[chord - 1] != 0) {
    out.nearer_end = chord - 1;
  }
  const Chord following = graph_.begin[j] + mate_[chord] + 1;  // of j: i + 1, if it sees that
  const Position later = disc_.next(i);
  if (following < graph_.begin[j + 1] && graph_.other[following] == later) {
    const Chord turned = graph_.begin[later] + mate_[following];
    if (path_[turned] != 0) out.later_start = turned;
  }
  return out;
}

std::optional<Chord> HamiltonianPath::find_middle() const {
  for (Position i = 0; i < disc_.size(); ++i) {
    for (Chord c = graph_.begin[i]; c < graph_.begin[i + 1]; ++c) {
      if (path_[c] != 0 && path_[graph_.begin[graph_.other[c]] + mate_[c]] != 0) return c;
    }
  }
  return std::nullopt;
}

std::vector<Position> HamiltonianPath::unroll(Chord middle) const {
  const Position j = graph_.other[middle];
  const Chord turned = graph_.begin[j] + mate_[middle];
  std::vector<Position> corners, rest;
  unroll_side(graph_.other[turned], middle, corners);
  unroll_side(j, turned, rest);
  for (std::size_t t = 0, u = corners.size() / 3; t + 1 < u; ++t) {  // the far end comes first
    --u;
    std::swap_ranges(corners.begin() + static_cast<std::ptrdiff_t>(3 * t),
                     corners.begin() + static_cast<std::ptrdiff_t>(3 * t + 3),
                     corners.begin() + static_cast<std::ptrdiff_t>(3 * u));
  }
  corners.insert(corners.end(), rest.begin(), rest.end());
  return corners;
}

/// The triangles beyond the chord from i, the one at the chord first.
void HamiltonianPath::unroll_side(Position i, Chord chord, std::vector<Position>& corners) const {
  for (;;) {
    const Position j = graph_.other[chord];
    const Step from = step(i, chord);
    bool end_moves = from.nearer_end.has_value();
    if (from.nearer_end && from.later_start) {
      end_moves = length_of(i, disc_.previous(j)) <= length_of(disc_.next(i), j);
    }
    const Position apex = end_moves ? disc_.previous(j) : disc_.next(i);
    corners.insert(corners.end(), {i, apex, j});
    if (from.ends) return;
    chord = end_moves ? *from.nearer_end : *from.later_start;
    if (!end_moves) i = apex;
  }
}

std::optional<std::vector<Position>> hamiltonian_path(const PolygonDisc& disc) {
  bool convex = true;
  for (Position i = 0; i < disc.size() && convex; ++i) convex = !disc.reflex(i);
  if (convex) return convex_path(disc);
  return HamiltonianPath(disc).find();
}

}  // namespace
}  // namespace strips

std::optional<PolygonOrder> hamiltonian_triangulation(const Polygon& polygon) {
  strips::PolygonDisc disc = strips::polygon_disc(polygon);
  const auto corners = strips::hamiltonian_path(disc);
  if (!corners) return std::nullopt;
  return strips::order_of_disc(std::move(disc), *corners, OrderKind::kPath);
}

}  // namespace quadloom
