// The two configurations that need many Steiner points, in strictly convex quads with nearly as few
// (Bremner, Hurtado, Ramaswami and Sacristan, theorems 2.2 and 2.4).
//
// The line, m = 4k + r: one point s below, the virtual edges e(1) ... e(m) of the line from both ends: an
// edge, a point above, an edge, a point below, ..., so that the k-th point from either end is above
// for odd k; the r in the middle (choose_kinds):
//
//               t                 edge    kEdge   quads above and below it
//            /  |  \              above   kAbove  p is joined to t and both ends; the quad v s v' p
//          /    p    \            below   kBelow  p is joined to s and both ends; the quad v p v' t
//     v --- v'    v'' --- v       Two points on the same side in a row leave a quad between them.
//        \   \  s  /   /
//          \    |    /            Differs from the paper: it wants s in L(b, v2) and R(b, vm), which is
//               b                 outside of the hull; the other sides are meant.
//
// The ring: hull edges two by two share a Steiner point s beside their common corner; the quads of
// a pair are a, a', s, b and a', a'', b', s. What is left inside is a polygon with a corner b at every
// other place, and one point c in the middle is joined to these:
//
//     a'' ----- a'                for odd k the last hull edge makes a triangle with its b
//      | b'  s  |
//      |   .  b |                 Cost: O(n). All quads are checked.
//      |  c     a
#include <algorithm>
#include <vector>

#include "convex/open_region.hpp"
#include "convex/patch.hpp"
#include "quadloom/convex.hpp"
#include "quadloom/kernel.hpp"

namespace quadloom {

using convex::Effort;
using convex::HalfPlane;
using convex::OpenRegion;

namespace {

class MeshBuilder {
 public:
  explicit MeshBuilder(std::span<const Point> points) {
    result_.mesh.points.assign(points.begin(), points.end());
    result_.input_vertices = points.size();
    for (VertexId i = 0; i < points.size(); ++i) result_.input_to_vertex.push_back(i);
  }

  Point at(VertexId v) const { return result_.mesh.points[v]; }

  /// left of the given lines, each of two vertices
  VertexId add_steiner(const std::vector<std::array<VertexId, 2>>& lines,
                       std::array<VertexId, 3> parents) {
    std::vector<Point> ends;
    for (const auto& [from, to] : lines) ends.insert(ends.end(), {at(from), at(to)});
    OpenRegion region(ends);
    for (std::size_t i = 0; i < ends.size(); i += 2) region.add(ends[i], ends[i + 1]);
    const auto place = region.place(Effort::kExact);
    if (!place) throw Error(ErrorCode::kGuarantee, "there are no doubles for a Steiner point");
    return add_steiner(*place, parents);
  }
  VertexId add_steiner(Point place, std::array<VertexId, 3> parents) {
    const auto v = static_cast<VertexId>(result_.mesh.points.size());
    result_.mesh.points.push_back(place);
    result_.steiner.push_back({v, SteinerKind::kInner, parents});
    return v;
  }

  void add_quad(VertexId a, VertexId b, VertexId c, VertexId d) {
    if (!convex::strictly_convex({at(a), a}, {at(b), b}, {at(c), c}, {at(d), d})) {
      throw Error(ErrorCode::kBadOption, "the points are not such a set: a quad is not convex");
    }
    result_.mesh.quad_vertex.insert(result_.mesh.quad_vertex.end(), {a, b, c, d});
  }

  ConvexResult result_;
};

enum class EdgeKind { kEdge, kAbove, kBelow };

std::vector<EdgeKind> choose_kinds(std::size_t m) {
  const std::size_t k = m / 4, r = m % 4;
  std::vector<EdgeKind> kinds(m, EdgeKind::kEdge);
  for (std::size_t i = 1; i <= k; ++i) {
    const EdgeKind kind = i % 2 == 1 ? EdgeKind::kAbove : EdgeKind::kBelow;
    kinds[2 * i - 1] = kinds[m - 2 * i] = kind;
  }
  const bool above = (k % 2 == 1) == (r < 3);
  const EdgeKind middle = above ? EdgeKind::kAbove : EdgeKind::kBelow;
  if (r == 3) kinds[2 * k + 1] = middle;
  if (r < 3) std::fill(kinds.begin() + 2 * k, kinds.begin() + 2 * k + r, middle);
  return kinds;
}

class LineMesh : MeshBuilder {
 public:
  explicit LineMesh(std::span<const Point> points)
      : MeshBuilder(points),
        m_(static_cast<VertexId>(points.size()) - 3),
        t_(m_ + 1),
        b_(m_ + 2),
        kinds_(choose_kinds(m_)) {}

  ConvexResult build() {
    s_ = add_steiner({{1, b_}, {b_, m_ - 1}, {m_, 0}}, {1, b_, m_ - 1});
    for (VertexId e = 0; e < m_; ++e) inner_.push_back(place_at(e));
    for (VertexId e = 0; e < m_; ++e) add_faces_of_edge(e);
    for (VertexId v = 1; v < m_; ++v) add_face_at_vertex(v);
    result_.statistics.hull_points = 4;
    return std::move(result_);
  }

 private:
  EdgeKind kind(VertexId e) const { return kinds_[e]; }

  /// In the triangle of the edge and t (s), and in the wedge from s (t) over the edge.
  VertexId place_at(VertexId e) {
    if (kind(e) == EdgeKind::kEdge) return kNone;
    const VertexId v = e, w = e + 1;
    if (kind(e) == EdgeKind::kAbove) {
      return add_steiner({{v, w}, {w, t_}, {t_, v}, {v, s_}, {s_, w}}, {v, w, t_});
    }
    return add_steiner({{w, v}, {v, s_}, {s_, w}, {w, t_}, {t_, v}}, {w, v, b_});
  }

  void add_faces_of_edge(VertexId e) {
    const VertexId v = e, w = e + 1;
    if (kind(e) == EdgeKind::kAbove) return add_quad(v, s_, w, inner_[e]);
    if (kind(e) == EdgeKind::kBelow) return add_quad(v, inner_[e], w, t_);
    const auto next_to = [&](bool there, VertexId f, EdgeKind side, VertexId otherwise) {
      return there && kind(f) == side ? inner_[f] : otherwise;
    };
    const bool first = e == 0, last = e + 1 == m_;
    add_quad(v, w, next_to(!last, e + 1, EdgeKind::kAbove, t_),
             next_to(!first, e - 1, EdgeKind::kAbove, t_));
    add_quad(w, v, next_to(!first, e - 1, EdgeKind::kBelow, first ? b_ : s_),
             next_to(!last, e + 1, EdgeKind::kBelow, last ? b_ : s_));
  }

  void add_face_at_vertex(VertexId v) {
    if (kind(v - 1) != kind(v) || kind(v) == EdgeKind::kEdge) return;
    if (kind(v) == EdgeKind::kAbove) {
      add_quad(t_, inner_[v - 1], v, inner_[v]);
    } else {
      add_quad(s_, inner_[v], v, inner_[v - 1]);
    }
  }

  VertexId m_, t_, b_;
  VertexId s_ = kNone;
  std::vector<EdgeKind> kinds_;
  std::vector<VertexId> inner_;  // per edge: its point
};

class RingMesh : MeshBuilder {
 public:
  explicit RingMesh(std::span<const Point> points)
      : MeshBuilder(points), k_(static_cast<VertexId>(points.size() / 2)) {}

  ConvexResult build() {
    const VertexId c = add_steiner(middle(), {0, k_ / 3, 2 * k_ / 3});
    const VertexId pairs = k_ / 2;
    for (VertexId i = 0; i < 2 * pairs; i += 2) add_pair(i, c);
    for (VertexId i = 0; i < k_; ++i) {
      const bool inside_a_pair = i % 2 == 0 && i + 1 < 2 * pairs;
      if (!inside_a_pair) add_quad(c, b(i), a(i + 1), b(i + 1));
    }
    if (k_ % 2 == 1) result_.mesh.tri_vertex = {a(k_ - 1), a(0), b(k_ - 1)};
    result_.statistics.hull_points = k_;
    return std::move(result_);
  }

 private:
  VertexId a(VertexId i) const { return i % k_; }
  VertexId b(VertexId i) const { return k_ + i % k_; }

  Point middle() const {
    Point sum;
    for (VertexId i = 0; i < k_; ++i) sum = {sum.x + at(i).x / k_, sum.y + at(i).y / k_};
    return sum;
  }

  void add_pair(VertexId i, VertexId c) {
    const VertexId s = add_steiner({{a(i), a(i + 1)},
                                    {a(i + 1), a(i + 2)},
                                    {b(i), a(i + 1)},
                                    {a(i + 1), b(i + 1)},
                                    {b(i), a(i)},
                                    {a(i + 2), b(i + 1)},
                                    {b(i + 1), b(i)},
                                    {c, b(i)},
                                    {b(i + 1), c}},
                                   {b(i), a(i + 1), b(i + 1)});
    add_quad(a(i), a(i + 1), s, b(i));
    add_quad(a(i + 1), a(i + 2), b(i + 1), s);
    add_quad(c, b(i), s, b(i + 1));
  }

  VertexId k_;
};

}  // namespace

ConvexResult bhrs_line_mesh(std::span<const Point> points) {
  if (points.size() < 7)
    throw Error(ErrorCode::kBadOption, "theorem 2.2 is for seven points or more");
  return LineMesh(points).build();
}

ConvexResult bhrs_ring_mesh(std::span<const Point> points) {
  if (points.size() < 8 || points.size() % 2 != 0) {
    throw Error(ErrorCode::kBadOption,
                "theorem 2.4 is for an even number of points, eight or more");
  }
  return RingMesh(points).build();
}

}  // namespace quadloom
