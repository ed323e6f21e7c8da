// Walks: a left-over triangle moves through quads until it meets another one, or the boundary.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "quadrangulate/paired_mesh.hpp"

namespace quadloom::quadrangulate {

enum class WalkQuads : std::uint8_t {
  kStrictlyConvex,  // a walk leaves only strictly convex quads behind
  kAny,             // any simple quad; flat and non-convex ones are avoided where a detour exists
};

struct WalkLimits {
  WalkQuads quads = WalkQuads::kAny;
  std::size_t nodes = 0xffffffffU;  // of the search, at most
  std::uint8_t visits = 1;          // how many routes may go through the same quad
  /// On a surface: the least cosine between the normals of the three triangles of a pentagon.
  double least_cosine = -1;
};

/// Cheapest walks on a paired mesh.
///
/// A free triangle beside a quad is a pentagon; cutting off another ear moves the free triangle to
/// where its neighbours are others. A search (Dijkstra over such moves, short and well-shaped
/// first) finds the way to another free triangle, with which it becomes a quad; only then are the
/// pentagons along the way re-cut. Vertices, boundary and the number of triangles stay. A search
/// costs O(nodes log nodes).
class Walker {
 public:
  explicit Walker(PairedMesh& mesh) : mesh_(mesh) {}

  /// Walks the free triangle to another one and pairs them. False, and nothing changed, if none was
  /// found.
  bool merge(TriangleId start, const WalkLimits& limits);

  /// Where a walk to the boundary may end: at the edge a->b with the free triangle a, b, c.
  struct BoundaryGoal {
    /// What it costs to end there, at least; negative: not there. Called for every edge seen.
    std::function<int(VertexId a, VertexId b, VertexId c)> cost;
    /// Whether the walk may really end there. Called for the best edges only, in order of cost.
    std::function<bool(VertexId a, VertexId b)> accept;
  };

  /// Walks one of the free triangles to the boundary; its boundary halfedge, or kNone and nothing
  /// changed.
  HalfedgeId reach_boundary(std::span<const TriangleId> starts, const BoundaryGoal& goal,
                            const WalkLimits& limits);

  /// Of the last search.
  std::size_t nodes() const { return nodes_.size(); }
  std::size_t walks() const { return walks_; }
  std::size_t steps() const { return steps_; }

  /// Called after each re-cut with the triangles touched.
  std::function<void(std::span<const TriangleId>)> on_recut;

 private:
  /// The free triangle after some moves: where it is and how it came there.
  struct Node {
    std::uint32_t parent = kNone;
    /// The halfedge of the quad, or of the free goal, that was entered; kNone for a start.
    HalfedgeId enter = kNone;
    std::array<VertexId, 3> corner;
    /// The mesh's halfedge from corner i to i + 1; kNone for the edge just cut.
    std::array<HalfedgeId, 3> exit;
    std::int8_t ear = 0;
    bool goal = false;
    std::uint32_t depth = 0;  // moves from the start
  };
  /// How often a search has visited a triangle, and after how few moves, if that is not more.
  struct Visits {
    static constexpr std::uint32_t kDeepest = (1U << 24) - 1;
    std::uint32_t search = 0;
    std::uint32_t least_depth : 24 = kDeepest;
    std::uint32_t count : 8 = 0;
  };
  /// Nodes waiting to be expanded, by cost. No move costs as much as the ring is long, so that the
  /// costs waiting at any time fit in one turn of it; among equal costs the last one pushed comes
  /// first.
  class Queue {
   public:
    static constexpr std::uint32_t kRing = 128;
    void clear();
    void push(std::uint32_t cost, std::uint32_t node);
    /// The cheapest node, kNone if there is none; its cost is then cost().
    std::uint32_t pop();
    std::uint32_t cost() const { return cost_; }

   private:
    std::array<std::vector<std::uint32_t>, kRing> bucket_;
    std::uint32_t cost_ = 0;
    std::size_t size_ = 0;
  };

  std::uint32_t search(std::span<const TriangleId> starts, const BoundaryGoal* boundary,
                       const WalkLimits& limits);
  void expand(std::uint32_t from, const BoundaryGoal* boundary, const WalkLimits& limits);
  void try_goal(std::uint32_t from, std::size_t i, const WalkLimits& limits);
  void try_boundary(std::uint32_t from, std::size_t i, const BoundaryGoal& boundary);
  void try_ears(std::uint32_t from, std::size_t i, const WalkLimits& limits);
  void try_wheel(std::uint32_t from, HalfedgeId enter, const QuadBehind& quad, VertexId centre);
  bool flat_enough(const Node& node, std::span<const TriangleId> others, double least_cosine,
                   kernel::Chart& chart) const;
  bool may_visit(std::uint32_t node, TriangleId t, std::uint8_t visits);
  void push(std::uint32_t move_cost, const Node& node);
  TriangleId apply(std::uint32_t node);

  PairedMesh& mesh_;
  std::vector<Node> nodes_;
  Queue queue_;
  std::vector<Visits> visits_;  // per triangle: of the last search that visited it
  std::uint32_t searches_ = 0;
  std::size_t walks_ = 0;
  std::size_t steps_ = 0;
};

}  // namespace quadloom::quadrangulate
