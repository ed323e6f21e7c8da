// Triangles as strips: the code of given paths, and the paths for it.
//
// Arkin, Held, Mitchell and Skiena, Hamiltonian Triangulations for Fast Rendering, introduction and
// section 5: a sequence of vertices whose triangles turn left and right in turn; two turns the same
// way in a row cost a swap (a bit, or a vertex sent again). Every path of triangles begins anew.
//
// Steps of encode_paths: check_paths, ends_of (each path, from both sides), join_strips (the order),
// then write_strip for each. encode_strips finds the paths: few ones for kSwap, where turns are free,
// else those of few indices. Small meshes get the shortest of try_paths (with several seeds, the order
// then coded anew), try_walk (theorem 5.3) and, if they are very small, try_all (the optimum).
//
// What differs from the paper: orientation is kept, and no triangle is drawn twice. Which turn is
// free is then no choice: a strip that begins even turns left in its second triangle. Cost: O(n).
#include <algorithm>

#include "quadloom/strips.hpp"
#include "strips/encode_order.hpp"
#include "strips/encode_walk.hpp"
#include "strips/join_strips.hpp"
#include "strips/strip_writer.hpp"

namespace quadloom {
namespace {

using strips::StripEnd;
using strips::StripState;
using strips::StripWriter;

void check_corners(const Triangulation& mesh) {
  for (TriangleId t = 0; t < mesh.triangle_count(); ++t) {
    const VertexId* v = &mesh.tri_vertex[3 * std::size_t{t}];
    if (v[0] != v[1] && v[1] != v[2] && v[2] != v[0]) continue;
    throw Error(ErrorCode::kBadMesh,
                "triangle " + std::to_string(t) + " has a corner twice: strips cannot draw it",
                {t});
  }
}

void check_paths(const Triangulation& mesh, const PathPartition& paths) {
  if (is_path_partition(dual_graph(mesh), paths)) return;
  throw Error(ErrorCode::kBadOption, "the paths are no partition of the mesh's triangles");
}

/// The end of a path at the triangle of h, by which it leaves for the others.
//
//         apex             even: apex, o, then g; odd: apex, g, then o
//         /  \             .
//        o____g            .
StripEnd end_at(const Triangulation& mesh, HalfedgeId h, bool odd) {
  return {mesh.apex(h), odd ? mesh.target(h) : mesh.origin(h), odd};
}

/// A path with its halfedges seen from either side.
class Path {
 public:
  Path(const Triangulation& mesh, std::span<const HalfedgeId> leave, bool backwards)
      : mesh_(mesh), leave_(leave), backwards_(backwards) {}

  std::size_t size() const { return leave_.size(); }
  TriangleId first() const { return triangle_of(backwards_ ? leave_.back() : leave_.front()); }
  /// By which it leaves its i-th triangle, not the last one.
  HalfedgeId leave(std::size_t i) const {
    return backwards_ ? mesh_.twin[leave_[size() - 2 - i]] : leave_[i];
  }
  HalfedgeId entry(std::size_t i) const { return mesh_.twin[leave(i - 1)]; }

  /// As a strip begins with it. The second triangle turns right if it is drawn even, after an odd
  /// first one.
  StripEnd end() const {
    if (size() == 1) {
      const HalfedgeId h = 3 * (leave_[0] / 3);
      return backwards_ ? StripEnd{mesh_.apex(h), mesh_.target(h), true}
                        : StripEnd{mesh_.origin(h), mesh_.target(h), false};
    }
    return end_at(mesh_, leave(0), size() > 2 && leave(1) == next_halfedge(entry(1)));
  }

 private:
  const Triangulation& mesh_;
  std::span<const HalfedgeId> leave_;
  bool backwards_;
};

std::vector<std::array<StripEnd, 2>> ends_of(const Triangulation& mesh,
                                             const PathPartition& paths) {
  std::vector<std::array<StripEnd, 2>> ends(paths.count());
  for (std::size_t p = 0; p < ends.size(); ++p) {
    ends[p] = {Path(mesh, paths.path(p), false).end(), Path(mesh, paths.path(p), true).end()};
  }
  return ends;
}

/// The corner of triangle t that is not in the state.
VertexId third_corner(const Triangulation& mesh, TriangleId t, const StripState& state) {
  VertexId third = 3 * t;
  while (mesh.tri_vertex[third] == state.before || mesh.tri_vertex[third] == state.last) ++third;
  return mesh.tri_vertex[third];
}

void write_strip(const Triangulation& mesh, const Path& path, StripWriter& writer) {
  const StripEnd begin = path.end();
  writer.go_to(begin);
  writer.draw(third_corner(mesh, path.first(), begin));
  for (std::size_t i = 1; i < path.size(); ++i) {
    const HalfedgeId entry = path.entry(i);
    const VertexId kept = writer.state().before;
    if (mesh.origin(entry) != kept && mesh.target(entry) != kept) writer.swap();
    writer.draw(mesh.apex(entry));
  }
}

StripResult write_paths(const Triangulation& mesh, const PathPartition& paths,
                        StripEncoding encoding) {
  const strips::StripOrder order = strips::join_strips(ends_of(mesh, paths), encoding);
  StripWriter writer(encoding, mesh.triangle_count());
  for (const std::uint32_t s : order.strip) {
    write_strip(mesh, Path(mesh, paths.path(s / 2), s % 2 == 1), writer);
  }
  StripResult result;
  result.triangles = mesh.triangle_count();
  result.strips = paths.count();
  result.joined = order.joined;
  result.swaps = writer.swaps();
  result.restarts = writer.restarts();
  result.code = std::move(writer).take();
  return result;
}

constexpr std::size_t kSmall = 200;  // triangles
constexpr std::uint64_t kSeeds = 8;

PathOptions search_for(const StripOptions& options) {
  PathOptions search;
  search.goal =
      options.encoding == StripEncoding::kSwap ? PathGoal::kFewestPaths : PathGoal::kFewestIndices;
  search.effort = options.effort;
  search.seed = options.seed;
  search.progress = options.progress;
  return search;
}

/// Keeps the shorter code.
void keep(StripResult&& other, StripResult& best) {
  if (other.code.index.size() < best.code.index.size()) best = std::move(other);
}

/// The triangles in the order in which the paths' strips draw them.
std::vector<TriangleId> order_of(const Triangulation& mesh, const PathPartition& paths,
                                 StripEncoding encoding) {
  std::vector<TriangleId> order;
  for (const std::uint32_t s : strips::join_strips(ends_of(mesh, paths), encoding).strip) {
    const auto path = paths.path(s / 2);
    for (std::size_t i = 0; i < path.size(); ++i) {
      order.push_back(triangle_of(path[s % 2 == 1 ? path.size() - 1 - i : i]));
    }
  }
  return order;
}

void try_paths(const Triangulation& mesh, const DualGraph& graph, const StripOptions& options,
               StripResult& best) {
  PathOptions search = search_for(options);
  for (std::uint64_t i = 0; i < kSeeds; ++i) {
    search.seed = options.seed + i;
    const PathPartition paths = path_partition(graph, search);
    keep(write_paths(mesh, paths, options.encoding), best);
    if (options.encoding == StripEncoding::kSwap) continue;
    const std::vector<TriangleId> order = order_of(mesh, paths, options.encoding);
    keep(strips::encode_order(mesh, order, options.encoding), best);
  }
}

void try_walk(const Triangulation& mesh, const DualGraph& graph, StripEncoding encoding,
              StripResult& best) {
  if (encoding == StripEncoding::kSwap) return;
  keep(strips::encode_order(mesh, strips::christofides_order(graph), encoding), best);
}

void try_all(const Triangulation& mesh, StripEncoding encoding, StripResult& best) {
  const std::vector<TriangleId> order = strips::shortest_order(mesh, encoding);
  keep(encoding == StripEncoding::kSwap
           ? write_paths(mesh, strips::paths_of_order(mesh, order), encoding)
           : strips::encode_order(mesh, order, encoding),
       best);
}

}  // namespace

StripResult encode_paths(const Triangulation& mesh, const PathPartition& paths,
                         StripEncoding encoding) {
  check_corners(mesh);
  check_paths(mesh, paths);
  return write_paths(mesh, paths, encoding);
}

StripResult encode_strips(const Triangulation& mesh, const StripOptions& options) {
  const DualGraph graph = dual_graph(mesh);
  check_corners(mesh);
  StripResult best =
      write_paths(mesh, path_partition(graph, search_for(options)), options.encoding);
  if (mesh.triangle_count() > kSmall || options.effort == PathEffort::kFast) return best;
  if (mesh.triangle_count() > strips::kMostExact) {
    try_paths(mesh, graph, options, best);
    try_walk(mesh, graph, options.encoding, best);
  } else if (mesh.triangle_count() > 0) {
    try_all(mesh, options.encoding, best);
  }
  return best;
}

}  // namespace quadloom
