#include "kernel/ring_direction.hpp"

#include <algorithm>

#include "kernel/predicates_inline.hpp"

namespace quadloom::kernel {

//      .                    All edges at the smallest corner m go to the right of it. The one that
//     /  ____               is clockwise of all others has the outside on its right as seen from m:
//    m--'                   if the ring leaves m along it, the ring is counter-clockwise.
//     \____
bool goes_counter_clockwise(std::span<const Point> ring) {
  const Point m = *std::min_element(ring.begin(), ring.end(), lex_less);
  Point lowest = m;
  bool leaves = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i], b = ring[i + 1 == ring.size() ? 0 : i + 1];
    if ((a == m) == (b == m)) continue;
    const Point other = a == m ? b : a;
    if (lowest == m || orient(m, lowest, other) < 0) {
      lowest = other;
      leaves = a == m;
    }
  }
  return leaves;
}

}  // namespace quadloom::kernel
