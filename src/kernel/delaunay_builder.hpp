// The incremental Delaunay triangulation behind delaunay(): see delaunay.cpp for the algorithm.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "quadloom/core.hpp"

namespace quadloom::kernel {

/// Triangulates distinct points, numbered along a space-filling curve. Besides the triangles there
/// is, while it grows, a ghost triangle beyond each edge of the hull, whose third corner is the
/// point at infinity.
class DelaunayBuilder {
 public:
  /// Corners v[0..2] counter-clockwise, v[3] = v[0]. Edge i goes from v[i] to v[i + 1]; it is edge
  /// twin[i] & 3 of triangle twin[i] >> 2 on the other side.
  struct alignas(32) Triangle {
    std::uint32_t v[4];
    std::uint32_t twin[3];
    std::uint32_t unused;
  };

  /// The number of triangles, ghosts included, is 2 n - 2; four of them take the numbers of two.
  static constexpr std::size_t kMaxDelaunayPoints = std::size_t{1} << 29;

  /// Takes the points in their spatial order.
  explicit DelaunayBuilder(std::vector<Point> points);

  /// Triangulates. False if all points are on one line (or fewer than three).
  bool build();

  /// Built and without ghosts: a twin beyond the hull is kNone.
  std::span<const Triangle> triangles() const { return triangles_; }

 private:
  using Edge = std::uint32_t;  // triangle << 2 | edge

  /// An edge seen from beyond the cavity, and in bit 32 whether the triangle there is in conflict.
  using Judged = std::uint64_t;
  static constexpr Judged kInConflict = Judged{1} << 32;

  static Edge next(Edge e) { return (e & ~3U) | (9U >> (2 * (e & 3U)) & 3U); }
  static Edge previous(Edge e) { return (e & ~3U) | (18U >> (2 * (e & 3U)) & 3U); }

  std::vector<std::uint32_t> insertion_order() const;
  bool first_triangle(std::vector<std::uint32_t>& order);
  void insert(std::uint32_t p);
  std::uint32_t locate(std::uint32_t p) const;
  void collect_cavity(std::uint32_t start, std::uint32_t p);
  void fill_cavity(std::uint32_t p);
  Judged* judge_pair(Edge second, Edge first, Point at, Judged* top) const;
  void grow_buffers();
  bool in_conflict_exact(const Triangle& t, Point at) const;
  bool beyond_exact(const Triangle& t, std::uint32_t i, Point at) const;
  void drop_ghosts();
  std::vector<std::uint32_t> mark_ghosts();
  bool is_ghost(const Triangle& t) const {
    return t.v[0] == ghost_ || t.v[1] == ghost_ || t.v[2] == ghost_;
  }

  std::vector<Point> points_;  // and the point at infinity, not-a-number in both coordinates
  std::uint32_t ghost_ = 0;
  std::vector<Triangle> triangles_;
  std::uint32_t last_ = 0;  // a triangle at the last point inserted, not a ghost
  // The triangles that the new point destroys, and the edges around them, seen from outside,
  // counter-clockwise. Buffers of which the first so many entries count.
  std::vector<std::uint32_t> cavity_;
  std::vector<Edge> rim_;
  std::vector<Judged> stack_;
  std::size_t cavity_size_ = 0, rim_size_ = 0;
};

}  // namespace quadloom::kernel
