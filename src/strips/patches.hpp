// Patches: connected sets of triangles, small enough for the cache, that part a mesh.
#pragma once

#include <cstdint>
#include <vector>

#include "quadloom/dual.hpp"

namespace quadloom::strips {

/// Cuts a graph into patches of at most `capacity` nodes, one after the other. A patch grows breadth
/// first, so it is round; it begins next to those before it. Nodes that are left between patches make
/// patches of several parts. O(n) for all patches together.
class PatchGrower {
 public:
  enum class Direction { kUp, kDown };  // where new components begin: at the first or the last node

  PatchGrower(const DualGraph& graph, std::size_t capacity, Direction direction);

  /// The next patch, the number in `patch` of each of its nodes being local(node); empty at the end.
  void grow(std::vector<TriangleId>& patch);
  std::uint32_t local(TriangleId t) const { return local_[t]; }

 private:
  TriangleId begin_part();
  void keep_front(const std::vector<TriangleId>& patch, std::size_t from);

  const DualGraph& graph_;
  std::size_t capacity_;
  Direction direction_;
  std::vector<std::uint8_t> taken_;
  std::vector<std::uint32_t> local_;
  std::vector<TriangleId> front_;  // beside patches; some are taken by now
  std::size_t next_front_ = 0;
  TriangleId next_node_ = 0;
  std::size_t left_;
};

}  // namespace quadloom::strips
