// Pairs of triangles become quads, and the triangles that are left over become quads too.
//
// Ramaswami, Ramos and Toussaint, section 3 (the proposition: quads by removing edges alone if and only
// if the dual graph has a perfect matching) and its maximum-weight variant; beyond the paper what becomes
// of the rest. Guarantee: without Leftover::kTriangle, OddBoundary::kTriangle or min_quality all faces are
// quads; boundary, edges to keep and regions stay; the only points at borders are those that parity
// demands (odd_parts.hpp).
//
// Steps:
//   1. cut_along_kept_edges   nothing reaches over them (mesh_parts.hpp)
//   2. match_triangles        the pairs (triangulation_matching.hpp)
//   3. make_parts_even        points at the borders of odd parts (odd_parts.hpp)
//   4. walk_together          left-over triangles meet by re-cut pentagons (walk_rounds.hpp)
//   5. cross_together         those that do not meet so cross quads with inner Steiner points
//   6. or_with_fewer_points   if that took several points, the Q-percolation may do with fewer
//
// In the plane step 5 is seldom needed after step 4, as a rule in corridors of a triangle's width. On a
// surface walks are allowed only where it is rather flat. They could also make an edge twice there (in a
// closed part of few triangles); then the work is done again without walks.
// Cost: near-linear in practice, see matching.md.
#include "quadrangulate/triangulation_pair.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "core/step_reports.hpp"
#include "quadrangulate/mesh_parts.hpp"
#include "quadrangulate/odd_parts.hpp"
#include "quadrangulate/steiner_crossing.hpp"
#include "quadrangulate/triangulation_matching.hpp"
#include "quadrangulate/triangulation_q_percolation.hpp"
#include "quadrangulate/triangulation_result.hpp"
#include "quadrangulate/walk_rounds.hpp"

namespace quadloom::quadrangulate {
namespace {

enum class Walks : std::uint8_t { kAllowed, kForbidden };

PairedMesh paired_mesh(const TriangleMesh& input, Triangulation cut,
                       const TriangleMatching& matching) {
  PairedMesh mesh{std::move(cut), matching.mate, input.z, {}};
  mesh.source.resize(mesh.mate.size());
  for (TriangleId t = 0; t < mesh.source.size(); ++t) mesh.source[t] = t;
  return mesh;
}

[[noreturn]] void refuse(const TriangleMatching& matching) {
  const std::size_t left = matching.unmatched, barrier = matching.barrier.size();
  std::string sentence =
      "the triangles cannot all be paired: " + std::to_string(left) +
      (left == 1 ? " stays" : " stay") + " over whatever is done, since without " +
      std::to_string(barrier) + " of them the mesh falls into " + std::to_string(left + barrier) +
      " parts of an odd number of triangles each, and each of these needs one of the " +
      std::to_string(barrier);
  throw Error(ErrorCode::kGuarantee, sentence, {matching.barrier.begin(), matching.barrier.end()});
}

/// How many triangles stay free.
std::size_t cross_together(SteinerCrossing& crossing, const PairedMesh& mesh,
                           const Progress& progress) {
  std::vector<TriangleId> free = free_triangles(mesh);
  StepReports report(progress, "crossing", free.size(), 1);
  for (const TriangleId t : free) {
    report();
    // A second try may find another way where the first one met a triangle without room.
    for (int tries = 0; tries < 8 && mesh.is_free(t); ++tries) crossing.merge(t);
  }
  return free_triangles(mesh).size();
}

bool has_double_edge(const Quadrangulation& mesh) {
  std::vector<std::uint64_t> edges;
  edges.reserve(mesh.quad_vertex.size() + mesh.tri_vertex.size());
  const auto add_faces = [&](const std::vector<VertexId>& corner, std::size_t k) {
    for (std::size_t i = 0; i < corner.size(); ++i) {
      const std::size_t next = i % k == k - 1 ? i + 1 - k : i + 1;
      edges.push_back(std::uint64_t{corner[i]} << 32 | corner[next]);
    }
  };
  add_faces(mesh.quad_vertex, 4);
  add_faces(mesh.tri_vertex, 3);
  std::sort(edges.begin(), edges.end());
  return std::adjacent_find(edges.begin(), edges.end()) != edges.end();
}

void require_no_rest(const PairedMesh& mesh) {
  const std::vector<TriangleId> free = free_triangles(mesh);
  if (free.empty()) return;
  const TriangleId t = mesh.source[free.front()];
  throw Error(ErrorCode::kGuarantee,
              std::to_string(free.size()) +
                  " triangles stay over: no double lies inside a triangle " +
                  "where a Steiner point is needed, next to triangle " + std::to_string(t),
              {t});
}

PairedTriangles convert(const TriangleMesh& input, const Triangulation& cut,
                        const TriangleMatching& matching, const TriangleOptions& options,
                        Walks walks) {
  const MeshParts parts = parts_of(cut);
  PairedMesh mesh = paired_mesh(input, cut, matching);
  Walker walker(mesh);
  SteinerCrossing crossing(mesh);
  std::vector<SteinerPoint> at_borders;
  if (options.leftover == Leftover::kWalk || options.leftover == Leftover::kSteiner) {
    at_borders = make_parts_even(mesh, input, parts, walker, crossing, options.odd_boundary);
    if (options.leftover == Leftover::kWalk && walks == Walks::kAllowed) {
      const auto rounds = mesh.planar() ? std::span<const WalkLimits>(kCorridorRounds)
                                        : std::span<const WalkLimits>(kSurfaceRounds);
      walk_together(walker, mesh, rounds, options.progress);
    }
    cross_together(crossing, mesh, options.progress);
    if (options.odd_boundary != OddBoundary::kTriangle) require_no_rest(mesh);
  }

  PairedTriangles result{std::move(mesh), std::move(at_borders), matching.barrier, {}};
  const auto& inner = crossing.points();
  result.steiner.insert(result.steiner.end(), inner.begin(), inner.end());
  std::sort(result.steiner.begin(), result.steiner.end(),
            [](const auto& a, const auto& b) { return a.vertex < b.vertex; });
  result.statistics.triangles = input.mesh.triangle_count();
  result.statistics.boundary_edges = border_size(input.mesh);
  result.statistics.parts = parts.count();
  result.statistics.odd_parts = parts.odd_count();
  result.statistics.unmatched = matching.unmatched;
  result.statistics.parted = matching.parted;
  result.statistics.walks = walker.walks();
  result.statistics.walk_steps = walker.steps();
  result.statistics.crossings = crossing.crossings();
  result.statistics.weight_gap = matching.weight_gap;
  return result;
}

/// The result, or that of the Q-percolation if it adds fewer points.
TriangleResult or_with_fewer_points(TriangleResult&& result, const TriangleMesh& input,
                                    const TriangleOptions& options) {
  if (result.statistics.crossings < 2 || result.mesh.triangle_count() > 0) return std::move(result);
  TriangleOptions quarter = options;
  quarter.method = TriangleMethod::kQuarter;
  try {
    TriangleResult other = q_percolate_triangulation(input, quarter);
    if (other.steiner.size() < result.steiner.size() && other.mesh.triangle_count() == 0) {
      other.barrier = std::move(result.barrier);
      other.statistics.unmatched = result.statistics.unmatched;
      other.statistics.weight_gap = result.statistics.weight_gap;
      return other;
    }
  } catch (const Error& error) {
    if (error.code() != ErrorCode::kGuarantee) throw;  // it cannot make every part even that we can
  }
  return std::move(result);
}

}  // namespace

PairedTriangles pair_triangles(const TriangleMesh& input, const TriangleOptions& options) {
  const Triangulation cut = cut_along_kept_edges(input);
  report_progress(options.progress, "pairing", 0);
  const TriangleMatching matching = match_triangles(input, cut, options);
  if (options.leftover == Leftover::kError && matching.unmatched > 0) refuse(matching);

  PairedTriangles result = convert(input, cut, matching, options, Walks::kAllowed);
  if (!input.z.empty() && result.statistics.walks > 0 &&
      has_double_edge(to_quadrangulation(result.mesh))) {
    result = convert(input, cut, matching, options, Walks::kForbidden);
  }
  return result;
}

TriangleResult pair_triangulation(const TriangleMesh& input, const TriangleOptions& options) {
  PairedTriangles paired = pair_triangles(input, options);
  TriangleResult result = to_triangle_result(std::move(paired.mesh), input.mesh.points.size());
  result.steiner = std::move(paired.steiner);
  result.barrier = std::move(paired.barrier);
  result.statistics = paired.statistics;
  return or_with_fewer_points(std::move(result), input, options);
}

}  // namespace quadloom::quadrangulate
