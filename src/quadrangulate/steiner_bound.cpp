// What the theorems on few Steiner points promise.
#include <limits>

#include "quadloom/quadrangulate.hpp"

namespace quadloom {
namespace {

constexpr std::size_t kNoBound = std::numeric_limits<std::size_t>::max();

}  // namespace

// Bose and Toussaint, theorems 3.1 and 4.3.
std::size_t steiner_bound(const PointStatistics& statistics, const PointOptions& options) {
  if (options.method == PointMethod::kSubdivide && !statistics.fell_back_to_spiral) return kNoBound;
  const bool odd = statistics.hull_points % 2 == 1;
  return odd && options.odd_boundary != OddBoundary::kTriangle ? 1 : 0;
}

// Ramaswami, Ramos and Toussaint.
std::size_t steiner_bound(const TriangleStatistics& s, const TriangleOptions& options) {
  const std::size_t odd = options.odd_boundary == OddBoundary::kTriangle ? 0 : s.odd_parts;
  switch (options.method) {
    case TriangleMethod::kFans:  // theorem 2.1 on the mesh opened up: n = t + 2
      return (s.triangles + 2 * s.parts) / 3;
    case TriangleMethod::kPercolate:  // theorem 3.3; no holes and no inner vertices: t = n - 2
      if (s.parts == 1 && s.triangles + 2 == s.boundary_edges) return s.boundary_edges / 3;
      return kNoBound;
    case TriangleMethod::kQPercolate:  // theorem 3.4
      return s.triangles / 2 + odd;
    case TriangleMethod::kQuarter:
      return s.triangles / 4 + odd + 2 * s.crowded;
    case TriangleMethod::kPair:
      if (options.leftover == Leftover::kTriangle || options.leftover == Leftover::kError) return 0;
      return kNoBound;
    case TriangleMethod::kSubdivide:
      return kNoBound;
  }
  return kNoBound;
}

}  // namespace quadloom
