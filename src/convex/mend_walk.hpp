// Bad quads taken apart: their triangles walk to each other.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "quadrangulate/quick_walk.hpp"
#include "quadrangulate/steiner_crossing.hpp"
#include "quadrangulate/walk.hpp"

namespace quadloom::convex {

class MendWalker {
 public:
  /// `touch` is called with the triangles of each change.
  MendWalker(quadrangulate::PairedMesh& mesh,
             std::function<void(std::span<const TriangleId>)> touch);

  /// Takes the quads of the triangles apart and brings their halves together, by strictly convex quads as far
  /// as possible; all that were free are paired, but for one if they are odd. Returns the triangles whose quads
  /// have changed, each at least once. Costs as much as there is to do, not as the mesh is large.
  std::vector<TriangleId> walk(std::span<const TriangleId> apart);

  /// Whether the last walk() had to cross quads; these have changed, too.
  bool crossed() const { return crossed_; }
  /// Points of all crossings so far.
  const std::vector<SteinerPoint>& points() const { return crossing_.points(); }

 private:
  template <typename Merge>
  void sweep(Merge merge);
  void forget_paired();
  bool is_large() const;
  void walk_convexly();
  void walk_deeply();
  void rejoin_halves();
  void walk_anyhow();

  quadrangulate::PairedMesh& mesh_;
  quadrangulate::QuickWalker<quadrangulate::PairedMesh> quick_;
  quadrangulate::Walker walker_;
  quadrangulate::SteinerCrossing crossing_;
  std::function<void(std::span<const TriangleId>)> touch_;
  std::vector<HalfedgeId> taken_apart_;  // the inner halfedge of each quad
  std::vector<TriangleId> free_;
  std::vector<TriangleId> changed_;
  bool crossed_ = false;
  std::size_t deep_nodes_ = 0;  // left for thorough searches
};

}  // namespace quadloom::convex
