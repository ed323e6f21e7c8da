// The dual graph of a triangulation and its matchings.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "quadloom/core.hpp"

namespace quadloom {

// ---- The graph. ----

/// A graph without loops whose nodes have at most three edges. In the dual graph of a triangulation
/// the nodes are the triangles; node t has the slots 3t, 3t + 1, 3t + 2, its halfedges, and twin[h]
/// is the other end of the edge at slot h, kNone where there is no edge. Two nodes may share more
/// than one edge (closed surfaces).
struct DualGraph {
  std::vector<HalfedgeId> twin;

  std::size_t node_count() const { return twin.size() / 3; }
  /// The node at the other end of the edge at slot h.
  TriangleId across(HalfedgeId h) const { return triangle_of(twin[h]); }
};

/// All inner edges of the triangulation. Throws Error kBadMesh if its twins do not agree.
DualGraph dual_graph(const Triangulation& mesh);

/// The same without the edges that must stay: forbidden[h] != 0 on either side, by halfedge
/// (protected features, borders of regions). Throws Error kBadOption if the size is wrong.
DualGraph dual_graph(const Triangulation& mesh, std::span<const std::uint8_t> forbidden);

/// A spanning tree of each component: the edges by which a breadth-first search from the smallest
/// node found the others. O(n).
DualGraph spanning_forest(const DualGraph& graph);

// ---- Matchings. ----

/// A matching of the dual graph: mate[t] is the halfedge of triangle t that it shares with its
/// partner, kNone if t is unmatched. twin[mate[t]] is the partner's halfedge.
struct DualMatching {
  std::vector<HalfedgeId> mate;
  std::size_t unmatched = 0;
};

/// Whether `matching` is one: mates are edges of the graph, mutual, and the count is right. O(n).
bool is_matching(const DualGraph& graph, const DualMatching& matching);

/// Pairs of triangles in order of shape, the best first (see quad_shape); pairs whose quad is not
/// strictly convex stay unmatched. At least half of the maximum weight. Ties go to the smaller
/// halfedge.
DualMatching greedy_shape_matching(const Triangulation& mesh);

/// A matching of the greatest size, and why there is none greater: without the nodes of the barrier
/// the graph has matching.unmatched + barrier.size() odd components, and each barrier node can
/// serve only one of them (Tutte and Berge).
struct MaximumMatching {
  DualMatching matching;
  std::vector<TriangleId> barrier;  ///< ascending; empty if the matching is perfect
};

/// A maximum matching by Edmonds' algorithm; `start` (a matching of the graph) is augmented, what
/// it matches stays matched. The first form starts from its own greedy matching. Near-linear in
/// practice.
MaximumMatching maximum_matching(const DualGraph& graph);
MaximumMatching maximum_matching(const DualGraph& graph, const DualMatching& start);

/// Whether the matching is one and the barrier proves that it is maximum; counts the odd components
/// from the graph alone. O(n).
bool verify_tutte_berge(const DualGraph& graph, const MaximumMatching& result);

// ---- Matchings with weights. Weights are integers by halfedge, the same on both sides. ----

/// The weight of a pair of triangles by shape: 1 + 65,535 x quad_shape of their quad, rounded down,
/// if it is strictly convex (exactly), else 0. With z, one a vertex, the mesh is a surface in space:
/// the shape is that of the angles in space, and a pair weighs 0 if it is not strictly convex in the
/// coordinate plane that it is nearest to, or folded by more than 90 degrees. The same integers on
/// every platform. Throws Error kBadOption if the size of z is wrong.
std::vector<std::int32_t> shape_weights(const Triangulation& mesh, std::span<const double> z = {});
std::vector<std::int32_t> shape_weights(const TriangleMesh& mesh);

/// The graph without the edges that weigh less than `least`: with shape weights and 1, the pairs
/// that are strictly convex.
DualGraph heavy_edges(const DualGraph& graph, std::span<const std::int32_t> weight,
                      std::int32_t least);

/// What the best matching is.
enum class MatchingGoal {
  kWeight,          ///< the greatest weight; edges of weight 0 or less need not be used
  kSizeThenWeight,  ///< the greatest weight among the matchings of the greatest size; perfect if
                    ///< there is a perfect one
};

/// Why no matching is better (Edmonds' linear program): the duals of the nodes of an edge and of the
/// sets that hold both of them sum up to at least twice its weight plus bonus; over all nodes, and
/// sets times half their size rounded down, the duals sum up to that of the matching. No dual is
/// negative. The bonus is 0, or for kSizeThenWeight so large that size counts first.
struct WeightCertificate {
  std::int64_t bonus = 0;
  std::vector<std::int64_t> node_dual;
  std::vector<std::uint32_t> set_of_node;  ///< the smallest set that holds the node, kNone if none
  std::vector<std::uint32_t> parent_of_set;  ///< the next larger set, kNone if none
  std::vector<std::int64_t> set_dual;
};

struct MaximumWeightMatching {
  DualMatching matching;
  std::int64_t weight = 0;  ///< of the matching
  WeightCertificate certificate;
};

/// The best matching, proven. Throws Error kBadOption if the weights are not one a halfedge and the
/// same on both sides, or so large that sums do not fit 62 bits; kCancelled. Seconds for a million nodes.
MaximumWeightMatching maximum_weight_matching(const DualGraph& graph,
                                              std::span<const std::int32_t> weight,
                                              MatchingGoal goal, const Progress& progress = {});

/// A good matching in about half of the time: the first rounds of the exact algorithm, then, for
/// kSizeThenWeight, the missing pairs by maximum_matching. The size is exact, the weight is within
/// upper_bound - weight of the best one (figures: docs/algorithms/matching.md). Throws as
/// maximum_weight_matching.
struct NearMaximumMatching {
  DualMatching matching;
  std::int64_t weight = 0;
  std::int64_t upper_bound = 0;  ///< no matching of the goal weighs more
};
NearMaximumMatching near_maximum_weight_matching(const DualGraph& graph,
                                                 std::span<const std::int32_t> weight,
                                                 MatchingGoal goal, const Progress& progress = {});

/// Whether the matching is one, has the weight that it says, and the certificate proves that none is
/// better; from the graph and the weights alone.
bool verify_weight(const DualGraph& graph, std::span<const std::int32_t> weight, MatchingGoal goal,
                   const MaximumWeightMatching& result);

/// The weight of a matching.
std::int64_t weight_of(const DualMatching& matching, std::span<const std::int32_t> weight);

// ---- Trees (Ramaswami, Ramos and Toussaint, section 3). A forest is taken tree by tree. ----

/// Theorem 3.1: a maximum matching of a forest. Throws Error kBadMesh if the graph has a cycle.
/// O(n).
DualMatching percolate_up(const DualGraph& forest);

/// Theorem 3.2: a maximum matching of a forest in which every unmatched node is a leaf (has at most
/// one edge). Throws Error kBadMesh if the graph has a cycle. O(n).
DualMatching percolate_up_and_down(const DualGraph& forest);

}  // namespace quadloom
