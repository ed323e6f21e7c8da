// Convex parts and what is on the other side of their sides.
#pragma once

#include <vector>

#include "quadloom/core.hpp"

namespace quadloom::strips {

using SideId = std::uint32_t;
using PartId = std::uint32_t;

/// The sides of the faces of a mesh: side s starts at corner face_vertex[s].
class PartSides {
 public:
  explicit PartSides(const PolygonMesh& parts);

  VertexId origin(SideId s) const { return parts_.face_vertex[s]; }
  VertexId target(SideId s) const { return parts_.face_vertex[next(s)]; }
  PartId part(SideId s) const { return part_[s]; }
  SideId next(SideId s) const;
  SideId previous(SideId s) const;
  SideId twin(SideId s) const { return twin_[s]; }  ///< kNone on the boundary
  std::size_t count() const { return twin_.size(); }
  /// The sides of a part behind one of them, counter-clockwise, that one left out.
  std::vector<SideId> others(SideId s) const;
  Point at(VertexId v) const { return parts_.points[v]; }
  /// The part goes straight on where this side starts. Exact.
  bool flat_at_origin(SideId s) const { return orient2d_of(previous(s), s) == 0; }
  bool flat_at_target(SideId s) const { return orient2d_of(s, next(s)) == 0; }

 private:
  int orient2d_of(SideId s, SideId then) const;

  const PolygonMesh& parts_;
  std::vector<PartId> part_;
  std::vector<SideId> twin_;
};

}  // namespace quadloom::strips
