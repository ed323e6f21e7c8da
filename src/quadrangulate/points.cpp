// The public door for point sets: check the input, run the method, map duplicates.
#include <optional>
#include <utility>

#include "quadloom/kernel.hpp"
#include "quadloom/quadrangulate.hpp"
#include "quadrangulate/point_input.hpp"
#include "quadrangulate/points_delaunay.hpp"
#include "quadrangulate/points_insertion.hpp"
#include "quadrangulate/points_spiral.hpp"
#include "quadrangulate/points_subdivide.hpp"
#include "quadrangulate/serpentine.hpp"

namespace quadloom {

using namespace quadrangulate;

namespace {

/// The methods that start from the Delaunay triangulation.
std::optional<PointResult> from_delaunay(std::span<const Point> input,
                                         const PointOptions& options) {
  DelaunayResult triangulation = delaunay(input);
  std::optional<PointResult> result;
  if (options.method == PointMethod::kSubdivide) {
    result = subdivide_quadrangulation(std::move(triangulation.mesh), options);
  } else {
    result = delaunay_quadrangulation(std::move(triangulation.mesh), options);
  }
  if (result) result->input_to_vertex = std::move(triangulation.input_to_vertex);
  return result;
}

/// What the method makes of the points; empty if it gave up, which no input is known to cause.
std::optional<PointResult> run_method(std::span<const Point> input, const PointOptions& options) {
  if (options.method == PointMethod::kDelaunay || options.method == PointMethod::kSubdivide) {
    return from_delaunay(input, options);
  }
  DistinctPoints distinct = points_of_the_plane(input);
  std::optional<PointResult> result;
  switch (options.method) {
    case PointMethod::kSpiral:
      result = spiral_quadrangulation(distinct.points, options);
      break;
    case PointMethod::kInsertion:
      result = insertion_quadrangulation(distinct.points, options);
      break;
    case PointMethod::kDelaunay:
    case PointMethod::kSubdivide:
      break;
  }
  if (result) result->input_to_vertex = std::move(distinct.input_to_vertex);
  return result;
}

}  // namespace

PointResult quadrangulate_points(std::span<const Point> input, const PointOptions& options) {
  report_progress(options.progress, "input", 0);
  if (auto result = run_method(input, options)) return std::move(*result);
  PointOptions spiral = options;
  spiral.method = PointMethod::kSpiral;
  PointResult result = std::move(run_method(input, spiral).value());
  result.statistics.fell_back_to_spiral = true;
  return result;
}

bool has_quadrangulation(std::span<const Point> input) {
  const DistinctPoints distinct = distinct_points(input);
  return span_the_plane(distinct.points) && convex_hull(distinct.points).size() % 2 == 0;
}

SerpentineResult serpentine_triangulation(std::span<const Point> input) {
  DistinctPoints distinct = points_of_the_plane(input);
  Serpentine path = make_serpentine(distinct.points, convex_layers(distinct.points));
  SerpentineResult result;
  result.mesh = to_triangulation(distinct.points, path);
  result.spiral = std::move(path.spiral);
  result.input_to_vertex = std::move(distinct.input_to_vertex);
  return result;
}

}  // namespace quadloom
