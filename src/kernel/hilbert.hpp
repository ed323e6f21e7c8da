// Positions along a Hilbert curve over a grid of 65536 x 65536 cells.
#pragma once

#include <array>
#include <cstdint>

namespace quadloom::kernel {

// One step of the curve takes a bit of x and one of y to two bits of the position:
//
//     1---2      The curve enters the square at 0 and leaves it at 3. In quarter 0 it runs
//     |   |      with x and y swapped, in quarter 3 swapped and turned by half a turn, in 1 and
//     0   3      2 as in the whole. A state is (turned, swapped), two bits.
//
// Four steps at once are a look-up: 4 states x 16 x 16 quarters of quarters.
struct HilbertTable {
  std::array<std::uint16_t, 1024> step{};  // position << 2 | next state

  constexpr HilbertTable() {
    for (unsigned state = 0; state < 4; ++state) {
      for (unsigned xy = 0; xy < 256; ++xy) step[state << 8 | xy] = four_steps(state, xy);
    }
  }

 private:
  static constexpr std::uint16_t four_steps(unsigned state, unsigned xy) {
    unsigned position = 0;
    for (unsigned bit = 4; bit-- > 0;) {
      const unsigned turned = state >> 1, swapped = state & 1;
      const unsigned x = (xy >> (4 + bit) & 1) ^ turned, y = (xy >> bit & 1) ^ turned;
      const unsigned u = swapped ? y : x, v = swapped ? x : y;
      position = position << 2 | ((3 * u) ^ v);
      if (v == 0) state ^= u << 1 | 1U;
    }
    return static_cast<std::uint16_t>(position << 2 | state);
  }
};
inline constexpr HilbertTable kHilbertTable;

/// The position of cell (x, y), both below 2^16, along the curve.
inline std::uint32_t hilbert_position(std::uint32_t x, std::uint32_t y) {
  std::uint32_t position = 0, state = 0;
  for (int shift = 12; shift >= 0; shift -= 4) {
    const std::uint32_t xy = (x >> shift & 15U) << 4 | (y >> shift & 15U);
    const std::uint32_t entry = kHilbertTable.step[state << 8 | xy];
    position = position << 8 | entry >> 2;
    state = entry & 3U;
  }
  return position;
}

}  // namespace quadloom::kernel
