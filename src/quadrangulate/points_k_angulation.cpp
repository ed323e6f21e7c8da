// Meshes of k-gons for any k >= 4 (Bose and Toussaint, corollary 4.1).
//
// Count. With F faces, t = 2n - 2 - h, i points added inside and o on or outside the boundary:
// (k - 2) F = t + 2 i + o. The paper groups k - 2 consecutive triangles of the serpentine path and
// adds the o <= k - 3 missing points at the first one. It overlooks that a group which makes a full
// turn of the spiral touches itself: the three triangles of a triangle with one point inside are no
// pentagon. The ways to faces, until one keeps the bound; if none does, the fewest added points:
//
//   1. try_grown_faces  faces grown in the Delaunay triangulation; then triangles move from face to
//                       face until one or two lack corners (face_transfer.cpp): round cells
//   2. try_cut_sides    the same from the two sides of a path through all inner points, whose trees of
//                       triangles can be cut anywhere: large k. Several paths, within a bound
//   3. try_spiral       groups of the path, shorter where a turn is short (path_groups.cpp), or two
//                       faces along a path (two_faces.cpp). First with PointMethod::kSpiral
//
// Guarantee: faces are always simple k-gons. At most k - 3 points without inner points or with
// k - 2 >= t / 2. Otherwise 1 and 2 are searches: they met the bound in sweeps over all generators, n
// up to 300 and k up to n, but no proof says that they must. Known not to be met: sets of thousands of
// points with k above about 20, where the search gets stuck; and points on a line up to the last bits
// (the generator near-line), where the doubles have no room for the points: more of them, or Error
// kGuarantee.
// Cost: O(n log n), and searches of at most a few thousand steps a point.
#include <algorithm>
#include <optional>
#include <utility>

#include "quadloom/kernel.hpp"
#include "quadloom/quadrangulate.hpp"
#include "quadrangulate/face_starts.hpp"
#include "quadrangulate/face_transfer.hpp"
#include "quadrangulate/k_gon_builder.hpp"
#include "quadrangulate/odd_boundary.hpp"
#include "quadrangulate/path_groups.hpp"
#include "quadrangulate/point_input.hpp"

namespace quadloom {

using namespace quadrangulate;

namespace {

std::size_t count_added(const std::vector<PathGroup>& groups) {
  std::size_t sum = 0;
  for (const PathGroup& group : groups) sum += group.entering;
  return sum;
}

/// The places in the hull where the spiral may start, best first: a corner whose hull edge admits a
/// point, then the other corners.
std::vector<std::size_t> possible_starts(const std::vector<Point>& points,
                                         std::span<const VertexId> hull, OddBoundary wish) {
  std::vector<std::size_t> starts;
  try {
    starts.push_back(choose_odd_edge(points, hull, wish, EdgeStart::kCorner).index);
  } catch (const Error&) {
    starts.push_back(0);  // the mesh may need no point there
  }
  const std::size_t h = hull.size();
  for (std::size_t i = 0; i < h; ++i) {
    const bool corner =
        orient2d(points[hull[(i + h - 1) % h]], points[hull[i]], points[hull[(i + 1) % h]]) != 0;
    if (corner && i != starts[0]) starts.push_back(i);
  }
  return starts;
}

struct GroupedPath {
  std::size_t start = 0;  // in the hull
  Serpentine path;
  std::vector<PathGroup> groups;
  std::size_t added = 0;
};

/// Diagonals that cannot take the points that the grouping wants there, because the next triangle is
/// too small for the doubles; the grouping is asked again until it wants none of these.
std::vector<char> closed_diagonals(const std::vector<Point>& points, const Serpentine& path,
                                   std::size_t full) {
  constexpr int kMostRounds = 200;
  std::vector<char> closed(path.size(), 0);
  for (int round = 0; round < kMostRounds; ++round) {
    bool fits = true;
    std::size_t t = 0;
    for (const PathGroup& group : group_path(path, full, closed)) {
      if (t > 0 && group.entering > 0 &&
          !chain_in_triangle(points[path.outer(t)], points[path.inner(t)], points[path.apex(t)],
                             group.entering)) {
        closed[t] = 1;
        fits = false;
      }
      t += group.triangles;
    }
    if (fits) break;
  }
  return closed;
}

/// The first start that keeps the bound, or else the one with the fewest added points.
GroupedPath best_grouping(const std::vector<Point>& points, const ConvexLayers& layers,
                          std::size_t k, OddBoundary wish) {
  const std::size_t most_starts = points.size() <= 2'000 ? 64 : 4;
  const auto hull = layers.layer(0);
  std::vector<std::size_t> starts = possible_starts(points, hull, wish);
  if (starts.size() > most_starts) starts.resize(most_starts);
  GroupedPath best;
  for (const std::size_t start : starts) {
    GroupedPath now;
    now.start = start;
    now.path = make_serpentine(points, layers, hull[start]);
    now.groups = group_path(now.path, k - 2, closed_diagonals(points, now.path, k - 2));
    now.added = count_added(now.groups);
    if (best.groups.empty() || now.added < best.added) best = std::move(now);
    if (best.added <= k - 3) break;
  }
  return best;
}

/// Inner points of two faces of k corners; none if two such faces are too few for the set.
std::optional<std::size_t> inner_points_of_cut(std::size_t n, std::size_t h, std::size_t k) {
  const std::size_t without = (h + 1) / 2 + (n - h) + 1;
  if (n == h || k < without) return std::nullopt;
  return k - without;
}

/// The result with the fewest added points so far, and the door to the methods.
class Candidates {
 public:
  Candidates(const std::vector<Point>& points, const ConvexLayers& layers, std::size_t k,
             const PointOptions& options)
      : points_(points), layers_(layers), hull_(layers.layer(0)), k_(k), options_(options) {}

  bool within_bound() const {
    const std::size_t triangles = 2 * points_.size() - 2 - hull_.size();
    return best_ && best_->steiner.size() <= enough_points(triangles, k_);
  }

  /// Spiral: groups of the path, or two faces.
  void try_spiral() {
    report_progress(options_.progress, "grouping", 0);
    const GroupedPath path = best_grouping(points_, layers_, k_, options_.odd_boundary);
    const auto cut = inner_points_of_cut(points_.size(), hull_.size(), k_);
    const bool two = cut && *cut + hull_.size() % 2 < path.added;
    consider(two ? *cut + hull_.size() % 2 : path.added, [&](KGonBuilder& builder) {
      return two ? builder.from_cut(path.start, *cut) : builder.from_groups(path.path, path.groups);
    });
  }

  void try_grown_faces() {
    report_progress(options_.progress, "growing faces", 0);
    std::size_t work = kWork + kWorkAPoint * points_.size();
    try_plan(transfer_triangles(grow_faces(points_, k_), k_,
                                {.disturbances = 40, .progress = options_.progress}, work));
  }

  /// Other ends of the cut and other disturbances each time.
  void try_cut_sides() {
    constexpr std::size_t kMostAttempts = 64;
    constexpr std::size_t kMostFailures = 40;  // to find places for the points
    const std::size_t h = hull_.size();
    const std::size_t all_work = 8 * kWork + kWorkAPoint * points_.size();
    std::size_t work = all_work;
    for (std::size_t i = 0; i < kMostAttempts && work > 0 && failures_ < kMostFailures; ++i) {
      report_progress(options_.progress, "cutting sides",
                      1 - static_cast<double>(work) / static_cast<double>(all_work));
      const std::size_t steps = 1 + (h / 2 - 1 + i / h) % (h - 1);
      const LabelledTriangles start =
          cut_sides(points_, hull_, i % h, steps, k_, options_.progress);
      try_plan(transfer_triangles(start, k_, {.seed = i + 1, .progress = options_.progress}, work));
      if (within_bound()) return;
    }
  }

  /// Throws if no method found places for its points.
  KAngulationResult take_best() {
    if (!best_) throw Error(failure_.value());
    return std::move(*best_);
  }

 private:
  // Corners looked at by the transfers; ten million take a tenth of a second.
  static constexpr std::size_t kWork = 10'000'000;
  static constexpr std::size_t kWorkAPoint = 2'000;

  void try_plan(const std::optional<FacePlan>& plan) {
    if (!plan) return;
    consider(plan->added, [&](KGonBuilder& builder) { return builder.from_plan(*plan); });
  }

  template <typename Build>
  void consider(std::size_t added, const Build& build) {
    if (best_ && best_->steiner.size() <= added) return;
    try {
      KGonBuilder builder(points_, hull_, options_);
      best_ = build(builder);
    } catch (const Error& error) {
      if (error.code() != ErrorCode::kGuarantee) throw;
      failure_ = error;
      ++failures_;
    }
  }

  const std::vector<Point>& points_;
  const ConvexLayers& layers_;
  std::span<const VertexId> hull_;
  std::size_t k_;
  const PointOptions& options_;
  std::optional<KAngulationResult> best_;
  std::optional<Error> failure_;
  std::size_t failures_ = 0;
};

}  // namespace

KAngulationResult k_angulate_points(std::span<const Point> input, std::size_t k,
                                    const PointOptions& options) {
  if (k < 4) throw Error(ErrorCode::kBadOption, "faces must have at least 4 corners");
  if (options.odd_boundary == OddBoundary::kTriangle) {
    throw Error(ErrorCode::kBadOption, "a mesh of k-gons cannot leave a triangle");
  }
  report_progress(options.progress, "input", 0);
  DistinctPoints distinct = points_of_the_plane(input);
  const auto& points = distinct.points;
  const ConvexLayers layers = convex_layers(points, options.progress);
  Candidates candidates(points, layers, k, options);
  const bool spiral = options.method == PointMethod::kSpiral;
  if (spiral) candidates.try_spiral();
  if (!candidates.within_bound()) candidates.try_grown_faces();
  if (!candidates.within_bound()) candidates.try_cut_sides();
  if (!candidates.within_bound() && !spiral) candidates.try_spiral();
  KAngulationResult result = candidates.take_best();
  result.input_to_vertex = std::move(distinct.input_to_vertex);
  return result;
}

}  // namespace quadloom
