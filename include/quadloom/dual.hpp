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

// ---- Trees (Ramaswami, Ramos and Toussaint, section 3). A forest is taken tree by tree. ----

/// Theorem 3.1: a maximum matching of a forest. Throws Error kBadMesh if the graph has a cycle.
/// O(n).
DualMatching percolate_up(const DualGraph& forest);

/// Theorem 3.2: a maximum matching of a forest in which every unmatched node is a leaf (has at most
/// one edge). Throws Error kBadMesh if the graph has a cycle. O(n).
DualMatching percolate_up_and_down(const DualGraph& forest);

}  // namespace quadloom
