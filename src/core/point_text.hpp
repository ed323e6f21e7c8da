// Coordinates in messages.
#pragma once

#include <string>

#include "quadloom/core.hpp"

namespace quadloom {

/// "(0.5, 1e+300)", digits that read back the same.
std::string point_text(Point p);

}  // namespace quadloom
