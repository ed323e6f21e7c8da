// The turns of a pentagon's corners, and what is left of it without an ear.
#pragma once

#include <array>
#include <cstdint>

#include "kernel/predicates_inline.hpp"
#include "quadrangulate/paired_mesh.hpp"

namespace quadloom::quadrangulate {

/// For the pentagon p[0..4] the exact signs of the turns at each corner k between its neighbours
/// (`at`), and from corner k over k + 2 to k + 3 (`wide`). The floating-point filter judges all ten of them
/// without a branch, two at a time; what it leaves open is decided exactly.
class PentagonTurns {
 public:
  explicit PentagonTurns(const std::array<Point, 5>& p) {
    using kernel::Pair;
    std::array<double, 10> x, y;  // the edges k, k + 1; from 5 on the diagonals k, k + 2
    for (std::size_t k = 0; k < 5; ++k) {
      const Point& from = p[k];
      const Point& edge = p[(k + 1) % 5];
      const Point& diagonal = p[(k + 2) % 5];
      x[k] = edge.x - from.x;
      y[k] = edge.y - from.y;
      x[k + 5] = diagonal.x - from.x;
      y[k + 5] = diagonal.y - from.y;
    }
    // Turn k is that from edge k - 1 to edge k, turn 5 + k that from diagonal k to edge k + 2.
    std::uint32_t decided = 0;
    for (std::size_t k = 0; k < 10; k += 2) {
      const auto first = [](std::size_t turn) { return turn < 5 ? (turn + 4) % 5 : turn; };
      const auto second = [](std::size_t turn) { return turn < 5 ? turn : (turn + 2) % 5; };
      const Pair ax = {x[first(k)], x[first(k + 1)]}, ay = {y[first(k)], y[first(k + 1)]};
      const Pair bx = {x[second(k)], x[second(k + 1)]}, by = {y[second(k)], y[second(k + 1)]};
      const kernel::PairSigns signs = kernel::proven_difference(ax * by, ay * bx);
      left_ |= signs.positive << k;
      decided |= (signs.positive | signs.negative) << k;
    }
    right_ = decided & ~left_;
    if (decided != kAll) decide_exactly(p, decided);
  }

  int at(std::size_t k) const { return sign(k); }
  /// The quad that is left without corner k.
  QuadKind without(std::size_t k) const {
    // Its corners are k + 1 .. k + 4; those next to k see the far side, the others keep their turns.
    return classify_quad(sign(5 + (k + 4) % 5), sign((k + 2) % 5), sign((k + 3) % 5),
                         sign(5 + (k + 1) % 5));
  }
  /// The corners, as bits, that can be cut off and leave a strictly convex quad.
  std::uint32_t convex_cuts() const {
    const auto turned = [](std::uint32_t bits, unsigned by) { return (bits | bits << 5) >> by; };
    const std::uint32_t corner = left_ & 31U, wide = left_ >> 5;
    return corner & turned(corner, 2) & turned(corner, 3) & turned(wide, 4) & turned(wide, 1);
  }

 private:
  static constexpr std::uint32_t kAll = (1U << 10) - 1;

  int sign(std::size_t turn) const {
    return static_cast<int>(left_ >> turn & 1U) - static_cast<int>(right_ >> turn & 1U);
  }
  void decide_exactly(const std::array<Point, 5>& p, std::uint32_t decided);

  std::uint32_t left_ = 0, right_ = 0;  // a bit a turn, `at` first
};

}  // namespace quadloom::quadrangulate
