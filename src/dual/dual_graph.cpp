// The dual graph of a triangulation, with or without forbidden edges, and its spanning forest.
#include <string>

#include "dual/weights.hpp"
#include "quadloom/dual.hpp"

namespace quadloom {
namespace {

void check_twin(const Triangulation& mesh, HalfedgeId h) {
  const HalfedgeId g = mesh.twin[h];
  if (g == kNone || (g < mesh.twin.size() && mesh.twin[g] == h)) return;
  throw Error(ErrorCode::kBadMesh, "halfedge " + std::to_string(h) + " is not the twin of its twin",
              {h});
}

}  // namespace

DualGraph dual_graph(const Triangulation& mesh) {
  if (mesh.twin.size() != mesh.tri_vertex.size() || mesh.twin.size() % 3 != 0) {
    throw Error(ErrorCode::kBadMesh, "a triangulation needs three corners and twins a triangle");
  }
  DualGraph graph{mesh.twin};
  for (HalfedgeId h = 0; h < mesh.twin.size(); ++h) {
    check_twin(mesh, h);
    // A triangle that is glued to itself has no partner there.
    if (mesh.twin[h] != kNone && triangle_of(mesh.twin[h]) == triangle_of(h)) graph.twin[h] = kNone;
  }
  return graph;
}

DualGraph dual_graph(const Triangulation& mesh, std::span<const std::uint8_t> forbidden) {
  if (forbidden.size() != mesh.twin.size()) {
    throw Error(ErrorCode::kBadOption, "forbidden edges need one entry a halfedge");
  }
  DualGraph graph = dual_graph(mesh);
  for (HalfedgeId h = 0; h < graph.twin.size(); ++h) {
    if (forbidden[h] == 0 || graph.twin[h] == kNone) continue;
    graph.twin[graph.twin[h]] = kNone;
    graph.twin[h] = kNone;
  }
  return graph;
}

DualGraph heavy_edges(const DualGraph& graph, std::span<const std::int32_t> weight,
                      std::int32_t least) {
  dual::check_weights(graph, weight);
  DualGraph heavy = graph;
  for (HalfedgeId h = 0; h < heavy.twin.size(); ++h) {
    if (weight[h] < least) heavy.twin[h] = kNone;
  }
  return heavy;
}

DualGraph spanning_forest(const DualGraph& graph) {
  DualGraph forest{std::vector<HalfedgeId>(graph.twin.size(), kNone)};
  std::vector<std::uint8_t> seen(graph.node_count());
  std::vector<TriangleId> queue;
  queue.reserve(graph.node_count());
  for (TriangleId root = 0; root < graph.node_count(); ++root) {
    if (seen[root] != 0) continue;
    seen[root] = 1;
    queue.push_back(root);
    for (std::size_t next = queue.size() - 1; next < queue.size(); ++next) {
      for (HalfedgeId h = 3 * queue[next]; h < 3 * queue[next] + 3; ++h) {
        if (graph.twin[h] == kNone || seen[graph.across(h)] != 0) continue;
        seen[graph.across(h)] = 1;
        queue.push_back(graph.across(h));
        forest.twin[h] = graph.twin[h];
        forest.twin[graph.twin[h]] = h;
      }
    }
  }
  return forest;
}

}  // namespace quadloom
