// Strictly convex quads of a point set by pentagons (Ramaswami, Ramos and Toussaint, theorem 4.2): at most
// 7 ceil(t / 6) Steiner points, t = 2n - 2 - h, for an odd h one more outside or one triangle. The spiral
// method's bound is better (theirs came later); this is for those who want to see the theorem.
//
//   1. path_of_points  the path of triangles (path_pieces.hpp)
//   2. for each six triangles of it, two pentagons a b c d e and b a f g h:
//      place_between   a Steiner point s on the edge between them
//      two patches     lemma 4.1: each pentagon with s on its boundary into at most five strictly convex
//                      quads, with at most three points inside
//   3. the five or fewer that are left: the cheapest pieces
//
//              d ------- e
//             /           \             Lemma 4.1 is a case of the hexagon's theorem: the corner s is flat
//            c             a             (r), so three points are enough whatever the others are. Three
//             \          / \            triangles around a point are a quad with a point inside.
//              b --- s --    f
//               \          /            Rounding may put s beside the edge: it then makes one pentagon
//                h ------ g             smaller and the other larger, by a triangle that is inside the
//                                       triangle of the path there, which is checked exactly.
// Where no doubles are found for six triangles, they are cut into the cheapest pieces.
//
// Cost: O(n log n) for the layers, then O(n).
#include "convex/points_convex_pentagons.hpp"

#include <optional>
#include <utility>

#include "convex/path_pieces.hpp"
#include "kernel/predicates_inline.hpp"

namespace quadloom::convex {
namespace {

constexpr std::size_t kSix = 6;

bool inside(Point p, Point a, Point b, Point c) {
  return kernel::orient(a, b, p) > 0 && kernel::orient(b, c, p) > 0 && kernel::orient(c, a, p) > 0;
}

bool between(Point p, Point a, Point b) {
  const bool in_x = (a.x < p.x && p.x < b.x) || (b.x < p.x && p.x < a.x);
  const bool in_y = (a.y < p.y && p.y < b.y) || (b.y < p.y && p.y < a.y);
  return in_x || in_y;
}

struct Between {
  Point at;
  bool left;  // in the triangle left of the edge, or on it
};

/// The middle of the edge a b, left of which is the triangle a b c and right of it b a d; none if rounding
/// moves it out of both.
std::optional<Between> place_between(Point a, Point b, Point c, Point d) {
  const Point s = {a.x / 2 + b.x / 2, a.y / 2 + b.y / 2};
  const int side = kernel::orient(a, b, s);
  const bool good = side == 0  ? between(s, a, b)
                    : side > 0 ? inside(s, a, b, c)
                               : inside(s, b, a, d);
  if (!good) return std::nullopt;
  return Between{s, side >= 0};
}

class SixBySix {
 public:
  SixBySix(const Serpentine& path, const Pieces& pieces, ConvexResult& result)
      : path_(path), pieces_(pieces), result_(result), builder_(path, pieces, result) {}

  void build(std::size_t first, const Progress& progress) {
    std::size_t t = first;
    for (; t + kSix <= path_.size(); t += kSix) {
      if ((t - first) % (kSix << 14) == 0) {
        report_progress(progress, "convex quads",
                        static_cast<double>(t) / static_cast<double>(path_.size()));
      }
      if (!add_six(t)) builder_.build(t, cheapest_pieces(pieces_, t, t + kSix, {}));
    }
    builder_.build(t, cheapest_pieces(pieces_, t, path_.size(), {}));
  }

 private:
  /// The edge between triangles t + 2 and t + 3 has the latter on its left from outer to inner.
  bool add_six(std::size_t t) {
    const VertexId a = path_.outer(t + 3), b = path_.inner(t + 3);
    const VertexId before = opposite(t + 2, a, b), behind = path_.apex(t + 3);
    const auto& at = result_.mesh.points;
    const auto place = place_between(at[a], at[b], at[behind], at[before]);
    if (!place) return false;
    const auto s = static_cast<VertexId>(at.size());
    auto one = pieces_.patch_of_pentagon(t, b, a, place->at, s);
    auto other = pieces_.patch_of_pentagon(t + 3, a, b, place->at, s);
    if (!one.patch || !other.patch) return false;
    result_.mesh.points.push_back(place->at);
    result_.steiner.push_back({s, SteinerKind::kInner, {a, b, place->left ? behind : before}});
    if (!place->left)
      std::swap(result_.steiner.back().parents[0], result_.steiner.back().parents[1]);
    // With s beside the edge a point of one patch may be in a triangle of the other pentagon.
    builder_.add_patch(std::move(one), t, kSix);
    builder_.add_patch(std::move(other), t, kSix);
    return true;
  }

  VertexId opposite(std::size_t t, VertexId a, VertexId b) const {
    for (const VertexId v : {path_.outer(t), path_.inner(t)}) {
      if (v != a && v != b) return v;
    }
    return path_.apex(t);
  }

  const Serpentine& path_;
  const Pieces& pieces_;
  ConvexResult& result_;
  PathBuilder builder_;
};

}  // namespace

ConvexResult convex_pentagon_quadrangulation(const std::vector<Point>& points,
                                             const ConvexOptions& options) {
  PathOfPoints given = path_of_points(points, options);
  const Pieces pieces(points, given.path);
  SixBySix(given.path, pieces, given.result).build(given.first, options.progress);
  return std::move(given.result);
}

}  // namespace quadloom::convex
