// The serpentine triangulation of the convex spiral by rotating calipers (Bose and Toussaint,
// lemma 4.1 and section 4.1).
//
// The spiral p_1 ... p_n, with h points on the hull, bounds a corridor between its outer and its
// inner turns. A diagonal p_i p_j moves along it, from p_1 p_h; the calipers are parallel lines
// through p_i and p_j that turn clockwise and meet the next spiral edge at one of them:
//
//      p_i ------> p_i+1            outer edge met first: triangle p_i, p_j, p_i+1, then i advances
//        \        .                 inner edge met first: triangle p_i, p_j, p_j+1, then j advances
//         \    .
//   <---- p_j ----> p_j+1 (inner turn)
//
//   1. measure_turns    for each spiral edge the number of half turns from the direction p_h ->
//   p_1;
//                       the inner edge is one full turn ahead of the outer edge that it competes
//                       with, so two edges compare by half turns and one cross product
//   2. rotate_calipers  until j = n; ties (parallel edges): the side that did not move last, for
//   shape
//   3. fan              the rest is star-shaped from p_n: i advances alone
//   4. close            let p_r ... p_n be the last straight run of the spiral (r = n - 1 if there
//   is
//                       no longer one). The fan stops at p_n p_r-1; the triangles that are left
//                       have the apex p_r-1 and the run's edges from p_n down to p_r
//
// Degenerate input. Step 4 is the paper's fix in other words; without it the last triangles of the
// fan would be flat. Nothing else can be: a flat triangle p_i, p_i+1, p_j has a straight run from
// p_i to p_j, but the calipers advance i only if the spiral makes a full turn between p_i and p_j;
// and p_i on the line of p_j, p_j+1 would have been met by the ray before p_j (behind p_j), or the
// calipers would have passed p_i already (ahead of p_j+1). If all points are on the hull (h = n)
// the same steps 3 and 4 do: p_1 is a corner, so r > 1, and the paper's special case is not needed.
// Cost: O(n).
#include "quadrangulate/serpentine.hpp"

#include <algorithm>
#include <cstdint>

#include "kernel/predicates_inline.hpp"

namespace quadloom::quadrangulate {
namespace {

class Calipers {
 public:
  Calipers(std::span<const Point> points, const std::vector<VertexId>& spiral, std::size_t hull)
      : spiral_(spiral), hull_(hull) {
    at_.reserve(spiral.size());
    for (const VertexId v : spiral) at_.push_back(points[v]);
    measure_turns();
  }

  /// The triangles' corners. Here p_1 is spiral_[0].
  std::vector<VertexId> triangulate() {
    const std::size_t last = spiral_.size() - 1;
    corner_.reserve(3 * (2 * spiral_.size() - 2 - hull_));
    rotate_calipers(last);
    const std::size_t run = first_of_last_run(last);
    for (; outer_ + 1 < run; ++outer_) add_triangle(outer_ + 1);
    for (; inner_ > run; --inner_) add_triangle(inner_ - 1);
    return std::move(corner_);
  }

 private:
  Point at(std::size_t i) const { return at_[i]; }

  void measure_turns() {
    const Point from = at(hull_ - 1);
    const Point to = at(0);
    half_turns_.resize(spiral_.size() - 1);
    std::uint32_t full_turns = 0;
    std::uint32_t half_before = 0;
    for (std::size_t k = 0; k + 1 < spiral_.size(); ++k) {
      const int side = kernel::cross(from, to, at(k), at(k + 1));
      const bool first_half = side < 0 || (side == 0 && dot_sign(from, to, at(k), at(k + 1)) > 0);
      const std::uint32_t half = first_half ? 0 : 1;
      if (half < half_before) ++full_turns;
      half_turns_[k] = 2 * full_turns + half;
      half_before = half;
    }
  }

  void rotate_calipers(std::size_t last) {
    inner_ = hull_ - 1;
    bool outer_moved_last = false;
    while (inner_ < last) {
      const int order = compare_turns(outer_, inner_);
      const bool move_outer = order < 0 || (order == 0 && !outer_moved_last);
      add_triangle(move_outer ? outer_ + 1 : inner_ + 1);
      ++(move_outer ? outer_ : inner_);
      outer_moved_last = move_outer;
    }
  }

  /// -1 if the outer edge from p_i is met before the inner edge from p_j, 0 if they are parallel.
  int compare_turns(std::size_t i, std::size_t j) const {
    const std::uint32_t outer = half_turns_[i] + 2;
    const std::uint32_t inner = half_turns_[j];
    if (outer != inner) return outer < inner ? -1 : 1;
    return kernel::cross(at(i), at(i + 1), at(j), at(j + 1));
  }

  std::size_t first_of_last_run(std::size_t last) const {
    std::size_t run = last - 1;
    while (run > 0 && orient2d(at(run - 1), at(run), at(last)) == 0) --run;
    return run;
  }

  void add_triangle(std::size_t apex) {
    corner_.insert(corner_.end(), {spiral_[outer_], spiral_[inner_], spiral_[apex]});
  }

  const std::vector<VertexId>& spiral_;
  std::vector<Point> at_;  // in the order of the spiral: the calipers go through them one by one
  std::size_t hull_;
  std::vector<std::uint32_t> half_turns_;
  std::vector<VertexId> corner_;
  std::size_t outer_ = 0;
  std::size_t inner_ = 0;
};

void link(Triangulation& mesh, HalfedgeId a, HalfedgeId b) {
  mesh.twin[a] = b;
  mesh.twin[b] = a;
}

}  // namespace

Serpentine make_serpentine(std::span<const Point> points, const ConvexLayers& layers,
                           VertexId start) {
  Serpentine path;
  path.spiral = convex_spiral(points, layers, start);
  path.hull_points = layers.layer(0).size();
  path.corner = Calipers(points, path.spiral, path.hull_points).triangulate();
  return path;
}

Triangulation to_triangulation(std::span<const Point> points, const Serpentine& path) {
  Triangulation mesh;
  mesh.points.assign(points.begin(), points.end());
  mesh.tri_vertex = path.corner;
  mesh.twin.assign(path.corner.size(), kNone);
  std::vector<std::uint32_t> rank(points.size());
  for (std::uint32_t i = 0; i < path.spiral.size(); ++i) rank[path.spiral[i]] = i;
  std::vector<HalfedgeId> at_spiral_edge(points.size(), kNone);  // by the edge's first rank
  const auto add_spiral_edge = [&](HalfedgeId h) {
    HalfedgeId& other = at_spiral_edge[std::min(rank[mesh.origin(h)], rank[mesh.target(h)])];
    if (other != kNone) link(mesh, h, other);
    other = h;
  };
  for (std::size_t t = 0; t < path.size(); ++t) {
    const auto first = static_cast<HalfedgeId>(3 * t);
    if (t + 1 == path.size()) {
      add_spiral_edge(first + 1);
      add_spiral_edge(first + 2);
    } else if (path.replaced(t) == Replaced::kOuter) {
      link(mesh, first + 1, first + 3);
      add_spiral_edge(first + 2);
    } else {
      link(mesh, first + 2, first + 3);
      add_spiral_edge(first + 1);
    }
  }
  return mesh;
}

}  // namespace quadloom::quadrangulate
