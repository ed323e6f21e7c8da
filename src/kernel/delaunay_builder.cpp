// Steps 3 to 6 of the algorithm in delaunay.cpp.
#include "kernel/delaunay_builder.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "kernel/perturbed_incircle.hpp"
#include "kernel/predicates_inline.hpp"

namespace quadloom::kernel {
namespace {

/// Of so many points all but one belong to the last round, of those left all but one of so many to
/// the round before it, and so on.
constexpr std::size_t kRoundRatio = 8;
constexpr std::size_t kFirstRound = 64;

/// A fixed hash, so that the choice of the early points owes nothing to their order.
std::uint64_t hash(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31);
}

}  // namespace

DelaunayBuilder::DelaunayBuilder(std::vector<Point> points)
    : points_(std::move(points)), ghost_(static_cast<std::uint32_t>(points_.size())) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  points_.push_back({kNan, kNan});
}

bool DelaunayBuilder::build() {
  std::vector<std::uint32_t> order = insertion_order();
  if (!first_triangle(order)) return false;
  triangles_.reserve(2 * points_.size());
  grow_buffers();
  for (std::size_t i = 3; i < order.size(); ++i) insert(order[i]);
  drop_ghosts();
  points_ = std::vector<Point>();  // freed before the result takes its memory
  return true;
}

// Rounds, the coarsest first: of each kRoundRatio neighbours along the curve, one that the hash
// chooses belongs to an earlier round. In a round the points follow the curve.
std::vector<std::uint32_t> DelaunayBuilder::insertion_order() const {
  const std::size_t n = ghost_;
  std::vector<std::uint32_t> order(n), remaining(n);
  for (std::size_t i = 0; i < n; ++i) remaining[i] = static_cast<std::uint32_t>(i);
  std::size_t end = n;
  while (remaining.size() > kFirstRound) {
    const std::size_t size = remaining.size();
    const std::size_t earlier = size / kRoundRatio;
    std::size_t to = end - (size - earlier), kept = 0;
    end = to;
    for (std::size_t begin = 0; begin < size; begin += kRoundRatio) {
      const bool whole = begin + kRoundRatio <= size;
      const std::size_t chosen = whole ? begin + hash(begin + size) % kRoundRatio : size;
      for (std::size_t i = begin; i < std::min(begin + kRoundRatio, size); ++i) {
        if (i != chosen) order[to++] = remaining[i];
      }
      if (whole) remaining[kept++] = remaining[chosen];
    }
    remaining.resize(kept);
  }
  std::copy(remaining.begin(), remaining.end(), order.begin());
  return order;
}

// The first two points and the first that is not on their line, moved to the front; around the
// triangle its three ghosts:
//
//            3       c       2        ghost 1 + i lies beyond edge i; its edge 0 is that edge's
//                   / \               twin, edges 1 and 2 lead to infinity
//                  / 0 \              .
//                 a-----b
//                    1
bool DelaunayBuilder::first_triangle(std::vector<std::uint32_t>& order) {
  std::size_t k = 2;
  int turn = 0;
  for (; k < order.size(); ++k) {
    turn = orient(points_[order[0]], points_[order[1]], points_[order[k]]);
    if (turn != 0) break;
  }
  if (turn == 0) return false;
  std::rotate(order.begin() + 2, order.begin() + static_cast<std::ptrdiff_t>(k),
              order.begin() + static_cast<std::ptrdiff_t>(k) + 1);
  if (turn < 0) std::swap(order[0], order[1]);
  const std::uint32_t a = order[0], b = order[1], c = order[2], inf = ghost_;
  triangles_ = {{{a, b, c, a}, {4, 8, 12}, 0},
                {{b, a, inf, b}, {0, 14, 9}, 0},
                {{c, b, inf, c}, {1, 6, 13}, 0},
                {{a, c, inf, a}, {2, 10, 5}, 0}};
  last_ = 0;
  return true;
}

void DelaunayBuilder::insert(std::uint32_t p) {
  collect_cavity(locate(p), p);
  fill_cavity(p);
}

// Walks through edges that have p strictly beyond them, never back through the edge it came by,
// until there is none (p is in the triangle or on its border) or a ghost is reached (p is beyond
// its hull edge). In a Delaunay triangulation such a walk ends. After a few steps, which edge is
// tried first is left to chance: a fixed choice goes around long fans of slivers (Devillers, Pion,
// Teillaud 2002).
std::uint32_t DelaunayBuilder::locate(std::uint32_t p) const {
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
    std::uint32_t i = next(entry) & 3U, j = previous(entry) & 3U;
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
[[gnu::noinline]] bool DelaunayBuilder::beyond_exact(const Triangle& t, std::uint32_t i,
                                                     Point at) const {
  if (is_ghost(t)) return false;
  return cross_exact(points_[t.v[i]], points_[t.v[i + 1]], points_[t.v[i]], at) < 0;
}

// A ghost is in conflict with the points strictly beyond its hull edge, and with those on the edge
// between its ends. Its filter is silent, since its corner at infinity is not a number.
[[gnu::noinline]] bool DelaunayBuilder::in_conflict_exact(const Triangle& t, Point at) const {
  for (std::uint32_t i = 0; i < 3; ++i) {
    if (t.v[i] != ghost_) continue;
    const Point a = points_[t.v[(i + 1) % 3]], b = points_[t.v[(i + 2) % 3]];
    const int turn = orient(a, b, at);
    return turn > 0 || (turn == 0 && lex_less(a, at) != lex_less(b, at));
  }
  const Point a = points_[t.v[0]], b = points_[t.v[1]], c = points_[t.v[2]];
  int sign = incircle_filter(a, b, c, at);  // sharper than the one for pairs
  if (sign == 0) sign = incircle_exact(a, b, c, at);
  return (sign != 0 ? sign : perturbed_incircle(a, b, c, at)) > 0;
}

// Judges the triangles beyond two edges at once and pushes the edges, `first` on top. Two tests
// side by side cost hardly more than one.
inline DelaunayBuilder::Judged* DelaunayBuilder::judge_pair(Edge second, Edge first, Point at,
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

void DelaunayBuilder::grow_buffers() {
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
void DelaunayBuilder::collect_cavity(std::uint32_t start, std::uint32_t p) {
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
    cavity_[cavity_size++] = edge >> 2;
    // The rim ends two longer than the cavity, which in turn gets two fresh triangles; the stack
    // is never longer than the rim will be.
    if (cavity_size + 3 > cavity_.size()) {
      const auto depth = top - stack_.data();
      grow_buffers();
      top = stack_.data() + depth;
    }
    const Triangle& t = triangles_[edge >> 2];
    top = judge_pair(t.twin[previous(edge) & 3U], t.twin[next(edge) & 3U], at, top);
  }
  cavity_size_ = cavity_size;
  rim_size_ = rim_size;
}

// The star of p: one triangle (a, b, p) for each edge b -> a of the rim. It has two triangles more
// than the cavity, whose places are taken first.
void DelaunayBuilder::fill_cavity(std::uint32_t p) {
  const auto fresh = static_cast<std::uint32_t>(triangles_.size());
  triangles_.resize(fresh + 2);
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
  while (is_ghost(triangles_[cavity_[real]])) ++real;
  last_ = cavity_[real];
}

// Cuts the ghosts off and closes the gaps with the last triangles.
void DelaunayBuilder::drop_ghosts() {
  const std::vector<std::uint32_t> ghosts = mark_ghosts();
  const std::size_t kept = triangles_.size() - ghosts.size();
  std::size_t from = triangles_.size();
  for (const std::uint32_t gap : ghosts) {
    if (gap >= kept) continue;
    do {
      --from;
    } while (is_ghost(triangles_[from]));
    triangles_[gap] = triangles_[from];
    for (std::uint32_t i = 0; i < 3; ++i) {
      const Edge e = triangles_[gap].twin[i];
      if (e != kNone) triangles_[e >> 2].twin[e & 3U] = gap << 2 | i;
    }
  }
  triangles_.resize(kept);
}

// The ghosts, found by going around the hull; the twins that lead to them become kNone.
std::vector<std::uint32_t> DelaunayBuilder::mark_ghosts() {
  std::uint32_t at = 0;
  while (!is_ghost(triangles_[at])) ++at;
  std::vector<std::uint32_t> ghosts;
  const std::uint32_t start = at;
  do {
    ghosts.push_back(at);
    const Triangle& t = triangles_[at];
    const std::uint32_t infinity = t.v[0] == ghost_ ? 0 : t.v[1] == ghost_ ? 1 : 2;
    const Edge inside = t.twin[next(infinity)];
    triangles_[inside >> 2].twin[inside & 3U] = kNone;
    at = t.twin[infinity] >> 2;
  } while (at != start);
  return ghosts;
}

}  // namespace quadloom::kernel
