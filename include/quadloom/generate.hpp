// Named point sets and polygons for tests, benchmarks and teaching.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "quadloom/core.hpp"
#include "quadloom/kernel.hpp"

namespace quadloom {

/// One kind of point set. `make` wants n >= min_points and gives n points or as near to n as the
/// kind allows, never all on one line; the same n and seed give the same doubles on every platform.
struct Generator {
  std::string_view name;
  std::string_view what;       ///< one line for a help text
  std::size_t min_points = 3;  ///< the least n
  std::vector<Point> (*make)(std::size_t n, std::uint64_t seed) = nullptr;
};

/// All generators, in the order of a help text.
std::span<const Generator> generators();

/// n points (as near to n as the kind allows) of the kind of that name. Throws Error kBadOption for
/// an unknown name (the sentence lists the names) or an n that is too small for the kind.
std::vector<Point> generate_points(std::string_view kind, std::size_t n, std::uint64_t seed = 1);

/// One kind of simple polygon, with whole coordinates below 2^32. `make` wants n >= min_corners and
/// gives one ring of n corners or as near to n as the kind allows.
struct PolygonGenerator {
  std::string_view name;
  std::string_view what;
  std::size_t min_corners = 3;
  Polygon (*make)(std::size_t n, std::uint64_t seed) = nullptr;
};

std::span<const PolygonGenerator> polygon_generators();

/// As generate_points.
Polygon generate_polygon(std::string_view kind, std::size_t n, std::uint64_t seed = 1);

/// The polygon eight times as big and with triangles cut out of it, at most `holes` and one from each
/// of the triangles that constrained_delaunay gives. Whole coordinates stay whole.
Polygon with_holes(const Polygon& polygon, std::size_t holes, std::uint64_t seed = 1);

}  // namespace quadloom
