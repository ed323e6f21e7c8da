// Simplicity of one face.
//
// Quads: a quad a b c d is simple, counter-clockwise and of positive area if and only if one of its
// diagonals splits it into two counter-clockwise triangles. The four signs needed are its four
// turns.
//
//        d-----c          d        c      split along a-c: turns at b and d are left
//        |   / |           \ \   / |      split along b-d: turns at a and c are left
//        | /   |            \  a   |      (a reflex corner or a flat one leaves one diagonal)
//        a-----b             \___b-+
//
// Other polygons: no two edges meet but at the corner that neighbours share. Few corners: all
// pairs. Many: the sweep of Shamos and Hoey (Geometric intersection problems, 1976) over the
// corners in lexicographic order (which is a sweep line turned by an infinitely small angle, so
// that vertical edges are nothing special), with exact comparisons:
//
//   1. sort_corners: equal corners: not simple.
//   2. at each corner: remove_ended takes the edges that end here out of the ordered set of edges
//      that the line meets and tests the two that become neighbours;
//   3. insert_begun puts the edges that begin here in and tests each with its two neighbours. A
//      corner that lies on an edge shows as a zero when its place in the set is sought.
//
// Until the leftmost common point is met the order in the set is right, and just before it the
// edges through it are neighbours: they are tested in time. Cost O(k log k).
//
// A simple polygon's orientation is the turn at its lexicographically smallest corner.

#include "certify/polygon.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <set>
#include <vector>

#include "kernel/predicates_inline.hpp"
#include "kernel/segments.hpp"
#include "quadloom/kernel.hpp"

namespace quadloom::certify {
namespace {

constexpr std::size_t kMostPairs = 64;

/// The edges ab and bc share more than b.
bool folds_back(Point a, Point b, Point c) {
  return orient2d(a, b, c) == 0 && dot_sign(b, a, b, c) >= 0;
}

/// Corner i + 1 after corner i, around.
std::size_t after(std::size_t i, std::size_t count) { return i + 1 == count ? 0 : i + 1; }

class Sweep {
 public:
  explicit Sweep(std::span<const Point> corners)
      : corners_(corners), active_(Below{this}), place_(corners.size(), active_.end()) {}

  bool edges_disjoint() {
    if (!sort_corners()) return false;
    for (const auto v : order_) {
      remove_ended(v);
      insert_begun(v);
      if (met_) return false;
    }
    return true;
  }

 private:
  using Edge = std::uint32_t;  // from corner e to the next one

  /// The order of two edges along the sweep line, both met by it.
  struct Below {
    Sweep* sweep;
    bool operator()(Edge a, Edge b) const { return sweep->below(a, b); }
  };
  using Active = std::set<Edge, Below>;

  Edge next(Edge e) const { return static_cast<Edge>(after(e, corners_.size())); }
  Edge previous(Edge e) const { return static_cast<Edge>(e == 0 ? corners_.size() - 1 : e - 1); }
  std::array<Point, 2> ends(Edge e) const {
    const Point a = corners_[e], b = corners_[next(e)];
    return lex_less(a, b) ? std::array{a, b} : std::array{b, a};
  }

  //         t            the edge that begins later is above the other
  //        /             if its beginning is left of the other's line;
  //   s---+---- t'       on it: they touch, the polygon is not simple
  //
  bool below(Edge a, Edge b) {
    if (a == b) return false;
    const auto [as, at] = ends(a);
    const auto [bs, bt] = ends(b);
    const int side = as == bs           ? orient2d(as, at, bt)
                     : lex_less(as, bs) ? orient2d(as, at, bs)
                                        : -orient2d(bs, bt, as);
    if (side == 0) met_ = true;
    return side > 0;
  }

  void test(Edge a, Edge b) {
    if (b == next(a)) {
      if (folds_back(corners_[a], corners_[b], corners_[next(b)])) met_ = true;
    } else if (a == next(b)) {
      test(b, a);
    } else if (kernel::segments_meet(corners_[a], corners_[next(a)], corners_[b],
                                     corners_[next(b)])) {
      met_ = true;
    }
  }

  bool sort_corners() {
    order_.resize(corners_.size());
    std::iota(order_.begin(), order_.end(), Edge{0});
    std::ranges::sort(order_, [&](Edge a, Edge b) { return lex_less(corners_[a], corners_[b]); });
    return std::ranges::adjacent_find(
               order_, [&](Edge a, Edge b) { return corners_[a] == corners_[b]; }) == order_.end();
  }

  void remove_ended(Edge v) {
    for (const Edge e : {previous(v), v}) {
      if (place_[e] == active_.end()) continue;
      const auto above = active_.erase(place_[e]);
      place_[e] = active_.end();
      if (above != active_.end() && above != active_.begin()) test(*std::prev(above), *above);
    }
  }

  void insert_begun(Edge v) {
    for (const Edge e : {previous(v), v}) {
      if (ends(e)[0] != corners_[v]) continue;
      const auto [place, is_new] = active_.insert(e);
      if (!is_new) met_ = true;
      if (met_) return;
      place_[e] = place;
      if (place != active_.begin()) test(*std::prev(place), e);
      if (std::next(place) != active_.end()) test(e, *std::next(place));
    }
  }

  std::span<const Point> corners_;
  std::vector<Edge> order_;
  bool met_ = false;
  Active active_;
  std::vector<Active::iterator> place_;
};

bool counter_clockwise(std::span<const Point> corners) {
  const auto k = corners.size();
  const auto least =
      static_cast<std::size_t>(std::ranges::min_element(corners, lex_less) - corners.begin());
  return orient2d(corners[least == 0 ? k - 1 : least - 1], corners[least],
                  corners[after(least, k)]) > 0;
}

int smallest_turn(std::span<const Point> corners) {
  int least = 1;
  const auto k = corners.size();
  for (std::size_t i = 0; i < k && least >= 0; ++i) {
    const auto j = after(i, k);
    least = std::min(least, orient2d(corners[i], corners[j], corners[after(j, k)]));
  }
  return least;
}

PolygonVerdict judge_quad(Point a, Point b, Point c, Point d) {
  using kernel::orient;  // inlined: a fifth of the time of all the checks
  const int at_a = orient(d, a, b), at_b = orient(a, b, c), at_c = orient(b, c, d),
            at_d = orient(c, d, a);
  return {(at_b > 0 && at_d > 0) || (at_a > 0 && at_c > 0),
          std::min(std::min(at_a, at_b), std::min(at_c, at_d))};
}

}  // namespace

bool edges_disjoint_by_pairs(std::span<const Point> corners) {
  const auto k = corners.size();
  for (std::size_t i = 0; i < k; ++i) {
    const auto j = after(i, k);
    if (folds_back(corners[i], corners[j], corners[after(j, k)])) return false;
    for (std::size_t m = i + 2; m < k && !(i == 0 && m == k - 1); ++m) {
      if (kernel::segments_meet(corners[i], corners[j], corners[m], corners[after(m, k)]))
        return false;
    }
  }
  return true;
}

bool edges_disjoint_by_sweep(std::span<const Point> corners) {
  return Sweep(corners).edges_disjoint();
}

PolygonVerdict judge_polygon(std::span<const Point> corners) {
  if (corners.size() == 3) {
    const bool left = orient2d(corners[0], corners[1], corners[2]) > 0;
    return {left, left ? 1 : -1};
  }
  if (corners.size() == 4) return judge_quad(corners[0], corners[1], corners[2], corners[3]);
  const bool disjoint = corners.size() <= kMostPairs ? edges_disjoint_by_pairs(corners)
                                                     : edges_disjoint_by_sweep(corners);
  return {disjoint && counter_clockwise(corners), smallest_turn(corners)};
}

}  // namespace quadloom::certify
