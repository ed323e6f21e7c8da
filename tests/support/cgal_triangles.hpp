// CGAL's triangulations as sets of triangles, to compare with ours.
#pragma once

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>

#include "support/delaunay_checks.hpp"

namespace quadloom {

using CgalKernel = CGAL::Exact_predicates_inexact_constructions_kernel;

/// The finite triangles of any of CGAL's planar triangulations.
template <typename Cgal>
TriangleSet finite_triangles(const Cgal& cgal) {
  TriangleSet out;
  for (auto f = cgal.finite_faces_begin(); f != cgal.finite_faces_end(); ++f) {
    const auto corner = [&](int i) {
      return Point{f->vertex(i)->point().x(), f->vertex(i)->point().y()};
    };
    out.push_back(canonical_triangle(corner(0), corner(1), corner(2)));
  }
  std::sort(out.begin(), out.end());
  return out;
}

}  // namespace quadloom
