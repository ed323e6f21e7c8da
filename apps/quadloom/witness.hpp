// Why a triangulation has no perfect matching, for people.
#pragma once

#include <string>
#include <vector>

#include "mesh_input.hpp"

namespace quadloom::app {

/// Tutte and Berge's witness: without the barrier the triangles fall into odd_parts parts with an odd
/// number of triangles, unmatched more than the barrier has triangles.
struct Witness {
  std::size_t unmatched = 0;
  std::vector<TriangleId> barrier;
  std::size_t odd_parts = 0;
  std::vector<std::uint8_t> group;  ///< per triangle: 1 the barrier, 2 an odd part, else 0
  bool all_pairs = true;            ///< no pair was refused for its shape
  bool proves = false;              ///< the parts were counted anew, and there are as many as said
};

/// From the triangles and the options, which say what pairs are allowed.
Witness find_witness(const SourceMesh& source, std::vector<TriangleId> barrier,
                     std::size_t unmatched, const TriangleOptions& options);

/// "3 triangles stay unmatched whatever is done: taking the 2 triangles 5, 17 away leaves 5 parts with
/// an odd number of triangles". Triangles by the numbers of the source's faces.
std::string in_words(const Witness& witness, const std::vector<std::uint32_t>& source_face);

}  // namespace quadloom::app
