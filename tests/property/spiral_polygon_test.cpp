// Spiral polygons: every generator, against the paper's quadratic procedure; the certificate's mutations.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/random.hpp"
#include "quadloom/generate.hpp"
#include "strips/shrinking_hull.hpp"
#include "support/bad_points.hpp"
#include "support/grid_points.hpp"
#include "support/spiral_polygon_checks.hpp"

namespace quadloom {
namespace {

using testing::expect_paper_procedure;
using testing::expect_spiral_polygon;
using testing::ring_points;

TEST(SpiralPolygon, EveryGenerator) {
  for (const Generator& generator : generators()) {
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
      const std::size_t n = generator.min_points + Random(seed).below(seed % 6 == 0 ? 800 : 80);
      SCOPED_TRACE(::testing::Message() << generator.name << ", n = " << n << ", seed " << seed);
      const std::vector<Point> input = generator.make(n, seed);
      const SpiralPolygon spiral = spiral_polygon(input);
      expect_spiral_polygon(input, spiral);
      expect_paper_procedure(spiral.mesh.points, spiral);
      if (HasFatalFailure()) return;
    }
  }
}

TEST(SpiralPolygon, RandomSubsetsOfSmallGrids) {
  for (std::uint64_t seed = 1; seed <= 4000; ++seed) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed);
    Random random(seed);
    const auto points = testing::random_grid_points(random, 3 + random.below(50),
                                                    2 + random.below(9), 2 + random.below(9));
    if (points.size() < 3 || testing::all_collinear(points)) continue;
    const SpiralPolygon spiral = spiral_polygon(points);
    expect_spiral_polygon(points, spiral);
    expect_paper_procedure(points, spiral);
    if (HasFatalFailure()) return;
  }
}

TEST(SpiralPolygon, ManyPoints) {
  for (const char* kind : {"uniform", "grid", "lines", "circles", "cross", "convex"}) {
    SCOPED_TRACE(kind);
    const std::vector<Point> points = generate_points(kind, 30'000, 9);
    expect_spiral_polygon(points, spiral_polygon(points));
    if (HasFatalFailure()) return;
  }
}

TEST(SpiralPolygon, ExactMapsKeepThePromise) {
  Point (*const maps[])(Point) = {
      [](Point p) {
        return Point{-p.y, p.x};
      },
      [](Point p) {
        return Point{-p.x, p.y};
      },
      [](Point p) {
        return Point{std::ldexp(p.x, -1000), std::ldexp(p.y, 600)};
      },
      [](Point p) {
        return Point{std::ldexp(p.x, 900), std::ldexp(p.y, 900)};
      },
  };
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    for (const char* kind : {"uniform", "grid", "lines", "bhrs-ring"}) {
      SCOPED_TRACE(::testing::Message() << kind << ", seed " << seed);
      const std::vector<Point> points = generate_points(kind, 12 + seed, seed);
      for (const auto map : maps) {
        std::vector<Point> mapped = points;
        std::transform(points.begin(), points.end(), mapped.begin(), map);
        const SpiralPolygon spiral = spiral_polygon(mapped);
        expect_spiral_polygon(mapped, spiral);
        expect_paper_procedure(spiral.mesh.points, spiral);
        if (HasFatalFailure()) return;
      }
    }
  }
}

TEST(SpiralPolygon, DoesNotDependOnTheOrderOfTheInput) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed);
    Random random(seed);
    auto points = testing::random_grid_points(random, 40, 9, 9);
    const std::vector<Point> ring = ring_points(spiral_polygon(points));
    for (std::size_t i = points.size(); i > 1; --i) {
      std::swap(points[i - 1], points[random.below(i)]);
    }
    ASSERT_EQ(ring_points(spiral_polygon(points)), ring);
  }
}

TEST(SpiralPolygon, ThePaperStopsAtPointsInsideTheFirstHullEdge) {
  const std::vector<Point> points = {{0, 0}, {2, 0}, {0, 1}, {1, 1}, {0, 2}};
  EXPECT_TRUE(testing::literal_spiral_polygon(points).stuck);
  const SpiralPolygon spiral = spiral_polygon(points);
  expect_spiral_polygon(points, spiral);
  EXPECT_EQ(spiral.ring, (std::vector<VertexId>{1, 3, 4, 2, 0}));
}

TEST(SpiralPolygon, TheNextPointCanBeTwoLayersAway) {
  // Lemma 2.6 says one. No three of these are on a line.
  const std::vector<Point> points = {{11, 10}, {18, 23}, {14, 18}, {8, 4},   {6, 1}, {16, 21},
                                     {12, 27}, {14, 23}, {20, 18}, {27, 29}, {6, 27}};
  for (std::size_t a = 0; a < points.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      for (std::size_t c = 0; c < b; ++c) ASSERT_NE(orient2d(points[a], points[b], points[c]), 0);
    }
  }
  EXPECT_EQ(testing::literal_spiral_polygon(points).most_layers_between, 2U);
  const SpiralPolygon spiral = spiral_polygon(points);
  expect_spiral_polygon(points, spiral);
  expect_paper_procedure(points, spiral);
}

TEST(SpiralPolygon, BadInputIsRefusedAndDuplicatesAreMerged) {
  testing::expect_bad_points_refused(
      [](const std::vector<Point>& points) { spiral_polygon(points); });
  const std::vector<Point> repeated = {{0, 0}, {3, 0}, {0, 0}, {0, 3}, {1, 1}, {3, 0}};
  const SpiralPolygon spiral = spiral_polygon(repeated);
  expect_spiral_polygon(repeated, spiral);
  EXPECT_EQ(spiral.input_to_vertex, (std::vector<VertexId>{0, 1, 0, 2, 3, 1}));
}

TEST(ShrinkingHull, IsTheHullOfWhatIsLeft) {
  for (std::uint64_t seed = 1; seed <= 1500; ++seed) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed);
    Random random(seed);
    auto points = seed % 3 == 0
                      ? testing::uniform_points(random, 1 + random.below(40))
                      : testing::random_grid_points(random, 1 + random.below(40),
                                                    1 + random.below(8), 1 + random.below(8));
    std::sort(points.begin(), points.end(), lex_less);
    strips::ShrinkingHull hull(points);
    std::vector<Point> left = points;
    while (!hull.empty()) {
      ASSERT_EQ(points[hull.least()], left.front());
      ASSERT_EQ(points[hull.greatest()], left.back());
      ASSERT_EQ(hull.straight(), left.size() < 3 || testing::all_collinear(left));
      strips::ShrinkingHull::Spot gone{hull.least(), kernel::HullSide::kLower};
      Point after{};
      if (!hull.straight()) {
        const std::vector<VertexId> expected = convex_hull(left);
        auto spot = gone;
        for (const VertexId v : expected) {
          ASSERT_EQ(points[spot.point], left[v]);
          const auto next = hull.after(spot);
          ASSERT_EQ(hull.before(next).point, spot.point);
          spot = next;
        }
        ASSERT_EQ(spot.point, gone.point);
        for (std::uint64_t i = random.below(expected.size()); i > 0; --i) gone = hull.after(gone);
        after = points[hull.after(gone).point];
      } else if (random.below(2) == 0) {
        gone.point = hull.greatest();
      }
      left.erase(std::find(left.begin(), left.end(), points[gone.point]));
      const bool ring = !hull.straight();
      const auto next = hull.erase(gone);
      if (ring) {
        ASSERT_EQ(points[next.point], after);
      }
    }
    ASSERT_TRUE(left.empty());
  }
}

// ---- The certificate can fail. ----

/// A spiral polygon of random points and random choices in it.
struct Subject {
  explicit Subject(std::uint64_t seed) : random(seed) {
    points = testing::uniform_points(random, 12 + random.below(80));
    ring = ring_points(spiral_polygon(points));
  }
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(random.below(n)); }
  std::size_t any() { return below(ring.size()); }

  Random random;
  std::vector<Point> points, ring;
};

template <class Damage>
void expect_caught(Damage damage, std::vector<Fault> faults) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed);
    Subject s(seed);
    ASSERT_TRUE(certify_spiral_polygon(s.ring, s.points).ok());
    damage(s);
    const Certificate verdict = certify_spiral_polygon(s.ring, s.points);
    ASSERT_TRUE(std::count(faults.begin(), faults.end(), verdict.fault) > 0)
        << static_cast<int>(verdict.fault) << ' ' << verdict.sentence;
    ASSERT_FALSE(verdict.sentence.empty());
  }
}

TEST(CertifySpiral, ACornerLeftOut) {
  const auto damage = [](Subject& s) {
    const auto i = static_cast<std::ptrdiff_t>(s.any());
    s.ring.erase(s.ring.begin() + i);
  };
  expect_caught(damage, {Fault::kMissingPoint, Fault::kNotSimple});
}

TEST(CertifySpiral, ACornerTwice) {
  expect_caught([](Subject& s) { s.ring.push_back(s.ring[s.any()]); }, {Fault::kNotSimple});
}

TEST(CertifySpiral, ACornerTooMany) {
  // Outside the hull's edge from the lowest corner to the next.
  const auto damage = [](Subject& s) {
    const Point a = s.ring[0], b = s.ring[1];
    s.ring.insert(s.ring.begin() + 1,
                  Point{(a.x + b.x) / 2 + (b.y - a.y) / 8, (a.y + b.y) / 2 - (b.x - a.x) / 8});
  };
  expect_caught(damage, {Fault::kTooManySteiner});
}

TEST(CertifySpiral, Clockwise) {
  expect_caught([](Subject& s) { std::reverse(s.ring.begin(), s.ring.end()); },
                {Fault::kNotSimple});
}

TEST(CertifySpiral, TwoCornersSwapped) {
  const auto damage = [](Subject& s) {
    const std::size_t i = s.any();
    std::swap(s.ring[i], s.ring[(i + 2 + s.below(s.ring.size() - 4)) % s.ring.size()]);
  };
  expect_caught(damage, {Fault::kNotSimple, Fault::kReflexChains});
}

TEST(CertifySpiral, NotFinite) {
  expect_caught([](Subject& s) { s.ring[s.any()].x = std::nan(""); }, {Fault::kNotFinite});
}

TEST(CertifySpiral, TwoReflexChains) {
  //  o-------------o
  //  |  o       o  |      each of the two dents is a chain
  //  |_/ \_____/ \_|  (one corner in)
  const std::vector<Point> ring = {{0, 0}, {1, 1}, {2, 0}, {4, 0}, {5, 1}, {6, 0}, {6, 3}, {0, 3}};
  const Certificate two = certify_spiral_polygon(ring, ring);
  EXPECT_EQ(two.fault, Fault::kReflexChains);
  EXPECT_EQ(two.culprits, (std::vector<std::size_t>{1, 4}));
  std::vector<Point> one = ring;
  one[4] = {5, 0};
  EXPECT_TRUE(certify_spiral_polygon(one, one).ok());
  // Flat corners part nothing: the reflex corners 1 and 3 are one chain.
  const std::vector<Point> flat = {{0, 0}, {1, 2}, {2, 2}, {3, 2}, {4, 0}, {4, 4}, {0, 4}};
  const Certificate verdict = certify_spiral_polygon(flat, flat);
  EXPECT_TRUE(verdict.ok()) << verdict.sentence;
  EXPECT_EQ(verdict.non_convex, 2U);
  EXPECT_EQ(verdict.flat_cornered, 1U);
  EXPECT_EQ(verdict.strictly_convex, 4U);
  EXPECT_EQ(verdict.boundary, 7U);
  EXPECT_EQ(verdict.points, 7U);
}

TEST(CertifySpiral, ReflexCornersAroundTheRingsEnds) {
  std::vector<Point> ring = {{1, 2}, {2, 2}, {3, 2}, {4, 0}, {4, 4}, {0, 4}, {0, 0}};
  for (std::size_t i = 0; i < ring.size(); ++i) {
    EXPECT_TRUE(certify_spiral_polygon(ring, ring).ok());
    std::rotate(ring.begin(), ring.begin() + 1, ring.end());
  }
}

TEST(CertifySpiral, TooFewCornersAndTouchingRings) {
  const std::vector<Point> two = {{0, 0}, {1, 0}};
  EXPECT_EQ(certify_spiral_polygon(two, two).fault, Fault::kCornerCount);
  // The corner (1, 0) lies on an edge.
  const std::vector<Point> touching = {{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, 2}};
  EXPECT_EQ(certify_spiral_polygon(touching, touching).fault, Fault::kNotSimple);
}

}  // namespace
}  // namespace quadloom
