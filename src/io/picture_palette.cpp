#include "io/picture_palette.hpp"

#include <algorithm>
#include <cmath>

namespace quadloom::io {

Colour ramp_colour(double t) {
  constexpr std::array<std::array<int, 3>, 10> kStops = {{{0x44, 0x01, 0x54},
                                                          {0x48, 0x28, 0x78},
                                                          {0x3e, 0x4a, 0x89},
                                                          {0x31, 0x68, 0x8e},
                                                          {0x26, 0x82, 0x8e},
                                                          {0x1f, 0x9e, 0x89},
                                                          {0x35, 0xb7, 0x79},
                                                          {0x6e, 0xce, 0x58},
                                                          {0xb5, 0xde, 0x2b},
                                                          {0xfd, 0xe7, 0x25}}};
  const double at = std::clamp(t, 0.0, 1.0) * (kStops.size() - 1);
  const auto i = std::min<std::size_t>(static_cast<std::size_t>(at), kStops.size() - 2);
  const double f = at - static_cast<double>(i);
  const auto mix = [&](std::size_t c) {
    return (kStops[i][c] * (1 - f) + kStops[i + 1][c] * f) / 255;
  };
  return {mix(0), mix(1), mix(2)};
}

}  // namespace quadloom::io
