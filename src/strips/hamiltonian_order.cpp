// Can the triangles of a mesh, as they are, be put in Hamiltonian order?
//
// NP-complete (Arkin, Held, Mitchell, Skiena, "Hamiltonian triangulations for fast rendering", section 5),
// so this is a search with a limit, on the dual graph, which has three edges a node at most.
//
//   1. find_obstacle    what rules an order out at a glance (dual_obstacles.cpp)
//   2. frontier_order   an order of the triangles with few edges between those before and after
//   3. frontier_search  the search along that order: first with narrow beams, which find an order fast
//                       where there are many; then with all states, whose failure proves that there is
//                       none
//
// Degenerate input: any manifold connectivity. One triangle has a path, two neighbours too.
#include <algorithm>
#include <array>

#include "quadloom/strips.hpp"
#include "strips/dual_obstacles.hpp"
#include "strips/frontier_search.hpp"

namespace quadloom {

HamiltonianOrder hamiltonian_order(const Triangulation& mesh, const OrderSearchOptions& options) {
  if (options.kind == OrderKind::kSequential) {
    throw Error(ErrorCode::kBadOption, "sequential_order decides what is sequential");
  }
  if (mesh.tri_vertex.empty()) {
    throw Error(ErrorCode::kTooFewPoints, "a mesh without triangles has no order");
  }
  report_progress(options.progress, "input", 0);
  const DualGraph graph = dual_graph(mesh);
  HamiltonianOrder out;
  if (auto obstacle = strips::find_obstacle(graph, options.kind)) {
    out.answer = Answer::kNo;
    out.reason = obstacle->reason;
    out.culprits = std::move(obstacle->culprits);
    return out;
  }
  if (graph.node_count() <= 2) {
    out.answer = Answer::kYes;
    for (TriangleId t = 0; t < graph.node_count(); ++t) out.order.push_back(t);
    return out;
  }
  const strips::FrontierOrder order = strips::frontier_order(graph, options.progress);
  constexpr std::array<std::size_t, 6> kBeams = {64, 256, 1024, 4096, 16384, 0};
  for (const std::size_t beam : kBeams) {
    strips::FrontierLimits limits;
    limits.beam = beam;
    limits.work = options.work_at_most - out.work;
    strips::FrontierResult found =
        strips::frontier_search(graph, order, options.kind, limits, options.progress);
    out.work = std::min(options.work_at_most, out.work + found.work);
    out.answer = found.answer;
    out.order = std::move(found.order);
    if (out.answer == Answer::kNo) out.reason = NoOrder::kExhausted;
    if (out.answer != Answer::kUnknown || out.work >= options.work_at_most) break;
  }
  return out;
}

}  // namespace quadloom
