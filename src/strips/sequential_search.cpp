// Does a small point set have a sequential triangulation? By search.
//
// (Arkin, Held, Mitchell, Skiena, "Hamiltonian triangulations for fast rendering", section 4, found their
// set of nine points without one by a search of this kind.)
//
//   1. EmptyTriangles  which triangles can be in a triangulation, by their sides, and which edges cross
//   2. begin           some triangle has the first hull edge: each is tried, its corners in three orders
//                      (the others are the same sequences read backwards)
//   3. grow            the sequence grows at its head, by any triangle that fits on the last edge; then at
//                      its tail. Each is placed if it is empty, crosses no edge and covers nothing twice
//   4. reaches_all     what is not covered must be reached again: every side that still needs a triangle
//                      is on the boundary of the region before the head, or of that before the tail
//
//         s0 ---- s2              The triangle s1 s2 s3 leaves the side s1 s3 behind. If that is not on the
//          \     /  \             hull, what is beyond must be covered later, coming from elsewhere.
//           \   /    \   .
//            s1 ----- s3
//
// Disjoint empty triangles that are as many as a triangulation has (2n - 2 - h) are one: their edges cross
// nowhere, so they are in some triangulation, and it has no others.
//
// Degenerate input: triangles without area are none, and a triangle with a point on a side is not empty.
// Depth: the number of triangles, below 2 n <= 64. Cost: exponential; the limit counts triangles tried.
#include "strips/sequential_search.hpp"

#include <algorithm>
#include <array>
#include <bitset>
#include <utility>

#include "quadloom/kernel.hpp"

namespace quadloom::strips {
namespace {

constexpr std::size_t kMost = kMostSequentialPoints;
using Edges = std::bitset<kMost*(kMost - 1) / 2>;
using Sides = std::bitset<kMost * kMost>;

std::size_t edge_of(VertexId a, VertexId b) {
  if (a < b) std::swap(a, b);
  return std::size_t{a} * (a - 1) / 2 + b;
}
std::size_t side_of(VertexId a, VertexId b) { return std::size_t{a} * kMost + b; }

class EmptyTriangles {
 public:
  explicit EmptyTriangles(std::span<const Point> points)
      : count_(static_cast<VertexId>(points.size())) {
    for (VertexId a = 0; a < count_; ++a) {
      for (VertexId b = 0; b < count_; ++b) {
        for (VertexId c = 0; c < count_; ++c) {
          if (is_empty(points, a, b, c)) apex_[side_of(a, b)].push_back(c);
        }
      }
      sort_around(points, a);
    }
    for (VertexId a = 0; a < count_; ++a) {
      for (VertexId b = 0; b < a; ++b) find_crossings(points, a, b);
    }
  }

  VertexId count() const { return count_; }
  /// What is on the left of a -> b as the third corner of an empty triangle.
  const std::vector<VertexId>& apexes(VertexId a, VertexId b) const { return apex_[side_of(a, b)]; }
  const Edges& crossings(VertexId a, VertexId b) const { return crossing_[edge_of(a, b)]; }
  /// The other points in clockwise order around a point, and where one is among them.
  const std::vector<VertexId>& around(VertexId v) const { return around_[v]; }
  std::size_t rank(VertexId v, VertexId w) const { return rank_[side_of(v, w)]; }

 private:
  static bool is_empty(std::span<const Point> p, VertexId a, VertexId b, VertexId c) {
    if (a == b || b == c || c == a || orient2d(p[a], p[b], p[c]) <= 0) return false;
    for (VertexId v = 0; v < p.size(); ++v) {
      if (v == a || v == b || v == c) continue;
      if (orient2d(p[a], p[b], p[v]) >= 0 && orient2d(p[b], p[c], p[v]) >= 0 &&
          orient2d(p[c], p[a], p[v]) >= 0) {
        return false;
      }
    }
    return true;
  }

  void sort_around(std::span<const Point> p, VertexId v) {
    auto& around = around_[v];
    for (VertexId w = 0; w < count_; ++w) {
      if (w != v) around.push_back(w);
    }
    const auto half = [&](VertexId w) { return lex_less(p[v], p[w]) ? 0 : 1; };
    std::sort(around.begin(), around.end(), [&](VertexId u, VertexId w) {
      if (half(u) != half(w)) return half(u) < half(w);
      const int turn = orient2d(p[v], p[u], p[w]);
      return turn != 0 ? turn < 0 : u < w;
    });
    for (std::size_t i = 0; i < around.size(); ++i) rank_[side_of(v, around[i])] = i;
  }

  void find_crossings(std::span<const Point> p, VertexId a, VertexId b) {
    for (VertexId c = 0; c < count_; ++c) {
      for (VertexId d = 0; d < c; ++d) {
        if (c == a || c == b || d == a || d == b) continue;
        if (orient2d(p[a], p[b], p[c]) * orient2d(p[a], p[b], p[d]) < 0 &&
            orient2d(p[c], p[d], p[a]) * orient2d(p[c], p[d], p[b]) < 0) {
          crossing_[edge_of(a, b)].set(edge_of(c, d));
        }
      }
    }
  }

  VertexId count_;
  std::array<std::vector<VertexId>, kMost * kMost> apex_;
  std::array<Edges, kMost*(kMost - 1) / 2> crossing_;
  std::array<std::vector<VertexId>, kMost> around_;
  std::array<std::size_t, kMost* kMost> rank_ = {};
};

/// The edge across which the sequence goes on: from the corner before the last to the last one. The side
/// that the next triangle has is left or right of it.
struct Front {
  VertexId before = kNone, last = kNone;
  bool left = true;

  VertexId from() const { return left ? before : last; }
  VertexId to() const { return left ? last : before; }
};

class SequenceSearch {
 public:
  SequenceSearch(const EmptyTriangles& triangles, std::span<const VertexId> hull,
                 std::uint64_t work_at_most, const Progress& progress)
      : triangles_(triangles),
        wanted_(2 * std::size_t{triangles.count()} - 2 - hull.size()),
        work_at_most_(work_at_most),
        progress_(progress) {
    for (std::size_t i = 0; i < hull.size(); ++i) {
      const VertexId a = hull[i], b = hull[(i + 1) % hull.size()];
      open(a, b);
      outside_.set(side_of(b, a));
    }
    first_ = {hull[0], hull[1]};
  }

  SequenceFound run() {
    SequenceFound out;
    const auto [a, b] = first_;
    for (const VertexId c : triangles_.apexes(a, b)) {
      for (const std::array<VertexId, 3>& order :
           {std::array<VertexId, 3>{a, b, c}, {b, c, a}, {c, a, b}}) {
        if (begin(order)) out.answer = Answer::kYes;
        if (out.answer == Answer::kYes || work_ >= work_at_most_) break;
      }
      if (out.answer == Answer::kYes || work_ >= work_at_most_) break;
    }
    out.work = work_;
    if (out.answer == Answer::kYes) {
      out.sequence.assign(tail_.rbegin(), tail_.rend());
      out.sequence.insert(out.sequence.end(), head_.begin(), head_.end());
    } else if (work_ < work_at_most_) {
      out.answer = Answer::kNo;
    }
    return out;
  }

 private:
  struct Change {
    std::array<VertexId, 3> corner;
    std::array<bool, 3> opened;
    Edges edges_before;
  };

  /// The corners are counter-clockwise.
  bool begin(const std::array<VertexId, 3>& s) {
    const Change change = place(s);
    head_.assign(s.begin(), s.end());
    const bool found = grow({s[1], s[2], false}, {s[1], s[0], true}, true);
    if (!found) undo(change);
    return found;
  }

  /// Fills in the rest at the head, then at the tail, whose turn comes at any time; true if it succeeds.
  bool grow(Front head, Front tail, bool at_head) {
    if (placed_ == wanted_) return true;
    if (!reaches_all(head, tail, at_head)) return false;
    const Front front = at_head ? head : tail;
    for (const VertexId d : triangles_.apexes(front.from(), front.to())) {
      if (!count_work()) return false;
      if (!fits(front, d)) continue;
      const Change change = place({front.from(), front.to(), d});
      auto& end = at_head ? head_ : tail_;
      end.push_back(d);
      const Front next = {front.last, d, !front.left};
      if (at_head ? grow(next, tail, true) : grow(head, next, false)) return true;
      end.pop_back();
      undo(change);
    }
    return at_head && work_ < work_at_most_ && grow(head, tail, false);
  }

  bool count_work() {
    if (work_ >= work_at_most_) return false;
    if (++work_ % (1U << 20) == 0) {
      report_progress(progress_, "searching a sequence",
                      static_cast<double>(work_) / static_cast<double>(work_at_most_));
    }
    return true;
  }

  /// Whether the side is on the hull or has its triangle.
  bool is_done(VertexId a, VertexId b) const {
    return covered_[side_of(a, b)] || outside_[side_of(a, b)];
  }

  bool fits(const Front& front, VertexId d) const {
    const VertexId a = front.from(), b = front.to();
    if (is_done(a, b) || is_done(b, d) || is_done(d, a)) return false;
    return (triangles_.crossings(b, d) & edges_).none() &&
           (triangles_.crossings(d, a) & edges_).none();
  }

  void open(VertexId a, VertexId b) {
    open_.set(side_of(a, b));
    edges_.set(edge_of(a, b));
    ++open_count_;
  }

  Change place(const std::array<VertexId, 3>& corner) {
    Change change{corner, {}, edges_};
    for (std::size_t i = 0; i < 3; ++i) {
      const VertexId a = corner[i], b = corner[(i + 1) % 3];
      covered_.set(side_of(a, b));
      if (open_[side_of(a, b)]) {
        open_.reset(side_of(a, b));
        --open_count_;
      }
      change.opened[i] = !is_done(b, a);
      if (change.opened[i]) open(b, a);
      edges_.set(edge_of(a, b));
    }
    ++placed_;
    return change;
  }

  void undo(const Change& change) {
    for (std::size_t i = 0; i < 3; ++i) {
      const VertexId a = change.corner[i], b = change.corner[(i + 1) % 3];
      covered_.reset(side_of(a, b));
      if (change.opened[i]) {
        open_.reset(side_of(b, a));
        --open_count_;
      }
    }
    edges_ = change.edges_before;
    // A side was open before if its edge was there.
    for (std::size_t i = 0; i < 3; ++i) {
      const VertexId a = change.corner[i], b = change.corner[(i + 1) % 3];
      if (!edges_[edge_of(a, b)] || open_[side_of(a, b)]) continue;
      open_.set(side_of(a, b));
      ++open_count_;
    }
    --placed_;
  }

  /// Every region that is not covered has one boundary, since the first triangle is at the hull and all
  /// others hang on it. How many sides the boundary of the region left of the open side a -> b has; 0 if it is not open.
  std::size_t walk(VertexId a, VertexId b, Sides& seen) const {
    std::size_t sides = 0;
    while (open_[side_of(a, b)] && !seen[side_of(a, b)]) {
      seen.set(side_of(a, b));
      ++sides;
      const auto& around = triangles_.around(b);
      std::size_t at = triangles_.rank(b, a);
      do {
        at = at + 1 == around.size() ? 0 : at + 1;
      } while (!open_[side_of(b, around[at])]);
      a = std::exchange(b, around[at]);
    }
    return sides;
  }

  bool reaches_all(const Front& head, const Front& tail, bool at_head) const {
    Sides seen;
    std::size_t sides = walk(tail.from(), tail.to(), seen);
    if (at_head) sides += walk(head.from(), head.to(), seen);
    return sides == open_count_;
  }

  const EmptyTriangles& triangles_;
  std::size_t wanted_;
  std::uint64_t work_at_most_;
  const Progress& progress_;
  std::array<VertexId, 2> first_ = {kNone, kNone};  // a hull edge
  Edges edges_;                                     // that are there
  Sides covered_;                                   // sides of triangles
  Sides open_;                                      // sides that must get one
  Sides outside_;                                   // the outer sides of the hull
  std::size_t open_count_ = 0, placed_ = 0;
  std::uint64_t work_ = 0;
  std::vector<VertexId> head_, tail_;  // the sequence is the tail backwards, then the head
};

}  // namespace

SequenceFound search_sequence(std::span<const Point> points, std::uint64_t work_at_most,
                              const Progress& progress) {
  const EmptyTriangles triangles(points);
  return SequenceSearch(triangles, convex_hull(points), work_at_most, progress).run();
}

}  // namespace quadloom::strips
