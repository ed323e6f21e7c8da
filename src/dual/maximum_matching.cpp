// Maximum matching of a degree-3 graph by Edmonds' blossom algorithm.
//
// Theorem (Edmonds 1965; Berge 1957): a matching is maximum if and only if no alternating path joins
// two unmatched nodes. A search grows an alternating tree from one unmatched node, breadth first:
//
//     root ----- inner ===== outer ----- inner ===== outer       --- not matched, === matched
//
//   1. grow        an unmatched edge from an outer node to a node that is not in the tree takes that
//                  node as an inner one and its mate as an outer one; an unmatched one ends the path
//   2. shrink      an edge between two outer nodes closes an odd cycle (a blossom): all of its nodes
//                  can be reached as outer ones, so its inner nodes become outer too and remember the
//                  edge that closed it (their bridge); a union-find keeps each blossom's base
//   3. augment     the edges along the path from tree edges and bridges become the matching
//   4. freeze      if the search ends without a path, its nodes never take part in another one
//                  (Edmonds' Hungarian trees); the inner nodes of the frozen trees are the barrier
//
// Why the barrier proves the result: when a tree freezes, an outer blossom has only inner nodes of
// this tree or of earlier ones as neighbours. So without the barrier each outer blossom is a
// component, it is odd, and a tree has one more of them than inner nodes.
//
// What differs from the textbook: a greedy start (sparse_start) that leaves few searches; a search
// resets only what it touched; no recursion, a path is collected as a set of edges with a stack of
// pieces. Degenerate input: loops must not be there, double edges and empty graphs are fine. Cost:
// O(n m a(n)) in the worst case; a search ends at the nearest unmatched node, and failed searches
// are O(n) together, so near-linear in practice.
#include <utility>

#include "dual/sparse_start.hpp"
#include "quadloom/dual.hpp"

namespace quadloom {
namespace {

enum class Label : std::uint8_t { kOutside, kOuter, kInner, kFrozenOuter, kFrozenInner };

struct Node {
  TriangleId above = 0;       // union-find: the base is its own
  HalfedgeId entry = kNone;   // inner: the tree edge, seen from the outer node before it
  HalfedgeId bridge = kNone;  // inner, but in a blossom: the edge that closed it, near end first
  Label label = Label::kOutside;
  bool in_blossom = false;  // was inner, became outer
};

class Edmonds {
 public:
  Edmonds(const DualGraph& graph, DualMatching matching)
      : graph_(graph), matching_(std::move(matching)), node_(graph.node_count()) {
    for (TriangleId t = 0; t < node_.size(); ++t) node_[t].above = t;
    stamp_.assign(node_.size(), 0);
  }

  MaximumMatching run() {
    for (TriangleId root = 0; root < node_.size(); ++root) {
      if (is_free(root) && !search(root)) freeze();
    }
    return {std::move(matching_), barrier()};
  }

 private:
  bool is_free(TriangleId t) const { return matching_.mate[t] == kNone; }
  TriangleId mate(TriangleId t) const { return graph_.across(matching_.mate[t]); }

  TriangleId base(TriangleId t) {
    while (node_[t].above != t) {
      node_[t].above = node_[node_[t].above].above;
      t = node_[t].above;
    }
    return t;
  }

  /// True: the matching has grown by one edge.
  bool search(TriangleId root) {
    queue_.clear();
    inner_.clear();
    make_outer(root);
    std::size_t next = 0;
    while (next < queue_.size()) {  // the queue grows on the way
      const TriangleId t = queue_[next++];
      for (HalfedgeId h = 3 * t; h < 3 * t + 3; ++h) {
        if (graph_.twin[h] == kNone) continue;
        const TriangleId other = graph_.across(h);
        if (node_[other].label == Label::kOutside) {
          if (is_free(other)) {
            augment(h, root);
            reset();
            return true;
          }
          grow(h);
        } else if (node_[other].label == Label::kOuter && base(t) != base(other)) {
          shrink(h);
        }
      }
    }
    return false;
  }

  void make_outer(TriangleId t) {
    node_[t].label = Label::kOuter;
    queue_.push_back(t);
  }

  void grow(HalfedgeId h) {
    const TriangleId inner = graph_.across(h);
    node_[inner].label = Label::kInner;
    node_[inner].entry = h;
    inner_.push_back(inner);
    make_outer(mate(inner));
  }

  /// The base two steps nearer to the root, kNone at the root.
  TriangleId outer_above(TriangleId base_node) {
    if (is_free(base_node)) return kNone;
    return base(triangle_of(node_[mate(base_node)].entry));
  }

  //            common               The two ends walk up in turns, so that the cost is the cycle's
  //            /    .               length; the first base that both have stamped is the blossom's.
  //         inner   inner
  //          //      ..
  //       outer --h-- outer
  void shrink(HalfedgeId h) {
    const TriangleId near = base(triangle_of(h)), far = base(graph_.across(h));
    const TriangleId common = common_base(near, far);
    contract(near, common, h);
    contract(far, common, graph_.twin[h]);
  }

  TriangleId common_base(TriangleId a, TriangleId b) {
    ++round_;
    while (true) {
      if (a != kNone) {
        if (stamp_[a] == round_) return a;
        stamp_[a] = round_;
        a = outer_above(a);
      }
      std::swap(a, b);
    }
  }

  void contract(TriangleId from, TriangleId common, HalfedgeId bridge) {
    while (from != common) {
      const TriangleId inner = mate(from), up = outer_above(from);
      node_[inner].bridge = bridge;
      node_[inner].in_blossom = true;
      make_outer(inner);
      node_[from].above = common;
      node_[inner].above = common;
      from = up;
    }
  }

  /// Matches along the path from the free end of h to the root. The path from an outer node t to an
  /// outer node above it: if t has always been outer, over its mate's tree edge; if it was inner,
  /// from the near end of its bridge up to its mate, taken backwards, over the bridge, and on from
  /// the bridge's far end.
  void augment(HalfedgeId h, TriangleId root) {
    path_.assign(1, h);
    pieces_.assign(1, {triangle_of(h), root});
    while (!pieces_.empty()) {
      auto [from, to] = pieces_.back();
      pieces_.pop_back();
      while (from != to) {
        if (node_[from].in_blossom) {
          const HalfedgeId bridge = node_[from].bridge;
          path_.push_back(bridge);
          pieces_.emplace_back(triangle_of(bridge), mate(from));
          from = graph_.across(bridge);
        } else {
          const HalfedgeId entry = node_[mate(from)].entry;
          path_.push_back(entry);
          from = triangle_of(entry);
        }
      }
    }
    for (const HalfedgeId e : path_) {
      matching_.mate[triangle_of(e)] = e;
      matching_.mate[graph_.across(e)] = graph_.twin[e];
    }
    matching_.unmatched -= 2;
  }

  void reset() {
    for (const TriangleId t : queue_) node_[t] = {t, kNone, kNone, Label::kOutside, false};
    for (const TriangleId t : inner_) node_[t] = {t, kNone, kNone, Label::kOutside, false};
  }

  void freeze() {
    for (const TriangleId t : inner_) {
      if (!node_[t].in_blossom) node_[t].label = Label::kFrozenInner;
    }
    for (const TriangleId t : queue_) node_[t].label = Label::kFrozenOuter;
  }

  std::vector<TriangleId> barrier() const {
    std::vector<TriangleId> out;
    for (TriangleId t = 0; t < node_.size(); ++t) {
      if (node_[t].label == Label::kFrozenInner) out.push_back(t);
    }
    return out;
  }

  const DualGraph& graph_;
  DualMatching matching_;
  std::vector<Node> node_;
  std::vector<std::uint32_t> stamp_;
  std::uint32_t round_ = 0;
  std::vector<TriangleId> queue_;  // the outer nodes of this search
  std::vector<TriangleId> inner_;  // those that entered it as inner ones
  std::vector<HalfedgeId> path_;
  std::vector<std::pair<TriangleId, TriangleId>> pieces_;
};

}  // namespace

MaximumMatching maximum_matching(const DualGraph& graph) {
  return Edmonds(graph, dual::sparse_start(graph)).run();
}

MaximumMatching maximum_matching(const DualGraph& graph, const DualMatching& start) {
  if (!is_matching(graph, start)) {
    throw Error(ErrorCode::kBadOption, "the start is not a matching of the graph");
  }
  return Edmonds(graph, start).run();
}

}  // namespace quadloom
