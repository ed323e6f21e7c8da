// Which pairs are possible, what each weighs, and the best matching.
//
// Pairs of kAny: all edges that may go, as many as possible, then weight: all triangles are paired if
// and only if the dual graph has a perfect matching (Ramaswami, Ramos and Toussaint, section 3). The
// two triangles of any edge make a simple quad; on a surface they must not have the same three corners.
// Pairs of kConvex: the strictly convex ones, as much weight as possible.
#include "quadrangulate/triangulation_matching.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace quadloom::quadrangulate {
namespace {

using Weights = std::vector<std::int32_t>;

constexpr double kWeightScale = 65535;

bool is_half_of_quad(const TriangleMesh& input, TriangleId t) {
  return !input.given_pair.empty() && input.given_pair[t] != kNone;
}

/// The edges of pairs that are possible at all; the halves of a given quad have each other.
DualGraph possible_pairs(const TriangleMesh& input, const Triangulation& cut) {
  DualGraph graph = dual_graph(cut);
  for (HalfedgeId h = 0; h < graph.twin.size(); ++h) {
    const HalfedgeId twin = graph.twin[h];
    if (twin == kNone) continue;
    const TriangleId t = triangle_of(h);
    const bool in_quads = is_half_of_quad(input, t) || is_half_of_quad(input, triangle_of(twin));
    if (in_quads ? is_half_of_quad(input, t) && input.given_pair[t] == h
                 : cut.apex(h) != cut.apex(twin)) {
      continue;
    }
    graph.twin[h] = kNone;
    graph.twin[twin] = kNone;
  }
  return graph;
}

/// The given weights as integers, the greatest as large as the best shape; an edge has the mean of its two
/// halfedges.
Weights given_weights(const Triangulation& cut, std::span<const double> given) {
  if (given.size() != cut.twin.size()) {
    throw Error(ErrorCode::kBadOption, "a weight for each halfedge is needed");
  }
  for (std::size_t h = 0; h < given.size(); ++h) {
    if (std::isfinite(given[h]) && given[h] >= 0) continue;
    throw Error(ErrorCode::kBadOption,
                "the weight of halfedge " + std::to_string(h) + " is negative or not finite", {h});
  }
  const double most = given.empty() ? 0 : *std::max_element(given.begin(), given.end());
  Weights weight(given.size());
  for (HalfedgeId h = 0; h < given.size(); ++h) {
    const HalfedgeId twin = cut.twin[h];
    if (twin == kNone || twin < h) continue;
    const double share = most > 0 ? (given[h] / most + given[twin] / most) / 2 : 0;
    weight[h] = weight[twin] = 1 + static_cast<std::int32_t>(share * kWeightScale);
  }
  return weight;
}

Weights pair_weights(const Triangulation& cut, const Weights& shape,
                     const TriangleOptions& options) {
  if (options.weight == PairWeight::kShape) return shape;
  if (options.weight == PairWeight::kGiven) return given_weights(cut, options.halfedge_weight);
  Weights weight(shape.size());
  for (std::size_t h = 0; h < shape.size(); ++h) weight[h] = shape[h] > 0 ? 1 : 0;
  return weight;
}

/// The least shape weight of a pair that may be made; 0: any.
std::int32_t least_weight(const TriangleOptions& options) {
  if (!(options.min_quality >= 0 && options.min_quality <= 1)) {
    throw Error(ErrorCode::kBadOption, "the least quality is a number from 0 to 1");
  }
  if (options.min_quality > 0) {
    return 1 + static_cast<std::int32_t>(std::ceil(options.min_quality * kWeightScale));
  }
  return options.pairs == PairKind::kConvex ? 1 : 0;
}

/// The best matching of the graph, and for kNear how much of the weight it may lack.
DualMatching best_matching(const DualGraph& graph, const Weights& weight,
                           const TriangleOptions& options, TriangleMatching& out) {
  constexpr MatchingGoal kGoal = MatchingGoal::kSizeThenWeight;
  if (options.effort == MatchingEffort::kExact) {
    return maximum_weight_matching(graph, weight, kGoal, options.progress).matching;
  }
  NearMaximumMatching near = near_maximum_weight_matching(graph, weight, kGoal, options.progress);
  if (near.upper_bound > near.weight) {
    out.weight_gap =
        static_cast<double>(near.upper_bound - near.weight) / static_cast<double>(near.upper_bound);
  }
  return std::move(near.matching);
}

/// Quads that are not strictly convex become triangles again, but for those that were given.
void part_other_than_convex(const TriangleMesh& input, const Weights& shape,
                            TriangleMatching& out) {
  for (TriangleId t = 0; t < out.mate.size(); ++t) {
    const HalfedgeId h = out.mate[t];
    if (h == kNone || shape[h] > 0) continue;
    out.mate[triangle_of(input.mesh.twin[h])] = kNone;
    out.mate[t] = kNone;
    ++out.parted;
  }
}

}  // namespace

TriangleMatching match_triangles(const TriangleMesh& input, const Triangulation& cut,
                                 const TriangleOptions& options) {
  TriangleMatching out;
  const std::int32_t least = least_weight(options);
  Weights shape = shape_weights(cut, input.z);
  for (const HalfedgeId h : input.given_pair) {
    if (h != kNone) shape[h] = static_cast<std::int32_t>(kWeightScale) + 1;  // whatever its shape
  }
  const Weights weight = pair_weights(cut, shape, options);
  const DualGraph graph = heavy_edges(possible_pairs(input, cut), shape, least);
  DualMatching matching = best_matching(graph, weight, options, out);
  if (matching.unmatched > 0) out.barrier = maximum_matching(graph, matching).barrier;
  out.mate = std::move(matching.mate);
  out.unmatched = matching.unmatched;
  if (options.pairs == PairKind::kAuto && options.leftover == Leftover::kWalk) {
    part_other_than_convex(input, shape, out);
  }
  return out;
}

}  // namespace quadloom::quadrangulate
