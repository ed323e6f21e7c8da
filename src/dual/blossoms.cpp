#include "dual/blossoms.hpp"

namespace quadloom::dual {

Blossoms::Blossoms(const DualGraph& graph)
    : graph_(graph),
      node_count_(static_cast<SetId>(graph.node_count())),
      set_(graph.node_count()) {}

TriangleId Blossoms::base(SetId s) const {
  if (set_[s].mate != kNone) return triangle_of(set_[s].mate);
  return is_blossom(s) ? free_[s - node_count_] : s;
}

void Blossoms::set_free(SetId s, TriangleId node) {
  set_[s].mate = kNone;
  if (is_blossom(s)) free_[s - node_count_] = node;
}

SetId Blossoms::make(const std::vector<CycleStep>& cycle) {
  auto made = static_cast<SetId>(set_.size());
  if (unused_.empty()) {
    set_.emplace_back();
    first_.emplace_back();
    free_.emplace_back();
    count_.emplace_back();
  } else {
    made = unused_.back();
    unused_.pop_back();
  }
  const SetId holder = cycle.front().set;
  set_[made] = {kNone, kNone, kNone, set_[holder].mate, false};
  first_[made - node_count_] = holder;
  free_[made - node_count_] = base(holder);
  count_[made - node_count_] = 0;
  for (std::size_t i = 0; i < cycle.size(); ++i) {
    Set& child = set_[cycle[i].set];
    count_[made - node_count_] += count(cycle[i].set);
    child.parent = made;
    child.next = cycle[i + 1 < cycle.size() ? i + 1 : 0].set;
    child.link = cycle[i].link;
  }
  return made;
}

const std::vector<SetId>& Blossoms::way_to_base(SetId s) {
  way_.assign(1, base(s));
  while (way_.back() != s) way_.push_back(set_[way_.back()].parent);
  return way_;
}

const std::vector<Blossoms::CycleStep>& Blossoms::cycle(SetId s) {
  cycle_.clear();
  SetId at = first_[s - node_count_];
  do {
    cycle_.push_back({at, set_[at].link});
    at = set_[at].next;
  } while (at != first_[s - node_count_]);
  return cycle_;
}

//        holder ===== mate of the blossom      The children after the one that holds the base are
//        /     .                               matched in pairs along the cycle.
//      1        4
//      #         #
//       2 ---- 3
const std::vector<Blossoms::CycleStep>& Blossoms::open(SetId s, SetId holder) {
  const TriangleId node = base(s);
  const HalfedgeId mate = set_[s].mate;
  first_[s - node_count_] = holder;
  cycle(s);
  set_free(holder, node);
  set_[holder].mate = mate;
  for (std::size_t i = 1; i < cycle_.size(); i += 2) {
    set_[cycle_[i].set].mate = cycle_[i].link;
    set_[cycle_[i + 1].set].mate = graph_.twin[cycle_[i].link];
  }
  for (const CycleStep& step : cycle_) set_[step.set].parent = kNone;
  set_[s].unused = true;
  unused_.push_back(s);
  return cycle_;
}

}  // namespace quadloom::dual
