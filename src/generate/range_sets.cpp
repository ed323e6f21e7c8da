// Coordinates of very different sizes.
#include <numbers>

#include "generate/elementary.hpp"
#include "generate/sets.hpp"

namespace quadloom::generate {
namespace {

// A size whose logarithm is even over 18 decades, either sign.
double over_decades(Random& random) {
  constexpr double kBitsPerDecade = std::numbers::ln10 / std::numbers::ln2;
  const double size = power_of_two(kBitsPerDecade * (18 * random.uniform() - 9));
  return random.below(2) == 0 ? size : -size;
}

}  // namespace

Points make_decades(std::size_t n, std::uint64_t seed) {
  Random random(seed);
  Points points(n);
  for (Point& p : points) {
    const double x = over_decades(random);
    p = {x, over_decades(random)};
  }
  return points;
}

Points make_two_clusters(std::size_t n, std::uint64_t seed) {
  Random random(seed);
  Points points(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double x = random.uniform();
    points[i] = {x + (i % 2 == 0 ? 0 : 1e9), random.uniform()};
  }
  return points;
}

// A unit square so far from the origin that only about 24 bits of a coordinate vary.
Points make_offset(std::size_t n, std::uint64_t seed) {
  Random random(seed);
  Points points(n);
  for (Point& p : points) {
    const double x = random.uniform();
    p = {4.5e8 + x, -7.2e8 + random.uniform()};
  }
  return points;
}

}  // namespace quadloom::generate
