// Delaunay-shaped quadrangulation of a point set with at most one Steiner point.
//
// Guarantee: Bose and Toussaint's (theorems 3.1 and 4.3), which their own algorithms meet with long
// thin quads; this one goes past the papers. The count holds by construction, since a walk that
// cannot finish hands the whole set to the spiral method; that has not been seen on any input,
// tests and benchmarks count it.
//
// Steps:
//   1. pair_by_shape      greedy matching on the dual of the Delaunay triangulation, strictly convex pairs only
//   2. walk_to_hull       if the number of hull points is odd: the left-over triangle that is nearest to a good hull
//                         edge walks there and becomes a quad with the one Steiner point
//   3. walk_convexly      left-over triangles walk towards each other by cheap searches that leave strictly convex quads
//   4. walk_deeply        small meshes: thorough searches for such ways
//   5. walk_anyhow        the others pair up by any quads
//   6. walk_together      what these searches do not bring together, if anything
//   7. slide_diagonals    hill climb on shape, see diagonal_slides.hpp
//
// Large meshes: steps 3 and 7 go over ranges of the faces on several threads, then over what is at their borders
// (face_range.hpp). The ranges depend on the mesh alone, and so does the result.
//
// Steps 3, 5 and 7 see all of the mesh and work on one record a quad (quad_mesh.hpp), the others on triangles.
//
// Degenerate input: all decisions are the kernel's exact predicates; collinear hull points are hull
// points; in wrapped quads (an inner point of degree two) a walk turns the wheel, see
// paired_mesh.hpp. Vertices and triangles are numbered along a curve (kernel/delaunay_in_order.hpp), so that
// all passes and searches stay near each other in memory. Cost: O(n log n) for the triangulation, O(n) for the matching, and short
// searches; near-linear in practice.
#include "quadrangulate/points_delaunay.hpp"

#include <utility>

#include "dual/greedy_matching.hpp"
#include "quadloom/kernel.hpp"
#include "quadrangulate/diagonal_slides.hpp"
#include "quadrangulate/hull_walk.hpp"
#include "quadrangulate/odd_boundary.hpp"
#include "quadrangulate/walk_rounds.hpp"

namespace quadloom::quadrangulate {
namespace {

constexpr std::size_t kSmall = 100'000;  // faces; in larger meshes there are enough other ways

PairedMesh pair_by_shape(Triangulation&& delaunay) {
  std::vector<HalfedgeId> mate =
      dual::greedy_matching(delaunay, dual::GreedyOrder::kShapeAndScarcity).mate;
  return {std::move(delaunay), std::move(mate), {}, {}};
}

/// Thorough walks, which are for triangles in pairs.
template <typename Walk>
void walk_in_pairs(QuadMesh& mesh, PointStatistics& statistics, Walk walk) {
  PairedMesh paired = to_paired_mesh(std::move(mesh));
  Walker walker(paired);
  walk(walker, paired);
  statistics.walks += walker.walks();
  statistics.walk_steps += walker.steps();
  mesh = to_quad_mesh(std::move(paired));
}

/// Returns how many free triangles are left.
std::size_t walk(QuadMesh& mesh, PointStatistics& statistics, const Progress& progress) {
  const WalkCounts near = walk_convexly(mesh, progress);
  if (mesh.face_count() < kSmall && free_triangles(mesh).size() > 1) {
    walk_in_pairs(mesh, statistics, walk_deeply);
  }
  const WalkCounts far = walk_anyhow(mesh);
  if (free_triangles(mesh).size() > 1) {
    walk_in_pairs(mesh, statistics, [&](Walker& walker, const PairedMesh& paired) {
      walk_together(walker, paired, kLastPlanarRounds, progress);
    });
  }
  statistics.walks += near.walks + far.walks;
  statistics.walk_steps += near.steps + far.steps;
  return free_triangles(mesh).size();
}

}  // namespace

std::optional<DelaunayQuads> delaunay_quads(kernel::DelaunayInOrder&& delaunay,
                                            const PointOptions& options,
                                            std::span<const SteinerKind> kinds) {
  DelaunayQuads out;
  out.input_vertices = delaunay.mesh.points.size();
  report_progress(options.progress, "pairing", 0);
  out.order = VertexOrder(std::move(delaunay.vertex));
  PairedMesh paired = pair_by_shape(std::move(delaunay.mesh));
  const std::vector<TriangleId> free = free_triangles(paired);
  out.statistics.unmatched_greedy = free.size();

  const HullOfMesh hull(paired.tri);
  out.statistics.hull_points = hull.size();
  const bool odd = hull.size() % 2 == 1;
  if (odd && !kinds.empty()) {
    Walker walker(paired);
    out.steiner = walk_to_hull(paired, walker, hull, free, kinds);
    out.statistics.walks += walker.walks();
    out.statistics.walk_steps += walker.steps();
    if (!out.steiner && kinds.size() == 2) return std::nullopt;  // both kinds: there is always one
  }
  out.mesh = to_quad_mesh(std::move(paired));
  const std::size_t left = walk(out.mesh, out.statistics, options.progress);
  if (left != (odd && !out.steiner ? 1U : 0U)) return std::nullopt;

  report_progress(options.progress, "improving", 0);
  out.statistics.slides = slide_diagonals(out.mesh);
  return out;
}

std::optional<PointResult> delaunay_quadrangulation(kernel::DelaunayInOrder&& delaunay,
                                                    const PointOptions& options) {
  const auto wish = kinds_by_wish(options.odd_boundary);
  std::span<const SteinerKind> kinds = wish;
  if (options.odd_boundary == OddBoundary::kTriangle) kinds = {};
  auto quads = delaunay_quads(std::move(delaunay), options, kinds);
  if (!quads) return std::nullopt;
  report_progress(options.progress, "numbering", 0);
  PointResult result;
  result.input_vertices = quads->input_vertices;
  result.statistics = quads->statistics;
  if (quads->steiner) result.steiner.push_back(quads->order.given(*quads->steiner));
  result.mesh = to_quadrangulation(std::move(quads->mesh));
  quads->order.restore(result.mesh);
  return result;
}

}  // namespace quadloom::quadrangulate
