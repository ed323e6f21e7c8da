// Random points: even, normal, in clusters, and with repeats.
#include <algorithm>
#include <cmath>

#include "generate/elementary.hpp"
#include "generate/sets.hpp"

namespace quadloom::generate {
namespace {

Point uniform_point(Random& random) {
  const double x = random.uniform();
  return {x, random.uniform()};
}

// Two independent standard normal numbers (Box and Muller).
Point normal_point(Random& random) {
  const double radius = std::sqrt(-2 * natural_log(1 - random.uniform()));
  const Point d = on_unit_circle(random.uniform());
  return {radius * d.x, radius * d.y};
}

}  // namespace

Points make_uniform(std::size_t n, std::uint64_t seed) {
  Random random(seed);
  Points points(n);
  for (Point& p : points) p = uniform_point(random);
  return points;
}

Points make_gaussian(std::size_t n, std::uint64_t seed) {
  Random random(seed);
  Points points(n);
  for (Point& p : points) p = normal_point(random);
  return points;
}

// Twelve normal clusters of different widths, and one point in ten spread evenly.
Points make_clusters(std::size_t n, std::uint64_t seed) {
  Random random(seed);
  constexpr std::size_t kClusters = 12;
  Points centre(kClusters);
  for (Point& c : centre) c = uniform_point(random);
  Points points(n);
  for (Point& p : points) {
    const auto cluster = static_cast<std::size_t>(random.below(kClusters));
    const double width = 0.005 * static_cast<double>(1 + cluster);
    const Point even = uniform_point(random);
    const Point around = normal_point(random);
    const Point c = centre[cluster];
    p = random.below(10) == 0 ? even : Point{c.x + width * around.x, c.y + width * around.y};
  }
  return points;
}

// Each point settles near an earlier one, at a distance that follows a power law, so that density
// varies over several orders of magnitude as it does among towns.
Points make_towns_like(std::size_t n, std::uint64_t seed) {
  Random random(seed);
  constexpr std::size_t kFounders = 8;
  Points points;
  points.reserve(n);
  while (points.size() < n) {
    if (points.size() < kFounders) {
      points.push_back(uniform_point(random));
      continue;
    }
    const Point parent = points[static_cast<std::size_t>(random.below(points.size()))];
    const double u = 1 - random.uniform();
    const double step = std::min(0.25, 0.002 / (u * std::sqrt(u)));  // P(step > s) ~ s^(-2/3)
    const Point d = on_unit_circle(random.uniform());
    points.push_back({parent.x + step * d.x, parent.y + step * d.y});
  }
  return points;
}

// A third as many places as points (at least three); every place is taken.
Points make_duplicates(std::size_t n, std::uint64_t seed) {
  Random random(seed);
  const std::size_t places = std::max<std::size_t>(3, n / 3);
  Points points = make_uniform(places, seed);
  points.reserve(n);
  while (points.size() < n) {
    points.push_back(points[static_cast<std::size_t>(random.below(places))]);
  }
  return points;
}

}  // namespace quadloom::generate
