// What corners of polygons see of each other, against definitions.
#include "strips/visibility.hpp"

#include <gtest/gtest.h>

#include "support/small_polygons.hpp"

namespace quadloom {
namespace {

using strips::Position;
using strips::Seen;
using strips::Sight;

class Definition {
 public:
  explicit Definition(std::vector<Point> ring) : ring_(std::move(ring)) {}

  std::size_t size() const { return ring_.size(); }

  /// What i sees of j, if anything.
  std::optional<Sight> sight(std::size_t i, std::size_t j) const {
    std::vector<std::size_t> on = {i, j};
    for (std::size_t v = 0; v < size(); ++v) {
      if (v != i && v != j && between(ring_[i], ring_[v], ring_[j])) on.push_back(v);
    }
    std::sort(on.begin() + 1, on.end(),
              [&](std::size_t v, std::size_t w) { return between(ring_[i], ring_[v], ring_[w]); });
    bool before = false, after = false;
    for (std::size_t k = 1; k < on.size(); ++k) {
      if (!side(on[k - 1], on[k]) && !chord(on[k - 1], on[k])) return std::nullopt;
      if (on[k] == j) break;
      ((on[k] + size() - i) % size() < (j + size() - i) % size() ? before : after) = true;
    }
    if (before && after) return std::nullopt;
    if (before) return Sight::kPastBefore;
    return after ? Sight::kPastAfter : Sight::kChord;
  }

 private:
  static bool between(Point a, Point p, Point b) {
    return p != a && p != b && orient2d(a, b, p) == 0 && dot_sign(p, a, p, b) < 0;
  }
  std::size_t next(std::size_t v) const { return (v + 1) % size(); }
  bool side(std::size_t v, std::size_t w) const { return next(v) == w || next(w) == v; }

  /// No corner is on the open segment: it is inside if it crosses no side and starts inward.
  bool chord(std::size_t v, std::size_t w) const {
    const Point p = ring_[v], q = ring_[w];
    for (std::size_t a = 0; a < size(); ++a) {
      const Point r = ring_[a], s = ring_[next(a)];
      if (orient2d(p, q, r) * orient2d(p, q, s) < 0 && orient2d(r, s, p) * orient2d(r, s, q) < 0) {
        return false;
      }
    }
    const Point out = ring_[next(v)], in = ring_[(v + size() - 1) % size()];
    const bool left = orient2d(p, out, q) > 0, right = orient2d(in, p, q) > 0;
    return orient2d(in, p, out) > 0 ? left && right : left || right;
  }

  std::vector<Point> ring_;
};

void expect_as_defined(const std::vector<Point>& ring) {
  const strips::PolygonDisc disc = strips::polygon_disc(Polygon{{ring}});
  ASSERT_EQ(disc.size(), ring.size());
  std::vector<Point> around;
  for (Position i = 0; i < disc.size(); ++i) around.push_back(disc.at(i));
  const Definition definition(around);
  strips::Visibility visibility(disc);
  for (Position i = 0; i < disc.size(); ++i) {
    std::vector<std::pair<Position, Sight>> wanted, found;
    for (Position length = 2; length + 1 < disc.size(); ++length) {
      const Position j = (i + length) % disc.size();
      if (const auto sight = definition.sight(i, j)) wanted.emplace_back(j, *sight);
    }
    for (const Seen& seen : visibility.look_from(i)) found.emplace_back(seen.position, seen.sight);
    ASSERT_EQ(found, wanted) << "from corner " << i;
  }
}

TEST(Visibility, IsAsDefinedForRandomPolygons) {
  const std::uint64_t seed = 111;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  for (int trial = 0; trial < 600 && !HasFailure(); ++trial) {
    SCOPED_TRACE("trial " + std::to_string(trial));
    expect_as_defined(test::random_ring(random, 4 + random.below(40)));
  }
}

TEST(Visibility, IsAsDefinedForPolygonsOfGrids) {
  const std::uint64_t seed = 112;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  std::size_t polygons = 0;
  for (int trial = 0; trial < 6000 && !HasFailure(); ++trial) {
    SCOPED_TRACE("trial " + std::to_string(trial));
    const int width = 3 + static_cast<int>(random.below(4));
    const std::uint64_t most = static_cast<std::uint64_t>(width * width) - 1;
    const auto ring = test::random_grid_ring(
        random, 4 + random.below(std::min<std::uint64_t>(most, 18) - 3), width);
    if (ring.empty()) continue;
    expect_as_defined(ring);
    ++polygons;
  }
  EXPECT_GT(polygons, 1500U);
}

TEST(Visibility, GraphHasEachChordFromBothEnds) {
  Random random(113);
  const strips::PolygonDisc disc = strips::polygon_disc(Polygon{{test::random_ring(random, 60)}});
  const strips::VisibilityGraph graph = strips::visibility_graph(disc);
  const auto chords_of = [&](Position i) {
    return std::vector<Position>(
        graph.other.begin() + static_cast<std::ptrdiff_t>(graph.begin[i]),
        graph.other.begin() + static_cast<std::ptrdiff_t>(graph.begin[i + 1]));
  };
  std::size_t pairs = 0;
  for (Position i = 0; i < disc.size(); ++i) {
    for (const Position j : chords_of(i)) {
      const auto back = chords_of(j);
      EXPECT_EQ(std::count(back.begin(), back.end(), i), 1);
      ++pairs;
    }
  }
  EXPECT_GE(pairs, 2 * (std::size_t{disc.size()} - 3));  // those of a triangulation at least
}

}  // namespace
}  // namespace quadloom
