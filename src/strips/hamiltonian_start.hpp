// The triangles that a Hamiltonian cycle through a point set begins with.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/random.hpp"
#include "strips/wedge.hpp"

namespace quadloom::strips {

/// Wedges in the order of a cycle that tile the hull. `inner` are the points strictly inside the hull
/// (at least one), all others are in `hull`, counter-clockwise; the wedges' ranges are ranges of
/// `inner`, which is put into another order. None if no such cycle was found.
struct CycleStart {
  std::vector<Wedge> wedges;
  std::size_t centres = 0;  // inner points among their corners
};
std::optional<CycleStart> start_cycle(std::span<const Place> hull, std::vector<Place>& inner,
                                      Random& random);

}  // namespace quadloom::strips
