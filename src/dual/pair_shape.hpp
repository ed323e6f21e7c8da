// The shape of the quad that two triangles make.
#pragma once

#include "kernel/predicates_inline.hpp"
#include "kernel/squareness.hpp"
#include "quadloom/core.hpp"

namespace quadloom::dual {

//        c
//      /   .        The pair across a->b is the quad a, d, b, c, strictly convex if and only if its
//      corners at
//    a --- b        a and b turn left; the corners at c and d belong to triangles.
//      .   /
//        d
/// The squareness of the pair across an inner halfedge; -1 if the quad is not strictly convex.
inline double pair_squareness(const Triangulation& mesh, HalfedgeId h) {
  const Point a = mesh.points[mesh.origin(h)], b = mesh.points[mesh.target(h)];
  const Point c = mesh.points[mesh.apex(h)], d = mesh.points[mesh.apex(mesh.twin[h])];
  if (kernel::orient(c, a, d) <= 0 || kernel::orient(d, b, c) <= 0) return -1;
  return kernel::squareness(a, d, b, c);
}

}  // namespace quadloom::dual
