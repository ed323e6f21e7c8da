// Where the added points of a Hamiltonian refinement go, and which edges can be flipped between them.
#pragma once

#include <optional>

#include "kernel/chart.hpp"
#include "quadloom/core.hpp"

namespace quadloom::strips {

struct InnerPlace {
  kernel::Vector3 at;
  bool incentre = true;  // as rounded; else another place inside
};

/// A place strictly inside a triangle, exactly in the plane, on a surface exactly in its chart. Throws
/// Error kGuarantee (culprit: the triangle) if no double was found there.
InnerPlace inner_place(const Triangulation& mesh, const kernel::Places& places, TriangleId t);

/// The two triangles at the halfedge h, from a to b, seen in the plane or in their chart: c and d are
/// the places inside them.
///
///           c
///         / | \                 .
///        a--+--b                The edge a-b can be flipped to c-d if a d c and b c d turn left.
///         \ | /                 .
///           d
struct Kite {
  Point a, b, c, d;
};
Kite kite(const Triangulation& mesh, const kernel::Places& places, HalfedgeId h,
          const kernel::Vector3& c, const kernel::Vector3& d);
bool can_flip(const Kite& kite);

/// A place m near the middle of the edge such that a m c, m b c, b m d and m a d turn left; empty if
/// none was found.
std::optional<kernel::Vector3> middle_place(const Triangulation& mesh, const kernel::Places& places,
                                            HalfedgeId h, const kernel::Vector3& c,
                                            const kernel::Vector3& d);

/// The cotangent of the smallest angle of a triangle; infinity if it has no area. From sums, products,
/// quotients and roots alone, so the same on every platform.
double sharpness(const kernel::Vector3& a, const kernel::Vector3& b, const kernel::Vector3& c);

}  // namespace quadloom::strips
