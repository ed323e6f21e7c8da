// What a picture shows of each face, and the counts for its legend.
#pragma once

#include <cstdint>
#include <vector>

#include "quadloom/io.hpp"

namespace quadloom::io {

enum class FaceKind : std::uint8_t { kTriangle, kStrictlyConvex, kFlatCornered, kNonConvex };

struct FaceFigures {
  std::vector<FaceKind> kind;  // decided exactly
  std::vector<float> shape;    // see face_shape; empty unless the picture shows it
  std::size_t count[4] = {};   // by kind
  bool quads_only = true;      // every face has four corners or three
};
FaceFigures measure_faces(const PolygonMesh& mesh, ColourBy colour);

/// quad_shape, and for k corners its like: 1 for equal angles, 0 where one is 180 degrees or more.
double face_shape(const PolygonMesh& mesh, std::size_t face);

}  // namespace quadloom::io
