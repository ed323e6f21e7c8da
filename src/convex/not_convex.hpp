// The quads of a mesh that are not strictly convex.
#pragma once

#include <vector>

#include "quadloom/core.hpp"

namespace quadloom::convex {

/// Ascending; exact. O(n).
std::vector<QuadId> quads_not_convex(const Quadrangulation& mesh);

}  // namespace quadloom::convex
