// The cases of Bremner, Hurtado, Ramaswami and Sacristan, section 3.1.2: where the first of several
// Steiner points goes in a hexagon.
#pragma once

#include <boost/container/static_vector.hpp>

#include "convex/open_region.hpp"
#include "convex/patch.hpp"

namespace quadloom::convex {

/// A Steiner point s that is joined to the neighbours of a corner and so cuts it off in a quad:
///
///      next ----- corner        the quad corner, next, s, previous is strictly convex if s is left of
///        |          |           previous -> corner, corner -> next and previous -> next;
///        s ----- previous       `within` has the half-planes that the paper's region asks for besides
struct Cut {
  int corner = 0;
  boost::container::static_vector<HalfPlane, 6> within;
};

using Cuts = boost::container::static_vector<Cut, 16>;

/// The pattern of reflex (r) and strictly convex (c) corners, flat ones counting as reflex, up to
/// rotation and reflection: "cccccc", "rccccc", "rcrccc", "rrcccc", "rccrcc", "rcrcrc", "rrcrcc",
/// "rrrccc". Any other pattern is no simple polygon's: nullptr.
const char* pattern_of(const Hexagon& hexagon);

/// The first cuts that the paper makes where one Steiner point is not enough, in all rotations and
/// reflections of the hexagon that fit the pattern.
Cuts first_cuts(const Hexagon& hexagon);

}  // namespace quadloom::convex
