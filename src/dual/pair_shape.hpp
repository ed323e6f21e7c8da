// The shape of the quad that two triangles make.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "kernel/chart.hpp"
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
inline bool strictly_convex_pair(Point a, Point d, Point b, Point c) {
  return kernel::orient(c, a, d) > 0 && kernel::orient(d, b, c) > 0;
}
/// The squareness of the pair across an inner halfedge; -1 if the quad is not strictly convex.
inline double pair_squareness(const Triangulation& mesh, HalfedgeId h) {
  const Point a = mesh.points[mesh.origin(h)], b = mesh.points[mesh.target(h)];
  const Point c = mesh.points[mesh.apex(h)], d = mesh.points[mesh.apex(mesh.twin[h])];
  if (!strictly_convex_pair(a, d, b, c)) return -1;
  return kernel::squareness(a, d, b, c);
}

/// The squared cosine of the corner at b of a, b, c.
inline double squared_cosine(kernel::Vector3 a, kernel::Vector3 b, kernel::Vector3 c) {
  const kernel::Vector3 u = a - b, v = c - b;
  const double dot = kernel::dot(u, v);
  return dot * dot / (kernel::dot(u, u) * kernel::dot(v, v));
}

/// The same on a surface, by the angles in space; -1 if the quad is not strictly convex in the
/// coordinate plane that it is nearest to, or folded by more than 90 degrees.
inline double pair_squareness(const Triangulation& mesh, const kernel::Places& places,
                              HalfedgeId h) {
  const VertexId a = mesh.origin(h), b = mesh.target(h);
  const VertexId c = mesh.apex(h), d = mesh.apex(mesh.twin[h]);
  const kernel::Vector3 left = places.area(a, b, c), right = places.area(a, d, b);
  if (kernel::dot(left, right) < 0) return -1;
  const kernel::Chart chart(left + right);
  const std::array<VertexId, 4> q = {a, d, b, c};
  double worst = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const VertexId before = q[(i + 3) % 4], after = q[(i + 1) % 4];
    if (kernel::orient(places.seen(chart, before), places.seen(chart, q[i]),
                       places.seen(chart, after)) <= 0) {
      return -1;
    }
    const double corner = squared_cosine(places.at(before), places.at(q[i]), places.at(after));
    if (!(corner < 1)) return 0;  // flat, or not in the range of doubles
    worst = std::max(worst, corner);
  }
  return 1 - std::sqrt(worst);
}

}  // namespace quadloom::dual
