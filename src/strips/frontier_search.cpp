// The nodes are taken in an order; at each step the part of a path or cycle among the nodes taken is a set
// of pieces, and all that matters of them for the rest is which edges of the frontier (those from nodes
// taken to others) they use, and which two belong to one piece. Parts that agree in that are one state.
//
//   1. FrontierPlan  for each node in the order the places of its edges in the frontier: those that are
//                    closed and those that are opened. A place is reused when its edge is closed
//   2. extend        each state goes on in all ways in which the node gets two edges, or, as an end of the
//                    path, one. A node to come that would have three, or too few, ends it at once
//   3. narrow        if more states came out than the beam is wide, those with the fewest ends of the path
//                    stay, and of those a random sample (by hash); measured against those with the most
//                    and the fewest pieces, a sample finds an order with far narrower beams
//   4. read_back     from the last state to the first: the edges that were used
//
//         taken   | to come       The frontier has four places; a state says for each whether its edge is
//             ,---+--- ...        used, and which other place is the other end of the piece: here the
//        o---o    |               first two and the last are used, and the last one's piece ends at a
//             `---+--- ...        node (an end of the path).
//        o        +    ...
//         `o------+--- ...
//
// (Simpath: Knuth, The Art of Computer Programming, volume 4A, 7.1.4; for a graph of degree three the
// states are few, since each node leaves out one edge.) Degenerate input: none. Cost: the number of
// states, exponential in the width of the order; each costs O(width). Memory: 4 bytes a state, and the
// frontiers of two steps.
#include "strips/frontier_search.hpp"

#include <algorithm>
#include <bit>
#include <boost/container/static_vector.hpp>
#include <cstring>
#include <limits>
#include <span>
#include <utility>

namespace quadloom::strips {
namespace {

using Slot = std::uint16_t;
using Used = boost::container::static_vector<Slot, 3>;

/// An edge of a node: its place in the frontier and its slot in the graph.
struct Opened {
  Slot place;
  HalfedgeId h;
};

/// A node that has edges in the frontier after a step: where, and how many edges it will still get.
struct Waiting {
  boost::container::static_vector<Slot, 3> place;
  int to_come = 0;
};

struct Step {
  boost::container::static_vector<Slot, 3> closed;
  boost::container::static_vector<Opened, 3> opened;
  boost::container::static_vector<Waiting, 3> waiting;  // the nodes at the opened edges
};

std::vector<Step> frontier_plan(const DualGraph& graph, const FrontierOrder& order) {
  std::vector<Slot> place(graph.twin.size(), 0);
  std::vector<std::uint8_t> taken(graph.node_count(), 0);
  std::vector<Slot> free;
  for (std::size_t i = order.width + 3; i > 0; --i) free.push_back(static_cast<Slot>(i - 1));
  std::vector<Step> plan;
  plan.reserve(order.node.size());
  for (const TriangleId t : order.node) {
    Step& step = plan.emplace_back();
    taken[t] = 1;
    for (HalfedgeId h = 3 * t; h < 3 * t + 3; ++h) {
      if (graph.twin[h] != kNone && taken[graph.across(h)] != 0) step.closed.push_back(place[h]);
    }
    for (HalfedgeId h = 3 * t; h < 3 * t + 3; ++h) {
      if (graph.twin[h] == kNone || taken[graph.across(h)] != 0) continue;
      place[graph.twin[h]] = free.back();
      free.pop_back();
      step.opened.push_back({place[graph.twin[h]], h});
    }
    // Only now may the places that are closed be used again.
    free.insert(free.end(), step.closed.begin(), step.closed.end());
    for (const Opened& open : step.opened) {
      const TriangleId u = graph.across(open.h);
      Waiting& waiting = step.waiting.emplace_back();
      for (HalfedgeId h = 3 * u; h < 3 * u + 3; ++h) {
        if (graph.twin[h] == kNone) continue;
        if (taken[graph.across(h)] != 0) {
          waiting.place.push_back(place[h]);
        } else {
          ++waiting.to_come;
        }
      }
    }
  }
  return plan;
}

std::uint64_t mixed(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31);
}

/// States of one step. A state has for each place the other end of the piece that uses its edge.
template <class Label>
struct Layer {
  static constexpr Label kUnused = std::numeric_limits<Label>::max();
  static constexpr Label kEnd = kUnused - 1;  // the piece's other end is an end of the path

  std::size_t width = 0;
  std::vector<Label> label;         // `width` a state
  std::vector<std::uint64_t> hash;  // one a state

  std::size_t size() const { return hash.size(); }
  const Label* state(std::size_t s) const { return label.data() + s * width; }
  void clear() {
    label.clear();
    hash.clear();
  }
};

/// Finds equal states.
template <class Label>
class StateTable {
 public:
  void reset(std::size_t expected) {
    std::size_t size = 64;
    while (size < 2 * expected) size *= 2;
    cell_.assign(size, kNone);
  }
  /// Whether the last state of the layer is new; it is dropped if not.
  bool keep_last(Layer<Label>& layer) {
    if (2 * layer.size() > cell_.size()) grow(layer);
    const std::size_t last = layer.size() - 1;
    std::size_t at = layer.hash[last] & (cell_.size() - 1);
    for (; cell_[at] != kNone; at = (at + 1) & (cell_.size() - 1)) {
      const std::uint32_t other = cell_[at];
      if (layer.hash[other] != layer.hash[last] ||
          std::memcmp(layer.state(other), layer.state(last), layer.width * sizeof(Label)) != 0) {
        continue;
      }
      layer.hash.pop_back();
      layer.label.resize(layer.label.size() - layer.width);
      return false;
    }
    cell_[at] = static_cast<std::uint32_t>(last);
    return true;
  }

 private:
  void grow(const Layer<Label>& layer) {
    cell_.assign(4 * cell_.size(), kNone);
    for (std::size_t s = 0; s + 1 < layer.size(); ++s) {
      std::size_t at = layer.hash[s] & (cell_.size() - 1);
      while (cell_[at] != kNone) at = (at + 1) & (cell_.size() - 1);
      cell_[at] = static_cast<std::uint32_t>(s);
    }
  }

  std::vector<std::uint32_t> cell_;
};

/// Where a state came from: the number of the state before and which of the opened edges it uses.
struct Origin {
  std::uint32_t packed = 0;
  Origin(std::size_t state, unsigned used)
      : packed(static_cast<std::uint32_t>(state) << 3 | used) {}
  std::uint32_t state() const { return packed >> 3; }
  unsigned used() const { return packed & 7U; }
};
constexpr std::uint64_t kMostStates = 1U << 29;

template <class Label>
class FrontierSearch {
 public:
  FrontierSearch(const DualGraph& graph, const FrontierOrder& order, OrderKind kind,
                 const FrontierLimits& limits)
      : graph_(graph), order_(order), kind_(kind), limits_(limits) {
    limits_.work = std::min(limits_.work, kMostStates);
    plan_ = frontier_plan(graph, order);
    now_.width = next_.width = order.width + 3;
  }

  FrontierResult run(const Progress& progress) {
    FrontierResult out;
    now_.label.assign(now_.width, kUnused);
    now_.hash.assign(1, 0);
    for (at_ = 0; at_ < plan_.size(); ++at_) {
      if (at_ % 64 == 0) {
        report_progress(progress, "searching an order",
                        static_cast<double>(at_) / static_cast<double>(plan_.size()));
      }
      next_.clear();
      origin_.emplace_back();
      table_.reset(now_.size());
      for (std::size_t s = 0; s < now_.size() && !found_ && out.work <= limits_.work; ++s) {
        const std::size_t before = next_.size();
        extending_ = s;
        extend(s);
        out.work += next_.size() - before + 1;
      }
      if (found_ || out.work > limits_.work || next_.size() == 0) break;
      narrow();
      std::swap(now_, next_);
    }
    if (found_) {
      out.answer = Answer::kYes;
      out.order = read_back();
    } else if (out.work <= limits_.work && !narrowed_) {
      out.answer = Answer::kNo;
    }
    return out;
  }

 private:
  static constexpr Label kUnused = Layer<Label>::kUnused;
  static constexpr Label kEnd = Layer<Label>::kEnd;

  void set(std::size_t place, Label label) {
    Label& at = work_[place];
    work_hash_ ^= key(place, at) ^ key(place, label);
    at = label;
  }
  static std::uint64_t key(std::size_t place, Label label) {
    return label == kUnused ? 0 : mixed((std::uint64_t{label} << 20 | place) + 0x9e3779b97f4a7c15U);
  }

  /// All ways on from a state.
  void extend(std::size_t s) {
    const Step& step = plan_[at_];
    const Label* state = now_.state(s);
    Used in;
    for (const Slot place : step.closed) {
      if (state[place] != kUnused) in.push_back(place);
    }
    if (in.size() == 3) return;
    const auto ends = static_cast<int>(std::count(state, state + now_.width, kEnd));
    const std::size_t opened = step.opened.size();
    for (unsigned used = 0; used < 1U << opened && !found_; ++used) {
      const std::size_t edges = in.size() + static_cast<std::size_t>(std::popcount(used));
      const bool is_end = edges == 1;
      if (edges != 2 && !(is_end && kind_ == OrderKind::kPath && ends < 2)) continue;
      work_.assign(state, state + now_.width);
      work_hash_ = now_.hash[s];
      if (!connect(step, in, used, is_end) || !can_go_on(step, ends + (is_end ? 1 : 0))) continue;
      next_.label.insert(next_.label.end(), work_.begin(), work_.end());
      next_.hash.push_back(work_hash_);
      if (table_.keep_last(next_)) origin_.back().emplace_back(s, used);
    }
  }

  /// What the pieces are after the node has been taken. False if a piece is closed, or ends at both
  /// ends, too early; found_ if it is at the end.
  bool connect(const Step& step, const Used& in, unsigned used, bool is_end) {
    boost::container::static_vector<Label, 2> loose;  // the far ends of the two sides of the node
    for (const Slot place : in) loose.push_back(work_[place]);
    const bool closes = in.size() == 2 && loose[0] == in[1];
    for (const Slot place : step.closed) set(place, kUnused);
    if (is_end) loose.push_back(kEnd);
    for (std::size_t i = 0; i < step.opened.size(); ++i) {
      if ((used >> i & 1U) != 0) loose.push_back(static_cast<Label>(step.opened[i].place));
    }
    if (closes || (loose[0] == kEnd && loose[1] == kEnd)) {
      if (at_ + 1 < plan_.size()) return false;
      found_ = true;
      origin_.back().emplace_back(extending_, used);
      return false;
    }
    if (loose[0] != kEnd) set(loose[0], loose[1]);
    if (loose[1] != kEnd) set(loose[1], loose[0]);
    return true;
  }

  bool can_go_on(const Step& step, int ends) const {
    const int least = kind_ == OrderKind::kPath && ends < 2 ? 1 : 2;
    for (const Waiting& waiting : step.waiting) {
      int edges = 0;
      for (const Slot place : waiting.place) edges += work_[place] != kUnused ? 1 : 0;
      if (edges > 2 || edges + waiting.to_come < least) return false;
    }
    return true;
  }

  void narrow() {
    if (limits_.beam == 0 || next_.size() <= limits_.beam) return;
    narrowed_ = true;
    std::vector<std::pair<std::uint64_t, std::uint32_t>> ranked(next_.size());
    for (std::uint32_t s = 0; s < next_.size(); ++s) {
      const Label* state = next_.state(s);
      const auto ends = std::count(state, state + next_.width, kEnd);
      ranked[s] = {static_cast<std::uint64_t>(ends) << 62 | next_.hash[s] >> 2, s};
    }
    std::nth_element(ranked.begin(), ranked.begin() + static_cast<std::ptrdiff_t>(limits_.beam),
                     ranked.end());
    ranked.resize(limits_.beam);
    Layer<Label> kept;
    kept.width = next_.width;
    std::vector<Origin> origins;
    for (const auto& [order, s] : ranked) {
      kept.label.insert(kept.label.end(), next_.state(s), next_.state(s) + next_.width);
      kept.hash.push_back(next_.hash[s]);
      origins.push_back(origin_.back()[s]);
    }
    next_ = std::move(kept);
    origin_.back() = std::move(origins);
  }

  /// The way back through the states, then along the path or the cycle.
  std::vector<TriangleId> read_back() const {
    std::vector<std::uint8_t> uses(graph_.twin.size(), 0);
    std::size_t state = 0;
    for (std::size_t i = at_ + 1; i-- > 0;) {
      const Origin origin = i == at_ ? origin_[i].back() : origin_[i][state];
      for (std::size_t k = 0; k < plan_[i].opened.size(); ++k) {
        if ((origin.used() >> k & 1U) == 0) continue;
        const HalfedgeId h = plan_[i].opened[k].h;
        uses[h] = uses[graph_.twin[h]] = 1;
      }
      state = origin.state();
    }
    return along(uses);
  }

  std::vector<TriangleId> along(const std::vector<std::uint8_t>& uses) const {
    TriangleId start = 0;
    for (TriangleId t = 0; t < graph_.node_count(); ++t) {
      if (uses[3 * t] + uses[3 * t + 1] + uses[3 * t + 2] == 1) start = t;
    }
    std::vector<TriangleId> order;
    HalfedgeId entered = kNone;
    for (TriangleId t = start; order.size() < graph_.node_count();) {
      order.push_back(t);
      for (HalfedgeId h = 3 * t; h < 3 * t + 3; ++h) {
        if (uses[h] == 0 || h == entered) continue;
        entered = graph_.twin[h];
        t = graph_.across(h);
        break;
      }
    }
    return order;
  }

  const DualGraph& graph_;
  const FrontierOrder& order_;
  OrderKind kind_;
  FrontierLimits limits_;
  std::vector<Step> plan_;
  std::size_t at_ = 0;
  Layer<Label> now_, next_;
  StateTable<Label> table_;
  std::vector<std::vector<Origin>> origin_;  // by step, of each state
  std::vector<Label> work_;                  // the state being made
  std::uint64_t work_hash_ = 0;
  std::size_t extending_ = 0;  // the state it is made from
  bool found_ = false, narrowed_ = false;
};

}  // namespace

FrontierResult frontier_search(const DualGraph& graph, const FrontierOrder& order, OrderKind kind,
                               const FrontierLimits& limits, const Progress& progress) {
  if (order.width < 250) {
    return FrontierSearch<std::uint8_t>(graph, order, kind, limits).run(progress);
  }
  if (order.width < 65000) {
    return FrontierSearch<std::uint16_t>(graph, order, kind, limits).run(progress);
  }
  return {};
}

}  // namespace quadloom::strips
