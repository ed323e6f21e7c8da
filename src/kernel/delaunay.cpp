// The Delaunay triangulation of any points.
//
// Incremental insertion (Bowyer 1981, Watson 1981) in biased randomized rounds (Amenta, Choi, Rote
// 2003) along a Hilbert curve. O(n log n) expected for any input; no recursion.
//
// Steps:
//   1. spatial_order     the points along the curve, copied in that order
//   2. number_distinct   equal points, now neighbours, are merged
//   3. insertion_order   rounds, each eight times the one before, chosen by a fixed hash
//   4. first_triangle    three points that are not on a line, with three ghost triangles
//   5. insert            for each point: locate (a walk from the last point), collect_cavity (the
//                        triangles whose circle holds the point), fill_cavity (its star)
//   6. emit              the triangles in spatial order over the caller's numbers, without ghosts
//
// The hull: beyond each hull edge is a ghost triangle with a corner at infinity, in conflict with
// the points strictly beyond the edge and with the points inside the edge itself. So no point needs
// a special case, and a point on a hull edge splits it: collinear boundary points all stay on the
// boundary and no flat triangle arises. The point at infinity has NaN coordinates; no filter is
// proven for NaN, so ghosts are told apart on the rare path alone.
//
// Ties: four points on a circle are decided as if each point was lifted off the paraboloid by an
// infinitesimal, the lexicographically larger by far the more (Devillers and Teillaud 2003). This
// is one consistent set of lifted points, so the walk and the cavities are those of a true regular
// triangulation: the result depends on the set of points alone, not on their order. In a lattice,
// all diagonals are parallel. Orientations are never perturbed.
//
// Degenerate input: repeated points, grids, circles, all points but one on a line, any magnitude.
// Cost: about ten incircle tests and three orientations a point; 136 bytes a point at the peak, 68
// of them the result.
#include <algorithm>
#include <string>
#include <utility>

#include "kernel/delaunay_builder.hpp"
#include "kernel/input_points.hpp"
#include "quadloom/kernel.hpp"

namespace quadloom {
namespace {

using kernel::DelaunayBuilder;

/// The vertex number of each distinct point in the spatial order, whose duplicates are dropped from
/// `in_order`.
std::vector<VertexId> drop_duplicates(std::vector<Point>& in_order, std::vector<VertexId> order,
                                      std::span<const VertexId> input_to_vertex,
                                      std::size_t distinct) {
  if (distinct == order.size()) return order;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i > 0 && in_order[i] == in_order[kept - 1]) continue;
    in_order[kept] = in_order[i];
    order[kept++] = input_to_vertex[order[i]];
  }
  in_order.resize(kept);
  order.resize(kept);
  return order;
}

/// The triangles sorted by the first of their corners along the curve (a counting sort), each
/// corner under its vertex number.
void emit(const DelaunayBuilder& builder, std::span<const VertexId> vertex, Triangulation& mesh) {
  const auto triangles = builder.triangles();
  const std::uint32_t ghost = builder.ghost();
  const auto is_ghost = [ghost](const DelaunayBuilder::Triangle& t) {
    return t.v[0] == ghost || t.v[1] == ghost || t.v[2] == ghost;
  };
  const auto first_corner = [](const DelaunayBuilder::Triangle& t) {
    return std::min({t.v[0], t.v[1], t.v[2]});
  };
  std::vector<std::uint32_t> place(ghost + std::size_t{1}, 0);
  for (const auto& t : triangles) {
    if (!is_ghost(t)) ++place[first_corner(t) + 1];
  }
  for (std::size_t i = 1; i < place.size(); ++i) place[i] += place[i - 1];
  std::vector<std::uint32_t> first_halfedge(triangles.size(), kNone);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (!is_ghost(triangles[t])) first_halfedge[t] = 3 * place[first_corner(triangles[t])]++;
  }
  mesh.tri_vertex.resize(3 * std::size_t{place.back()});
  mesh.twin.resize(3 * std::size_t{place.back()});
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const std::uint32_t h = first_halfedge[t];
    if (h == kNone) continue;
    for (std::uint32_t i = 0; i < 3; ++i) {
      const std::uint32_t other = first_halfedge[triangles[t].twin[i] >> 2];
      mesh.tri_vertex[h + i] = vertex[triangles[t].v[i]];
      mesh.twin[h + i] = other == kNone ? kNone : other + (triangles[t].twin[i] & 3U);
    }
  }
}

}  // namespace

DelaunayResult delaunay(std::span<const Point> input) {
  kernel::check_points(input, std::min(kMaxPoints, DelaunayBuilder::kMaxDelaunayPoints));
  DelaunayResult out;
  std::vector<VertexId> order = spatial_order(input);
  std::vector<Point> in_order = kernel::gather(input, order);
  const std::size_t count = kernel::number_distinct(in_order, order, out.input_to_vertex);
  if (count < 3) {
    throw Error(ErrorCode::kTooFewPoints,
                "a triangulation needs three distinct points, not " + std::to_string(count));
  }
  const std::vector<VertexId> vertex =
      drop_duplicates(in_order, std::move(order), out.input_to_vertex, count);
  DelaunayBuilder builder(std::move(in_order));
  if (!builder.build()) {
    throw Error(ErrorCode::kAllCollinear,
                "all " + std::to_string(count) + " distinct points are on one line");
  }
  out.mesh.points = kernel::points_by_number(input, out.input_to_vertex, count);
  emit(builder, vertex, out.mesh);
  return out;
}

}  // namespace quadloom
