// Edmonds' primal-dual search for maximum-weight matchings, one unmatched node at a time.
//
// Theorem (Edmonds 1965): let every node have a dual y >= 0 and every blossom a dual z >= 0 such that
// each edge uv has slack y(u) + y(v) + sum of z over the blossoms that hold both - 2 weight >= 0. If
// each matched edge has slack 0, each blossom with z > 0 is matched inside but for one node, and each
// unmatched node has y = 0, then no matching weighs more. A search from an unmatched node with y > 0
// keeps the first three conditions and ends with that node matched or another one unmatched at y = 0.
//
// A search grows an alternating tree of sets (nodes and blossoms at the top of the family) over
// edges of slack 0. When there is none, the duals of outer nodes go down and those of inner nodes up
// by the same amount (blossoms: by twice that, the other way round) until there is something to do:
//
//   1. grow      an edge from an outer set to one outside the tree gets slack 0
//   2. shrink    an edge between two outer sets gets slack 0: they and the sets between them and
//                their first common one become a blossom, an outer set
//   3. expand    the dual of an inner blossom gets 0: it is opened, its children on the way from its
//                entry to its base stay in the tree, the others leave it
//   4. flip      grow has met an unmatched set: the tree path to it changes sides; or the dual of an
//                outer node gets 0: it becomes the unmatched node instead of the root
//   5. settle    duals and sets at the top are written back; new blossoms with z = 0 are dissolved
//
// The changes are lazy. now_ is the amount so far; an outer node keeps y + now_, an inner one
// y - now_, an outer blossom z - 2 now_, an inner one z + 2 now_, so that nothing but a change of
// label touches them, and what is due when is a constant: edge events at the kept y(u) + y(v) - 2w
// (outer to outside), half of that (outer to outer), blossom events at half the kept z. Events that
// are out of date are recognised when they come up. All of it is integers: along tight edges the
// duals have the same parity, so the slack between two outer nodes is even.
//
// What differs from the textbook: one tree at a time, so a search is local and ends at the nearest
// unmatched node in terms of slack; matchings inside blossoms are lazy (see blossoms.hpp); outer
// blossoms merge by union-find; there is no recursion. Cost: a search takes O(k log k) for the k
// nodes of its tree, but for nodes in inner blossoms that are expanded once a level.
#include "dual/weighted_search.hpp"

#include <algorithm>
#include <utility>

namespace quadloom::dual {

WeightedSearch::WeightedSearch(const DualGraph& graph, std::span<const std::int32_t> weight,
                               std::int64_t bonus, std::span<const Dual> dual,
                               const DualMatching& matching)
    : graph_(graph),
      weight_(weight),
      bonus_(bonus),
      blossoms_(graph),
      tops_(blossoms_, dual),
      state_(graph.node_count()) {
  for (TriangleId t = 0; t < graph.node_count(); ++t) {
    state_[t].above = state_[t].name = t;
    blossoms_.set_mate(t, matching.mate[t]);
  }
}

bool WeightedSearch::is_settled(TriangleId t) const {
  const SetId s = tops_.holder(t);
  return blossoms_.base(s) != t || mate(s) != kNone || tops_.dual(t) == 0;
}

void WeightedSearch::search(TriangleId root, Dual limit) {
  now_ = 0;
  limit_ = limit;
  end_node_ = kNone;
  const SetId s = tops_.holder(root);
  make_outer(s, 0);
  scan_outer(s);
  while (advance()) {
  }
  settle();
}

SetId WeightedSearch::find(SetId s) {
  while (state_[s].above != s) {
    state_[s].above = state_[state_[s].above].above;
    s = state_[s].above;
  }
  return s;
}

SetId WeightedSearch::top(TriangleId t) { return state_[find(tops_.holder(t))].name; }

/// Makes `s` a set of its own.
void WeightedSearch::clear_state(SetId s) {
  state_[s] = {s, s, kNone, kNone, state_[s].stamp, Label::kOutside};
}

// ---- Labels. `amount` is what the kept duals of the nodes change by. ----

void WeightedSearch::make_outer(SetId s, Dual amount) {
  tops_.add_to_nodes(s, amount);
  if (blossoms_.is_blossom(s)) blossom_dual(s) -= 2 * now_;
  state_[s].label = Label::kOuter;
  tree_.push_back(s);
}

void WeightedSearch::make_inner(SetId s, HalfedgeId entry, Dual amount) {
  tops_.add_to_nodes(s, amount);
  state_[s].label = Label::kInner;
  state_[s].entry = entry;
  tree_.push_back(s);
  if (blossoms_.is_blossom(s)) {
    blossom_dual(s) += 2 * now_;
    add_blossom_event(s);
  }
}

// ---- Events. ----

void WeightedSearch::add_edge_event(Dual time, HalfedgeId h) {
  if (time == now_) {
    tight_.push_back(h);
    return;
  }
  edge_events_.push_back({time, h});
  std::push_heap(edge_events_.begin(), edge_events_.end());
}

void WeightedSearch::add_blossom_event(SetId s) {
  blossom_events_.push_back({blossom_dual(s) / 2, s});
  std::push_heap(blossom_events_.begin(), blossom_events_.end());
}

/// The edge at h from a node of the outer set `near`: what can happen there, and when.
void WeightedSearch::scan_edge(HalfedgeId h, SetId near) {
  const TriangleId from = triangle_of(h), to = graph_.across(h);
  const SetId other = top(to);
  const Label label = state_[other].label;
  if (label == Label::kInner) {
    if (!blossoms_.is_blossom(other)) return;
    waiting_.push_back({h, state_[other].waiting});
    state_[other].waiting = static_cast<std::uint32_t>(waiting_.size() - 1);
    return;
  }
  if (label == Label::kOuter && other == near) return;
  const Dual sum = tops_.dual(from) + tops_.dual(to) - doubled(h);
  add_edge_event(label == Label::kOuter ? sum / 2 : sum, h);
}

void WeightedSearch::scan_outer(SetId s) {
  const SetId near = top(blossoms_.base(s));
  blossoms_.for_each_node(s, [&](TriangleId t) {
    if (end_node_ == kNone || tops_.dual(t) < end_) {
      end_ = tops_.dual(t);
      end_node_ = t;
    }
    for (HalfedgeId h = 3 * t; h < 3 * t + 3; ++h) {
      if (graph_.twin[h] != kNone && tops_.holder(graph_.across(h)) != s) scan_edge(h, near);
    }
  });
}

/// Handles the next event; false when the search has ended.
bool WeightedSearch::advance() {
  if (!tight_.empty()) {
    const HalfedgeId h = tight_.back();
    tight_.pop_back();
    return handle_edge(h);
  }
  const bool blossom_first =
      !blossom_events_.empty() &&
      (edge_events_.empty() || blossom_events_.front().time <= edge_events_.front().time);
  std::vector<Event>& events = blossom_first ? blossom_events_ : edge_events_;
  if (events.empty() || events.front().time > std::min(end_, limit_)) {
    now_ = std::min(end_, limit_);
    if (now_ == end_) flip(top(end_node_), kNone, end_node_);
    return false;
  }
  std::pop_heap(events.begin(), events.end());
  const Event event = events.back();
  events.pop_back();
  now_ = event.time;
  if (!blossom_first) return handle_edge(event.what);
  const State& state = state_[event.what];
  if (blossoms_.is_at_top(event.what) && state.label == Label::kInner &&
      blossom_dual(event.what) == 2 * now_) {
    expand(event.what);
  }
  return true;
}

bool WeightedSearch::handle_edge(HalfedgeId h) {
  const TriangleId from = triangle_of(h), to = graph_.across(h);
  const SetId near = top(from), far = top(to);
  const Dual sum = tops_.dual(from) + tops_.dual(to) - doubled(h);
  if (state_[far].label == Label::kOuter) {
    if (near != far && sum == 2 * now_) shrink(h);
  } else if (state_[far].label == Label::kInner || sum > now_) {
    scan_edge(h, near);  // out of date: `far` is or has been an inner set
  } else if (mate(far) != kNone) {
    grow(h);
  } else {
    blossoms_.set_mate(far, graph_.twin[h]);
    flip(near, h, kNone);
    return false;
  }
  return true;
}

// ---- The tree. ----

void WeightedSearch::grow(HalfedgeId h) {
  const SetId inner = top(graph_.across(h));
  const SetId outer = top(graph_.across(mate(inner)));
  make_inner(inner, h, -now_);
  make_outer(outer, now_);
  scan_outer(outer);
}

/// The outer set two steps nearer to the root, kNone at the root.
SetId WeightedSearch::outer_above(SetId s) {
  if (mate(s) == kNone) return kNone;
  return top(triangle_of(state_[top(graph_.across(mate(s)))].entry));
}

SetId WeightedSearch::common_set(SetId a, SetId b) {
  ++round_;
  while (true) {
    if (a != kNone) {
      if (state_[a].stamp == round_) return a;
      state_[a].stamp = round_;
      a = outer_above(a);
    }
    std::swap(a, b);
  }
}

//          common             The cycle goes from the common set down to the near end of h, over h
//          /    .             and up again.
//       inner   inner
//        //      ..
//     outer --h-- outer
void WeightedSearch::shrink(HalfedgeId h) {
  const SetId near = top(triangle_of(h)), far = top(graph_.across(h));
  const SetId common = common_set(near, far);
  cycle_.assign(1, {near, h});
  for (SetId s = near; s != common;) {
    const SetId inner = top(graph_.across(mate(s)));
    cycle_.push_back({inner, mate(inner)});
    s = outer_above(s);
    cycle_.push_back({s, state_[inner].entry});
  }
  std::reverse(cycle_.begin(), cycle_.end());
  for (SetId s = far; s != common; s = outer_above(s)) {
    const SetId inner = top(graph_.across(mate(s)));
    cycle_.push_back({s, mate(s)});
    cycle_.push_back({inner, graph_.twin[state_[inner].entry]});
  }
  const SetId made = blossoms_.make(cycle_);
  if (made >= state_.size()) {
    state_.emplace_back();
    blossom_dual_.emplace_back();
  }
  clear_state(made);
  state_[made].label = Label::kOuter;
  blossom_dual(made) = -2 * now_;
  tree_.push_back(made);
  for (const auto& [s, link] : cycle_) {
    const bool inner = state_[s].label == Label::kInner;
    if (blossoms_.is_blossom(s)) blossom_dual(s) += inner ? -2 * now_ : 2 * now_;
    if (inner) tops_.add_to_nodes(s, 2 * now_);
  }
  unite(made);
  for (const auto& [s, link] : cycle_) {
    if (state_[s].label == Label::kInner) scan_outer(s);
  }
}

/// The children of `made`, in cycle_, become one set in the union-find, under the largest one's root.
void WeightedSearch::unite(SetId made) {
  SetId largest = cycle_.front().set;
  for (const auto& [s, link] : cycle_) {
    if (blossoms_.count(s) > blossoms_.count(largest)) largest = s;
  }
  const SetId root = find(largest);
  for (const auto& [s, link] : cycle_) state_[find(s)].above = root;
  state_[made].above = root;
  state_[root].name = made;
}

//        base ===== outer          From the entry to the base along the side of even length: inner,
//        /    .                    outer, ..., inner. The other children are matched with each other
//      out     outer               and leave the tree.
//      ##       ##
//      out --- inner (entry)
void WeightedSearch::expand(SetId s) {
  const HalfedgeId entry = state_[s].entry;
  const TriangleId base = blossoms_.base(s);
  std::uint32_t waiting = state_[s].waiting;
  state_[s].label = Label::kOutside;
  tops_.split(s, blossoms_.cycle(s));
  cycle_ = blossoms_.open(s, tops_.holder(base));
  for (const auto& [child, link] : cycle_) {
    clear_state(child);
  }
  label_part(cycle_, entry);
  for (const auto& [child, link] : cycle_) {
    if (state_[child].label == Label::kOutside) tops_.add_to_nodes(child, now_);
  }
  for (const auto& [child, link] : cycle_) {
    if (state_[child].label == Label::kOuter) scan_outer(child);
  }
  for (; waiting != kNone; waiting = waiting_[waiting].next) {
    const HalfedgeId h = waiting_[waiting].edge;
    scan_edge(h, top(triangle_of(h)));
  }
}

/// Labels the children from the entry to the base, cycle[0]. Children at odd places are matched
/// with the next one.
void WeightedSearch::label_part(const std::vector<Blossoms::CycleStep>& cycle, HalfedgeId entry) {
  const SetId holder = top(graph_.across(entry));
  std::size_t i = 0;
  while (cycle[i].set != holder) ++i;
  make_inner(cycle[i].set, entry, 0);
  const bool forward = i % 2 == 1;
  while (i != 0 && i != cycle.size()) {
    const std::size_t outer = forward ? i + 1 : i - 1, inner = forward ? i + 2 : i - 2;
    make_outer(cycle[outer].set, 2 * now_);
    const HalfedgeId next = forward ? cycle[outer].link : graph_.twin[cycle[inner].link];
    make_inner(cycle[inner == cycle.size() ? 0 : inner].set, next, 0);
    i = inner;
  }
}

// ---- The end of a search. ----

/// Matches outer set `s` along h (kNone: leaves its `node` unmatched) and changes the path from
/// there to the root.
void WeightedSearch::flip(SetId s, HalfedgeId h, TriangleId node) {
  const auto rematch = [&](SetId outer, HalfedgeId edge) {
    const HalfedgeId old = mate(outer);
    if (edge == kNone) {
      blossoms_.set_free(outer, node);
    } else {
      blossoms_.set_mate(outer, edge);
    }
    return old;
  };
  for (HalfedgeId old = rematch(s, h); old != kNone; old = rematch(s, h)) {
    const SetId inner = top(graph_.across(old));
    h = state_[inner].entry;
    blossoms_.set_mate(inner, graph_.twin[h]);
    s = top(triangle_of(h));
  }
}

void WeightedSearch::settle() {
  // tree_ also names sets that went into a blossom or were opened; those are not at the top, or have
  // no label any more.
  for (const SetId s : tree_) {
    if (!blossoms_.is_at_top(s)) continue;
    if (state_[s].label == Label::kOuter) {
      settle_outer(s);
    } else if (state_[s].label == Label::kInner) {
      tops_.add_to_nodes(s, now_);
      if (blossoms_.is_blossom(s)) blossom_dual(s) -= 2 * now_;
      clear_state(s);
    }
  }
  tree_.clear();
  tight_.clear();
  edge_events_.clear();
  blossom_events_.clear();
  waiting_.clear();
}

void WeightedSearch::settle_outer(SetId s) {
  collect_parts(s);
  for (const SetId part : parts_) tops_.add_to_nodes(part, -now_);
  if (blossoms_.is_blossom(s)) blossom_dual(s) += 2 * now_;
  dissolve(s);
  for (const SetId at : at_top_) {
    clear_state(at);
    if (tops_.has_cell(at)) continue;
    collect_parts(at);
    tops_.join(at, parts_);
  }
}

/// The sets in `s` that were at the top before they were shrunk.
void WeightedSearch::collect_parts(SetId s) {
  parts_.clear();
  stack_.assign(1, s);
  while (!stack_.empty()) {
    const SetId at = stack_.back();
    stack_.pop_back();
    if (tops_.has_cell(at)) {
      parts_.push_back(at);
    } else {
      for (const auto& [child, link] : blossoms_.cycle(at)) stack_.push_back(child);
    }
  }
}

/// Opens `s` and what comes out of it while the dual is 0; at_top_ is what remains. Blossoms around
/// the same base are opened in one go, so that the way to it is walked once.
void WeightedSearch::dissolve(SetId s) {
  at_top_.clear();
  stack_.assign(1, s);
  const auto is_empty = [&](SetId at) { return blossoms_.is_blossom(at) && blossom_dual(at) == 0; };
  while (!stack_.empty()) {
    const SetId outermost = stack_.back();
    stack_.pop_back();
    if (!is_empty(outermost)) {
      at_top_.push_back(outermost);
      continue;
    }
    const std::vector<SetId>& way = blossoms_.way_to_base(outermost);
    std::size_t i = way.size() - 1;
    for (; is_empty(way[i]); --i) {
      if (tops_.has_cell(way[i])) tops_.split(way[i], blossoms_.cycle(way[i]));
      for (const auto& [child, link] : blossoms_.open(way[i], way[i - 1])) {
        if (child != way[i - 1]) stack_.push_back(child);
      }
    }
    at_top_.push_back(way[i]);
  }
}

}  // namespace quadloom::dual
