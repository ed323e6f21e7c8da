// The public door for point sets: check the input, run the method, map duplicates.
#include <utility>

#include "convex/points_convex_spiral.hpp"
#include "quadrangulate/point_input.hpp"

namespace quadloom {

ConvexResult convex_quadrangulation(std::span<const Point> input, const ConvexOptions& options) {
  if (options.odd_boundary == OddBoundary::kOnEdge) {
    throw Error(ErrorCode::kBadOption, "a point on a hull edge would be a flat corner");
  }
  DistinctPoints distinct = quadrangulate::points_of_the_plane(input);
  ConvexResult result = convex::convex_spiral_quadrangulation(distinct.points, options);
  result.input_to_vertex = std::move(distinct.input_to_vertex);
  return result;
}

}  // namespace quadloom
