// The check of the input and the merging of equal points, shared by the public doors.
#pragma once

#include <span>
#include <vector>

#include "quadloom/core.hpp"

namespace quadloom::kernel {

/// Throws Error kTooManyPoints (more than `limit`) and kNotFinite (culprit: the first such point).
void check_points(std::span<const Point> input, std::size_t limit);

/// The points in that order.
std::vector<Point> gather(std::span<const Point> points, std::span<const VertexId> order);

/// Numbers the distinct points by first occurrence. `in_order` are the input's points gathered in
/// `order`, a spatial order. Returns how many distinct points there are.
std::size_t number_distinct(std::span<const Point> in_order, std::span<const VertexId> order,
                            std::vector<VertexId>& input_to_vertex);

/// The points by number, when there are `count` of them.
std::vector<Point> points_by_number(std::span<const Point> input,
                                    std::span<const VertexId> input_to_vertex, std::size_t count);

}  // namespace quadloom::kernel
