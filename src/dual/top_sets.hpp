// Which set at the top holds a node, and the node's dual; a whole set changes in O(1).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dual/blossoms.hpp"

namespace quadloom::dual {

/// Twice a weight, or a dual variable in the same unit.
using Dual = std::int64_t;

/// Each set at the top has a cell, and its nodes name the cell. When a blossom is opened its largest
/// child keeps the cell, when sets become one the largest's cell stays: so a node changes its cell
/// O(log n) times while sets grow, and opening a deep nest costs no more than what comes out of it.
class TopSets {
 public:
  TopSets(const Blossoms& blossoms, std::span<const Dual> dual);

  SetId holder(TriangleId t) const { return cell_[node_[t].cell].set; }
  Dual dual(TriangleId t) const { return node_[t].dual + cell_[node_[t].cell].shift; }
  bool has_cell(SetId s) const { return s < cell_of_set_.size() && cell_of_set_[s] != kNone; }
  void add_to_nodes(SetId s, Dual amount) { cell_[cell_of_set_[s]].shift += amount; }

  /// Each child of the blossom gets a cell.
  void split(SetId s, std::span<const Blossoms::CycleStep> children);
  /// One cell for the blossom whose parts (not only its children) have cells now.
  void join(SetId s, std::span<const SetId> parts);

 private:
  void move_nodes(SetId s, std::uint32_t to);
  void give_cell(SetId s, std::uint32_t cell);

  struct Node {
    Dual dual;  // without the cell's shift
    std::uint32_t cell;
  };
  struct Cell {
    Dual shift;
    SetId set;
  };

  const Blossoms& blossoms_;
  std::vector<Node> node_;
  std::vector<Cell> cell_;
  std::vector<std::uint32_t> cell_of_set_, unused_cells_;
};

}  // namespace quadloom::dual
