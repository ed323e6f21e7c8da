// The pairing method of quadrangulate_triangles.
#pragma once

#include <vector>

#include "quadrangulate/paired_mesh.hpp"

namespace quadloom::quadrangulate {

/// See quadrangulate_triangles, which has checked the input.
TriangleResult pair_triangulation(const TriangleMesh& input, const TriangleOptions& options);

/// The same before it is written out.
struct PairedTriangles {
  PairedMesh mesh;
  std::vector<SteinerPoint> steiner;  ///< by vertex
  std::vector<TriangleId> barrier;
  TriangleStatistics statistics;
};
PairedTriangles pair_triangles(const TriangleMesh& input, const TriangleOptions& options);

}  // namespace quadloom::quadrangulate
