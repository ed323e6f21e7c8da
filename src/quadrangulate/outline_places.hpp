// The points that a subdivision adds on the boundary of a mesh.
#pragma once

#include <optional>

#include "quadrangulate/outer_places.hpp"
#include "quadrangulate/subdivision.hpp"

namespace quadloom::quadrangulate {

/// In the plane each point is exactly on its edge, in its middle half, if a double is; else it is the
/// nearest double tried that is outside beside the middle, such that the boundary stays simple; else
/// it is anywhere on the edge. On a surface it is the rounded midpoint.
class OutlinePlaces final : public BoundaryPlaces {
 public:
  explicit OutlinePlaces(const Triangulation& mesh) : mesh_(mesh) {}

  /// Throws Error kGuarantee for an edge that has no place, kBadMesh if a point must be outside and the
  /// boundary crosses itself.
  void place_all(Subdivision& s) override;
  std::vector<EdgeId> make_room(Subdivision&, EdgeId) override { return {}; }
  bool may_move(const Subdivision& s, EdgeId e, Point place) override;
  void moved(const Subdivision& s, EdgeId e) override;

  std::size_t size() const { return size_; }

 private:
  OuterPlaces& outside();
  Point place_of(HalfedgeId h);
  std::optional<Point> place_outside(HalfedgeId h);

  const Triangulation& mesh_;
  std::optional<OuterPlaces> outside_;  // made when the first point must be outside
  std::size_t size_ = 0;                // boundary edges
};

}  // namespace quadloom::quadrangulate
