// Points with whole coordinates that are exactly what their name says.
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "generate/elementary.hpp"
#include "generate/sets.hpp"

namespace quadloom::generate {
namespace {

struct Whole {
  std::int64_t x, y;
};

Point to_point(Whole z) { return {static_cast<double>(z.x), static_cast<double>(z.y)}; }

Whole times(Whole a, Whole b) { return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x}; }

double norm(Whole z) { return static_cast<double>(z.x * z.x + z.y * z.y); }

// The first primes of the form a^2 + b^2 (5, 13, 17, ..., 113) as Gaussian integers a + bi.
constexpr std::array<Whole, 14> kPrimes = {{{2, 1},
                                            {3, 2},
                                            {4, 1},
                                            {5, 2},
                                            {6, 1},
                                            {5, 4},
                                            {7, 2},
                                            {6, 5},
                                            {8, 3},
                                            {8, 5},
                                            {9, 4},
                                            {10, 1},
                                            {10, 3},
                                            {8, 7}}};
using Exponents = std::array<int, kPrimes.size()>;

// Exponents for which the circle of squared radius prod p^e carries at least n whole points, or as
// many as coordinates up to 2^52 allow: there are 4 prod (e + 1). Greedy: always the prime that
// adds most to the logarithm of the count for its own logarithm.
Exponents circle_exponents(std::size_t n) {
  Exponents exponent = {};
  double radius = 1;
  for (std::size_t count = 4; count < n;) {
    std::size_t best = kPrimes.size();
    double best_gain = 0;
    for (std::size_t i = 0; i < kPrimes.size(); ++i) {
      if (radius * std::sqrt(norm(kPrimes[i])) > 0x1p52) continue;
      const double gain = natural_log(1 + 1.0 / (exponent[i] + 1)) / natural_log(norm(kPrimes[i]));
      if (gain > best_gain) {
        best = i;
        best_gain = gain;
      }
    }
    if (best == kPrimes.size()) break;
    const auto e = static_cast<std::size_t>(++exponent[best]);
    count = count / e * (e + 1);
    radius *= std::sqrt(norm(kPrimes[best]));
  }
  return exponent;
}

// All products of p^j conj(p)^(e - j) over the primes, times the four units.
std::vector<Whole> whole_circle(const Exponents& exponent) {
  std::vector<Whole> all = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  for (std::size_t i = 0; i < kPrimes.size(); ++i) {
    if (exponent[i] == 0) continue;
    const Whole p = kPrimes[i], conjugate = {p.x, -p.y};
    std::vector<Whole> longer;
    longer.reserve(all.size() * static_cast<std::size_t>(exponent[i] + 1));
    for (int j = 0; j <= exponent[i]; ++j) {
      Whole factor = {1, 0};
      for (int k = 0; k < exponent[i]; ++k) factor = times(factor, k < j ? p : conjugate);
      for (const Whole& z : all) longer.push_back(times(z, factor));
    }
    all = std::move(longer);
  }
  return all;
}

// `count` random primitive vectors of the upper half plane (y > 0, or y = 0 and x > 0), by angle.
std::vector<Whole> edge_directions(std::size_t count, Random& random) {
  std::int64_t reach = 2;  // half of 2 reach^2 vectors are primitive, and more (6 / pi^2)
  while (static_cast<std::size_t>(reach * reach) < 2 * count) ++reach;
  std::vector<Whole> all = {{1, 0}};
  for (std::int64_t y = 1; y <= reach; ++y) {
    for (std::int64_t x = -reach; x <= reach; ++x) {
      if (std::gcd(x, y) == 1) all.push_back({x, y});
    }
  }
  shuffle(all, random);
  all.resize(std::min(count, all.size()));
  std::sort(all.begin(), all.end(),
            [](const Whole& a, const Whole& b) { return a.x * b.y - a.y * b.x > 0; });
  return all;
}

}  // namespace

// Exactly at the same distance from the origin, as many as doubles hold (995,328).
Points make_cocircular(std::size_t n, std::uint64_t seed) {
  Random random(seed);
  std::vector<Whole> all = whole_circle(circle_exponents(n));
  shuffle(all, random);
  all.resize(std::min(n, all.size()));
  Points points;
  points.reserve(all.size());
  for (const Whole& z : all) points.push_back(to_point(z));
  return points;
}

// A convex polygon without straight corners: different primitive vectors by angle as edges, then
// their opposites. For odd n one corner more, of which one is left out.
Points make_convex(std::size_t n, std::uint64_t seed) {
  Random random(seed);
  const std::vector<Whole> edges = edge_directions((n + 1) / 2, random);
  Points points;
  points.reserve(n + 1);
  Whole at = {0, 0};
  for (const std::int64_t sign : {1, -1}) {
    for (const Whole& e : edges) {
      points.push_back(to_point(at));
      at = {at.x + sign * e.x, at.y + sign * e.y};
    }
  }
  points.resize(n);
  shuffle(points, random);
  return points;
}

}  // namespace quadloom::generate
