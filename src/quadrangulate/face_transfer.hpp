// Faces of at most k corners become faces of k corners: triangles move from face to face.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "quadrangulate/face_starts.hpp"

namespace quadloom::quadrangulate {

/// Simple faces, counter-clockwise, and the points to add so that each has k corners.
struct FacePlan {
  struct Inner {
    VertexId from = kNone, to = kNone;  // an edge of `face`; its twin is an edge of another face
    std::size_t face = 0;
    std::size_t count = 0;
  };
  struct Outer {
    std::size_t face = 0;  // it has a hull edge
    std::size_t count = 0;
  };
  std::vector<std::vector<VertexId>> faces;
  std::vector<Inner> inner;
  std::vector<Outer> outer;
  std::size_t added = 0;
};

/// The bound of corollary 4.1; for quads none if the number of triangles is even, as theorem 3.1 has it.
constexpr std::size_t enough_points(std::size_t triangles, std::size_t k) {
  return k == 4 ? triangles % 2 : k - 3;
}

struct TransferEffort {
  int disturbances = 20;  // before it gives up
  std::uint64_t seed = 1;
  Progress progress = {};
};

/// The plan with the fewest added points that was found; the search stops at enough_points(), or when it has
/// looked at `work_left` corners, from which it takes what it used. None if in all of them some face
/// lacks corners and has neither a hull edge nor a neighbour that lacks as many.
std::optional<FacePlan> transfer_triangles(const LabelledTriangles& start, std::size_t k,
                                           const TransferEffort& effort, std::size_t& work_left);

}  // namespace quadloom::quadrangulate
