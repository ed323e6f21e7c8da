// The public door for point sets: check the input, run the method, map duplicates.
#include <utility>

#include "convex/points_convex_delaunay.hpp"
#include "convex/points_convex_spiral.hpp"
#include "quadloom/kernel.hpp"
#include "quadrangulate/point_input.hpp"

namespace quadloom {

ConvexResult convex_quadrangulation(std::span<const Point> input, const ConvexOptions& options) {
  if (options.odd_boundary == OddBoundary::kOnEdge) {
    throw Error(ErrorCode::kBadOption, "a point on a hull edge would be a flat corner");
  }
  report_progress(options.progress, "input", 0);
  if (options.method == ConvexMethod::kDelaunay) {
    DelaunayResult triangulation = delaunay(input);
    auto result = convex::convex_delaunay_quadrangulation(std::move(triangulation.mesh), options);
    if (result) {
      result->input_to_vertex = std::move(triangulation.input_to_vertex);
      return std::move(*result);
    }
  }
  DistinctPoints distinct = quadrangulate::points_of_the_plane(input);
  ConvexResult result = convex::convex_spiral_quadrangulation(distinct.points, options);
  result.input_to_vertex = std::move(distinct.input_to_vertex);
  return result;
}

}  // namespace quadloom
