// Places for Steiner points at boundary edges: outside or on the edge, as wished.
#pragma once

#include <optional>

#include "quadloom/quadrangulate.hpp"
#include "quadrangulate/outer_places.hpp"

namespace quadloom::quadrangulate {

struct EdgePlace {
  Point place;
  double z = 0;
  SteinerKind kind = SteinerKind::kOnEdge;
};

/// Gives boundary edges a Steiner point each, of the wished kind (kOutside or kOnEdge) or, where that
/// has no double, of the other kind. On a surface in space it is the edge's midpoint as rounded. The
/// mesh must outlive the object. See OuterPlaces for kOutside, point_on_segment for kOnEdge.
class EdgePlaces {
 public:
  EdgePlaces(const TriangleMesh& input, OddBoundary wish) : input_(input), wish_(wish) {}

  /// The place for the boundary halfedge h, each asked for once at most. Throws as OuterPlaces.
  std::optional<EdgePlace> place(HalfedgeId h);

  /// The same; throws Error kGuarantee naming the edge (culprits: its ends).
  EdgePlace place_or_throw(HalfedgeId h);

 private:
  std::optional<EdgePlace> place_of_kind(HalfedgeId h, SteinerKind kind);

  const TriangleMesh& input_;
  OddBoundary wish_;
  std::optional<OuterPlaces> outer_;  // made when it is needed
};

}  // namespace quadloom::quadrangulate
