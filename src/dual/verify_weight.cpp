// Checks the proof that comes with a maximum-weight matching, from the graph and the weights alone.
//
// Weak duality (Edmonds 1965): a matching M takes at most floor(|B| / 2) edges inside a set B, so
//   sum over M of 2 (weight + bonus) <= sum of node duals + sum of set duals x floor(|B| / 2)
// if no dual is negative and every edge is covered. Equality proves that M is maximum for weight +
// bonus; with a bonus above every difference of weights the size counts first.
#include <utility>

#include "dual/weights.hpp"
#include "quadloom/dual.hpp"

namespace quadloom {
namespace {

__extension__ using Wide = __int128;
using Weights = std::span<const std::int32_t>;

/// The sets as a forest, for sums along the way up from the first set that holds two nodes. Deep
/// nests are cut into chains of largest children, so that a way crosses O(log n) chains.
class SetForest {
 public:
  explicit SetForest(const WeightCertificate& proof) : proof_(proof) {
    is_valid_ = order_upwards();
    if (is_valid_) sum_downwards();
  }

  bool is_valid() const { return is_valid_; }
  std::uint32_t count(std::size_t s) const { return count_[s]; }

  /// The sum of the duals of the sets that hold both nodes.
  Wide common_sum(TriangleId a, TriangleId b) const {
    std::uint32_t s = proof_.set_of_node[a], t = proof_.set_of_node[b];
    while (s != kNone && t != kNone && chain_[s] != chain_[t]) {
      if (count_[chain_[s]] > count_[chain_[t]]) std::swap(s, t);
      s = proof_.parent_of_set[chain_[s]];
    }
    if (s == kNone || t == kNone) return 0;
    return sum_[count_[s] > count_[t] ? s : t];
  }

 private:
  /// Children before parents; counts nodes. False if a number is out of range, parents go in a
  /// circle, or a set holds no more than one of its children.
  bool order_upwards() {
    const std::size_t sets = proof_.set_dual.size();
    std::vector<std::uint32_t> children(sets);
    for (const std::uint32_t p : proof_.parent_of_set) {
      if (p != kNone && p >= sets) return false;
      if (p != kNone) ++children[p];
    }
    count_.assign(sets, 0);
    for (const std::uint32_t s : proof_.set_of_node) {
      if (s != kNone && s >= sets) return false;
      if (s != kNone) ++count_[s];
    }
    for (std::uint32_t s = 0; s < sets; ++s) {
      if (children[s] == 0) order_.push_back(s);
    }
    largest_child_.assign(sets, kNone);
    for (std::size_t i = 0; i < order_.size(); ++i) {
      const std::uint32_t s = order_[i], p = proof_.parent_of_set[s];
      if (count_[s] == 0) return false;
      if (largest_child_[s] != kNone && count_[largest_child_[s]] == count_[s]) return false;
      if (p == kNone) continue;
      count_[p] += count_[s];
      if (largest_child_[p] == kNone || count_[largest_child_[p]] < count_[s])
        largest_child_[p] = s;
      if (--children[p] == 0) order_.push_back(p);
    }
    return order_.size() == sets;
  }

  void sum_downwards() {
    chain_.assign(order_.size(), kNone);
    sum_.assign(order_.size(), 0);
    for (std::size_t i = order_.size(); i-- > 0;) {
      const std::uint32_t s = order_[i], p = proof_.parent_of_set[s];
      chain_[s] = p != kNone && largest_child_[p] == s ? chain_[p] : s;
      sum_[s] = proof_.set_dual[s] + (p == kNone ? 0 : sum_[p]);
    }
  }

  const WeightCertificate& proof_;
  bool is_valid_ = false;
  std::vector<std::uint32_t> order_, count_, largest_child_;
  std::vector<std::uint32_t> chain_;  // the outermost set of the set's chain
  std::vector<Wide> sum_;             // of the duals of the set and all that hold it
};

bool no_dual_is_negative(const WeightCertificate& proof) {
  for (const std::int64_t y : proof.node_dual) {
    if (y < 0) return false;
  }
  for (const std::int64_t z : proof.set_dual) {
    if (z < 0) return false;
  }
  return true;
}

bool every_edge_is_covered(const DualGraph& graph, Weights weight, const WeightCertificate& proof,
                           const SetForest& sets) {
  for (HalfedgeId h = 0; h < graph.twin.size(); ++h) {
    if (graph.twin[h] == kNone || graph.twin[h] < h) continue;
    const TriangleId a = triangle_of(h), b = graph.across(h);
    const Wide nodes = Wide{proof.node_dual[a]} + proof.node_dual[b];
    const Wide needed = 2 * (Wide{weight[h]} + proof.bonus);
    if (nodes < needed && nodes + sets.common_sum(a, b) < needed) return false;
  }
  return true;
}

Wide dual_sum(const WeightCertificate& proof, const SetForest& sets) {
  Wide sum = 0;
  for (const std::int64_t y : proof.node_dual) sum += y;
  for (std::size_t s = 0; s < proof.set_dual.size(); ++s) {
    sum += Wide{proof.set_dual[s]} * (sets.count(s) / 2);
  }
  return sum;
}

}  // namespace

bool verify_weight(const DualGraph& graph, Weights weight, MatchingGoal goal,
                   const MaximumWeightMatching& result) {
  dual::check_weights(graph, weight);
  const WeightCertificate& proof = result.certificate;
  const std::int64_t bonus =
      goal == MatchingGoal::kSizeThenWeight ? dual::bonus_for_size(graph, weight) : 0;
  if (!is_matching(graph, result.matching)) return false;
  if (weight_of(result.matching, weight) != result.weight) return false;
  if (goal == MatchingGoal::kWeight ? proof.bonus != 0 : proof.bonus < bonus) return false;
  if (proof.node_dual.size() != graph.node_count() ||
      proof.set_of_node.size() != graph.node_count() ||
      proof.parent_of_set.size() != proof.set_dual.size()) {
    return false;
  }
  const SetForest sets(proof);
  if (!sets.is_valid()) return false;
  const auto pairs =
      static_cast<std::int64_t>((graph.node_count() - result.matching.unmatched) / 2);
  return no_dual_is_negative(proof) && every_edge_is_covered(graph, weight, proof, sets) &&
         dual_sum(proof, sets) == 2 * (Wide{result.weight} + Wide{proof.bonus} * pairs);
}

}  // namespace quadloom
