// How the faces of a surface hang together.
#pragma once

#include <cstdint>
#include <vector>

#include "quadloom/core.hpp"

namespace quadloom::certify {

/// Faces at a vertex that are neighbours over edges make a fan; faces that are neighbours make a
/// component.
struct Topology {
  std::vector<std::uint32_t> fans;       ///< by vertex; 0: unused
  std::vector<std::uint32_t> component;  ///< by vertex: that of one of its fans, or kNone
  std::vector<std::int64_t> euler;  ///< by component: fans - edges + faces, so that a vertex of two
                                    ///< fans counts as two
};

/// No directed edge may be in two faces. Near-linear, but for sorting the edges at a vertex.
Topology topology_of(const PolygonMesh& mesh);

}  // namespace quadloom::certify
