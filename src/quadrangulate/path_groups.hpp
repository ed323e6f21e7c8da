// Consecutive triangles of a serpentine path, grouped into faces of k corners.
#pragma once

#include <cstdint>
#include <vector>

#include "quadrangulate/serpentine.hpp"

namespace quadloom::quadrangulate {

/// Group g takes `triangles` of the path and `entering` added points on the diagonal through which
/// the path enters it (the hull edge for the first group); the points on the diagonal where it
/// leaves are those of the next group. triangles + entering + leaving = k - 2 for every group.
struct PathGroup {
  std::uint32_t triangles = 0;
  std::uint32_t entering = 0;
};

/// Groups that are simple polygons, with few added points in all: the fewest if the part of the path
/// where groups could touch themselves is short enough to search, and none inside the mesh if no
/// group can touch itself. `full` is k - 2, the triangles of a face without added points.
/// No points go to the diagonal that enters triangle t if closed[t], except where the search does not
/// reach.
std::vector<PathGroup> group_path(const Serpentine& path, std::size_t full,
                                  const std::vector<char>& closed);

}  // namespace quadloom::quadrangulate
