// Maximum-weight matchings of degree-3 graphs, with a proof.
//
// Steps: start_duals, start_matching, settle_nodes (searches from each node that is unmatched with a
// positive dual), write_certificate, write_matching. The greatest size first: a bonus on every edge
// that outweighs all differences. The near-optimal one stops after some rounds; its duals still bound
// the weight. Cost: near-linear in practice, see weighted_search.cpp.
#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

#include "dual/weighted_search.hpp"
#include "dual/weights.hpp"
#include "quadloom/dual.hpp"

namespace quadloom {
namespace {

using dual::Dual;
using dual::SetId;
using Weights = std::span<const std::int32_t>;

/// Half of the doubled weight at each end, the most that any edge of the node asks for.
std::vector<Dual> start_duals(const DualGraph& graph, Weights weight, std::int64_t bonus) {
  std::vector<Dual> out(graph.node_count());
  for (HalfedgeId h = 0; h < graph.twin.size(); ++h) {
    if (graph.twin[h] == kNone) continue;
    out[triangle_of(h)] = std::max(out[triangle_of(h)], weight[h] + bonus);
  }
  return out;
}

/// Node by node the dual goes down to what its edges need; a tight edge to an unmatched node joins
/// the matching.
DualMatching start_matching(const DualGraph& graph, Weights weight, std::int64_t bonus,
                            std::vector<Dual>& duals) {
  DualMatching matching{std::vector<HalfedgeId>(graph.node_count(), kNone), graph.node_count()};
  for (TriangleId t = 0; t < graph.node_count(); ++t) {
    if (matching.mate[t] != kNone) continue;
    Dual need = 0;
    HalfedgeId tight = kNone;
    for (HalfedgeId h = 3 * t; h < 3 * t + 3; ++h) {
      if (graph.twin[h] == kNone) continue;
      const Dual asks = 2 * (weight[h] + bonus) - duals[graph.across(h)];
      if (asks < need) continue;
      const bool is_free = matching.mate[graph.across(h)] == kNone;
      if (asks > need) tight = kNone;
      if (is_free) tight = h;
      need = asks;
    }
    duals[t] = need;
    if (tight == kNone) continue;
    matching.mate[t] = tight;
    matching.mate[graph.across(tight)] = graph.twin[tight];
    matching.unmatched -= 2;
  }
  return matching;
}

/// The blossoms with a positive dual, renumbered.
WeightCertificate write_certificate(const dual::WeightedSearch& search, std::size_t nodes,
                                    std::int64_t bonus) {
  WeightCertificate out;
  out.bonus = bonus;
  for (TriangleId t = 0; t < nodes; ++t) out.node_dual.push_back(search.dual(t));
  out.set_of_node.assign(nodes, kNone);
  const dual::Blossoms& blossoms = search.blossoms();
  std::vector<std::uint32_t> number(blossoms.size(), kNone);
  std::vector<SetId> way;
  const auto counts = [&](SetId s) { return blossoms.is_blossom(s) && search.blossom_dual(s) > 0; };
  const auto next_larger = [&](SetId s) {
    for (s = blossoms.parent(s); s != kNone && !counts(s); s = blossoms.parent(s)) {
    }
    return s;
  };
  for (TriangleId t = 0; t < nodes; ++t) {
    way.clear();
    for (SetId s = next_larger(t); s != kNone && number[s] == kNone; s = next_larger(s)) {
      way.push_back(s);
    }
    for (const SetId s : way) {
      number[s] = static_cast<std::uint32_t>(out.set_dual.size());
      out.set_dual.push_back(search.blossom_dual(s));
      out.parent_of_set.push_back(next_larger(s));  // renumbered below
    }
    if (const SetId s = next_larger(t); s != kNone) out.set_of_node[t] = number[s];
  }
  for (std::uint32_t& parent : out.parent_of_set) {
    if (parent != kNone) parent = number[parent];
  }
  return out;
}

DualMatching write_matching(dual::Blossoms& blossoms, std::size_t nodes) {
  std::vector<SetId> tops;
  for (SetId s = 0; s < blossoms.size(); ++s) {
    if (blossoms.is_blossom(s) && blossoms.is_at_top(s)) tops.push_back(s);
  }
  while (!tops.empty()) {
    const std::vector<SetId> way = blossoms.way_to_base(tops.back());
    tops.pop_back();
    for (std::size_t i = way.size() - 1; i > 0; --i) {
      for (const auto& [child, link] : blossoms.open(way[i], way[i - 1])) {
        if (child != way[i - 1] && blossoms.is_blossom(child)) tops.push_back(child);
      }
    }
  }
  DualMatching matching{std::vector<HalfedgeId>(nodes), 0};
  for (TriangleId t = 0; t < nodes; ++t) {
    matching.mate[t] = blossoms.mate(t);
    matching.unmatched += matching.mate[t] == kNone;
  }
  return matching;
}

/// An eighth of the span of doubled weights.
Dual first_limit(const DualGraph& graph, Weights weight) {
  std::int64_t least = std::numeric_limits<std::int32_t>::max(), greatest = -least;
  for (HalfedgeId h = 0; h < graph.twin.size(); ++h) {
    if (graph.twin[h] == kNone) continue;
    least = std::min<std::int64_t>(least, weight[h]);
    greatest = std::max<std::int64_t>(greatest, weight[h]);
  }
  return std::max<Dual>(1, (greatest - least) / 4);
}

/// Rounds of searches from all unsettled nodes. In a round the dual of each goes down by the same
/// limit at most, so that their trees grow alike: without that the trees of the last ones are far
/// larger. The limit doubles when few nodes have been settled, and the last node has none.
void settle_nodes(dual::WeightedSearch& search, std::vector<TriangleId> unsettled, Dual limit,
                  int rounds, const Progress& progress) {
  const std::size_t all = unsettled.size();
  for (int round = 0; round < rounds; ++round) {
    const auto is_settled = [&](TriangleId t) { return search.is_settled(t); };
    const std::size_t settled = std::erase_if(unsettled, is_settled);
    if (unsettled.empty()) return;
    if (round > 1 && settled < unsettled.size() / 4) limit *= 2;
    if (unsettled.size() == 1) limit = std::numeric_limits<Dual>::max();
    std::size_t rest = unsettled.size();
    for (const TriangleId t : unsettled) {
      if (rest-- % 256 == 0) {
        report_progress(progress, "matching",
                        1 - static_cast<double>(unsettled.size()) / static_cast<double>(all));
      }
      if (!is_settled(t)) search.search(t, limit);
    }
  }
}

__extension__ using Wide = __int128;

/// The sum of the duals of the blossoms, each times half of its nodes rounded down.
Wide sum_of_blossoms(const dual::WeightedSearch& search, std::size_t nodes) {
  const dual::Blossoms& blossoms = search.blossoms();
  Wide sum = 0;
  for (auto s = static_cast<SetId>(nodes); s < blossoms.size(); ++s) {
    if (blossoms.is_in_use(s)) sum += Wide{search.blossom_dual(s)} * (blossoms.count(s) / 2);
  }
  return sum;
}

/// The duals of the nodes that a matching uses and of the blossoms bound twice its weight with the
/// bonus. A matching of the greatest size leaves as many nodes out as this one; at the least those
/// with the least duals.
std::int64_t upper_bound(std::vector<Dual> duals, Wide blossoms, MatchingGoal goal,
                         const DualMatching& matching, std::int64_t bonus) {
  std::size_t out = 0;
  if (goal == MatchingGoal::kSizeThenWeight) out = matching.unmatched;
  const auto used = duals.begin() + static_cast<std::ptrdiff_t>(out);
  if (used != duals.end()) std::nth_element(duals.begin(), used, duals.end());
  const Wide sum = std::accumulate(used, duals.end(), blossoms);
  const auto pairs = static_cast<std::int64_t>((duals.size() - matching.unmatched) / 2);
  const Wide bound = sum / 2 - Wide{bonus} * pairs;
  constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max();
  return bound < kMost ? static_cast<std::int64_t>(bound) : kMost;
}

struct PrimalDual {
  MaximumWeightMatching result;
  Wide blossoms = 0;  // see sum_of_blossoms
};

PrimalDual primal_dual(const DualGraph& graph, Weights weight, MatchingGoal goal, int rounds,
                       const Progress& progress) {
  report_progress(progress, "matching", 0);
  dual::check_weights(graph, weight);
  const std::int64_t bonus =
      goal == MatchingGoal::kSizeThenWeight ? dual::bonus_for_size(graph, weight) : 0;
  std::vector<Dual> duals = start_duals(graph, weight, bonus);
  const DualMatching start = start_matching(graph, weight, bonus, duals);
  std::vector<TriangleId> unmatched;
  for (TriangleId t = 0; t < graph.node_count(); ++t) {
    if (start.mate[t] == kNone) unmatched.push_back(t);
  }
  dual::WeightedSearch search(graph, weight, bonus, duals, start);
  settle_nodes(search, std::move(unmatched), first_limit(graph, weight), rounds, progress);

  PrimalDual out;
  out.blossoms = sum_of_blossoms(search, graph.node_count());
  out.result.certificate = write_certificate(search, graph.node_count(), bonus);
  out.result.matching = write_matching(search.blossoms(), graph.node_count());
  out.result.weight = weight_of(out.result.matching, weight);
  return out;
}

}  // namespace

MaximumWeightMatching maximum_weight_matching(const DualGraph& graph, Weights weight,
                                              MatchingGoal goal, const Progress& progress) {
  return primal_dual(graph, weight, goal, std::numeric_limits<int>::max(), progress).result;
}

NearMaximumMatching near_maximum_weight_matching(const DualGraph& graph, Weights weight,
                                                 MatchingGoal goal, const Progress& progress) {
  constexpr int kRounds = 5;
  auto [first, blossoms] = primal_dual(graph, weight, goal, kRounds, progress);
  NearMaximumMatching out{std::move(first.matching), 0, 0};
  if (goal == MatchingGoal::kSizeThenWeight) {
    out.matching = maximum_matching(graph, out.matching).matching;
  }
  out.weight = weight_of(out.matching, weight);
  out.upper_bound = upper_bound(std::move(first.certificate.node_dual), blossoms, goal,
                                out.matching, first.certificate.bonus);
  return out;
}

}  // namespace quadloom
