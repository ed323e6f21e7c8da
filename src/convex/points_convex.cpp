// The public door for point sets: check the input, run the method, map duplicates.
#include <optional>
#include <utility>

#include "convex/lower_bound_sets.hpp"
#include "convex/points_convex_delaunay.hpp"
#include "convex/points_convex_pentagons.hpp"
#include "convex/points_convex_spiral.hpp"
#include "kernel/delaunay_in_order.hpp"
#include "quadloom/kernel.hpp"
#include "quadrangulate/point_input.hpp"

namespace quadloom {
namespace {

/// From here on the spiral's mesh may have fewer points, and the bound is near.
constexpr std::size_t kManyPoints = 10;  // points of the input for each added one

/// Sets that need many points are looked for first where that takes no time; from kSettled on nothing else
/// can have many fewer points than the theorems' mesh of one, which is three from the best possible.
constexpr std::size_t kLookFirst = 1000;
constexpr std::size_t kSettled = 40;

/// By kPentagons, else by kSpiral.
ConvexResult by_path(std::span<const Point> input, const ConvexOptions& options) {
  DistinctPoints distinct = quadrangulate::points_of_the_plane(input);
  ConvexResult result = options.method == ConvexMethod::kPentagons
                            ? convex::convex_pentagon_quadrangulation(distinct.points, options)
                            : convex::convex_spiral_quadrangulation(distinct.points, options);
  result.input_to_vertex = std::move(distinct.input_to_vertex);
  return result;
}

std::optional<ConvexResult> by_delaunay(std::span<const Point> input,
                                        const ConvexOptions& options) {
  kernel::DelaunayInOrder triangulation = kernel::delaunay_in_order(input);
  std::vector<VertexId> input_to_vertex = std::move(triangulation.input_to_vertex);
  auto result = convex::convex_delaunay_quadrangulation(std::move(triangulation), options);
  if (result) result->input_to_vertex = std::move(input_to_vertex);
  return result;
}

/// The theorems' mesh of a set that needs many points, if this is one and an odd hull is to keep its
/// triangle.
std::optional<ConvexResult> by_lower_bound(std::span<const Point> input,
                                           const ConvexOptions& options) {
  DistinctPoints distinct = quadrangulate::points_of_the_plane(input);
  auto result = convex::lower_bound_mesh(distinct.points);
  if (!result ||
      (result->statistics.hull_points % 2 == 1 && options.odd_boundary != OddBoundary::kTriangle)) {
    return std::nullopt;
  }
  result->input_to_vertex = std::move(distinct.input_to_vertex);
  return result;
}

/// Fewer quads that are not convex, and then fewer points.
bool is_better(const ConvexResult& a, const ConvexResult& b) {
  return std::pair(a.not_convex.size(), a.steiner.size()) <
         std::pair(b.not_convex.size(), b.steiner.size());
}

}  // namespace

ConvexResult convex_quadrangulation(std::span<const Point> input, const ConvexOptions& options) {
  if (options.odd_boundary == OddBoundary::kOnEdge) {
    throw Error(ErrorCode::kBadOption, "a point on a hull edge would be a flat corner");
  }
  report_progress(options.progress, "input", 0);
  if (options.method != ConvexMethod::kDelaunay) return by_path(input, options);
  std::optional<ConvexResult> known;
  if (input.size() <= kLookFirst) known = by_lower_bound(input, options);
  if (known && known->input_vertices > kSettled) return std::move(*known);
  auto result = by_delaunay(input, options);
  if (!result) return by_path(input, options);
  if (result->steiner.size() * kManyPoints > result->input_vertices) {
    ConvexResult spiral = by_path(input, options);
    if (is_better(spiral, *result)) result = std::move(spiral);
    if (input.size() > kLookFirst) known = by_lower_bound(input, options);
    if (known && is_better(*known, *result)) result = std::move(known);
  }
  return std::move(*result);
}

}  // namespace quadloom
