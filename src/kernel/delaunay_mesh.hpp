// The Delaunay triangulation while it grows: see delaunay.cpp for the algorithm.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "core/large_array.hpp"
#include "quadloom/core.hpp"

namespace quadloom::kernel {

/// Points and triangles. Beyond each edge of the hull is a ghost triangle, whose third corner is the
/// point at infinity.
struct DelaunayMesh {
  /// Corners v[0..2] counter-clockwise, v[3] = v[0]. Edge i goes from v[i] to v[i + 1]; it is edge
  /// twin[i] & 3 of triangle twin[i] >> 2 on the other side.
  struct alignas(32) Triangle {
    std::uint32_t v[4];
    std::uint32_t twin[3];
    std::uint32_t unused;
  };
  using Edge = std::uint32_t;  // triangle << 2 | edge

  explicit DelaunayMesh(std::vector<Point> given)
      : points(std::move(given)), ghost(static_cast<std::uint32_t>(points.size())) {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    points.push_back({kNan, kNan});
    triangles = large_array<Triangle>(2 * points.size());
  }

  bool is_ghost(const Triangle& t) const {
    return t.v[0] == ghost || t.v[1] == ghost || t.v[2] == ghost;
  }
  static Edge next(Edge e) { return (e & ~3U) | (9U >> (2 * (e & 3U)) & 3U); }
  static Edge previous(Edge e) { return (e & ~3U) | (18U >> (2 * (e & 3U)) & 3U); }

  /// Of k points inserted the triangles are 0 to 2 k - 3; the k-th has brought the last two of them.
  static std::uint32_t triangles_of(std::size_t inserted) {
    return static_cast<std::uint32_t>(2 * inserted - 2);
  }

  std::vector<Point> points;       // and the point at infinity, not-a-number in both coordinates
  std::uint32_t ghost;             // its number
  LargeArray<Triangle> triangles;  // not touched before they are written, by whom needs them
};

}  // namespace quadloom::kernel
