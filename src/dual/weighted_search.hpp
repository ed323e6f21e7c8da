// Edmonds' primal-dual search for maximum-weight matchings, one unmatched node at a time.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dual/blossoms.hpp"
#include "dual/top_sets.hpp"
#include "quadloom/dual.hpp"

namespace quadloom::dual {

/// The state between searches (see the source for the conditions that it keeps): dual variables of
/// nodes and blossoms, and the matching of the sets at the top.
class WeightedSearch {
 public:
  /// Weights by halfedge, `bonus` added to each. The duals must be feasible for all edges, and the
  /// edges of the matching tight; unmatched nodes may have any dual of at least 0.
  WeightedSearch(const DualGraph& graph, std::span<const std::int32_t> weight, std::int64_t bonus,
                 std::span<const Dual> dual, const DualMatching& matching);

  /// Ends with `root`, an unmatched node, matched or with the dual 0, or with its dual lower by
  /// `limit`.
  void search(TriangleId root, Dual limit);

  /// Whether the node is matched or has the dual 0.
  bool is_settled(TriangleId t) const;
  Dual dual(TriangleId t) const { return tops_.dual(t); }
  Dual blossom_dual(SetId s) const { return blossom_dual_[s - graph_.node_count()]; }
  const Blossoms& blossoms() const { return blossoms_; }
  Blossoms& blossoms() { return blossoms_; }

 private:
  enum class Label : std::uint8_t { kOutside, kOuter, kInner };
  struct State {
    SetId above = 0;                // union-find over the sets that were at the top
    SetId name = 0;                 // of a root: the set at the top now
    HalfedgeId entry = kNone;       // inner: the tree edge, seen from the outer set before it
    std::uint32_t waiting = kNone;  // inner: the first of the edges from outer nodes
    std::uint32_t stamp = 0;
    Label label = Label::kOutside;
  };
  struct WaitingEdge {
    HalfedgeId edge;
    std::uint32_t next;
  };
  struct Event {
    Dual time;
    std::uint32_t what;  // a halfedge out of an outer node, or an inner blossom
    bool operator<(const Event& other) const { return time > other.time; }  // earliest on top
  };

  Dual doubled(HalfedgeId h) const { return 2 * (weight_[h] + bonus_); }
  Dual& blossom_dual(SetId s) { return blossom_dual_[s - graph_.node_count()]; }
  Label label(TriangleId t) { return state_[top(t)].label; }
  SetId find(SetId s);
  SetId top(TriangleId t);
  void clear_state(SetId s);
  HalfedgeId mate(SetId s) const { return blossoms_.mate(s); }

  void make_outer(SetId s, Dual amount);
  void make_inner(SetId s, HalfedgeId entry, Dual amount);
  void scan_outer(SetId s);
  void scan_edge(HalfedgeId h, SetId near);
  void add_edge_event(Dual time, HalfedgeId h);
  void add_blossom_event(SetId s);

  bool advance();
  bool handle_edge(HalfedgeId h);
  void grow(HalfedgeId h);
  SetId outer_above(SetId s);
  SetId common_set(SetId a, SetId b);
  void shrink(HalfedgeId h);
  void unite(SetId made);
  void expand(SetId s);
  void label_part(const std::vector<Blossoms::CycleStep>& cycle, HalfedgeId entry);
  void flip(SetId s, HalfedgeId h, TriangleId node);
  void settle();
  void settle_outer(SetId s);
  void collect_parts(SetId s);
  void dissolve(SetId s);

  const DualGraph& graph_;
  std::span<const std::int32_t> weight_;
  const std::int64_t bonus_;
  Blossoms blossoms_;
  TopSets tops_;  // before this search's shrinking; the duals in it: see the source
  std::vector<Dual> blossom_dual_;
  std::vector<State> state_;

  Dual now_ = 0;  // by how much the root's dual has gone down
  Dual end_ = 0;  // when the first outer node's dual will be 0
  Dual limit_ = 0;
  TriangleId end_node_ = kNone;
  std::uint32_t round_ = 0;
  std::vector<SetId> tree_;                          // what has got a label in this search
  std::vector<HalfedgeId> tight_;                    // edge events whose time is now
  std::vector<Event> edge_events_, blossom_events_;  // heaps
  std::vector<Blossoms::CycleStep> cycle_;
  std::vector<WaitingEdge> waiting_;
  std::vector<SetId> stack_, parts_, at_top_;
};

}  // namespace quadloom::dual
