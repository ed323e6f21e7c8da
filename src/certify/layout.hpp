// Whether the arrays of a mesh fit together at all.
#pragma once

#include <algorithm>

#include "quadloom/core.hpp"

namespace quadloom::certify {

/// Every face is a part of the list of corners, one after the other, nothing left over.
inline bool layout_fits(const PolygonMesh& mesh) {
  const auto& begin = mesh.face_begin;
  return !begin.empty() && begin.front() == 0 && begin.back() == mesh.face_vertex.size() &&
         std::ranges::is_sorted(begin);
}

}  // namespace quadloom::certify
