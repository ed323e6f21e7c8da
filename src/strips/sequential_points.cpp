// Sequential triangulations of point sets.
//
// Arkin, Held, Mitchell, Skiena, "Hamiltonian triangulations for fast rendering", section 4: at most two
// points strictly inside the hull: lemma 4.2 (sequential_hull.cpp), exact and near-linear; more: a search
// with a limit (sequential_search.cpp), for small sets. Not all sets have one (theorem 4.1).
#include <utility>

#include "quadloom/strips.hpp"
#include "quadrangulate/point_input.hpp"
#include "strips/match_twins.hpp"
#include "strips/sequential_hull.hpp"
#include "strips/sequential_search.hpp"

namespace quadloom {
namespace {

/// Triangle i is i, i + 1, i + 2 of the sequence, counter-clockwise.
Triangulation triangles_of(std::vector<Point> points, std::span<const VertexId> sequence) {
  Triangulation mesh;
  mesh.points = std::move(points);
  for (std::size_t i = 0; i + 2 < sequence.size(); ++i) {
    VertexId a = sequence[i], b = sequence[i + 1];
    const VertexId c = sequence[i + 2];
    if (orient2d(mesh.points[a], mesh.points[b], mesh.points[c]) < 0) std::swap(a, b);
    mesh.tri_vertex.insert(mesh.tri_vertex.end(), {a, b, c});
  }
  mesh.twin = strips::match_twins(mesh.tri_vertex, mesh.points.size());
  return mesh;
}

std::vector<VertexId> points_inside(std::size_t count, std::span<const VertexId> hull) {
  std::vector<std::uint8_t> outer(count, 0);
  for (const VertexId v : hull) outer[v] = 1;
  std::vector<VertexId> inner;
  for (VertexId v = 0; v < count; ++v) {
    if (outer[v] == 0) inner.push_back(v);
  }
  return inner;
}

}  // namespace

SequentialResult sequential_triangulation(std::span<const Point> input,
                                          const SequentialOptions& options) {
  DistinctPoints distinct = quadrangulate::points_of_the_plane(input);
  const std::vector<VertexId> hull = convex_hull(distinct.points);
  const std::vector<VertexId> inner = points_inside(distinct.points.size(), hull);
  SequentialResult out;
  out.input_to_vertex = std::move(distinct.input_to_vertex);
  out.inner_points = inner.size();
  if (inner.size() <= 2) {
    auto found = strips::sequence_of_few_inner(distinct.points, hull, inner);
    out.answer = found ? Answer::kYes : Answer::kNo;
    if (found) out.sequence = std::move(*found);
  } else if (distinct.points.size() <= strips::kMostSequentialPoints) {
    strips::SequenceFound found =
        strips::search_sequence(distinct.points, options.work_at_most, options.progress);
    out.answer = found.answer;
    out.sequence = std::move(found.sequence);
    out.work = found.work;
  }
  if (out.answer == Answer::kYes) out.mesh = triangles_of(std::move(distinct.points), out.sequence);
  return out;
}

}  // namespace quadloom
