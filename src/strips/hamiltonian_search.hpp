// A Hamiltonian cycle triangulation of a small point set, or that there is none, by exhaustion.
#pragma once

#include <span>
#include <vector>

#include "quadloom/convex.hpp"
#include "quadloom/core.hpp"

namespace quadloom::strips {

inline constexpr std::size_t kMostSearched = 16;  // points; their turns are kept in a table

struct CycleSearch {
  Answer answer = Answer::kUnknown;  ///< kUnknown: the work ran out
  std::vector<VertexId> corners;     ///< kYes: three a triangle, in the order of the cycle
};

/// At most kMostSearched distinct points, not all on a line. Tries at most `work` triangles.
CycleSearch search_cycle(std::span<const Point> points, std::size_t work);

}  // namespace quadloom::strips
