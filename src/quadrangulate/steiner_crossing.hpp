// Left-over triangles cross quads with inner Steiner points, where no walk brings them together.
#pragma once

#include <array>
#include <functional>
#include <span>
#include <vector>

#include "quadrangulate/paired_mesh.hpp"

namespace quadloom::quadrangulate {

/// A free triangle T beside the quad of N and F. Nothing but pairs and the inside of triangles changes:
/// every edge between quads, and so the shape of a surface, stays.
///
///      over        N and T become the quad, F is free: no point (an alternating path)
///      across N    s inside N: T + (edge to T, s), F + (edge to F, s); free: (the exit, s)
///      across F    s inside F: T + N, two triangles at s; free: (the exit, s)
///
///         c                     c
///       /   .                 /   .
///     a ----- b             a ----- b          across N to the exit a-d: the quads
///     | .  N  |     ->      | .  s /|          c, a, s, b and s, d, e, b; free: a, d, s
///     |   .   |             |  /.   |
///     |  F  . |             | /   . |
///     d ----- e             d ----- e
class SteinerCrossing {
 public:
  explicit SteinerCrossing(PairedMesh& mesh) : mesh_(mesh) {}

  /// Brings the free triangle to another free one of its part by the fewest points and pairs them. False, and
  /// nothing changed, if there is no other or no way.
  bool merge(TriangleId start);

  /// Brings one of the free triangles to a border edge a->b that the goal likes; its halfedge, or
  /// kNone and nothing changed.
  using EdgeGoal = std::function<bool(VertexId a, VertexId b)>;
  HalfedgeId reach_border(std::span<const TriangleId> starts, const EdgeGoal& goal);

  /// The points added so far, inner ones; parents are the corners of the triangle they lie in.
  const std::vector<SteinerPoint>& points() const { return points_; }
  std::size_t crossings() const { return points_.size(); }

 private:
  enum class Step : std::uint8_t { kStart, kOver, kAcross };
  /// Where the free triangle is after some steps.
  struct Node {
    std::uint32_t parent = kNone;
    HalfedgeId enter = kNone;     // of the quad that was passed last
    HalfedgeId exit = kNone;      // kAcross: the only way on, a side of that quad
    TriangleId triangle = kNone;  // kStart, kOver: the free triangle
    Step step = Step::kStart;
  };
  /// How a search ended: the last node, and where it goes on from there.
  struct End {
    std::uint32_t node = kNone;
    HalfedgeId last = kNone;  // towards the other free triangle, or the border edge
  };

  End search(std::span<const TriangleId> starts, const EdgeGoal* goal);
  void pass(std::uint32_t from, HalfedgeId enter);
  bool can_apply(std::uint32_t end);
  HalfedgeId apply(const End& end);
  void over(HalfedgeId enter);
  HalfedgeId across(HalfedgeId enter, HalfedgeId exit);
  std::array<TriangleId, 3> split(TriangleId t);
  TriangleId split_by(const Node& node) const;

  PairedMesh& mesh_;
  std::vector<SteinerPoint> points_;
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> now_, later_;  // nodes by number of points: a breadth-first search
  std::vector<std::uint32_t> search_of_;    // per triangle: the last search that came there
  std::uint32_t searches_ = 0;
  std::vector<std::uint8_t> full_;  // per triangle: no double is inside
};

}  // namespace quadloom::quadrangulate
