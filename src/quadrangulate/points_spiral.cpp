// Quads from the serpentine triangulation of the convex spiral: the SRC algorithm (Bose and
// Toussaint, section 4).
//
// Guarantee (theorems 4.2 to 4.4): no Steiner point if the number h of hull points is even, one if
// it is odd.
//
//   1. convex_layers      of the points; the outermost is the hull
//   2. choose_odd_edge    if h is odd: a hull edge near which (or on which) the added point has a
//                         place. The spiral then starts at that edge's first end, a corner, since
//                         the first triangle of the path is the one at the hull edge from the
//                         spiral's start
//   3. make_serpentine    the path of 2n - 2 - h triangles
//   4. pair_from_the_end  every other diagonal goes; h odd: the first triangle is left over, and
//   5. add_odd_point      makes it a quad
//
// Differs from the paper: the spiral may start at any hull corner, since next to a straight run of
// hull points there is no place outside (see odd_boundary.hpp). Degenerate input: see
// serpentine.cpp. Cost: O(n log n) for the layers, O(n) for the rest.
#include "quadrangulate/points_spiral.hpp"

#include "quadloom/kernel.hpp"
#include "quadrangulate/odd_boundary.hpp"
#include "quadrangulate/serpentine.hpp"

namespace quadloom::quadrangulate {
namespace {

/// The union of triangles t and t + 1 of the path.
///
///   outer --- apex'         outer replaced: outer, inner, apex', apex
///     | \     / |           inner replaced: outer, inner, apex, apex'
///     |  apex   |
///   inner ----- apex'
void add_quad(const Serpentine& path, std::size_t t, std::vector<VertexId>& quads) {
  const VertexId apex = path.apex(t);
  const VertexId next_apex = path.apex(t + 1);
  const bool outer = path.replaced(t) == Replaced::kOuter;
  quads.insert(quads.end(),
               {path.outer(t), path.inner(t), outer ? next_apex : apex, outer ? apex : next_apex});
}

std::vector<VertexId> pair_from_the_end(const Serpentine& path) {
  std::vector<VertexId> quads;
  quads.reserve(2 * path.size());
  for (std::size_t t = path.size() % 2; t < path.size(); t += 2) add_quad(path, t, quads);
  return quads;
}

void add_odd_point(const Serpentine& path, const OddPlace& odd, PointResult& result) {
  const auto s = static_cast<VertexId>(result.mesh.points.size());
  result.mesh.points.push_back(odd.place);
  result.mesh.quad_vertex.insert(result.mesh.quad_vertex.end(),
                                 {path.outer(0), s, path.inner(0), path.apex(0)});
  result.steiner.push_back({s, odd.kind, {path.outer(0), path.inner(0), kNone}});
}

}  // namespace

PointResult spiral_quadrangulation(const std::vector<Point>& points, const PointOptions& options) {
  const ConvexLayers layers = convex_layers(points, options.progress);
  report_progress(options.progress, "spiral", 0);
  const auto hull = layers.layer(0);
  const bool odd = hull.size() % 2 == 1;
  const bool add_point = odd && options.odd_boundary != OddBoundary::kTriangle;
  OddEdge edge;
  if (add_point) edge = choose_odd_edge(points, hull, options.odd_boundary, EdgeStart::kCorner);

  const Serpentine path = make_serpentine(points, layers, hull[edge.index]);
  PointResult result;
  result.input_vertices = points.size();
  result.statistics.hull_points = hull.size();
  result.mesh.points = points;
  result.mesh.quad_vertex = pair_from_the_end(path);
  if (add_point) {
    add_odd_point(path, edge.odd, result);
  } else if (odd) {
    result.mesh.tri_vertex = {path.outer(0), path.inner(0), path.apex(0)};
  }
  return result;
}

}  // namespace quadloom::quadrangulate
