// Few paths, or paths that make short codes, for any graph of at most three edges a node.
//
// Arkin, Held, Mitchell and Skiena, Hamiltonian Triangulations for Fast Rendering, section 5: the
// minimum is NP-hard to find for triangulations in general, and O(n) for trees (path_partition.cpp).
//
// Steps: alternating_strips (a start), then some times improve_ways (by exact optimisation over random
// forests) and open_cycles; the best of all that is kept; paths_of_edges. Each edge on a path is worth
// what it saves: a path less; where indices count, three of them, and one less where the path turns
// the same way on both sides of the edge, since the code then repeats a vertex. Cycles are free while
// ways improve: where paths are to be few they are opened after each round, before they multiply.
//
// A forest with the goal of fewest paths is parted optimally instead. Degenerate input: no triangles,
// several components, parallel edges. Cost: O(n) for a given effort.
#include "quadloom/strips.hpp"
#include "strips/alternating_strips.hpp"
#include "strips/improve_ways.hpp"
#include "strips/open_cycles.hpp"
#include "strips/paths_of_edges.hpp"

namespace quadloom {
namespace {

using strips::EdgeWorth;
using strips::Way;
using strips::WayTables;

/// So many times so many rounds.
struct Search {
  std::size_t times, rounds, passes;
};

Search search_for(PathGoal goal, PathEffort effort) {
  const bool paths = goal == PathGoal::kFewestPaths;
  switch (effort) {
    case PathEffort::kFast:
      return {0, 0, 0};
    case PathEffort::kStandard:
      return paths ? Search{2, 1, 16} : Search{1, 2, 16};
    default:
      return paths ? Search{16, 1, 32} : Search{8, 2, 32};
  }
}

EdgeWorth worth_for(PathGoal goal) {
  return goal == PathGoal::kFewestPaths ? EdgeWorth{1, 1} : EdgeWorth{3, 2};
}

bool is_forest(const DualGraph& graph) {
  std::size_t edges = 0;
  for (const HalfedgeId twin : graph.twin) edges += twin != kNone;
  const DualGraph forest = spanning_forest(graph);
  for (const HalfedgeId twin : forest.twin) edges -= twin != kNone;
  return edges == 0;
}

std::int64_t worth_of_paths(const DualGraph& graph, const WayTables& tables,
                            const std::vector<Way>& way) {
  std::int64_t worth = 0;
  for (HalfedgeId h = 0; h < graph.twin.size(); ++h) {
    const HalfedgeId twin = graph.twin[h];
    if (twin == kNone || twin < h) continue;
    worth += tables.worth(strips::kUseOfWay[way[triangle_of(h)]][h % 3],
                          strips::kUseOfWay[way[triangle_of(twin)]][twin % 3]);
  }
  return worth;
}

std::vector<Way> best_ways(const DualGraph& graph, const PathOptions& options) {
  const WayTables tables(worth_for(options.goal), options.seed);
  const auto [times, rounds, passes] = search_for(options.goal, options.effort);
  std::vector<Way> best = strips::alternating_strips(graph), way = best;
  std::int64_t most = worth_of_paths(graph, tables, best);
  for (std::size_t i = 0; i < times; ++i) {
    strips::improve_ways(graph, tables, {i * rounds, rounds, passes, times * rounds}, options.seed,
                         options.progress, way);
    strips::open_cycles(graph, tables, way);
    const std::int64_t worth = worth_of_paths(graph, tables, way);
    if (worth <= most) continue;
    most = worth;
    best = way;
  }
  return best;
}

}  // namespace

PathPartition path_partition(const DualGraph& graph, const PathOptions& options) {
  if (options.goal == PathGoal::kFewestPaths && is_forest(graph)) {
    return minimum_path_partition(graph);
  }
  return strips::paths_of_edges(graph, strips::used_edges(graph, best_ways(graph, options)));
}

}  // namespace quadloom
