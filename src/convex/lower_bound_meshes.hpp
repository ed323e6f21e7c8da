// What both meshes of lower-bound sets need.
#pragma once

#include <string>

#include "convex/open_region.hpp"
#include "quadloom/core.hpp"

namespace quadloom::convex {

/// A double of the region; throws Error kGuarantee that names what has no place.
Point place_or_throw(const OpenRegion& region, const std::string& what);

}  // namespace quadloom::convex
