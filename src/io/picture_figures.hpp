// What a picture shows of each face, and the counts for its legend.
#pragma once

#include <cstdint>
#include <vector>

#include "quadloom/io.hpp"

namespace quadloom::io {

inline constexpr std::size_t kMostGroups = 4;

enum class FaceKind : std::uint8_t { kTriangle, kStrictlyConvex, kFlatCornered, kNonConvex };

struct FaceFigures {
  std::vector<FaceKind> kind;       // decided exactly
  std::vector<float> shape;         // see face_shape; empty unless the picture shows it
  std::vector<std::uint8_t> group;  // of the options; empty unless the picture shows it
  std::size_t group_count[kMostGroups] = {};
  std::size_t count[4] = {};  // by kind
  bool quads_only = true;     // every face has four corners or three
};
FaceFigures measure_faces(const PolygonMesh& mesh, ColourBy colour);

/// Takes the groups of the faces over. Throws Error kBadOption if they are not one a face, or too great.
void add_groups(FaceFigures& figures, std::span<const std::uint8_t> group);

/// quad_shape, and for k corners its like: 1 for equal angles, 0 where one is 180 degrees or more.
double face_shape(const PolygonMesh& mesh, std::size_t face);

}  // namespace quadloom::io
