// Places for outer Steiner points: outside a planar mesh, beside an edge of its boundary.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "quadloom/core.hpp"

namespace quadloom::quadrangulate {

/// Gives boundary edges a point outside each. For an edge a -> b (the mesh on its left) the point s
/// lies strictly right of it and sees all of it; with every edge a-b that was given a place replaced
/// by a-s-b, all at once, the boundary is as simple as before, holes and narrow bays included.
///
/// Planar meshes alone. The mesh must outlive the object. O(b log b) for b boundary edges, and O(1) a
/// place.
class OuterPlaces {
 public:
  /// Throws Error kBadMesh if boundary edges of the mesh cross or overlap (culprits: two of them, as
  /// halfedges).
  explicit OuterPlaces(const Triangulation& mesh);

  /// The place for the boundary halfedge h, each asked for once at most; kNone where there is no
  /// double, or the boundary has no outer side there (it touches itself along the edge). The quad a,
  /// s, b, c with the apex c of the edge's triangle is strictly convex if doubles allow.
  std::optional<Point> place(HalfedgeId h);

  /// The same; throws Error kGuarantee naming the edge (culprits: its ends).
  Point place_or_throw(HalfedgeId h);

  // Instead of place(), for callers that look for places themselves, and move them:

  /// Whether s may be the place for h beside those that other edges took.
  bool allows(HalfedgeId h, Point s) const;
  /// Makes s, which is allowed, the place for h, in the stead of an earlier one.
  void take(HalfedgeId h, Point s);

 private:
  /// A triangle outside, and the place that the first of its edges was given.
  struct Pocket {
    std::array<Point, 3> corner;
    std::optional<Point> first;
    std::array<std::optional<Point>, 3> taken;  // by edge
  };

  void find_pockets();
  std::uint32_t outer_of(HalfedgeId h) const;

  const Triangulation& mesh_;
  std::vector<HalfedgeId> boundary_;  // ascending
  std::vector<std::uint32_t> outer_;  // by boundary edge: 3 x pocket + edge, or kNone
  std::vector<Pocket> pockets_;
};

}  // namespace quadloom::quadrangulate
