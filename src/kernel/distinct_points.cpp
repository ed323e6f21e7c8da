// The input at the public door: checked, and equal points merged. A spatial order has equal points
// next to each other, the first occurrence in front.
#include <cmath>
#include <numeric>
#include <string>

#include "core/large_array.hpp"
#include "core/parallel.hpp"
#include "kernel/input_points.hpp"
#include "quadloom/kernel.hpp"

namespace quadloom {
namespace kernel {
namespace {

constexpr std::size_t kBlock = std::size_t{1} << 16;  // of points, for a thread

bool is_finite(Point p) { return std::isfinite(p.x) && std::isfinite(p.y); }

}  // namespace

void check_points(std::span<const Point> input, std::size_t limit) {
  if (input.size() > limit) {
    throw Error(ErrorCode::kTooManyPoints,
                std::to_string(input.size()) + " points are more than the " +
                    std::to_string(limit) + " that 32-bit indices allow");
  }
  for (std::size_t i = 0; i < input.size(); ++i) {
    if (!is_finite(input[i])) {
      throw Error(ErrorCode::kNotFinite,
                  "point " + std::to_string(i) + " has a coordinate that is not a finite number",
                  {i});
    }
  }
}

std::vector<Point> gather(std::span<const Point> points, std::span<const VertexId> order) {
  std::vector<Point> out;
  reserve_large(
      out, with_room(order.size()) + 1);  // for a point at infinity, and those that methods add
  out.resize(order.size());
  parallel_for_blocks(order.size(), kBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) out[i] = points[order[i]];
  });
  return out;
}

std::size_t number_distinct(std::span<const Point> in_order, std::span<const VertexId> order,
                            std::vector<VertexId>& input_to_vertex) {
  input_to_vertex = large_vector<VertexId>(order.size());
  std::iota(input_to_vertex.begin(), input_to_vertex.end(), VertexId{0});
  bool repeated = false;
  for (std::size_t i = 1; i < order.size(); ++i) {
    if (in_order[i] == in_order[i - 1]) {
      input_to_vertex[order[i]] = input_to_vertex[order[i - 1]];  // the first occurrence
      repeated = true;
    }
  }
  if (!repeated) return order.size();
  VertexId count = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const VertexId first = input_to_vertex[i];
    input_to_vertex[i] = first == i ? count++ : input_to_vertex[first];
  }
  return count;
}

std::vector<Point> points_by_number(std::span<const Point> input,
                                    std::span<const VertexId> input_to_vertex, std::size_t count) {
  std::vector<Point> points;
  reserve_large(points, count);
  if (count == input.size()) {
    points.assign(input.begin(), input.end());
    return points;
  }
  for (std::size_t i = 0; i < input.size(); ++i) {
    if (input_to_vertex[i] == points.size()) points.push_back(input[i]);
  }
  return points;
}

}  // namespace kernel

DistinctPoints distinct_points(std::span<const Point> input) {
  kernel::check_points(input, kMaxPoints);
  DistinctPoints out;
  const std::vector<VertexId> order = spatial_order(input);
  const std::size_t count =
      kernel::number_distinct(kernel::gather(input, order), order, out.input_to_vertex);
  out.points = kernel::points_by_number(input, out.input_to_vertex, count);
  return out;
}

}  // namespace quadloom
