// Exhaustive search for a triangulation with a Hamiltonian cycle.
//
// A cycle through all triangles is a closed curve that meets no point; it has some of the points
// inside and the others, those of the hull among them, outside. Every edge that it crosses joins an
// inside point x to an outside point y:
//
//       y ----- y'           The next triangle is left of x -> y: with another outside point, so that
//       | \   /              the curve crosses x y' next, or with another inside point x', so that it
//       |  \ /               crosses x' y next.
//    ...|   x
//
//   1. begin   a hull edge u0 u1, outside, and an inside point w: the curve goes from u0 w to u1 w
//   2. extend  by each triangle that contains no point, overlaps none of those before, and agrees with
//              what is known to be inside or outside; depth first
//   3. close   when there are as many triangles as a triangulation has (2n - 2 - h triangles that do not
//              overlap and hold no points are one): is the curve back at u0 w?
//
// All decisions are signs of turns, from a table. Degenerate input needs no care: a point on the side
// of a triangle is a point that it contains. Cost: exponential, within the limit.
#include "strips/hamiltonian_search.hpp"

#include <algorithm>
#include <array>

#include "kernel/predicates_inline.hpp"
#include "quadloom/kernel.hpp"

namespace quadloom::strips {
namespace {

class Search {
 public:
  Search(std::span<const Point> points, std::size_t work)
      : count_(static_cast<VertexId>(points.size())), work_(work) {
    for (VertexId a = 0; a < count_; ++a) {
      for (VertexId b = 0; b < count_; ++b) {
        for (VertexId c = 0; c < count_; ++c) {
          turn_[a][b][c] =
              static_cast<std::int8_t>(kernel::orient(points[a], points[b], points[c]));
        }
      }
    }
    hull_ = convex_hull(points);
    wanted_ = 2 * points.size() - 2 - hull_.size();
  }

  CycleSearch run() {
    CycleSearch out;
    side_.fill(Side::kUnknown);
    for (const VertexId v : hull_) side_[v] = Side::kOutside;
    for (VertexId w = 0; w < count_ && wanted_ >= 3; ++w) {
      const Triangle first = {w, hull_[0], hull_[1]};
      if (side_[w] == Side::kOutside || !is_free(first)) continue;
      if (extend(first)) {
        out.answer = Answer::kYes;
        for (const Triangle& t : triangles_)
          out.corners.insert(out.corners.end(), t.begin(), t.end());
        return out;
      }
    }
    out.answer = work_ == 0 ? Answer::kUnknown : Answer::kNo;
    return out;
  }

 private:
  enum class Side : std::uint8_t { kUnknown, kInside, kOutside };
  using Triangle = std::array<VertexId, 3>;  // counter-clockwise

  /// The edge x y that the curve crosses next, the next way on to be tried (twice the point, plus one if
  /// it is inside), and which point got its side when the curve came here.
  struct Level {
    VertexId x, y;
    VertexId option = 0;
    VertexId sided = kNone;
  };

  /// Counter-clockwise and without a point in it or on its sides.
  bool is_free(const Triangle& t) const {
    const auto [a, b, c] = t;
    if (turn_[a][b][c] <= 0) return false;
    for (VertexId v = 0; v < count_; ++v) {
      if (v == a || v == b || v == c) continue;
      if (turn_[a][b][v] >= 0 && turn_[b][c][v] >= 0 && turn_[c][a][v] >= 0) return false;
    }
    return true;
  }

  /// Whether a side of one has the other altogether on its outer side.
  bool apart(const Triangle& s, const Triangle& t) const {
    const auto parts = [&](const Triangle& from, const Triangle& other) {
      for (std::size_t i = 0; i < 3; ++i) {
        const auto& turns = turn_[from[i]][from[(i + 1) % 3]];
        if (turns[other[0]] <= 0 && turns[other[1]] <= 0 && turns[other[2]] <= 0) return true;
      }
      return false;
    };
    return parts(s, t) || parts(t, s);
  }

  bool fits(const Triangle& t) const {
    return is_free(t) && std::all_of(triangles_.begin(), triangles_.end(),
                                     [&](const Triangle& s) { return apart(s, t); });
  }

  bool extend(const Triangle& first) {
    const VertexId w = first[0];
    triangles_ = {first};
    side_[w] = Side::kInside;
    std::vector<Level> levels = {{w, first[2], 0, kNone}};
    while (!levels.empty() && work_ > 0) {
      Level& level = levels.back();
      if (triangles_.size() == wanted_ && level.x == w && level.y == first[1]) return true;
      if (triangles_.size() == wanted_ || level.option == 2 * count_) {
        if (level.sided != kNone) side_[level.sided] = Side::kUnknown;
        levels.pop_back();
        triangles_.pop_back();
        continue;
      }
      const VertexId z = level.option / 2;
      const Side side = level.option % 2 == 0 ? Side::kOutside : Side::kInside;
      ++level.option;
      const Triangle next = {level.x, level.y, z};
      if (side_[z] != Side::kUnknown && side_[z] != side) continue;
      --work_;
      if (!fits(next)) continue;
      triangles_.push_back(next);
      const VertexId sided = side_[z] == Side::kUnknown ? z : kNone;
      side_[z] = side;
      levels.push_back(side == Side::kOutside ? Level{level.x, z, 0, sided}
                                              : Level{z, level.y, 0, sided});
    }
    side_[w] = Side::kUnknown;
    return false;
  }

  VertexId count_;
  std::size_t work_;
  std::array<std::array<std::array<std::int8_t, kMostSearched>, kMostSearched>, kMostSearched>
      turn_;
  std::array<Side, kMostSearched> side_;
  std::vector<VertexId> hull_;
  std::size_t wanted_ = 0;  // triangles
  std::vector<Triangle> triangles_;
};

}  // namespace

CycleSearch search_cycle(std::span<const Point> points, std::size_t work) {
  return Search(points, work).run();
}

}  // namespace quadloom::strips
