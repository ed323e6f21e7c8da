// Strictly convex quads of a point set, Delaunay-shaped, with almost no added points.
//
// Beyond the paper: the quads of the Delaunay method (quadrangulate/points_delaunay.hpp) are strictly convex
// but for some in a thousand, and these are mended (mend.hpp). On uniform points about n / 4,000 points
// are added, where theorem 3.1 of Bremner, Hurtado, Ramaswami and Sacristan has 3n/2. Mending alone does not
// keep that bound on every set; points_convex.cpp takes the spiral's mesh where that has fewer points.
//
// An odd number of points on the hull: a point outside, which its quad needs to be strictly convex, or else a
// triangle stays.
#include "convex/points_convex_delaunay.hpp"

#include <algorithm>
#include <utility>

#include "convex/mend.hpp"
#include "convex/not_convex.hpp"
#include "quadrangulate/points_delaunay.hpp"

namespace quadloom::convex {

std::optional<ConvexResult> convex_delaunay_quadrangulation(kernel::DelaunayInOrder&& delaunay,
                                                            const ConvexOptions& options) {
  PointOptions making;
  making.progress = options.progress;
  constexpr SteinerKind kOutside[] = {SteinerKind::kOutside};
  std::span<const SteinerKind> kinds = kOutside;
  if (options.odd_boundary == OddBoundary::kTriangle) kinds = {};
  auto quads = quadrangulate::delaunay_quads(std::move(delaunay), making, kinds);
  if (!quads) return std::nullopt;

  ConvexResult result;
  if (quads->steiner) result.steiner.push_back(*quads->steiner);
  quadrangulate::PairedMesh mesh = to_paired_mesh(std::move(quads->mesh));
  result.statistics.mending =
      mend_quads(mesh, options.seed, result.steiner, options.progress, Improve::kAll);
  report_progress(options.progress, "numbering", 0);
  result.statistics.hull_points = quads->statistics.hull_points;
  result.input_vertices = quads->input_vertices;
  for (SteinerPoint& s : result.steiner) s = quads->order.given(s);
  result.mesh = quadrangulate::to_quadrangulation(std::move(mesh));
  result.not_convex =
      quads_not_convex(result.mesh);  // while neighbours are near each other in memory
  quads->order.restore(result.mesh);
  return result;
}

}  // namespace quadloom::convex
