// Numbers of added points from those of the vertices that they were made from.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "quadloom/quadrangulate.hpp"

namespace quadloom::app {

/// The parents of an added point with their shares, which sum up to 1; kNone where there are fewer
/// than three.
struct Blend {
  VertexId vertex = kNone;
  std::array<VertexId, 3> parent = {kNone, kNone, kNone};
  std::array<double, 3> share = {0, 0, 0};
};

/// Where the added points lie between their parents: barycentric coordinates for a point in a
/// triangle, the place along it (at its projection) for one made from an edge, in the plane (z
/// empty) or in space. In the order of `steiner`.
std::vector<Blend> blends(std::span<const SteinerPoint> steiner, std::span<const Point> points,
                          std::span<const double> z = {});

/// Sets the values of the added points; those of the others are given.
void interpolate(std::span<const Blend> blends, std::span<double> values);

}  // namespace quadloom::app
