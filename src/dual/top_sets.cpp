#include "dual/top_sets.hpp"

#include <utility>

namespace quadloom::dual {

TopSets::TopSets(const Blossoms& blossoms, std::span<const Dual> dual) : blossoms_(blossoms) {
  node_.reserve(dual.size());
  cell_.reserve(dual.size());
  cell_of_set_.reserve(dual.size());
  for (std::uint32_t t = 0; t < dual.size(); ++t) {
    node_.push_back({dual[t], t});
    cell_.push_back({0, t});
    cell_of_set_.push_back(t);
  }
}

void TopSets::give_cell(SetId s, std::uint32_t cell) {
  if (s >= cell_of_set_.size()) cell_of_set_.resize(s + std::size_t{1}, kNone);
  cell_of_set_[s] = cell;
  cell_[cell].set = s;
}

void TopSets::move_nodes(SetId s, std::uint32_t to) {
  blossoms_.for_each_node(s, [&](TriangleId t) {
    node_[t].dual += cell_[node_[t].cell].shift - cell_[to].shift;
    node_[t].cell = to;
  });
}

void TopSets::split(SetId s, std::span<const Blossoms::CycleStep> children) {
  const std::uint32_t cell = std::exchange(cell_of_set_[s], kNone);
  SetId largest = children.front().set;
  for (const auto& [child, link] : children) {
    if (blossoms_.count(child) > blossoms_.count(largest)) largest = child;
  }
  for (const auto& [child, link] : children) {
    if (child == largest) continue;
    const std::uint32_t own = unused_cells_.back();
    unused_cells_.pop_back();
    cell_[own].shift = 0;
    move_nodes(child, own);
    give_cell(child, own);
  }
  give_cell(largest, cell);
}

void TopSets::join(SetId s, std::span<const SetId> parts) {
  SetId largest = parts.front();
  for (const SetId part : parts) {
    if (blossoms_.count(part) > blossoms_.count(largest)) largest = part;
  }
  const std::uint32_t cell = cell_of_set_[largest];
  for (const SetId part : parts) {
    if (part != largest) {
      move_nodes(part, cell);
      unused_cells_.push_back(cell_of_set_[part]);
    }
    cell_of_set_[part] = kNone;
  }
  give_cell(s, cell);
}

}  // namespace quadloom::dual
