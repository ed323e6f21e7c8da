// Step 5 of the algorithm in delaunay.cpp: one point after the other into the triangulation.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "kernel/delaunay_mesh.hpp"

namespace quadloom::kernel {

/// Inserts points, anywhere or within a range of the curve.
///
/// A triangle is owned by a range of vertices if its three corners are in it. An inserter of a range
/// walks through and destroys owned triangles alone, so what it makes is owned, too; beyond the edges
/// of owned triangles it reads corners and writes a twin. A triangle that is not owned by any range
/// keeps its corners, and has at most one edge with both ends in one range: so inserters of ranges
/// that have no vertex in common never meet, and can work at the same time.
class DelaunayInserter {
 public:
  explicit DelaunayInserter(DelaunayMesh& mesh) : DelaunayInserter(mesh, 0, 0) {}
  DelaunayInserter(DelaunayMesh& mesh, std::uint32_t begin, std::uint32_t end)
      : mesh_(mesh),
        points_(mesh.points.data()),
        triangles_(mesh.triangles.get()),
        begin_(begin),
        size_(end - begin) {
    grow_buffers();
  }

  /// Inserts p, which takes two fresh triangles besides those that it destroys.
  void insert(std::uint32_t p, std::uint32_t fresh);

  /// The same if the range allows; if not no triangle is changed, and the next walk starts where this one
  /// has come to.
  bool insert_within(std::uint32_t p, std::uint32_t fresh);

  /// The next walk starts there: a triangle that is no ghost, and owned.
  void start_at(std::uint32_t triangle) { last_ = triangle; }

 private:
  using Triangle = DelaunayMesh::Triangle;
  using Edge = DelaunayMesh::Edge;

  /// An edge seen from beyond the cavity, and in bit 32 whether the triangle there is in conflict.
  using Judged = std::uint64_t;
  static constexpr Judged kInConflict = Judged{1} << 32;

  bool owns(const Triangle& t) const {
    return t.v[0] - begin_ < size_ && t.v[1] - begin_ < size_ && t.v[2] - begin_ < size_;
  }
  template <bool kWithin>
  std::uint32_t locate(std::uint32_t p);
  template <bool kWithin>
  bool collect_cavity(std::uint32_t start, std::uint32_t p);
  void fill_cavity(std::uint32_t p, std::uint32_t fresh);
  Judged* judge_pair(Edge second, Edge first, Point at, Judged* top) const;
  void grow_buffers();
  bool in_conflict_exact(const Triangle& t, Point at) const;
  bool beyond_exact(const Triangle& t, std::uint32_t i, Point at) const;

  const DelaunayMesh& mesh_;
  const Point* const points_;
  Triangle* const triangles_;
  std::uint32_t begin_, size_;  // the range
  std::uint32_t last_ = 0;  // where the next walk starts: a triangle at the last point, not a ghost
  // The triangles that the new point destroys, and the edges around them, seen from outside,
  // counter-clockwise. Buffers of which the first so many entries count.
  std::vector<std::uint32_t> cavity_;
  std::vector<Edge> rim_;
  std::vector<Judged> stack_;
  std::size_t cavity_size_ = 0, rim_size_ = 0;
};

}  // namespace quadloom::kernel
