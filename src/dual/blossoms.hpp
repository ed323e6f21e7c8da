// Blossoms: odd sets of nodes, one inside the other, with a matching that is kept lazily.
#pragma once

#include <cstdint>
#include <vector>

#include "quadloom/dual.hpp"

namespace quadloom::dual {

/// A node (its own number) or a blossom (numbers from the number of nodes up).
using SetId = std::uint32_t;

/// A family of blossoms over the nodes of a graph. The children of a blossom (an odd number of nodes
/// and blossoms) form a cycle, each with the edge to the next. Only sets at the top know their mate;
/// whom the sets inside are matched with follows when the blossom is opened: the child that holds
/// the base takes the blossom's mate, the others are paired along the cycle.
class Blossoms {
 public:
  struct CycleStep {
    SetId set;
    HalfedgeId link;  // from the set to the next one
  };

  explicit Blossoms(const DualGraph& graph);

  bool is_blossom(SetId s) const { return s >= node_count_; }
  std::size_t size() const { return set_.size(); }  // numbers in use are below
  bool is_in_use(SetId s) const { return !set_[s].unused; }
  bool is_at_top(SetId s) const { return set_[s].parent == kNone && is_in_use(s); }
  /// How many nodes the set holds.
  std::uint32_t count(SetId s) const { return is_blossom(s) ? count_[s - node_count_] : 1; }
  SetId parent(SetId s) const { return set_[s].parent; }
  HalfedgeId mate(SetId s) const { return set_[s].mate; }
  /// The node by which a set at the top is matched, or that is unmatched in it.
  TriangleId base(SetId s) const;

  void set_mate(SetId s, HalfedgeId h) { set_[s].mate = h; }
  /// Leaves `node` of the set unmatched.
  void set_free(SetId s, TriangleId node);

  /// A new blossom at the top; the first step of the cycle holds the base.
  SetId make(const std::vector<CycleStep>& cycle);
  /// The children of a blossom, in the order of its cycle.
  const std::vector<CycleStep>& cycle(SetId s);
  /// Puts the children of a blossom at the top and forgets it. The result is its cycle from
  /// `holder`, the child that holds the base.
  const std::vector<CycleStep>& open(SetId s, SetId holder);
  /// The sets that hold the base of `s`, from the node up to `s` itself.
  const std::vector<SetId>& way_to_base(SetId s);
  /// Calls visit(node) for each node of the set.
  template <class Visit>
  void for_each_node(SetId s, Visit visit) const {
    SetId at = s;
    while (true) {
      while (is_blossom(at)) at = first_[at - node_count_];
      visit(static_cast<TriangleId>(at));
      while (at != s && set_[at].next == first_[set_[at].parent - node_count_]) {
        at = set_[at].parent;
      }
      if (at == s) return;
      at = set_[at].next;
    }
  }

 private:
  struct Set {
    SetId parent = kNone;
    SetId next = kNone;       // in the cycle of the parent
    HalfedgeId link = kNone;  // to `next`
    HalfedgeId mate = kNone;  // of a set at the top, from inside
    bool unused = false;      // a number without a blossom
  };

  const DualGraph& graph_;
  const SetId node_count_;
  std::vector<Set> set_;
  std::vector<SetId> first_;  // of blossoms: a child
  std::vector<std::uint32_t> count_;
  std::vector<TriangleId> free_;  // of blossoms without a mate: the unmatched node
  std::vector<SetId> unused_;
  std::vector<CycleStep> cycle_;
  std::vector<SetId> way_;
};

}  // namespace quadloom::dual
