// A triangle of a Hamiltonian cycle that still has points inside, and where its points are kept.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "quadloom/core.hpp"

namespace quadloom::strips {

/// A point with its number.
struct Place {
  Point at;
  VertexId vertex = kNone;
};

/// Some of the places that an algorithm holds in one array: [begin, end).
struct Range {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
  std::uint32_t size() const { return end - begin; }
  bool empty() const { return begin == end; }
};

/// The cycle enters through the edge pivot - from and leaves through pivot - to:
///
///            pivot            Points may be strictly inside, and on the third edge, the base, which the
///           /  |  \.          cycle never crosses; none is on the two edges that it crosses.
///      ->  / . | . \  ->      Either way around: pivot, from, to turn left or right.
///         /  .   .  \.
///      from --o--o-- to
struct Wedge {
  Place pivot, from, to;
  Range inside;
  Range base;  // in lexicographic order
};

/// The same with the cycle going the other way.
inline Wedge reversed(Wedge wedge) {
  std::swap(wedge.from, wedge.to);
  return wedge;
}

/// Moves place i of `range` into the cell cell[i], cells one after the other; cell c is then
/// begin[c] .. begin[c + 1] of the places. `buffer` is scratch. Stable. O(size + cells).
void sort_into_cells(std::vector<Place>& places, Range range, std::span<const std::uint32_t> cell,
                     std::size_t cells, std::vector<std::uint32_t>& begin,
                     std::vector<Place>& buffer);

/// Puts places that lie on one line into lexicographic order.
void sort_along(std::vector<Place>& places, Range range);

}  // namespace quadloom::strips
