// The incremental Delaunay triangulation behind delaunay(): see delaunay.cpp for the algorithm.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "kernel/delaunay_inserter.hpp"
#include "kernel/delaunay_mesh.hpp"
#include "kernel/insertion_order.hpp"
#include "quadloom/core.hpp"

namespace quadloom::kernel {

/// Triangulates distinct points, numbered along a space-filling curve.
class DelaunayBuilder {
 public:
  using Triangle = DelaunayMesh::Triangle;

  /// Of n points there are 2 n - 2 triangles, ghosts included, each with four numbers of edges.
  static constexpr std::size_t kMaxDelaunayPoints = std::size_t{1} << 29;

  /// Takes the points in their spatial order.
  explicit DelaunayBuilder(std::vector<Point> points) : mesh_(std::move(points)) {}

  /// Triangulates. False if all points are on one line (or fewer than three).
  bool build();

  /// Built and without ghosts: a twin beyond the hull is kNone.
  std::span<const Triangle> triangles() const { return {mesh_.triangles.get(), triangle_count_}; }

  /// The points, with room for more, after build(), which is done with them.
  std::vector<Point> take_points() {
    mesh_.points.pop_back();
    return std::move(mesh_.points);
  }

  /// For tests: how many points the ranges of large rounds put off.
  std::size_t put_off() const { return put_off_; }

 private:
  bool first_triangle(InsertionOrder& order);
  void insert_round(const InsertionOrder& order, std::size_t begin, std::size_t end,
                    DelaunayInserter& inserter);
  void drop_ghosts();
  std::vector<std::uint32_t> mark_ghosts();

  DelaunayMesh mesh_;
  std::size_t triangle_count_ = 0, put_off_ = 0;
};

}  // namespace quadloom::kernel
