// Sequential triangulations of a few points by a search over the sequences of vertices.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "quadloom/convex.hpp"

namespace quadloom::strips {

inline constexpr std::size_t kMostSequentialPoints = 32;

struct SequenceFound {
  Answer answer = Answer::kUnknown;
  std::vector<VertexId> sequence;  // kYes
  std::uint64_t work = 0;          // triangles tried
};

/// Of distinct points, at most kMostSequentialPoints and not all on a line.
SequenceFound search_sequence(std::span<const Point> points, std::uint64_t work_at_most,
                              const Progress& progress);

}  // namespace quadloom::strips
