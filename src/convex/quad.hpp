// Quads in strictly convex quads.
#pragma once

#include <array>
#include <optional>

#include "convex/patch.hpp"

namespace quadloom::convex {

/// A simple quad with a point strictly inside: three Steiner points. None: see quad.cpp.
std::optional<Patch> patch_quad_with_point(const std::array<Point, 4>& corners, Point inner);

/// A simple quad: none if it is strictly convex, else four.
std::optional<Patch> patch_quad(const std::array<Point, 4>& corners);

}  // namespace quadloom::convex
