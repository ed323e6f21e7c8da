// z for the vertices of a mesh from the z of the input points.
#pragma once

#include <span>
#include <vector>

#include "quadloom/quadrangulate.hpp"

namespace quadloom::app {

struct Elevation {
  std::vector<double> z;    // per vertex
  std::size_t other_z = 0;  // repeated points whose z differs from the first one's, which is kept
};

/// Added points as interpolate() has them.
Elevation carry_elevation(std::span<const double> input_z,
                          std::span<const VertexId> input_to_vertex, std::span<const Point> points,
                          std::span<const SteinerPoint> steiner);

}  // namespace quadloom::app
