// A random polygon with axis-parallel edges: a set of unit cells that grows from one cell, by cells
// that leave its boundary one cycle that never touches itself.
#include <array>
#include <unordered_set>

#include "core/random.hpp"
#include "generate/polygons.hpp"

namespace quadloom::generate {
namespace {

struct Cell {
  std::int64_t x = 0;
  std::int64_t y = 0;
};

constexpr std::array<Cell, 8> kAround = {
    {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};

class Cells {
 public:
  bool has(Cell c) const { return cells_.contains(key(c)); }
  void add(Cell c) { cells_.insert(key(c)); }
  void remove(Cell c) { cells_.erase(key(c)); }

  /// The places beside c may be taken next.
  void grow_from(Cell c) {
    for (std::size_t i = 0; i < 8; i += 2) {
      frontier_.push_back({c.x + kAround[i].x, c.y + kAround[i].y});
    }
  }
  bool may_grow() const { return !frontier_.empty(); }

  /// A random place beside a cell, taken off the list.
  Cell take(Random& random) {
    const auto i = static_cast<std::size_t>(random.below(frontier_.size()));
    std::swap(frontier_[i], frontier_.back());
    const Cell c = frontier_.back();
    frontier_.pop_back();
    return c;
  }

  /// Whether the cells around c are one run that holds a side neighbour at both of its ends: then c
  /// closes no ring and touches no cell at a corner alone.
  bool may_add(Cell c) const {
    if (has(c)) return false;
    std::array<bool, 8> taken{};
    for (std::size_t i = 0; i < 8; ++i) taken[i] = has({c.x + kAround[i].x, c.y + kAround[i].y});
    int runs = 0;
    for (std::size_t i = 0; i < 8; ++i) {
      if (taken[i] && !taken[(i + 7) % 8]) ++runs;
      const bool lone = i % 2 == 1 && taken[i] && !taken[(i + 7) % 8] && !taken[(i + 1) % 8];
      if (lone) return false;
    }
    return runs == 1;
  }

  /// How many corners the boundary has around c.
  int corners_of(Cell c) const {
    int corners = 0;
    for (const std::int64_t x : {c.x, c.x + 1}) {
      for (const std::int64_t y : {c.y, c.y + 1}) {
        const int around = has({x, y}) + has({x - 1, y}) + has({x, y - 1}) + has({x - 1, y - 1});
        corners += around % 2;
      }
    }
    return corners;
  }

 private:
  static std::uint64_t key(Cell c) {
    return (static_cast<std::uint64_t>(c.x) << 32) ^ static_cast<std::uint32_t>(c.y);
  }
  std::unordered_set<std::uint64_t> cells_;
  std::vector<Cell> frontier_;
};

/// The corners of the boundary, counter-clockwise: with a cell on the left, turn right, go on, or
/// turn left, whichever comes first.
std::vector<Point> trace(const Cells& cells) {
  Cell start{0, 0};
  while (cells.has({start.x, start.y - 1})) --start.y;
  Cell at = start;  // a lattice point, the lower left corner of the cell of that name
  std::size_t d = 0;
  constexpr std::array<Cell, 4> kStep = {{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
  // The cell on the left of a step in direction d, from the lattice point.
  constexpr std::array<Cell, 4> kLeft = {{{0, 0}, {-1, 0}, {-1, -1}, {0, -1}}};
  const auto open = [&](std::size_t way) {
    const Cell left = kLeft[way], right = kLeft[(way + 3) % 4];
    return cells.has({at.x + left.x, at.y + left.y}) &&
           !cells.has({at.x + right.x, at.y + right.y});
  };
  std::vector<Point> ring;
  do {
    at = {at.x + kStep[d].x, at.y + kStep[d].y};
    for (const std::size_t turn : {3, 0, 1}) {
      if (!open((d + turn) % 4)) continue;
      if (turn != 0) ring.push_back({static_cast<double>(at.x), static_cast<double>(at.y)});
      d = (d + turn) % 4;
      break;
    }
  } while (at.x != start.x || at.y != start.y || d != 0);
  return ring;
}

}  // namespace

// Mostly cells that make corners, or else the cells would grow into a disc.
Polygon make_rectilinear_polygon(std::size_t n, std::uint64_t seed) {
  Random random(seed);
  Cells cells;
  cells.add({0, 0});
  cells.grow_from({0, 0});
  for (std::size_t corners = 4; corners + 1 < n && cells.may_grow();) {
    const Cell c = cells.take(random);
    if (!cells.may_add(c)) continue;
    const int before = cells.corners_of(c);
    cells.add(c);
    const int more = cells.corners_of(c) - before;
    if (more >= 0 ? corners + static_cast<std::size_t>(more) <= n : random.below(8) == 0) {
      corners = static_cast<std::size_t>(static_cast<int>(corners) + more);
      cells.grow_from(c);
    } else {
      cells.remove(c);
    }
  }
  return {{trace(cells)}};
}

}  // namespace quadloom::generate
