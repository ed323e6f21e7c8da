// Step 5 of the algorithm in delaunay.cpp.
#include "kernel/delaunay_inserter.hpp"

#include <utility>

#include "kernel/perturbed_incircle.hpp"
#include "kernel/predicates_inline.hpp"

namespace quadloom::kernel {

void DelaunayInserter::insert(std::uint32_t p, std::uint32_t fresh) {
  collect_cavity<false>(locate<false>(p), p);
  fill_cavity(p, fresh);
}

bool DelaunayInserter::insert_within(std::uint32_t p, std::uint32_t fresh) {
  const std::uint32_t start = locate<true>(p);
  if (start == kNone || !collect_cavity<true>(start, p)) return false;
  fill_cavity(p, fresh);
  return true;
}

// Walks through edges that have p strictly beyond them, never back through the edge it came by,
// until there is none (p is in the triangle or on its border) or a ghost is reached (p is beyond
// its hull edge). In a Delaunay triangulation such a walk ends. After a few steps, which edge is
// tried first is left to chance: a fixed choice goes around long fans of slivers (Devillers, Pion,
// Teillaud 2002).
template <bool kWithin>
std::uint32_t DelaunayInserter::locate(std::uint32_t p) {
  constexpr int kFixedSteps = 6;
  const Point at = points_[p];
  const auto beyond = [&](const Triangle& t, std::uint32_t i) {
    const Point a = points_[t.v[i]], b = points_[t.v[i + 1]];
    const int sign = cross_filter(a, b, a, at);
    return sign != 0 ? sign < 0 : beyond_exact(t, i, at);
  };
  const Triangle& start = triangles_[last_];
  Edge entry = last_ << 2;
  if (beyond(start, 0)) entry = start.twin[0];
  std::uint32_t chance = p;
  for (int step = 0;; ++step) {
    const Triangle& t = triangles_[entry >> 2];
    if (kWithin && !owns(t)) {
      last_ = t.twin[entry & 3U] >> 2;  // where the walk comes from
      return kNone;
    }
    std::uint32_t i = DelaunayMesh::next(entry) & 3U, j = DelaunayMesh::previous(entry) & 3U;
    if (step > kFixedSteps) {
      chance = chance * 0x9e3779b9U + 1;
      if (chance >> 31) std::swap(i, j);
    }
    if (beyond(t, i)) {
      entry = t.twin[i];
    } else if (beyond(t, j)) {
      entry = t.twin[j];
    } else {
      return entry >> 2;
    }
  }
}

// A ghost has nothing beyond its edges to infinity, for which the filter is silent.
[[gnu::noinline]] bool DelaunayInserter::beyond_exact(const Triangle& t, std::uint32_t i,
                                                      Point at) const {
  if (mesh_.is_ghost(t)) return false;
  return cross_exact(points_[t.v[i]], points_[t.v[i + 1]], points_[t.v[i]], at) < 0;
}

// A ghost is in conflict with the points strictly beyond its hull edge, and with those on the edge
// between its ends. Its filter is silent, since its corner at infinity is not a number.
[[gnu::noinline]] bool DelaunayInserter::in_conflict_exact(const Triangle& t, Point at) const {
  for (std::uint32_t i = 0; i < 3; ++i) {
    if (t.v[i] != mesh_.ghost) continue;
    const Point a = points_[t.v[(i + 1) % 3]], b = points_[t.v[(i + 2) % 3]];
    const int turn = orient(a, b, at);
    return turn > 0 || (turn == 0 && lex_less(a, at) != lex_less(b, at));
  }
  // Its filter is sharper than the one for pairs.
  return inside_circle(points_[t.v[0]], points_[t.v[1]], points_[t.v[2]], at);
}

// Judges the triangles beyond two edges at once and pushes the edges, `first` on top. Two tests
// side by side cost hardly more than one.
inline DelaunayInserter::Judged* DelaunayInserter::judge_pair(Edge second, Edge first, Point at,
                                                              Judged* top) const {
  const Triangle &t = triangles_[first >> 2], &u = triangles_[second >> 2];
  const Point a = points_[t.v[0]], b = points_[t.v[1]], c = points_[t.v[2]];
  const Point d = points_[u.v[0]], e = points_[u.v[1]], f = points_[u.v[2]];
  const PairVerdict verdict =
      incircle_pair_filter(Pair{a.x, d.x} - at.x, Pair{a.y, d.y} - at.y, Pair{b.x, e.x} - at.x,
                           Pair{b.y, e.y} - at.y, Pair{c.x, f.x} - at.x, Pair{c.y, f.y} - at.y);
  bool first_conflict = verdict.inside[0] != 0, second_conflict = verdict.inside[1] != 0;
  if ((verdict.proven[0] & verdict.proven[1]) == 0) [[unlikely]] {
    if (verdict.proven[0] == 0) first_conflict = in_conflict_exact(t, at);
    if (verdict.proven[1] == 0) second_conflict = in_conflict_exact(u, at);
  }
  top[0] = second | (second_conflict ? kInConflict : 0);
  top[1] = first | (first_conflict ? kInConflict : 0);
  return top + 2;
}

void DelaunayInserter::grow_buffers() {
  cavity_.resize(2 * cavity_.size() + 62);
  rim_.resize(cavity_.size());
  stack_.resize(cavity_.size());
}

// From the triangle that holds p outwards, through every triangle in conflict. The cavity is
// star-shaped around p and has no vertex inside, so each triangle is reached once, and taking the
// edges in counter-clockwise order gives the rim in that order:
//
//        c                a -> b is an edge of the cavity, (b, a, c) the triangle beyond it. In
//       / \               conflict: a -> c and c -> b take the place of a -> b. Not in conflict:
//      /   \              b -> a joins the rim.
//     b-----a
//        p
template <bool kWithin>
bool DelaunayInserter::collect_cavity(std::uint32_t start, std::uint32_t p) {
  const Point at = points_[p];
  std::size_t cavity_size = 0, rim_size = 0;
  cavity_[cavity_size++] = start;
  const Triangle& first = triangles_[start];
  Judged* top = judge_pair(first.twin[2], first.twin[2], at, stack_.data()) - 1;
  top = judge_pair(first.twin[1], first.twin[0], at, top);
  while (top != stack_.data()) {
    const Judged judged = *--top;
    const auto edge = static_cast<Edge>(judged);
    if ((judged & kInConflict) == 0) {
      rim_[rim_size++] = edge;
      continue;
    }
    const Triangle& t = triangles_[edge >> 2];
    if (kWithin && !owns(t)) {
      last_ = start;
      return false;
    }
    cavity_[cavity_size++] = edge >> 2;
    // The rim ends two longer than the cavity, which in turn gets two fresh triangles; the stack
    // is never longer than the rim will be.
    if (cavity_size + 3 > cavity_.size()) {
      const auto depth = top - stack_.data();
      grow_buffers();
      top = stack_.data() + depth;
    }
    top = judge_pair(t.twin[DelaunayMesh::previous(edge) & 3U],
                     t.twin[DelaunayMesh::next(edge) & 3U], at, top);
  }
  cavity_size_ = cavity_size;
  rim_size_ = rim_size;
  return true;
}

// The star of p: one triangle (a, b, p) for each edge b -> a of the rim. It has two triangles more
// than the cavity, whose places are taken first.
void DelaunayInserter::fill_cavity(std::uint32_t p, std::uint32_t fresh) {
  const std::size_t m = rim_size_;
  cavity_[m - 2] = fresh;
  cavity_[m - 1] = fresh + 1;
  std::uint32_t before = fresh + 1;
  for (std::size_t i = 0; i < m; ++i) {
    const Edge e = rim_[i];
    Triangle& outside = triangles_[e >> 2];
    const std::uint32_t a = outside.v[(e & 3U) + 1], b = outside.v[e & 3U];
    const std::uint32_t at = cavity_[i], after = cavity_[i + 1 == m ? 0 : i + 1];
    outside.twin[e & 3U] = at << 2;
    triangles_[at] = {{a, b, p, a}, {e, after << 2 | 2, before << 2 | 1}, 0};
    before = at;
  }
  std::size_t real = 0;
  while (mesh_.is_ghost(triangles_[cavity_[real]])) ++real;
  last_ = cavity_[real];
}

}  // namespace quadloom::kernel
