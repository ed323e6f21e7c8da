// The makers behind the registry, by file.
#pragma once

#include <cstdint>
#include <vector>

#include "quadloom/core.hpp"

namespace quadloom::generate {

using Points = std::vector<Point>;

// random_sets.cpp
Points make_uniform(std::size_t n, std::uint64_t seed);
Points make_gaussian(std::size_t n, std::uint64_t seed);
Points make_clusters(std::size_t n, std::uint64_t seed);
Points make_towns_like(std::size_t n, std::uint64_t seed);
Points make_duplicates(std::size_t n, std::uint64_t seed);

// grid_sets.cpp
Points make_grid(std::size_t n, std::uint64_t seed);
Points make_rotated_grid(std::size_t n, std::uint64_t seed);
Points make_hex_grid(std::size_t n, std::uint64_t seed);
Points make_jittered_grid(std::size_t n, std::uint64_t seed);
Points make_raster(std::size_t n, std::uint64_t seed);

// circle_sets.cpp
Points make_circle(std::size_t n, std::uint64_t seed);
Points make_circles(std::size_t n, std::uint64_t seed);
Points make_spiral(std::size_t n, std::uint64_t seed);

// whole_sets.cpp
Points make_cocircular(std::size_t n, std::uint64_t seed);
Points make_convex(std::size_t n, std::uint64_t seed);

// line_sets.cpp
Points make_lines(std::size_t n, std::uint64_t seed);
Points make_cross(std::size_t n, std::uint64_t seed);
Points make_near_line(std::size_t n, std::uint64_t seed);
Points make_collinear_but_one(std::size_t n, std::uint64_t seed);

// range_sets.cpp
Points make_decades(std::size_t n, std::uint64_t seed);
Points make_two_clusters(std::size_t n, std::uint64_t seed);
Points make_offset(std::size_t n, std::uint64_t seed);

// ahms_set.cpp
Points make_ahms_nine(std::size_t n, std::uint64_t seed);

// lower_bound_sets.cpp
Points make_bhrs_line(std::size_t n, std::uint64_t seed);
Points make_bhrs_ring(std::size_t n, std::uint64_t seed);

}  // namespace quadloom::generate
