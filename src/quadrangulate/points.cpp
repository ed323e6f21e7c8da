// The public door for point sets: check the input, run the method, map duplicates.
#include <optional>
#include <utility>

#include "kernel/delaunay_in_order.hpp"
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

std::optional<PointResult> by_pairs(std::span<const Point> input, const PointOptions& options) {
  kernel::DelaunayInOrder triangulation = kernel::delaunay_in_order(input);
  std::vector<VertexId> input_to_vertex = std::move(triangulation.input_to_vertex);
  auto result = delaunay_quadrangulation(std::move(triangulation), options);
  if (result) result->input_to_vertex = std::move(input_to_vertex);
  return result;
}

PointResult by_subdivision(std::span<const Point> input, const PointOptions& options) {
  DelaunayResult triangulation = delaunay(input);
  PointResult result = subdivide_quadrangulation(std::move(triangulation.mesh), options);
  result.input_to_vertex = std::move(triangulation.input_to_vertex);
  return result;
}

/// What the method makes of the points; empty if it gave up, which no input is known to cause.
std::optional<PointResult> run_method(std::span<const Point> input, const PointOptions& options) {
  if (options.method == PointMethod::kDelaunay) return by_pairs(input, options);
  if (options.method == PointMethod::kSubdivide) return by_subdivision(input, options);
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

SerpentineResult serpentine_triangulation(std::span<const Point> input, const Progress& progress) {
  DistinctPoints distinct = points_of_the_plane(input);
  Serpentine path = make_serpentine(distinct.points, convex_layers(distinct.points, progress));
  SerpentineResult result;
  result.mesh = to_triangulation(distinct.points, path);
  result.spiral = std::move(path.spiral);
  result.input_to_vertex = std::move(distinct.input_to_vertex);
  return result;
}

}  // namespace quadloom
