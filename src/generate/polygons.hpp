// The makers of polygons behind the registry.
#pragma once

#include <cstdint>

#include "quadloom/kernel.hpp"

namespace quadloom::generate {

// polygons.cpp
Polygon make_star_polygon(std::size_t n, std::uint64_t seed);
Polygon make_comb_polygon(std::size_t n, std::uint64_t seed);
Polygon make_spiral_polygon(std::size_t n, std::uint64_t seed);

// fisk_polygon.cpp
Polygon make_fisk_polygon(std::size_t n, std::uint64_t seed);

// rectilinear_polygon.cpp
Polygon make_rectilinear_polygon(std::size_t n, std::uint64_t seed);

// two_opt_polygon.cpp
Polygon make_two_opt_polygon(std::size_t n, std::uint64_t seed);

}  // namespace quadloom::generate
