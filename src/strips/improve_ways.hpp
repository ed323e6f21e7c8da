// Better ways of paths through triangles.
#pragma once

#include <vector>

#include "quadloom/dual.hpp"
#include "quadloom/strips.hpp"
#include "strips/way_tables.hpp"

namespace quadloom::strips {

/// Some of the rounds of a search; in each the mesh falls into other patches.
struct Rounds {
  std::size_t first = 0;
  std::size_t count = 2;
  std::size_t passes = 16;  // over each patch
  std::size_t of = 2;       // for the progress
};

/// Changes the ways so that the edges on paths are worth more together, never less; cycles come up
/// as well as paths. Throws Error kCancelled. O(n) a pass.
void improve_ways(const DualGraph& graph, const WayTables& tables, const Rounds& rounds,
                  std::uint64_t seed, const Progress& progress, std::vector<Way>& way);

}  // namespace quadloom::strips
