// Grids: straight, turned, hexagonal, disturbed.
#include <algorithm>
#include <cmath>

#include "generate/elementary.hpp"
#include "generate/sets.hpp"

namespace quadloom::generate {
namespace {

// As square as n allows and as near to n as whole rows are; place(column, row) gives a point.
template <typename Place>
Points fill_grid(std::size_t n, Place place) {
  const auto root = static_cast<std::size_t>(std::sqrt(static_cast<double>(n)) + 0.5);
  const std::size_t columns = std::max<std::size_t>(2, root);
  const std::size_t rows = std::max<std::size_t>(2, (n + columns / 2) / columns);
  Points points;
  points.reserve(columns * rows);
  for (std::size_t r = 0; r < rows; ++r) {
    for (std::size_t c = 0; c < columns; ++c) {
      points.push_back(place(static_cast<double>(c), static_cast<double>(r)));
    }
  }
  return points;
}

}  // namespace

Points make_grid(std::size_t n, std::uint64_t) {
  return fill_grid(n, [](double c, double r) { return Point{c, r}; });
}

// Turned by an angle that depends on the seed, so that rows are straight up to rounding only.
Points make_rotated_grid(std::size_t n, std::uint64_t seed) {
  Random random(seed);
  const Point d = on_unit_circle(0.01 + 0.23 * random.uniform());
  return fill_grid(n, [d](double c, double r) {
    return Point{c * d.x - r * d.y, c * d.y + r * d.x};
  });
}

Points make_hex_grid(std::size_t n, std::uint64_t) {
  const double height = std::sqrt(0.75);
  return fill_grid(n, [height](double c, double r) {
    return Point{c + 0.5 * std::fmod(r, 2), r * height};
  });
}

// Each point of the grid moved by less than half a cell.
Points make_jittered_grid(std::size_t n, std::uint64_t seed) {
  Random random(seed);
  return fill_grid(n, [&random](double c, double r) {
    const double dx = 0.8 * random.uniform() - 0.4;
    return Point{c + dx, r + 0.8 * random.uniform() - 0.4};
  });
}

// A raster of 0.2 m cells at the coordinates of a map (UTM); 0.2 is no double, so its squares are
// squares up to rounding only.
Points make_raster(std::size_t n, std::uint64_t) {
  return fill_grid(n, [](double c, double r) {
    return Point{399960.1 + 0.2 * c, 5300040.1 + 0.2 * r};
  });
}

}  // namespace quadloom::generate
