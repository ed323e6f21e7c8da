// Hamiltonian and sequential triangulations of polygons against brute force over all triangulations.
#include <gtest/gtest.h>

#include "quadloom/quadloom.hpp"
#include "support/all_triangulations.hpp"
#include "support/grid_polygons.hpp"
#include "support/small_polygons.hpp"

namespace quadloom {
namespace {

/// The triangles as a path, or none: in a tree of triangles there is one way at most to stand in a row.
std::vector<TriangleId> row_of(const Triangulation& mesh) {
  const auto degree = [&](TriangleId t) {
    return std::count_if(mesh.twin.begin() + 3 * t, mesh.twin.begin() + 3 * t + 3,
                         [](HalfedgeId h) { return h != kNone; });
  };
  TriangleId at = kNone;
  for (TriangleId t = 0; t < mesh.triangle_count(); ++t) {
    if (degree(t) == 3) return {};
    if (degree(t) < 2) at = t;
  }
  std::vector<TriangleId> row = {at};
  for (TriangleId before = kNone; row.size() < mesh.triangle_count();) {
    for (HalfedgeId h = 3 * at; h < 3 * at + 3; ++h) {
      if (mesh.twin[h] == kNone || triangle_of(mesh.twin[h]) == before) continue;
      before = at;
      at = triangle_of(mesh.twin[h]);
      row.push_back(at);
      break;
    }
  }
  return row;
}

struct Answers {
  bool path = false;
  bool sequential = false;
};

Answers by_brute_force(const std::vector<Point>& ring) {
  Answers out;
  test::for_all_triangulations(ring, [&](const Triangulation& mesh) {
    const std::vector<TriangleId> row = row_of(mesh);
    if (row.empty()) return;
    out.path = true;
    if (out.sequential) return;
    const PolygonMesh in_order = to_polygon_mesh(reorder_triangles(mesh, row));
    out.sequential = certify_order(in_order, OrderKind::kSequential).ok();
  });
  return out;
}

void expect_certified(const Polygon& polygon, const PolygonOrder& made, OrderKind kind) {
  EXPECT_EQ(made.order, kind);
  const PolygonMesh mesh = to_polygon_mesh(made.mesh);
  CertifyOptions triangles;
  triangles.corners = 3;
  triangles.steiner_at_most = 0;
  const Certificate tiling = certify_polygons(mesh, std::span(&polygon, 1), {}, triangles);
  EXPECT_TRUE(tiling.ok()) << tiling.sentence;
  const Certificate order = certify_order(mesh, kind);
  EXPECT_TRUE(order.ok()) << order.sentence;
  EXPECT_EQ(made.input_vertices, made.mesh.points.size());
  for (HalfedgeId h = 0; h < made.mesh.twin.size(); ++h) {
    const HalfedgeId twin = made.mesh.twin[h];
    if (twin == kNone) continue;
    EXPECT_EQ(made.mesh.origin(twin), made.mesh.target(h));
    EXPECT_EQ(made.mesh.twin[twin], h);
  }
}

/// Returns what brute force says.
Answers expect_agreement(const std::vector<Point>& ring) {
  const Answers wanted = by_brute_force(ring);
  const Polygon polygon{{ring}};
  const auto path = hamiltonian_triangulation(polygon);
  EXPECT_EQ(path.has_value(), wanted.path);
  if (path) expect_certified(polygon, *path, OrderKind::kPath);
  const auto sequential = sequential_triangulation(polygon);
  EXPECT_EQ(sequential.has_value(), wanted.sequential);
  if (sequential) expect_certified(polygon, *sequential, OrderKind::kSequential);
  return wanted;
}

struct Count {
  std::size_t polygons = 0, paths = 0, sequential = 0;
  void add(const Answers& a) {
    ++polygons;
    paths += a.path ? 1 : 0;
    sequential += a.sequential ? 1 : 0;
  }
};

TEST(PolygonOrder, AgreesWithBruteForceOnRandomPolygons) {
  const std::uint64_t seed = 101;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  Count count;
  for (int trial = 0; trial < 4000; ++trial) {
    const std::vector<Point> ring =
        test::random_ring(random, 4 + std::max(random.below(9), random.below(9)));
    SCOPED_TRACE(test::text_of(ring));
    count.add(expect_agreement(ring));
    if (HasFailure()) return;
  }
  EXPECT_GT(count.paths, count.polygons / 4);  // both answers are frequent
  EXPECT_LT(count.paths, count.polygons * 9 / 10);
  EXPECT_GT(count.sequential, count.polygons / 20);
  EXPECT_LT(count.sequential, count.paths);
}

TEST(PolygonOrder, AgreesWithBruteForceOnRandomPolygonsOfGrids) {
  const std::uint64_t seed = 102;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  Count count;
  for (int trial = 0; trial < 4000; ++trial) {
    const int width = 4 + static_cast<int>(random.below(2));
    const std::vector<Point> ring = test::random_grid_ring(random, 4 + random.below(9), width);
    if (ring.empty()) continue;
    SCOPED_TRACE(test::text_of(ring));
    count.add(expect_agreement(ring));
    if (HasFailure()) return;
  }
  EXPECT_GT(count.polygons, 2000U);
  EXPECT_GT(count.paths, count.polygons / 4);
  EXPECT_LT(count.paths, count.polygons);
  EXPECT_GT(count.sequential, count.polygons / 20);
}

template <std::size_t N>
std::size_t expect_agreement_on_grid(int width) {
  std::size_t polygons = 0;
  testing::for_each_grid_polygon<N>(width, [&](const std::array<Point, N>& corners) {
    if (::testing::Test::HasFailure()) return;
    const std::vector<Point> ring(corners.begin(), corners.end());
    SCOPED_TRACE(test::text_of(ring));
    expect_agreement(ring);
    ++polygons;
  });
  return polygons;
}

TEST(PolygonOrder, AgreesWithBruteForceOnAllPolygonsOfSmallGrids) {
  EXPECT_GT(expect_agreement_on_grid<5>(3), 100U);
  EXPECT_GT(expect_agreement_on_grid<6>(3), 200U);
  EXPECT_GT(expect_agreement_on_grid<7>(3), 100U);
  EXPECT_GT(expect_agreement_on_grid<8>(3), 50U);
  EXPECT_GT(expect_agreement_on_grid<5>(4), 5000U);
}

// Figure 3 of the paper: monotone, star-shaped, one triangulation, and that is not a path.
TEST(PolygonOrder, NoneForThePapersMonotoneStar) {
  const std::vector<Point> ring = {{-9, -4}, {-4, -2}, {5, -5}, {2, -1}, {1, 5}, {0, 2}};
  std::size_t turns = 0;
  for (std::size_t i = 0; i < 6; ++i) {
    const Point a = ring[i], b = ring[(i + 1) % 6], c = ring[(i + 2) % 6];
    EXPECT_GT(orient2d(a, b, {0, 0}), 0);  // star-shaped
    turns += (a.x < b.x) != (b.x < c.x) ? 1 : 0;
  }
  EXPECT_EQ(turns, 2U);  // monotone
  std::size_t triangulations = 0;
  test::for_all_triangulations(ring, [&](const Triangulation&) { ++triangulations; });
  EXPECT_EQ(triangulations, 1U);
  const Answers none = expect_agreement(ring);
  EXPECT_FALSE(none.path);
}

/// Rectangular teeth on a bar.
std::vector<Point> rectilinear_comb(int teeth) {
  std::vector<Point> ring = {{0, 0}, {4.0 * teeth, 0}, {4.0 * teeth, 1}};
  for (int i = teeth; i-- > 0;) {
    for (const Point p : {Point{3, 1}, {3, 9}, {1, 9}, {1, 1}})
      ring.push_back({4.0 * i + p.x, p.y});
  }
  ring.push_back({0, 1});
  return ring;
}

TEST(PolygonOrder, NoneForCombs) {
  for (int teeth = 1; teeth < 4; ++teeth) {
    EXPECT_FALSE(hamiltonian_triangulation(Polygon{{rectilinear_comb(teeth)}})) << teeth;
  }
  const Answers none = expect_agreement(rectilinear_comb(2));
  EXPECT_FALSE(none.path);
  EXPECT_FALSE(hamiltonian_triangulation(generate_polygon("comb", 302)));
}

TEST(PolygonOrder, PathOfALongSpiral) {
  const Polygon spiral = generate_polygon("spiral", 400);
  const auto path = hamiltonian_triangulation(spiral);
  ASSERT_TRUE(path.has_value());
  expect_certified(spiral, *path, OrderKind::kPath);
}

TEST(PolygonOrder, ConvexPolygonsHavePathsWithFlatCornersToo) {
  for (int corners = 0; corners < 3; ++corners) {
    for (const double sides : {3.0, 4.0}) {
      Polygon polygon;
      auto& ring = polygon.rings.emplace_back();
      const std::vector<Point> at = {{0, 0}, {12, 0}, {12, 12}, {0, 12}};
      for (std::size_t i = 0; i < static_cast<std::size_t>(sides); ++i) {
        const Point a = at[i], b = at[(i + 1) % static_cast<std::size_t>(sides)];
        for (int k = 0; k <= corners; ++k) {
          const double f = static_cast<double>(k) / (corners + 1);
          ring.push_back({a.x + f * (b.x - a.x), a.y + f * (b.y - a.y)});
        }
      }
      const auto path = hamiltonian_triangulation(polygon);
      ASSERT_TRUE(path.has_value()) << corners << ' ' << sides;
      expect_certified(polygon, *path, OrderKind::kPath);
    }
  }
  Polygon parabola;
  for (int i = 0; i < 30000; ++i) {
    parabola.rings.resize(1);
    parabola.rings[0].push_back({static_cast<double>(i), static_cast<double>(i) * i});
  }
  const auto path = hamiltonian_triangulation(parabola);
  ASSERT_TRUE(path.has_value());
  expect_certified(parabola, *path, OrderKind::kPath);
}

TEST(PolygonOrder, RingsThatTouchThemselves) {
  // A hole that hangs on the outer ring by a corner, as one ring and as two: the inside is a disc.
  const Polygon one{{{{0, 0}, {9, 0}, {9, 9}, {0, 9}, {0, 0}, {3, 6}, {6, 6}, {6, 3}}}};
  const Polygon two{{{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {{0, 0}, {6, 3}, {6, 6}, {3, 6}}}};
  for (const Polygon& polygon : {one, two}) {
    const auto path = hamiltonian_triangulation(polygon);
    ASSERT_TRUE(path.has_value());
    expect_certified(polygon, *path, OrderKind::kPath);
    EXPECT_EQ(path->mesh.triangle_count(), 6U);
    EXPECT_EQ(path->input_vertices, 7U);
  }
  // Two triangles at a corner; a square in a square; a corner on another side.
  const Polygon bow{{{{0, 0}, {4, 0}, {2, 2}, {4, 4}, {0, 4}, {2, 2}}}};
  const Polygon frame{{{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {{3, 3}, {6, 3}, {6, 6}, {3, 6}}}};
  for (const Polygon& polygon : {bow, frame}) {
    for (const bool sequential : {false, true}) {
      try {
        sequential ? sequential_triangulation(polygon) : hamiltonian_triangulation(polygon);
        ADD_FAILURE() << "an error was expected";
      } catch (const Error& e) {
        EXPECT_EQ(e.code(), ErrorCode::kBadPolygon);
      }
    }
  }
}

TEST(PolygonOrder, InputIsNumberedAsGiven) {
  const Polygon polygon{{{{4, 0}, {0, 0}, {0, 4}, {4, 4}, {4, 4}, {4, 0}}}};  // clockwise, repeated
  for (const auto& made : {hamiltonian_triangulation(polygon), sequential_triangulation(polygon)}) {
    ASSERT_TRUE(made.has_value());
    EXPECT_EQ(made->input_to_vertex, (std::vector<VertexId>{0, 1, 2, 3, 3, 0}));
    EXPECT_EQ(made->mesh.triangle_count(), 2U);
  }
}

}  // namespace
}  // namespace quadloom
