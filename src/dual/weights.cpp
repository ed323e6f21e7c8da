#include "dual/weights.hpp"

#include <algorithm>

namespace quadloom {
namespace dual {

void check_weights(const DualGraph& graph, std::span<const std::int32_t> weight) {
  if (weight.size() != graph.twin.size()) {
    throw Error(ErrorCode::kBadOption, "weights need one entry a halfedge");
  }
  for (HalfedgeId h = 0; h < graph.twin.size(); ++h) {
    if (graph.twin[h] == kNone || weight[graph.twin[h]] == weight[h]) continue;
    throw Error(ErrorCode::kBadOption, "the two sides of an edge have different weights",
                {h, graph.twin[h]});
  }
}

std::int64_t bonus_for_size(const DualGraph& graph, std::span<const std::int32_t> weight) {
  std::int64_t least = 0, greatest = 0;
  for (HalfedgeId h = 0; h < graph.twin.size(); ++h) {
    if (graph.twin[h] == kNone) continue;
    least = std::min<std::int64_t>(least, weight[h]);
    greatest = std::max<std::int64_t>(greatest, weight[h]);
  }
  // Two matchings differ by less than this in weight; duals stay below four times the bonus.
  const auto pairs = static_cast<std::int64_t>(graph.node_count() / 2 + 1);
  if ((greatest - least + 1) > (std::int64_t{1} << 58) / pairs) {
    throw Error(ErrorCode::kBadOption, "weights are too large for a graph of this size");
  }
  return pairs * (greatest - least + 1);
}

}  // namespace dual

std::int64_t weight_of(const DualMatching& matching, std::span<const std::int32_t> weight) {
  std::int64_t twice = 0;
  for (const HalfedgeId h : matching.mate) {
    if (h != kNone) twice += weight[h];
  }
  return twice / 2;
}

}  // namespace quadloom
