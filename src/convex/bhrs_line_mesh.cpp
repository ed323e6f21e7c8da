// The mesh of the set of points on a line (Bremner, Hurtado, Ramaswami and Sacristan, theorem 2.2): at
// most ceil((m + 3) / 2) Steiner points, where ceil(m / 2) - 1 are needed.
//
// v(1) ... v(m + 1) on the line, t above, b below; e(j) is the place between v(j) and v(j + 1).
//
//   1. check_set       the points are such a set
//   2. place_base      s inside the triangle b v(2) v(m), so that b s v(2) v(1) and b v(m + 1) v(m) s
//                      are strictly convex; from above the line now all is between t and s
//   3. choose_kinds    m = 4k + r. From both ends inwards the places are alternately squares (v(j) v(j+1)
//                      is an edge) and diamonds (it is not; a Steiner point p above or below is across
//                      from s or t), 2k of each; the diamonds' p alternately above and below: from each
//                      end k of them. The r places in the middle: diamonds if r <= 2, p on the side of
//                      the last ones; if r = 3 a square, a diamond on the other side, a square
//   4. place_diamond   p in the wedges of t and of s over v(j) v(j + 1): whatever is beside the diamond,
//                      the quads are then strictly convex
//   5. add_side        above the line one quad between each two neighbouring edges to t, and below to s
//
//      t ------- t ------ t ------- t ------ t        t and s are drawn as bars
//      |         |        |         |        |
//      |         p        |         |        |        p   of a diamond, above: v2 s v3 p
//      |       /   \      |         |        |
//      v1 --- v2    v3 -- v4       v5 ------ v6 ...
//      |      |     |       \     /          |
//      b      |     |          q             |        q   of a diamond, below: v4 q v5 t
//      |      |     |          |             |
//      s ---- s --- s -------- s ----------- s
//
// A square has exactly one p beside it above and one below (b for the outermost): the diamonds at its two
// ends have theirs on different sides, and e(1) and e(m) are next to a diamond with p above.
//
// So that the same walk does both sides, b stands for the p below the places before e(1) and after e(m).
// Differs from the paper: for m = 2 the triangle of step 2 is empty; there the quad with a point inside
// takes 3 Steiner points (quad.hpp), as many as the theorem says, and for m = 1 the set is a convex quad.
// Degenerate input: places thinner than the doubles are reported. Cost: O(m log m), for the check.
#include <array>
#include <vector>

#include "convex/lower_bound_meshes.hpp"
#include "kernel/predicates_inline.hpp"
#include "quadloom/convex.hpp"
#include "quadloom/kernel.hpp"

namespace quadloom {
namespace convex {

Point place_or_throw(const OpenRegion& region, const std::string& what) {
  if (const auto place = region.place(Effort::kExact)) return *place;
  throw Error(ErrorCode::kGuarantee, "no doubles were found for the Steiner point " + what);
}

namespace {

enum class Kind : unsigned char { kSquare, kAbove, kBelow };  // a diamond: where p is

class LineMesh {
 public:
  explicit LineMesh(std::span<const Point> points)
      : m_(static_cast<std::uint32_t>(points.size()) - 3), top_(m_ + 1), bottom_(m_ + 2) {
    mesh_.points.assign(points.begin(), points.end());
  }

  Quadrangulation build() && {
    place_base();
    choose_kinds();
    added_.assign(m_ + 1, kNone);
    for (VertexId j = 1; j <= m_; ++j) {
      if (kinds_[j] != Kind::kSquare) place_diamond(j);
    }
    add_side(Kind::kAbove, top_, kNone);
    add_side(Kind::kBelow, base_, bottom_);
    return std::move(mesh_);
  }

 private:
  VertexId v(VertexId j) const { return j - 1; }  // numbered as in the paper
  Point at(VertexId vertex) const { return mesh_.points[vertex]; }

  VertexId add_point(Point p) {
    mesh_.points.push_back(p);
    return static_cast<VertexId>(mesh_.points.size() - 1);
  }

  void add_quad(Kind side, VertexId a, VertexId b, VertexId c, VertexId d) {
    const std::array<VertexId, 4> up = {a, b, c, d}, down = {d, c, b, a};
    const auto& quad = side == Kind::kAbove ? up : down;
    mesh_.quad_vertex.insert(mesh_.quad_vertex.end(), quad.begin(), quad.end());
  }

  void place_base() {
    const Point b = at(bottom_), from = at(v(2)), to = at(v(m_));
    const std::array<Point, 3> corners = {b, to, from};
    OpenRegion region(corners);
    for (std::size_t i = 0; i < 3; ++i) region.add(corners[i], corners[(i + 1) % 3]);
    base_ = add_point(place_or_throw(region, "next to the lower point"));
  }

  void choose_kinds() {
    kinds_.assign(m_ + 1, Kind::kSquare);
    const std::uint32_t k = m_ / 4, r = m_ % 4;
    for (std::uint32_t i = 1; i <= k; ++i) {
      const Kind kind = i % 2 == 1 ? Kind::kAbove : Kind::kBelow;
      kinds_[2 * i] = kind;
      kinds_[m_ + 1 - 2 * i] = kind;
    }
    const Kind last = k % 2 == 1 ? Kind::kAbove : Kind::kBelow;
    const Kind other = k % 2 == 1 ? Kind::kBelow : Kind::kAbove;
    if (r == 3) {
      kinds_[2 * k + 2] = other;
    } else {
      for (std::uint32_t i = 1; i <= r; ++i) kinds_[2 * k + i] = last;
    }
  }

  void place_diamond(VertexId j) {
    const Point left = at(v(j)), right = at(v(j + 1)), t = at(top_), s = at(base_);
    const std::array<Point, 4> box = {left, right, t, s};
    OpenRegion region(box);
    region.add(t, left);
    region.add(right, t);
    region.add(left, s);
    region.add(s, right);
    const bool above = kinds_[j] == Kind::kAbove;
    region.add(above ? left : right, above ? right : left);
    added_[j] = add_point(place_or_throw(
        region, "between line points " + std::to_string(j - 1) + " and " + std::to_string(j)));
    add_quad(kinds_[j], v(j), above ? base_ : top_, v(j + 1), added_[j]);
  }

  /// The quads around `apex`, which has an edge to each p of its side and to each v between two places
  /// that have no p there. `end`: what stands for p beyond both ends.
  void add_side(Kind side, VertexId apex, VertexId end) {
    VertexId before = end;  // the p of the place before v(j), or none
    for (VertexId j = 1; j <= m_ + 1; ++j) {
      const bool last = j == m_ + 1;
      const VertexId after = last ? end : kinds_[j] == side ? added_[j] : kNone;
      if (before != kNone && after != kNone) add_quad(side, before, v(j), after, apex);
      if (!last && kinds_[j] == Kind::kSquare) {
        const VertexId next = j == m_ ? end : kinds_[j + 1] == side ? added_[j + 1] : kNone;
        if (before != kNone) add_quad(side, before, v(j), v(j + 1), apex);
        if (next != kNone) add_quad(side, v(j), v(j + 1), next, apex);
      }
      before = after;
    }
  }

  std::uint32_t m_;
  VertexId top_, bottom_;
  VertexId base_ = kNone;        // s
  std::vector<Kind> kinds_;      // of the places, from 1
  std::vector<VertexId> added_;  // their p
  Quadrangulation mesh_;
};

void check_set(std::span<const Point> points) {
  const auto fail = [](const char* sentence) { throw Error(ErrorCode::kBadOption, sentence); };
  if (points.size() < 4) fail("the set has at least four points: two on a line, one on each side");
  if (distinct_points(points).points.size() != points.size()) fail("the points are not distinct");
  const std::size_t m = points.size() - 3;
  const Point first = points[0], last = points[m], top = points[m + 1], bottom = points[m + 2];
  const bool forward = lex_less(first, last);
  for (std::size_t i = 0; i < m; ++i) {
    const bool in_order =
        forward ? lex_less(points[i], points[i + 1]) : lex_less(points[i + 1], points[i]);
    if (!in_order || kernel::orient(first, last, points[i]) != 0) {
      fail("all points but the last two must lie in order on one line");
    }
  }
  if (kernel::orient(first, bottom, last) <= 0 || kernel::orient(bottom, last, top) <= 0 ||
      kernel::orient(last, top, first) <= 0 || kernel::orient(top, first, bottom) <= 0) {
    fail("the line's ends and the last two points, left and right of it, must be a convex quad");
  }
}

/// v(1) b v(3) t around v(2).
Quadrangulation mesh_of_two_places(std::span<const Point> points) {
  const std::array<VertexId, 5> name = {0, 4, 2, 3, 1};
  const auto patch =
      convexify_quad_with_point({points[0], points[4], points[2], points[3]}, points[1]);
  if (!patch) throw Error(ErrorCode::kGuarantee, "no doubles were found for the Steiner points");
  Quadrangulation mesh;
  mesh.points.assign(points.begin(), points.end());
  mesh.points.insert(mesh.points.end(), patch->steiner.begin(), patch->steiner.end());
  for (const auto& quad : patch->quads) {
    for (const VertexId corner : quad)
      mesh.quad_vertex.push_back(corner < 5 ? name[corner] : corner);
  }
  return mesh;
}

}  // namespace
}  // namespace convex

Quadrangulation mesh_of_bhrs_line(std::span<const Point> points) {
  convex::check_set(points);
  if (points.size() == 4) return {{points.begin(), points.end()}, {0, 3, 1, 2}, {}};
  if (points.size() == 5) return convex::mesh_of_two_places(points);
  return convex::LineMesh(points).build();
}

}  // namespace quadloom
