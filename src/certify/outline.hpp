// The boundary of a mesh that must be a given one: rings of polygons, or another mesh's boundary.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "certify/edges.hpp"
#include "certify/places.hpp"
#include "quadloom/kernel.hpp"

namespace quadloom::certify {

/// An edge of the given boundary, with the inside on its left.
struct OutlineEdge {
  Point from;
  Point to;
};

/// The edges of the rings; those that two polygons share are none.
std::vector<OutlineEdge> outline_of(std::span<const Polygon> polygons);

/// The edges of a source. Throws Error kBadMesh, kIndexOutOfRange.
EdgeReport check_source(const PolygonMesh& mesh);

/// The edges of one face alone. Throws as check_source.
std::vector<OutlineEdge> outline_of(const PolygonMesh& mesh);

struct OutlineReport {
  std::string sentence;  ///< what is wrong; empty if nothing is
  std::vector<std::size_t> culprits;
};

/// Whether the mesh's boundary edges are those of the outline, each in one piece or split by
/// vertices on it, or, if `outer_steiner`, replaced by two edges through a vertex for which
/// is_steiner is set.
OutlineReport match_outline(const PolygonMesh& mesh, std::span<const DirectedEdge> boundary,
                            std::span<const OutlineEdge> outline, const Places& places,
                            std::span<const std::uint8_t> is_steiner, bool outer_steiner);

/// Whether the closed directed edges have winding number 0 or 1 about every place.
OutlineReport judge_winding(const PolygonMesh& mesh, std::span<const DirectedEdge> boundary);

}  // namespace quadloom::certify
