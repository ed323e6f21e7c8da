// The public door for point sets: check the input, run the method, map duplicates.
#include <optional>
#include <utility>

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
  auto result = by_delaunay(input, options);
  if (!result) return by_path(input, options);
  if (result->steiner.size() * kManyPoints > result->input_vertices) {
    ConvexResult spiral = by_path(input, options);
    if (is_better(spiral, *result)) return spiral;
  }
  return std::move(*result);
}

}  // namespace quadloom
