#include "kernel/delaunay_builder.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "kernel/predicates_inline.hpp"

namespace quadloom::kernel {
namespace {

/// Each round inserts this many times as many points as all rounds before it (and one less).
constexpr std::size_t kRoundRatio = 8;
constexpr std::size_t kFirstRound = 64;

/// A fixed hash, so that the choice of the early points owes nothing to their order.
std::uint64_t hash(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31);
}

/// incircle(a, b, c, p) for a cocircular tie of distinct points, a, b, c counter-clockwise: the
/// sign when the lexicographically largest of the four is lifted a little off the paraboloid.
int perturbed_incircle(Point a, Point b, Point c, Point p) {
  const auto largest = [&](Point q, Point r, Point s, Point t) {
    return lex_less(r, q) && lex_less(s, q) && lex_less(t, q);
  };
  if (largest(p, a, b, c)) return -1;
  if (largest(c, a, b, p)) return orient(a, b, p);
  if (largest(b, a, c, p)) return orient(a, p, c);
  return orient(p, b, c);
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
  for (std::size_t i = 3; i < order.size(); ++i) insert(order[i]);
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
// its hull edge). In a Delaunay triangulation such a walk ends.
std::uint32_t DelaunayBuilder::locate(std::uint32_t p) const {
  const Point at = points_[p];
  const auto beyond = [&](const Triangle& t, std::uint32_t i) {
    const Point a = points_[t.v[i]], b = points_[t.v[i + 1]];
    const int sign = cross_filter(a, b, a, at);
    return sign != 0 ? sign < 0 : cross_exact(a, b, a, at) < 0;
  };
  std::uint32_t current = last_;
  Edge entry = current << 2;
  if (!beyond(triangles_[current], 0)) {
    entry = current << 2 | 3;
  } else {
    entry = triangles_[current].twin[0];
  }
  if ((entry & 3U) == 3) {
    const Triangle& t = triangles_[current];
    if (beyond(t, 1)) {
      entry = t.twin[1];
    } else if (beyond(t, 2)) {
      entry = t.twin[2];
    } else {
      return current;
    }
  }
  for (;;) {
    current = entry >> 2;
    const Triangle& t = triangles_[current];
    if (is_ghost(t)) return current;
    const std::uint32_t first = next(entry) & 3U, second = previous(entry) & 3U;
    if (beyond(t, first)) {
      entry = t.twin[first];
    } else if (beyond(t, second)) {
      entry = t.twin[second];
    } else {
      return current;
    }
  }
}

bool DelaunayBuilder::in_conflict(const Triangle& t, std::uint32_t p) const {
  const int sign = incircle_filter(points_[t.v[0]], points_[t.v[1]], points_[t.v[2]], points_[p]);
  return sign != 0 ? sign > 0 : in_conflict_exact(t, p);
}

// A ghost is in conflict with the points strictly beyond its hull edge, and with those on the edge
// between its ends. Its filter is silent, since its corner at infinity is not a number.
[[gnu::noinline]] bool DelaunayBuilder::in_conflict_exact(const Triangle& t,
                                                          std::uint32_t p) const {
  const Point at = points_[p];
  for (std::uint32_t i = 0; i < 3; ++i) {
    if (t.v[i] != ghost_) continue;
    const Point a = points_[t.v[(i + 1) % 3]], b = points_[t.v[(i + 2) % 3]];
    const int turn = orient(a, b, at);
    return turn > 0 || (turn == 0 && lex_less(a, at) != lex_less(b, at));
  }
  const Point a = points_[t.v[0]], b = points_[t.v[1]], c = points_[t.v[2]];
  const int sign = incircle_exact(a, b, c, at);
  return (sign != 0 ? sign : perturbed_incircle(a, b, c, at)) > 0;
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
  cavity_.clear();
  rim_.clear();
  cavity_.push_back(start);
  const Triangle& first = triangles_[start];
  stack_.assign({first.twin[2], first.twin[1], first.twin[0]});
  while (!stack_.empty()) {
    const Edge e = stack_.back();
    stack_.pop_back();
    const Triangle& t = triangles_[e >> 2];
    if (in_conflict(t, p)) {
      cavity_.push_back(e >> 2);
      stack_.push_back(t.twin[previous(e) & 3U]);
      stack_.push_back(t.twin[next(e) & 3U]);
    } else {
      rim_.push_back(e);
    }
  }
}

// The star of p: one triangle (a, b, p) for each edge b -> a of the rim. It has two triangles more
// than the cavity, whose places are taken first.
void DelaunayBuilder::fill_cavity(std::uint32_t p) {
  const auto fresh = static_cast<std::uint32_t>(triangles_.size());
  triangles_.resize(fresh + 2);
  cavity_.push_back(fresh);
  cavity_.push_back(fresh + 1);
  std::uint32_t before = cavity_.back();
  const std::size_t m = rim_.size();
  for (std::size_t i = 0; i < m; ++i) {
    const Edge e = rim_[i];
    Triangle& outside = triangles_[e >> 2];
    const std::uint32_t a = outside.v[(e & 3U) + 1], b = outside.v[e & 3U];
    const std::uint32_t at = cavity_[i], after = cavity_[i + 1 == m ? 0 : i + 1];
    outside.twin[e & 3U] = at << 2;
    triangles_[at] = {{a, b, p, a}, {e, after << 2 | 2, before << 2 | 1}, 0};
    if (a != ghost_ && b != ghost_) last_ = at;
    before = at;
  }
}

}  // namespace quadloom::kernel
