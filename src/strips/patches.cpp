// Patches of a graph, grown breadth first. Cost: O(n) for all of them.
#include "strips/patches.hpp"

#include <algorithm>

namespace quadloom::strips {

PatchGrower::PatchGrower(const DualGraph& graph, std::size_t capacity, Direction direction)
    : graph_(graph),
      capacity_(capacity),
      direction_(direction),
      taken_(graph.node_count()),
      local_(graph.node_count()),
      left_(graph.node_count()) {}

TriangleId PatchGrower::begin_part() {
  while (next_front_ < front_.size()) {
    const TriangleId t = front_[next_front_++];
    if (taken_[t] == 0) return t;
  }
  const auto count = static_cast<TriangleId>(graph_.node_count());
  const auto node = [&] {
    return direction_ == Direction::kUp ? next_node_ : count - 1 - next_node_;
  };
  while (taken_[node()] != 0) ++next_node_;
  return node();
}

void PatchGrower::keep_front(const std::vector<TriangleId>& patch, std::size_t from) {
  for (std::size_t i = from; i < patch.size(); ++i) {
    for (HalfedgeId h = 3 * patch[i]; h < 3 * patch[i] + 3; ++h) {
      if (graph_.twin[h] != kNone && taken_[graph_.across(h)] == 0) {
        front_.push_back(graph_.across(h));
      }
    }
  }
}

void PatchGrower::grow(std::vector<TriangleId>& patch) {
  patch.clear();
  const std::size_t size = std::min(capacity_, left_);
  std::size_t next = 0;
  const auto take = [&](TriangleId t) {
    taken_[t] = 1;
    local_[t] = static_cast<std::uint32_t>(patch.size());
    patch.push_back(t);
  };
  while (patch.size() < size) {
    if (next == patch.size()) take(begin_part());
    const TriangleId t = patch[next++];
    for (HalfedgeId h = 3 * t; h < 3 * t + 3 && patch.size() < size; ++h) {
      if (graph_.twin[h] != kNone && taken_[graph_.across(h)] == 0) take(graph_.across(h));
    }
  }
  left_ -= size;
  keep_front(patch, next);
}

}  // namespace quadloom::strips
