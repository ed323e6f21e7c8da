// Strips: what is decoded is what was encoded.
#include "quadloom/strips.hpp"

#include <gtest/gtest.h>

#include <map>
#include <queue>
#include <set>
#include <string>

#include "core/random.hpp"
#include "quadloom/generate.hpp"
#include "strips/strip_writer.hpp"
#include "support/surfaces.hpp"

namespace quadloom {
namespace {

using strips::StripState;

constexpr std::array kEncodings = {StripEncoding::kSwap, StripEncoding::kRepeat,
                                   StripEncoding::kRestart};
constexpr std::array kEfforts = {PathEffort::kFast, PathEffort::kStandard, PathEffort::kThorough};

/// By the definition: every strip on its own, its triangles by their number.
std::vector<VertexId> decode_slowly(const StripCode& code) {
  std::vector<VertexId> out;
  std::vector<VertexId> strip;
  const auto end_strip = [&] {
    for (std::size_t i = 0; i + 2 < strip.size(); ++i) {
      VertexId a = strip[i], b = strip[i + 1];
      const VertexId c = strip[i + 2];
      if (a == b || b == c || c == a) continue;
      if (i % 2 == 1) std::swap(a, b);
      out.insert(out.end(), {a, b, c});
    }
    strip.clear();
  };
  for (std::size_t i = 0; i < code.index.size(); ++i) {
    if (code.encoding != StripEncoding::kRepeat && code.index[i] == kStripRestart) {
      end_strip();
      continue;
    }
    // A swap is what a vertex sent again does.
    if (!code.swap.empty() && code.swap[i] != 0 && strip.size() >= 2) {
      strip.push_back(strip[strip.size() - 2]);
    }
    strip.push_back(code.index[i]);
  }
  end_strip();
  return out;
}

void check_counts(const Triangulation& mesh, const StripResult& result) {
  EXPECT_EQ(result.triangles, mesh.triangle_count());
  const std::size_t size = result.code.index.size(), t = result.triangles, s = result.strips;
  EXPECT_LE(s, t);
  const auto restarts = static_cast<std::size_t>(
      std::count(result.code.index.begin(), result.code.index.end(), kStripRestart));
  EXPECT_EQ(restarts, result.restarts);
  switch (result.code.encoding) {
    case StripEncoding::kSwap:
      EXPECT_EQ(size, t + 2 * s + restarts);
      EXPECT_EQ(restarts, s == 0 ? 0 : s - 1);
      break;
    case StripEncoding::kRepeat:
      EXPECT_EQ(restarts, 0U);
      EXPECT_LE(size, t + 4 * s + result.swaps + 1);
      break;
    case StripEncoding::kRestart:
      EXPECT_LE(size, t + 4 * s + result.swaps);
      break;
  }
}

void expect_round_trips(const Triangulation& mesh) {
  for (const StripEncoding encoding : kEncodings) {
    for (const PathEffort effort : kEfforts) {
      SCOPED_TRACE(testing::Message() << "encoding " << static_cast<int>(encoding) << ", effort "
                                      << static_cast<int>(effort));
      StripOptions options;
      options.encoding = encoding;
      options.effort = effort;
      const StripResult result = encode_strips(mesh, options);
      ASSERT_EQ(result.code.encoding, encoding);
      const std::vector<VertexId> decoded = decode_strips(result.code);
      ASSERT_EQ(decoded, decode_slowly(result.code));
      ASSERT_TRUE(same_triangles(decoded, mesh.tri_vertex));
      check_counts(mesh, result);
      ASSERT_FALSE(testing::Test::HasFailure());
    }
  }
}

Triangulation of_surface(const PolygonMesh& mesh) {
  return triangles_with_twins(mesh.points, mesh.face_vertex);
}

TEST(Strips, PointsOfAllKinds) {
  for (const Generator& g : generators()) {
    for (const std::size_t n : {g.min_points, std::size_t{40}, std::size_t{1500}}) {
      SCOPED_TRACE(std::string(g.name) + " " + std::to_string(n) + ", seed 3");
      expect_round_trips(delaunay(generate_points(g.name, std::max(n, g.min_points), 3)).mesh);
      if (HasFailure()) return;
    }
  }
}

TEST(Strips, ManySmallMeshes) {
  for (std::uint64_t seed = 1; seed <= 120; ++seed) {
    SCOPED_TRACE("uniform, seed " + std::to_string(seed));
    expect_round_trips(delaunay(generate_points("uniform", 3 + seed % 40, seed)).mesh);
    if (HasFailure()) return;
  }
}

TEST(Strips, Surfaces) {
  expect_round_trips(of_surface(test::torus(12, 20, false).mesh));
  expect_round_trips(of_surface(test::sphere(0).mesh));
  expect_round_trips(of_surface(test::sphere(3).mesh));
  expect_round_trips(of_surface(test::cube(false).mesh));
  expect_round_trips(of_surface(test::moebius_strip(15).mesh));  // one edge without twins
  expect_round_trips(of_surface(test::height_field(30, 20, false, 5).mesh));
}

TEST(Strips, NoTriangleAndOneTriangle) {
  expect_round_trips(triangles_with_twins({}, {}));
  expect_round_trips(triangles_with_twins(std::vector<Point>(3), {2, 0, 1}));
  const StripResult one = encode_strips(triangles_with_twins(std::vector<Point>(3), {2, 0, 1}));
  EXPECT_EQ(one.code.index.size(), 3U);
}

TEST(Strips, BowTiesAndParts) {
  // Two triangles at a vertex, and two apart from them.
  expect_round_trips(
      triangles_with_twins(std::vector<Point>(11), {0, 1, 2, 0, 3, 4, 5, 6, 7, 8, 10, 9}));
  // The same triangle twice, and from the other side.
  expect_round_trips(triangles_with_twins(std::vector<Point>(4), {0, 1, 2, 1, 2, 0, 2, 1, 0}));
  expect_round_trips(triangles_with_twins(std::vector<Point>(4), {0, 1, 2, 2, 1, 0}));
}

TEST(Strips, SoupsOfTriangles) {
  for (std::uint64_t seed = 1; seed <= 120; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const std::uint64_t points = 3 + random.below(40);
    std::vector<VertexId> triangles;
    for (std::uint64_t t = random.below(100); t > 0; --t) {
      VertexId v[3] = {0, 0, 0};
      while (v[0] == v[1] || v[1] == v[2] || v[2] == v[0]) {
        for (VertexId& corner : v) corner = static_cast<VertexId>(random.below(points));
      }
      triangles.insert(triangles.end(), v, v + 3);
    }
    expect_round_trips(triangles_with_twins(std::vector<Point>(points), triangles));
    if (HasFailure()) return;
  }
}

TEST(Strips, FacesInRandomOrderAndDirection) {
  Random random(8);
  test::Surface surface = test::torus(40, 60, false);
  test::shuffle_faces(surface.mesh, random, 0.3);
  expect_round_trips(of_surface(surface.mesh));
}

TEST(Strips, TwinsAreTheOnlyTwoOppositeSides) {
  const Triangulation fan =
      triangles_with_twins(std::vector<Point>(5), {0, 1, 2, 1, 0, 3, 0, 1, 4});
  EXPECT_EQ(fan.twin, std::vector<HalfedgeId>(9, kNone));  // three at one edge
  const Triangulation same = triangles_with_twins(std::vector<Point>(4), {0, 1, 2, 0, 1, 3});
  EXPECT_EQ(same.twin, std::vector<HalfedgeId>(6, kNone));  // both on one side of it
  const Triangulation pair = triangles_with_twins(std::vector<Point>(4), {0, 1, 2, 1, 0, 3});
  EXPECT_EQ(pair.twin[0], 3U);
  EXPECT_EQ(pair.twin[3], 0U);
  const Triangulation mesh = delaunay(generate_points("uniform", 2000)).mesh;
  EXPECT_EQ(triangles_with_twins(mesh.points, mesh.tri_vertex).twin, mesh.twin);
}

TEST(Strips, BadTriangles) {
  const std::vector<Point> points(4);
  EXPECT_THROW(triangles_with_twins(points, {0, 1, 1}), Error);
  EXPECT_THROW(triangles_with_twins(points, {0, 1, 4}), Error);
  EXPECT_THROW(triangles_with_twins(points, {0, 1}), Error);
  Triangulation twice = triangles_with_twins(points, {0, 1, 2});
  twice.tri_vertex[1] = 0;
  EXPECT_THROW(encode_strips(twice), Error);
}

TEST(Strips, PathsThatAreNoPartition) {
  const Triangulation mesh = delaunay(generate_points("uniform", 30)).mesh;
  PathPartition paths = path_partition(dual_graph(mesh));
  EXPECT_NO_THROW(encode_paths(mesh, paths, StripEncoding::kRestart));
  paths.leave[1] = paths.leave[0];
  EXPECT_THROW(encode_paths(mesh, paths, StripEncoding::kRestart), Error);
}

// A grid's rows are strips: two triangles a square, no swaps.
TEST(Strips, AGrid) {
  const Triangulation mesh = delaunay(generate_points("grid", 900)).mesh;
  StripOptions options;
  options.effort = PathEffort::kFast;
  const StripResult result = encode_strips(mesh, options);
  EXPECT_EQ(result.strips, 29U);
  EXPECT_EQ(result.swaps, 0U);
  EXPECT_EQ(result.code.index.size(), 29U * (58 + 2) + 28);  // none begins odd
}

// ---- The decoder. ----

TEST(DecodeStrips, AnySequenceIsACode) {
  for (std::uint64_t seed = 1; seed <= 20000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    StripCode code;
    code.encoding = kEncodings[seed % 3];
    const std::uint64_t alphabet = 1 + random.below(6);
    for (std::uint64_t n = random.below(30); n > 0; --n) {
      code.index.push_back(random.below(8) == 0 ? kStripRestart
                                                : static_cast<VertexId>(random.below(alphabet)));
      if (code.encoding == StripEncoding::kSwap) code.swap.push_back(random.below(3) == 0);
    }
    ASSERT_EQ(decode_strips(code), decode_slowly(code));
  }
}

TEST(DecodeStrips, BitsMustFit) {
  EXPECT_THROW(decode_strips({StripEncoding::kSwap, {0, 1, 2}, {0, 0}}), Error);
  EXPECT_THROW(decode_strips({StripEncoding::kRepeat, {0, 1, 2}, {0, 0, 0}}), Error);
  EXPECT_EQ(decode_strips({StripEncoding::kRestart, {0, 1, 2}, {}}),
            (std::vector<VertexId>{0, 1, 2}));
}

TEST(DecodeStrips, SameTrianglesCanTellThemApart) {
  const std::vector<VertexId> some = {0, 1, 2, 3, 4, 5};
  EXPECT_TRUE(same_triangles(some, std::vector<VertexId>{5, 3, 4, 1, 2, 0}));
  EXPECT_FALSE(same_triangles(some, std::vector<VertexId>{5, 4, 3, 1, 2, 0}));
  EXPECT_FALSE(same_triangles(some, std::vector<VertexId>{0, 1, 2}));
  EXPECT_FALSE(same_triangles(some, std::vector<VertexId>{0, 1, 2, 0, 1, 2}));
}

// ---- Bridges. ----

/// The fewest empty triangles from one state to all others over a few vertices.
std::map<std::tuple<VertexId, VertexId, bool>, std::size_t> distances(StripState from,
                                                                      VertexId vertices) {
  std::map<std::tuple<VertexId, VertexId, bool>, std::size_t> distance;
  std::queue<StripState> queue;
  distance[{from.before, from.last, from.odd}] = 0;
  for (queue.push(from); !queue.empty(); queue.pop()) {
    const StripState s = queue.front();
    const std::size_t d = distance[{s.before, s.last, s.odd}];
    for (VertexId v = 0; v < vertices; ++v) {
      if (s.before != s.last && s.before != v && s.last != v) continue;  // not empty
      if (distance.emplace(std::tuple(s.last, v, !s.odd), d + 1).second) {
        queue.push({s.last, v, !s.odd});
      }
    }
  }
  return distance;
}

TEST(Strips, BridgesAreShortest) {
  constexpr VertexId kVertices = 6;
  for (const bool odd : {false, true}) {
    const StripState from{0, 1, odd};
    const auto distance = distances(from, kVertices);
    for (VertexId x = 0; x < kVertices; ++x) {
      for (VertexId y = 0; y < kVertices; ++y) {
        if (x == y) continue;
        for (const bool to_odd : {false, true}) {
          const StripState to{x, y, to_odd};
          const strips::Bridge way = strips::bridge(from, to, StripEncoding::kRepeat);
          EXPECT_EQ(way.size, distance.at({x, y, to_odd})) << x << " " << y << " " << to_odd;
          StripState s = from;
          for (const VertexId v : way.span()) {
            EXPECT_TRUE(s.before == s.last || s.before == v || s.last == v);
            s = strips::after(s, v);
          }
          EXPECT_EQ(s, to);
          const strips::Bridge restarted = strips::bridge(from, to, StripEncoding::kRestart);
          EXPECT_EQ(restarted.size, std::min<std::size_t>(way.size, to_odd ? 4 : 3));
        }
      }
    }
  }
}

}  // namespace
}  // namespace quadloom
