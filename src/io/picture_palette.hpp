// Colours of pictures; all sets can be told apart with any common colour blindness and in grey.
#pragma once

#include <array>

namespace quadloom::io {

struct Colour {
  double r, g, b;
};

/// Dark violet to yellow through blue and green, even to the eye (viridis, CC0); t in [0, 1].
Colour ramp_colour(double t);

inline constexpr Colour kPaper = {1, 1, 1};
inline constexpr Colour kInk = {0.13, 0.14, 0.17};
inline constexpr Colour kQuietInk = {0.42, 0.44, 0.48};
inline constexpr Colour kConvexFill = {0.68, 0.83, 0.92};
inline constexpr Colour kFlatFill = {0.96, 0.76, 0.26};
inline constexpr Colour kNonConvexFill = {0.80, 0.29, 0.08};
inline constexpr Colour kTriangleFill = {0.72, 0.70, 0.74};
inline constexpr Colour kPlainFill = {0.965, 0.97, 0.975};
inline constexpr Colour kAddedPoint = {0.86, 0.0, 0.38};

}  // namespace quadloom::io
