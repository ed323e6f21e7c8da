// What the short C++ blocks of the documentation stand on: the names that they use without saying where from.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <quadloom/io.hpp>
#include <quadloom/quadloom.hpp>
#include <vector>

inline const std::vector<quadloom::Point> points = quadloom::generate_points("uniform", 14);
inline const quadloom::Triangulation triangulation = quadloom::delaunay(points).mesh;
inline const quadloom::io::MeshFile file = quadloom::io::read_mesh("harbour.14");
inline const quadloom::TriangleMesh triangle_mesh =
    quadloom::connect_triangles(file.mesh, file.z).triangles;
inline const quadloom::Polygon polygon = quadloom::generate_polygon("two-opt", 16);

/// What a block does with a result that it does not go on with.
template <class... Results>
void use(const Results&...) {}

/// Runs a block; it fails by a result other than 0 or an exception.
inline void run(const char* place, int (*block)()) {
  std::printf("%s\n", place);
  std::fflush(stdout);
  try {
    if (block() == 0) return;
  } catch (const std::exception& error) {
    std::printf("%s\n", error.what());
  }
  std::exit(1);
}
