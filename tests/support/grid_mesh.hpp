// Valid meshes to start from.
#pragma once

#include <array>
#include <cstdint>

#include "core/random.hpp"
#include "quadloom/core.hpp"

namespace quadloom::test {

/// A grid of columns x rows quads, vertex (column i, row j) = j (columns + 1) + i, inner vertices
/// moved at random by less than a quarter in x and y and then sheared; coordinates are exact, so
/// that the boundary's sides stay straight.
inline PolygonMesh grid_mesh(VertexId columns, VertexId rows, std::uint64_t seed = 0) {
  Random random(seed);
  PolygonMesh mesh;
  const auto jitter = [&](bool inner) {
    return inner && seed != 0 ? (static_cast<double>(random.below(1025)) - 512) / 2100.0 : 0.0;
  };
  const auto dyadic = [](double v) {
    return static_cast<double>(static_cast<int>(v * 4096)) / 4096;
  };
  for (VertexId j = 0; j <= rows; ++j) {
    for (VertexId i = 0; i <= columns; ++i) {
      const bool inner = i > 0 && j > 0 && i < columns && j < rows;
      const double x = i + dyadic(jitter(inner)), y = j + dyadic(jitter(inner));
      mesh.points.push_back({2 * x + y, x + 3 * y});
    }
  }
  for (VertexId j = 0; j < rows; ++j) {
    for (VertexId i = 0; i < columns; ++i) {
      const VertexId a = j * (columns + 1) + i, d = a + columns + 1;
      mesh.add_face(std::array{a, a + 1, d + 1, d});
    }
  }
  return mesh;
}

}  // namespace quadloom::test
