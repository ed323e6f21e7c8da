// The points inside the triangles of a Hamiltonian cycle become corners of it.
#pragma once

#include <vector>

#include "core/random.hpp"
#include "quadloom/strips.hpp"
#include "strips/wedge.hpp"

namespace quadloom::strips {

/// What the splitting did.
struct SplittingStatistics {
  std::size_t levels = 0;     ///< how deeply triangles are nested
  std::size_t locations = 0;  ///< how often a point was located
  std::size_t chains = 0;     ///< splitters that came with others on their line
};

/// The triangles (three corners each, counter-clockwise) of the cycle through `wedges`, in its order,
/// with all the places as corners. `count` is about how many there will be.
std::vector<VertexId> split_wedges(const std::vector<Wedge>& wedges, std::vector<Place>& places,
                                   std::size_t count, const HamiltonianOptions& options,
                                   Random& random, SplittingStatistics& statistics);

}  // namespace quadloom::strips
