// The kinds by name; the makers are in the *_sets.cpp files.
#include <array>
#include <string>

#include "generate/sets.hpp"
#include "quadloom/generate.hpp"

namespace quadloom {
namespace {

using namespace generate;

constexpr std::array<Generator, 25> kGenerators = {{
    {"uniform", "evenly random in the unit square", 3, make_uniform},
    {"gaussian", "normally distributed around the origin", 3, make_gaussian},
    {"clusters", "twelve normal clusters of different widths", 3, make_clusters},
    {"towns-like", "clustered by a power law, as towns are", 3, make_towns_like},
    {"duplicates", "random, each place taken about three times", 3, make_duplicates},
    {"grid", "a square grid with whole coordinates", 3, make_grid},
    {"rotated-grid", "a square grid, turned and rounded", 3, make_rotated_grid},
    {"hex-grid", "equilateral triangles, rounded", 3, make_hex_grid},
    {"jittered-grid", "a square grid, each point moved by less than half a cell", 3,
     make_jittered_grid},
    {"raster", "a raster of 0.2 m at the coordinates of a map", 3, make_raster},
    {"circle", "evenly spaced on the unit circle, rounded", 3, make_circle},
    {"circles", "concentric circles, points aligned on rays", 3, make_circles},
    {"cocircular", "whole coordinates, exactly on one circle", 3, make_cocircular},
    {"convex", "whole coordinates, corners of a convex polygon", 3, make_convex},
    {"spiral", "along an Archimedean spiral", 3, make_spiral},
    {"lines", "exactly on five lines", 3, make_lines},
    {"cross", "on the two axes", 3, make_cross},
    {"near-line", "on y = x / 3 up to units in the last place", 3, make_near_line},
    {"collinear-but-one", "all on one line but one", 3, make_collinear_but_one},
    {"decades", "coordinates from 1e-9 to 1e9, both signs", 3, make_decades},
    {"two-clusters", "two unit squares 1e9 apart", 3, make_two_clusters},
    {"offset", "a unit square at (4.5e8, -7.2e8)", 3, make_offset},
    {"bhrs-line", "a line of points, one above and one below (Bremner et al., theorem 2.1)", 5,
     make_bhrs_line},
    {"bhrs-ring", "a convex ring and a point inside each edge (Bremner et al., theorem 2.3)", 6,
     make_bhrs_ring},
    {"ahms-nine", "has no sequential triangulation (Arkin et al., theorem 4.1)", 9, make_ahms_nine},
}};

const Generator& find_generator(std::string_view kind) {
  std::string names;
  for (const Generator& g : kGenerators) {
    if (g.name == kind) return g;
    names += names.empty() ? "" : ", ";
    names += g.name;
  }
  throw Error(ErrorCode::kBadOption,
              "no kind of points is called '" + std::string(kind) + "'; there are " + names);
}

}  // namespace

std::span<const Generator> generators() { return kGenerators; }

std::vector<Point> generate_points(std::string_view kind, std::size_t n, std::uint64_t seed) {
  const Generator& g = find_generator(kind);
  if (n < g.min_points) {
    throw Error(ErrorCode::kBadOption, std::string(kind) + " needs at least " +
                                           std::to_string(g.min_points) + " points, not " +
                                           std::to_string(n));
  }
  if (n > kMaxPoints) {
    throw Error(ErrorCode::kBadOption, std::to_string(n) + " points are more than the limit of " +
                                           std::to_string(kMaxPoints));
  }
  return g.make(n, seed);
}

}  // namespace quadloom
