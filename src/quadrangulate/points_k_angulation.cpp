// Meshes of k-gons for any k >= 4 (Bose and Toussaint, corollary 4.1).
//
// Count. With F faces, t = 2n - 2 - h, i points added inside and o on or outside the boundary:
// (k - 2) F = t + 2 i + o. The paper groups k - 2 consecutive triangles of the serpentine path and
// adds the o <= k - 3 missing points at the first one. It overlooks that a group which makes a full
// turn of the spiral touches itself: the three triangles of a triangle with one point inside are no
// pentagon. Two ways out, of which the one with fewer added points is taken:
//
//   1. group_path     shorter groups where a turn is short; the corners that are missing are points
//                     added on the diagonal between two groups, one for both (path_groups.cpp)
//   2. cut_in_two     if k - 2 >= t / 2: two faces that share a path through all inner points
//                     (two_faces.cpp). With s = ceil(h/2) hull edges each and m = n - h inner points,
//                     k = s + m + 1 + i, o = h mod 2, so i + o = k - 1 - m - floor(h/2) <= k - 3.
//
// Guarantee: faces are always simple k-gons. At most k - 3 points are added if no group makes a full
// turn (then o alone, as in the paper), and if k - 2 >= t/2 or there is no inner point. In between
// (turns of fewer than about k/2 points, more than two faces) more can be needed by this method.
// Cost: O(n log n) and the bounded search of path_groups.cpp.
#include <algorithm>
#include <optional>
#include <utility>

#include "quadloom/kernel.hpp"
#include "quadloom/quadrangulate.hpp"
#include "quadrangulate/odd_boundary.hpp"
#include "quadrangulate/path_groups.hpp"
#include "quadrangulate/point_input.hpp"
#include "quadrangulate/steiner_chains.hpp"
#include "quadrangulate/two_faces.hpp"

namespace quadloom {

using namespace quadrangulate;

namespace {

using Edge = std::pair<VertexId, VertexId>;

std::size_t count_added(const std::vector<PathGroup>& groups) {
  std::size_t sum = 0;
  for (const PathGroup& group : groups) sum += group.entering;
  return sum;
}

class Builder {
 public:
  Builder(const std::vector<Point>& points, std::span<const VertexId> hull,
          const PointOptions& options)
      : hull_(hull.begin(), hull.end()), options_(options) {
    result_.mesh.points = points;
    result_.input_vertices = points.size();
  }

  /// Faces from groups of triangles of the path.
  KAngulationResult from_groups(const Serpentine& path, const std::vector<PathGroup>& groups) {
    std::vector<std::vector<VertexId>> faces;
    std::size_t t = 0;
    for (const PathGroup& group : groups) {
      if (t > 0 && group.entering > 0) {
        add_inner(path.outer(t), path.inner(t), path.apex(t), group.entering);
      }
      faces.push_back(polygon(path, t, group.triangles));
      t += group.triangles;
    }
    add_outer(faces[0], groups[0].entering);
    return finish(faces);
  }

  /// Two faces, left and right of a path.
  KAngulationResult from_cut(std::size_t from, std::size_t inner_points) {
    const std::size_t h = hull_.size();
    const std::size_t steps = h / 2;
    const CutPath cut = cut_through_all(result_.mesh.points, hull_, from, steps);
    const auto& path = cut.vertices;
    if (inner_points > 0) {
      add_inner(path[cut.wide_edge], path[cut.wide_edge + 1], cut.wide_apex, inner_points);
    }
    std::vector<std::vector<VertexId>> faces(2);
    for (std::size_t i = 0; i < steps; ++i) faces[0].push_back(hull_[(from + i) % h]);
    faces[0].insert(faces[0].end(), path.rbegin(), path.rend() - 1);
    faces[1].assign(path.begin(), path.end() - 1);
    for (std::size_t i = steps; i < h; ++i) faces[1].push_back(hull_[(from + i) % h]);
    add_outer(faces[0], h % 2);
    return finish(faces);
  }

 private:
  /// The union of triangles first ... first + count - 1 of the path.
  static std::vector<VertexId> polygon(const Serpentine& path, std::size_t first,
                                       std::size_t count) {
    std::vector<VertexId> out = {path.outer(first), path.inner(first)};
    std::vector<VertexId> outer_side;
    for (std::size_t t = first; t < first + count; ++t) {
      const bool outer = t + 1 == path.size() || path.replaced(t) == Replaced::kOuter;
      (outer ? outer_side : out).push_back(path.apex(t));
    }
    out.insert(out.end(), outer_side.rbegin(), outer_side.rend());
    return out;
  }

  void add_inner(VertexId a, VertexId b, VertexId apex, std::size_t count) {
    auto& points = result_.mesh.points;
    const auto places = chain_in_triangle(points[a], points[b], points[apex], count);
    if (!places) {
      throw Error(ErrorCode::kGuarantee,
                  "a triangle is too small to take a point with double-precision coordinates");
    }
    auto& chain = chains_[{a, b}];
    for (const Point& place : *places) {
      const auto s = static_cast<VertexId>(points.size());
      points.push_back(place);
      chain.push_back(s);
      result_.steiner.push_back({s, SteinerKind::kInner, {a, b, apex}});
    }
    chains_[{b, a}].assign(chain.rbegin(), chain.rend());
  }

  /// At the hull edges of one face.
  void add_outer(const std::vector<VertexId>& face, std::size_t count) {
    if (count == 0) return;
    std::vector<VertexId> next(result_.mesh.points.size(), kNone);
    for (std::size_t i = 0; i < hull_.size(); ++i) next[hull_[i]] = hull_[(i + 1) % hull_.size()];
    std::vector<Edge> edges;
    for (std::size_t i = 0; i < face.size(); ++i) {
      const Edge edge{face[i], face[(i + 1) % face.size()]};
      if (next[edge.first] == edge.second) edges.push_back(edge);
    }
    add_hull_points(hull_, edges, count, options_.odd_boundary, result_.mesh.points, chains_,
                    result_.steiner);
  }

  KAngulationResult finish(const std::vector<std::vector<VertexId>>& faces) {
    std::vector<VertexId> corners;
    for (const auto& face : faces) {
      corners.clear();
      for (std::size_t i = 0; i < face.size(); ++i) {
        corners.push_back(face[i]);
        const auto chain = chains_.find({face[i], face[(i + 1) % face.size()]});
        if (chain == chains_.end()) continue;
        corners.insert(corners.end(), chain->second.begin(), chain->second.end());
      }
      result_.mesh.add_face(corners);
    }
    return std::move(result_);
  }

  std::vector<VertexId> hull_;
  const PointOptions& options_;
  EdgeChains chains_;
  KAngulationResult result_;
};

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
  constexpr std::size_t kMostStarts = 64;
  const auto hull = layers.layer(0);
  std::vector<std::size_t> starts = possible_starts(points, hull, wish);
  if (starts.size() > kMostStarts) starts.resize(kMostStarts);
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
  report_progress(options.progress, "convex layers", 0);
  const ConvexLayers layers = convex_layers(points);
  const auto hull = layers.layer(0);

  report_progress(options.progress, "grouping", 0);
  const GroupedPath best = best_grouping(points, layers, k, options.odd_boundary);
  const auto cut = inner_points_of_cut(points.size(), hull.size(), k);
  Builder builder(points, hull, options);
  KAngulationResult result = cut && *cut + hull.size() % 2 < best.added
                                 ? builder.from_cut(best.start, *cut)
                                 : builder.from_groups(best.path, best.groups);
  result.input_to_vertex = std::move(distinct.input_to_vertex);
  return result;
}

}  // namespace quadloom
