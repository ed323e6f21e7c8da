// What a strictly convex quad costs where one choice of quads is weighed against another.
#pragma once

namespace quadloom::convex {

/// Of its squareness: from about 0.05 for a rectangle to 6 for a sliver, so that one sliver weighs more than
/// several plain quads (a worst corner of 30 degrees costs 1.2, one of 10 degrees 3).
inline double price(double squareness) { return 1 - squareness + 0.05 / (squareness + 0.01); }

}  // namespace quadloom::convex
