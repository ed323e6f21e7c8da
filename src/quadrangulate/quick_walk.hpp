// Walks on planar meshes, found by cheap searches.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "quadrangulate/quad_mesh.hpp"
#include "quadrangulate/walk.hpp"

namespace quadloom::quadrangulate {

/// Walks as in walk.hpp, for planar meshes and between free triangles alone. A search takes the first
/// free triangle that it meets, and passes a quad once. Mesh is a PairedMesh or a QuadMesh, of which a walker may be kept
/// to a range: it looks at no more than the range, and changes what is not at its border.
template <class Mesh>
class QuickWalker {
 public:
  explicit QuickWalker(Mesh& mesh, const FaceRange& range = {}) : mesh_(mesh), range_(range) {}

  /// The best-shaped walk of the free triangle through one quad to another one, strictly convex quads left
  /// behind; pairs them. False, and nothing changed, if there is none.
  bool merge_over_quad(TriangleId start);

  /// A short walk to another one by quads of good shape, found within so many nodes.
  bool merge(TriangleId start, WalkQuads quads, std::size_t nodes);

  /// Whether the last search ended for want of moves, not of nodes.
  bool locked() const { return goal_ == kNone && nodes_.size() < most_nodes_; }

  /// Whether a search came to the border of the range, beyond which there may be more, since this was last asked.
  bool take_met_border() { return std::exchange(met_border_, false); }

  /// Slides an edge between two quads near the triangle, quads that are strictly convex as before, so that there
  /// is a walk. If there is none, all is as before.
  bool merge_after_slide(TriangleId start, std::size_t nodes);

  /// Walks those of the triangles that are free towards each other, any quads left behind: each towards the nearest of
  /// those after it in the list, of which not all are looked at. A walk that takes more nodes than that stays undone.
  void merge_far(std::span<const std::uint32_t> triangles, std::size_t nodes = kNone);

  std::size_t walks() const { return walks_; }
  std::size_t steps() const { return steps_; }

  /// Called after each re-cut with the faces touched.
  std::function<void(std::span<const std::uint32_t>)> on_recut;

 private:
  /// The free triangle after some moves.
  struct Node {
    std::uint32_t parent = kNone;
    HalfedgeId enter = kNone;  // of the quad that was re-cut to get here; kNone for the start
    std::array<VertexId, 3> corner;
    std::array<HalfedgeId, 3> beyond;  // the edge from corner i to i + 1, seen from the other side;
                                       // kNone for the edge just cut, and on the boundary
    std::uint32_t cost = 0;
    std::uint32_t rank = 0;      // the cost, and what is still to come if there is an aim
    std::uint32_t next = kNone;  // in its bucket
    int ear = 0;
  };
  struct OverQuad {
    double worst;  // squared cosine
    HalfedgeId enter = kNone, met = kNone;
    std::size_t ear = 0;
  };
  /// No move costs as much as the ring is long, so that the costs waiting fit in one turn of it.
  static constexpr std::uint32_t kRing = 128;

  bool may_change(std::uint32_t face);
  bool aim_at_nearest(std::span<const TriangleId> others);
  std::uint32_t cost_to_aim(const Node& node) const;
  void try_over(HalfedgeId exit, OverQuad& best);
  bool search(std::size_t nodes);
  std::uint32_t pop();
  void expand(std::uint32_t from);
  void try_ears(std::uint32_t from, std::size_t i);
  void push(const Node& node);
  void try_goal(std::uint32_t from, std::size_t i);
  void apply(std::uint32_t end);
  bool try_slides(HalfedgeId edge, std::size_t nodes);
  void step(HalfedgeId enter, int ear);

  Mesh& mesh_;
  const FaceRange range_;
  bool met_border_ = false;
  TriangleId start_ = kNone;
  WalkQuads quads_ = WalkQuads::kStrictlyConvex;
  std::vector<Node> nodes_;
  std::array<std::uint32_t, kRing> bucket_;  // the last node of each, by cost
  std::uint32_t cost_ = 0;
  std::size_t waiting_ = 0, most_nodes_ = 0;
  Point aim_;
  double cost_of_length_ = 0;                       // of the way to the aim; 0: no aim
  std::uint32_t goal_ = kNone, goal_cost_ = kNone;  // the cheapest node that meets a free triangle
  HalfedgeId met_ = kNone;
  std::vector<std::uint32_t> search_of_;  // by quad of the range: the last search that passed it
  std::uint32_t searches_ = 0;
  std::size_t walks_ = 0;
  std::size_t steps_ = 0;
};

extern template class QuickWalker<PairedMesh>;
extern template class QuickWalker<QuadMesh>;

}  // namespace quadloom::quadrangulate
