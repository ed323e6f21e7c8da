// Which way around a ring goes.
#pragma once

#include <span>

#include "quadloom/core.hpp"

namespace quadloom::kernel {

/// Whether a closed ring (equal neighbours allowed, three different corners at least) goes
/// counter-clockwise around what it bounds. For a ring that touches itself: whether its outermost
/// part does.
bool goes_counter_clockwise(std::span<const Point> ring);

}  // namespace quadloom::kernel
