// Which faces of a mesh a pass may change, so that several passes go over large meshes at once.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "quadloom/core.hpp"

namespace quadloom::quadrangulate {

/// Faces by their numbers; all of them unless told otherwise. Faces are numbered along a curve, so a range is a patch of
/// the mesh.
struct FaceRange {
  std::uint32_t begin = 0, end = kNone;

  bool is_all() const { return end == kNone; }
  bool has(std::uint32_t face) const { return face - begin < end - begin; }
  /// How many of so many faces, all together, are in it.
  std::size_t size(std::size_t faces) const { return is_all() ? faces : end - begin; }
};

/// The ranges that large meshes are cut into, which depend on the number of faces alone; none for small ones.
std::vector<FaceRange> face_ranges(std::size_t faces);

}  // namespace quadloom::quadrangulate
