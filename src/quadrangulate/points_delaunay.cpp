// Delaunay-shaped quadrangulation of a point set with at most one Steiner point.
//
// Guarantee: Bose and Toussaint's (theorems 3.1 and 4.3), which their own algorithms meet with long
// thin quads; this one goes past the papers. The count holds by construction, since a walk that
// cannot finish hands the whole set to the spiral method; that has not been seen on any input,
// tests and benchmarks count it.
//
// Steps:
//   1. pair_by_shape      greedy matching on the dual of the Delaunay triangulation, strictly
//   convex pairs only
//   2. walk_to_hull       if the number of hull points is odd: the left-over triangle that is
//   nearest to a good hull
//                         edge walks there and becomes a quad with the one Steiner point
//   3. walk_together      left-over triangles walk towards each other, near ones first; only
//   strictly convex quads
//                         may be left behind as long as that is possible
//   4. slide_diagonals    hill climb on shape, see diagonal_slides.hpp
//
// Degenerate input: all decisions are the kernel's exact predicates; collinear hull points are hull
// points; in wrapped quads (an inner point of degree two) a walk turns the wheel, see
// paired_mesh.hpp. Cost: O(n log n) for the triangulation, O(n) for the matching, and short
// searches; near-linear in practice.
#include "quadrangulate/points_delaunay.hpp"

#include <algorithm>
#include <utility>

#include "quadloom/dual.hpp"
#include "quadloom/kernel.hpp"
#include "quadrangulate/diagonal_slides.hpp"
#include "quadrangulate/hull_walk.hpp"
#include "quadrangulate/walk_rounds.hpp"

namespace quadloom::quadrangulate {
namespace {

/// The input's vertices in the order in which the triangles name them, so that neighbours in the
/// plane are neighbours in memory: the triangles are in spatial order already, the input need not
/// be. Takes a third off the time of the walks.
class VertexOrder {
 public:
  explicit VertexOrder(Triangulation& mesh) : given_(mesh.points) {
    std::vector<VertexId> place(given_.size(), kNone);
    for (VertexId& v : mesh.tri_vertex) {
      if (place[v] == kNone) {
        place[v] = static_cast<VertexId>(order_.size());
        mesh.points[place[v]] = given_[v];
        order_.push_back(v);
      }
      v = place[v];
    }
  }

  VertexId given(VertexId v) const { return v < order_.size() ? order_[v] : v; }

  /// Back to the input's order; Steiner points keep their places behind.
  void restore(Quadrangulation& mesh) const {
    for (VertexId& v : mesh.quad_vertex) v = given(v);
    for (VertexId& v : mesh.tri_vertex) v = given(v);
    std::copy(given_.begin(), given_.end(), mesh.points.begin());
  }

 private:
  std::vector<Point> given_;
  std::vector<VertexId> order_;
};

PairedMesh pair_by_shape(Triangulation&& delaunay) {
  std::vector<HalfedgeId> mate = greedy_shape_matching(delaunay).mate;
  return {std::move(delaunay), std::move(mate), {}, {}};
}

}  // namespace

std::optional<PointResult> delaunay_quadrangulation(Triangulation&& delaunay,
                                                    const PointOptions& options) {
  PointResult result;
  result.input_vertices = delaunay.points.size();
  report_progress(options.progress, "pairing", 0);
  const VertexOrder order(delaunay);
  PairedMesh mesh = pair_by_shape(std::move(delaunay));
  const std::vector<TriangleId> free = free_triangles(mesh);
  result.statistics.unmatched_greedy = free.size();

  Walker walker(mesh);
  const HullOfMesh hull(mesh.tri);
  result.statistics.hull_points = hull.size();
  const bool odd = hull.size() % 2 == 1;
  if (odd && options.odd_boundary != OddBoundary::kTriangle) {
    auto placed = walk_to_hull(mesh, walker, hull, free, options.odd_boundary);
    if (!placed) return std::nullopt;
    for (VertexId& parent : placed->parents) {
      if (parent != kNone) parent = order.given(parent);
    }
    result.steiner.push_back(*placed);
  }
  walk_together(walker, mesh, kPlanarRounds, options.progress);
  const std::size_t left = free_triangles(mesh).size();
  if (left != (odd && options.odd_boundary == OddBoundary::kTriangle ? 1U : 0U))
    return std::nullopt;

  report_progress(options.progress, "improving", 0);
  result.statistics.slides = slide_diagonals(mesh);
  result.statistics.walks = walker.walks();
  result.statistics.walk_steps = walker.steps();
  result.mesh = to_quadrangulation(mesh);
  order.restore(result.mesh);
  return result;
}

}  // namespace quadloom::quadrangulate
