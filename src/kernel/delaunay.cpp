// The Delaunay triangulation of any points.
//
// Incremental insertion (Bowyer 1981, Watson 1981) in biased randomized rounds (Amenta, Choi, Rote
// 2003) along a Hilbert curve. O(n log n) expected for any input; no recursion.
//
// Steps:
//   1. spatial_order     the points along the curve, copied in that order
//   2. number_distinct   equal points, now neighbours, are merged
//   3. insertion_order   rounds, each eight times the one before, chosen by a fixed hash
//                        (insertion_order.cpp)
//   4. first_triangle    three points that are not on a line, with three ghost triangles
//   5. insert            for each point: locate (a walk from the last point), collect_cavity (the
//                        triangles whose circle holds the point), fill_cavity (its star);
//                        delaunay_inserter.cpp, and delaunay_ranges.cpp for large rounds, in which
//                        ranges of the curve are filled at the same time
//   6. drop_ghosts       a last triangle moves into the place of each ghost
//   7. emit              the triangles over the caller's numbers; or emit_in_order, sorted along
//                        the curve (delaunay_in_order.hpp)
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
// Threads: from 2^16 points on the large rounds are cut into ranges, and the other steps into
// blocks, which depend on the points alone. So the result is the same on any number of threads.
//
// Degenerate input: repeated points, grids, circles, all points but one on a line, any magnitude.
// Cost: about nine incircle tests, two at a time, and five orientations a point; 136 bytes a point
// at the peak, 68 of them the result.
#include <algorithm>
#include <string>
#include <utility>

#include "core/large_array.hpp"
#include "core/parallel.hpp"
#include "kernel/delaunay_builder.hpp"
#include "kernel/delaunay_in_order.hpp"
#include "kernel/input_points.hpp"
#include "quadloom/kernel.hpp"

namespace quadloom {
namespace {

using kernel::DelaunayBuilder;

constexpr std::size_t kBlock = std::size_t{1} << 15;  // of triangles, for a thread

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

/// Room for the triangles. The memory is new, so this is work, and each array is filled apart.
void resize(Triangulation& mesh, std::size_t triangles) {
  parallel_invoke([&] { mesh.tri_vertex = large_vector<VertexId>(3 * triangles); },
                  [&] { mesh.twin = large_vector<HalfedgeId>(3 * triangles); });
}

/// The triangles as they were built, each corner under its vertex number. Their order is that of
/// the last rounds along the curve, one after the other.
void emit(std::span<const DelaunayBuilder::Triangle> triangles, std::span<const VertexId> vertex,
          Triangulation& mesh) {
  resize(mesh, triangles.size());
  parallel_for_blocks(triangles.size(), kBlock, [&](std::size_t begin, std::size_t end) {
    std::size_t h = 3 * begin;
    for (const DelaunayBuilder::Triangle& t : triangles.subspan(begin, end - begin)) {
      for (std::size_t i = 0; i < 3; ++i, ++h) {
        mesh.tri_vertex[h] = vertex[t.v[i]];
        mesh.twin[h] = t.twin[i] == kNone ? kNone : 3 * (t.twin[i] >> 2) + (t.twin[i] & 3U);
      }
    }
  });
}

/// Where each triangle goes if they are sorted by the first of their vertices.
std::vector<TriangleId> places_along_curve(std::span<const DelaunayBuilder::Triangle> triangles,
                                           std::size_t vertices) {
  const auto first = [](const DelaunayBuilder::Triangle& t) {
    return std::min({t.v[0], t.v[1], t.v[2]});
  };
  std::vector<TriangleId> next(vertices + 1), place = large_vector<TriangleId>(triangles.size());
  for (const DelaunayBuilder::Triangle& t : triangles) ++next[first(t) + 1];
  for (std::size_t v = 0; v < vertices; ++v) next[v + 1] += next[v];
  for (std::size_t t = 0; t < place.size(); ++t) place[t] = next[first(triangles[t])]++;
  return place;
}

void emit_in_order(std::span<const DelaunayBuilder::Triangle> triangles, Triangulation& mesh) {
  std::vector<TriangleId> place;
  parallel_invoke([&] { place = places_along_curve(triangles, mesh.points.size()); },
                  [&] { resize(mesh, triangles.size()); });
  parallel_for_blocks(triangles.size(), kBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t twin = triangles[t].twin[i];
        mesh.tri_vertex[3 * place[t] + i] = triangles[t].v[i];
        mesh.twin[3 * place[t] + i] = twin == kNone ? kNone : 3 * place[twin >> 2] + (twin & 3U);
      }
    }
  });
}

/// Steps 1 to 6.
struct Built {
  DelaunayBuilder builder;
  std::vector<VertexId> vertex, input_to_vertex;
};

Built build(std::span<const Point> input) {
  kernel::check_points(input, std::min(kMaxPoints, DelaunayBuilder::kMaxDelaunayPoints));
  std::vector<VertexId> order = spatial_order(input);
  std::vector<Point> in_order = kernel::gather(input, order);
  std::vector<VertexId> input_to_vertex;
  const std::size_t count = kernel::number_distinct(in_order, order, input_to_vertex);
  if (count < 3) {
    throw Error(ErrorCode::kTooFewPoints,
                "a triangulation needs three distinct points, not " + std::to_string(count));
  }
  std::vector<VertexId> vertex =
      drop_duplicates(in_order, std::move(order), input_to_vertex, count);
  Built out{DelaunayBuilder(std::move(in_order)), std::move(vertex), std::move(input_to_vertex)};
  if (!out.builder.build()) {
    throw Error(ErrorCode::kAllCollinear,
                "all " + std::to_string(count) + " distinct points are on one line");
  }
  return out;
}

}  // namespace

DelaunayResult delaunay(std::span<const Point> input) {
  Built built = build(input);
  built.builder.take_points();  // and lets them go, before the result takes its memory
  DelaunayResult out;
  out.input_to_vertex = std::move(built.input_to_vertex);
  out.mesh.points = kernel::points_by_number(input, out.input_to_vertex, built.vertex.size());
  emit(built.builder.triangles(), built.vertex, out.mesh);
  return out;
}

kernel::DelaunayInOrder kernel::delaunay_in_order(std::span<const Point> input) {
  DelaunayInOrder out;
  Built built = build(input);
  out.mesh.points = built.builder.take_points();
  emit_in_order(built.builder.triangles(), out.mesh);
  out.vertex = std::move(built.vertex);
  out.input_to_vertex = std::move(built.input_to_vertex);
  return out;
}

}  // namespace quadloom
