#include "quadrangulate/point_input.hpp"

#include <algorithm>

namespace quadloom::quadrangulate {

bool span_the_plane(std::span<const Point> points) {
  return points.size() >= 3 && std::any_of(points.begin() + 2, points.end(), [&](const Point& p) {
           return orient2d(points[0], points[1], p) != 0;
         });
}

DistinctPoints points_of_the_plane(std::span<const Point> input) {
  DistinctPoints distinct = distinct_points(input);
  if (distinct.points.size() < 3) {
    throw Error(ErrorCode::kTooFewPoints, "fewer than three distinct points");
  }
  if (!span_the_plane(distinct.points)) {
    throw Error(ErrorCode::kAllCollinear, "all points lie on one line");
  }
  return distinct;
}

}  // namespace quadloom::quadrangulate
