// Convex parts of a polygon: merged triangles (merge_to_convex.cpp), and where those may not be the
// fewest and the search can be done in time, the fewest (fewest_cuts.cpp).
#include <algorithm>

#include "quadloom/strips.hpp"
#include "strips/convex_parts.hpp"

namespace quadloom {
namespace {

/// Corners of the inside with more than half a turn; each angle that it has at a vertex counts.
std::size_t reflex_corners(const Triangulation& mesh) {
  std::size_t count = 0;
  for (HalfedgeId h = 0; h < mesh.twin.size(); ++h) {
    if (mesh.twin[h] != kNone) continue;
    HalfedgeId before = previous_halfedge(h);
    while (mesh.twin[before] != kNone) before = previous_halfedge(mesh.twin[before]);
    const Point a = mesh.points[mesh.origin(before)], b = mesh.points[mesh.origin(h)],
                c = mesh.points[mesh.target(h)];
    count += orient2d(a, b, c) < 0 ? 1 : 0;
  }
  return count;
}

/// Each reflex corner needs a cut, and a cut has two ends. Around pieces and holes there is a part more
/// than cuts, plus the pieces but one, less the holes: 1 - (t + 2 - sides) / 2 of any t triangles. Without
/// holes the merging leaves at most four times what must be.
std::size_t least_parts(const Triangulation& mesh, std::size_t merged) {
  const auto sides = std::count(mesh.twin.begin(), mesh.twin.end(), kNone);
  const auto triangles = static_cast<std::ptrdiff_t>(mesh.triangle_count());
  const auto cuts = static_cast<std::ptrdiff_t>((reflex_corners(mesh) + 1) / 2);
  const auto parts = std::max<std::ptrdiff_t>(cuts + 1 - (triangles + 2 - sides) / 2, 1);
  const std::size_t quarter = strips::is_disc(mesh) ? (merged + 3) / 4 : 1;
  return std::max(static_cast<std::size_t>(parts), quarter);
}

void add_parts(PolygonMesh& mesh, const std::vector<std::vector<VertexId>>& parts) {
  for (const auto& part : parts) mesh.add_face(part);
}

/// None if that is too much work.
std::optional<ConvexDecomposition> exactly(const ConstrainedResult& triangulation,
                                           std::size_t most_steps) {
  if (!strips::is_disc(triangulation.mesh)) return std::nullopt;
  const strips::PolygonDisc disc = strips::disc_of(triangulation);
  const auto cuts = strips::fewest_cuts(disc, most_steps);
  if (!cuts) return std::nullopt;
  auto parts = strips::parts_between(disc, *cuts);
  for (auto& part : parts) {
    for (auto& corner : part) corner = disc.vertex[corner];
  }
  ConvexDecomposition out;
  out.at_least = parts.size();
  out.parts.points = disc.mesh.points;
  out.input_to_vertex = disc.input_to_vertex;
  add_parts(out.parts, parts);
  return out;
}

ConvexDecomposition by_merging(const ConstrainedResult& triangulation) {
  const auto parts = strips::merge_to_convex(triangulation.mesh);
  ConvexDecomposition out;
  out.at_least = least_parts(triangulation.mesh, parts.size());
  out.parts.points = triangulation.mesh.points;
  out.input_to_vertex = triangulation.input_to_vertex;
  add_parts(out.parts, parts);
  return out;
}

}  // namespace

ConvexDecomposition convex_decomposition(const Polygon& polygon,
                                         const DecompositionOptions& options) {
  const ConstrainedResult triangulation = constrained_delaunay(polygon);
  ConvexDecomposition merged = by_merging(triangulation);
  if (merged.is_fewest() || options.exact_steps == 0) return merged;
  auto fewest = exactly(triangulation, options.exact_steps);
  return fewest ? std::move(*fewest) : std::move(merged);
}

}  // namespace quadloom
