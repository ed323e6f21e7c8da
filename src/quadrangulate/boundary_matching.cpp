// Maximum matchings in which only nodes of one kind (at the boundary) stay over, from maximum matchings alone:
//
//   1. doubled   two copies of the graph, with an edge between the copies of each node that may stay. Its
//                matching is perfect if and only if the graph has a matching that covers all other nodes:
//                take that one in both copies, and the new edges for what it leaves over.
//   2. first_copy   the pairs of that matching within the first copy cover all other nodes
//   3. augmented to a maximum matching, which uncovers no node
//
//       o--o--x            x may stay: o-o pairs with o-o in both copies, x with its copy
//             |
//       o--o--x
//
// If the matching in step 1 is not perfect, there is no such matching; the result is maximum all the same.
#include "quadrangulate/boundary_matching.hpp"

#include <vector>

namespace quadloom::quadrangulate {
namespace {

HalfedgeId free_slot(const DualGraph& graph, TriangleId t) {
  for (HalfedgeId h = 3 * t; h < 3 * t + 3; ++h) {
    if (graph.twin[h] == kNone) return h;
  }
  return kNone;
}

DualGraph doubled(const DualGraph& graph, std::span<const std::uint8_t> may_stay) {
  const auto slots = static_cast<HalfedgeId>(graph.twin.size());
  if (graph.twin.size() >= kNone / 2) {
    throw Error(ErrorCode::kTooManyPoints, "too many triangles for 32-bit indices");
  }
  DualGraph out{graph.twin};
  out.twin.reserve(2 * graph.twin.size());
  for (const HalfedgeId twin : graph.twin) out.twin.push_back(twin == kNone ? kNone : twin + slots);
  for (TriangleId t = 0; t < graph.node_count(); ++t) {
    const HalfedgeId h = may_stay[t] != 0 ? free_slot(graph, t) : kNone;
    if (h == kNone) continue;
    out.twin[h] = h + slots;
    out.twin[h + slots] = h;
  }
  return out;
}

DualMatching first_copy(const DualGraph& graph, const DualMatching& both) {
  DualMatching out{std::vector<HalfedgeId>(graph.node_count(), kNone), graph.node_count()};
  for (TriangleId t = 0; t < graph.node_count(); ++t) {
    const HalfedgeId h = both.mate[t];
    if (h == kNone || graph.twin[h] == kNone) continue;
    out.mate[t] = h;
    --out.unmatched;
  }
  return out;
}

}  // namespace

DualMatching matching_inside_first(const DualGraph& graph, std::span<const std::uint8_t> may_stay) {
  DualMatching best = maximum_matching(graph).matching;
  bool good = true;
  for (TriangleId t = 0; t < graph.node_count(); ++t) {
    good = good && (best.mate[t] != kNone || may_stay[t] != 0);
  }
  if (good) return best;
  const DualMatching both = maximum_matching(doubled(graph, may_stay)).matching;
  return maximum_matching(graph, first_copy(graph, both)).matching;
}

}  // namespace quadloom::quadrangulate
