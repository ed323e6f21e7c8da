// Paths and cycles of triangles in polygons with added points.
#include <gtest/gtest.h>

#include "quadloom/quadloom.hpp"
#include "support/small_polygons.hpp"

namespace quadloom {
namespace {

/// What the flat corners of the parts allow.
struct Costs {
  bool cycle_root = false;  // some common side has a point that sees both parts
  bool path_root = false;   // some common side starts a path in both parts
};

Costs costs_of(const PolygonMesh& parts) {
  Costs out;
  const auto ends = [&](std::span<const VertexId> part, std::size_t i) {
    const auto at = [&](std::size_t k) { return parts.points[part[k % part.size()]]; };
    const std::size_t n = part.size();
    return std::array{orient2d(at(i + n - 1), at(i), at(i + 1)) == 0,
                      orient2d(at(i), at(i + 1), at(i + 2)) == 0};
  };
  for (std::size_t f = 0; f < parts.face_count(); ++f) {
    for (std::size_t g = 0; g < f; ++g) {
      const auto a = parts.face(f), b = parts.face(g);
      for (std::size_t i = 0; i < a.size(); ++i) {
        for (std::size_t j = 0; j < b.size(); ++j) {
          if (a[i] != b[(j + 1) % b.size()] || b[j] != a[(i + 1) % a.size()]) continue;
          const auto flat_a = ends(a, i), flat_b = ends(b, j);
          if (!((flat_a[0] || flat_a[1]) && (flat_b[0] || flat_b[1]))) out.cycle_root = true;
          if (!(flat_a[0] && flat_a[1]) && !(flat_b[0] && flat_b[1])) out.path_root = true;
        }
      }
    }
  }
  return out;
}

std::size_t points_of_theorem(const PolygonMesh& parts, OrderKind order) {
  const std::size_t k = parts.face_count();
  const Costs costs = costs_of(parts);
  if (order == OrderKind::kCycle) return k == 1 || !costs.cycle_root ? k : k - 1;
  if (k == 1) return 0;
  return costs.path_root ? k - 2 : k - 1;
}

void expect_certified(const Polygon& polygon, const PolygonOrder& made, OrderKind order) {
  EXPECT_EQ(made.order, order);
  const PolygonMesh mesh = to_polygon_mesh(made.mesh);
  CertifyOptions options;
  options.corners = 3;
  options.steiner_inside = true;
  const Certificate tiling = certify_polygons(mesh, std::span(&polygon, 1), {}, options);
  ASSERT_TRUE(tiling.ok()) << tiling.sentence;
  EXPECT_EQ(tiling.steiner, made.steiner.size());
  const Certificate row = certify_order(mesh, order);
  EXPECT_TRUE(row.ok()) << row.sentence;
  EXPECT_EQ(made.input_vertices + made.steiner.size(), made.mesh.points.size());
  for (const SteinerPoint& s : made.steiner) {
    const auto at = [&](std::size_t i) { return made.mesh.points[s.parents[i]]; };
    EXPECT_NE(orient2d(at(0), at(1), at(2)), 0);
  }
}

void expect_theorem(const Polygon& polygon, const DecompositionOptions& options = {}) {
  const ConvexDecomposition decomposition = convex_decomposition(polygon, options);
  for (const OrderKind order : {OrderKind::kPath, OrderKind::kCycle}) {
    SCOPED_TRACE(order == OrderKind::kPath ? "path" : "cycle");
    const PolygonOrder made = hamiltonian_triangulation_with_points(polygon, order, options);
    expect_certified(polygon, made, order);
    EXPECT_LE(made.steiner.size(), points_of_theorem(decomposition.parts, order));
    EXPECT_EQ(made.parts, decomposition.parts.face_count());
    EXPECT_EQ(made.parts_at_least, decomposition.at_least);
  }
}

TEST(PolygonWithPoints, RandomPolygons) {
  const std::uint64_t seed = 131;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  for (int trial = 0; trial < 1500 && !HasFailure(); ++trial) {
    const std::vector<Point> ring = test::random_ring(random, 4 + random.below(40));
    SCOPED_TRACE(test::text_of(ring));
    expect_theorem(Polygon{{ring}});
  }
}

TEST(PolygonWithPoints, PolygonsOfGrids) {
  const std::uint64_t seed = 132;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  std::size_t polygons = 0;
  for (int trial = 0; trial < 6000 && !HasFailure(); ++trial) {
    const int width = 3 + static_cast<int>(random.below(4));
    const std::uint64_t most =
        std::min<std::uint64_t>(static_cast<std::uint64_t>(width * width), 19);
    const auto ring = test::random_grid_ring(random, 4 + random.below(most - 4), width);
    if (ring.empty()) continue;
    SCOPED_TRACE(test::text_of(ring));
    expect_theorem(Polygon{{ring}});
    ++polygons;
  }
  EXPECT_GT(polygons, 2000U);
}

TEST(PolygonWithPoints, BigPolygonsWithHolesToo) {
  for (const auto& generator : polygon_generators()) {
    SCOPED_TRACE(generator.name);
    const Polygon polygon = generator.make(300, 5);
    expect_theorem(polygon);
    DecompositionOptions merging;
    merging.exact_steps = 0;
    expect_theorem(polygon, merging);
    expect_theorem(with_holes(polygon, 12, 3));
  }
}

// Figure 7 of the paper: a comb with teeth at both ends. A path needs k - 2 points, a cycle k - 1.
TEST(PolygonWithPoints, TheBoundsForThePapersComb) {
  for (int teeth = 2; teeth < 9; ++teeth) {
    std::vector<Point> ring = {{0, 0}, {4.0 * teeth - 2, 0}};
    for (int i = teeth; i-- > 0;) {
      ring.push_back({4.0 * i + 2, 9});
      ring.push_back({4.0 * i, 9});
      if (i > 0) ring.insert(ring.end(), {{4.0 * i, 1}, {4.0 * i - 2, 1}});
    }
    const Polygon comb{{ring}};
    const auto k = static_cast<std::size_t>(teeth + 1);
    const PolygonOrder path = hamiltonian_triangulation_with_points(comb, OrderKind::kPath);
    const PolygonOrder cycle = hamiltonian_triangulation_with_points(comb, OrderKind::kCycle);
    EXPECT_EQ(path.parts, k);
    EXPECT_EQ(path.steiner.size(), k - 2);
    EXPECT_EQ(cycle.steiner.size(), k - 1);
    expect_theorem(comb);
    EXPECT_EQ(hamiltonian_triangulation(comb).has_value(), teeth == 2);
  }
}

TEST(PolygonWithPoints, PointsThatSeeSeveralPartsSaveSome) {
  for (const char* kind : {"star", "two-opt"}) {
    const Polygon polygon = generate_polygon(kind, 500, 2);
    for (const OrderKind order : {OrderKind::kPath, OrderKind::kCycle}) {
      const PolygonOrder made = hamiltonian_triangulation_with_points(polygon, order);
      EXPECT_LT(made.steiner.size(), made.parts * 6 / 10) << kind;
    }
  }
  // All of a star polygon that is seen from its middle.
  const Polygon star{{{{0, 9}, {-1, 1}, {-9, 0}, {-1, -1}, {0, -9}, {1, -1}, {9, 0}, {1, 1}}}};
  EXPECT_EQ(hamiltonian_triangulation_with_points(star, OrderKind::kCycle).steiner.size(), 1U);
}

TEST(PolygonWithPoints, FlatCornersCostAPointWhereTheyMust) {
  // Two shifted rectangles: no point sees all. A T: it has no path of triangles at all.
  const Polygon shifted{{{{0, 0}, {2, 0}, {2, 1}, {3, 1}, {3, 2}, {1, 2}, {1, 1}, {0, 1}}}};
  const Polygon tee{{{{0, 0}, {3, 0}, {3, 1}, {2, 1}, {2, 5}, {1, 5}, {1, 1}, {0, 1}}}};
  const auto points = [](const Polygon& polygon, OrderKind order) {
    const PolygonOrder made = hamiltonian_triangulation_with_points(polygon, order);
    EXPECT_EQ(made.parts, 2U);
    return made.steiner.size();
  };
  EXPECT_EQ(points(shifted, OrderKind::kCycle), 2U);
  EXPECT_EQ(points(shifted, OrderKind::kPath), 0U);
  EXPECT_EQ(points(tee, OrderKind::kCycle), 1U);
  EXPECT_EQ(points(tee, OrderKind::kPath), 1U);
  EXPECT_FALSE(hamiltonian_triangulation(tee).has_value());
  expect_theorem(shifted);
  expect_theorem(tee);
}

TEST(PolygonWithPoints, ScaledByPowersOfTwoToTheEndsOfTheRange) {
  const std::uint64_t seed = 133;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  for (const double scale : {0x1p-1000, 0x1p-500, 0x1p500, 0x1p990}) {
    for (int trial = 0; trial < 20 && !HasFailure(); ++trial) {
      std::vector<Point> ring = test::random_ring(random, 12);
      for (Point& p : ring) p = {p.x * scale, p.y * scale};
      expect_theorem(Polygon{{ring}});
    }
  }
}

TEST(PolygonWithPoints, NarrowPlacesAreFoundAmongTheDoubles) {
  // Corridors a few doubles wide.
  for (const double width : {0x1p-40, 0x1p-46, 0x1p-48}) {
    const Polygon bent{
        {{{1, 1}, {9, 1}, {9, 8}, {9 - width, 8}, {9 - width, 1 + width}, {1, 1 + width}}}};
    expect_theorem(bent);
  }
}

TEST(PolygonWithPoints, AmongNeighbouringDoublesAPlaceOrAnError) {
  const std::uint64_t seed = 134;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  std::size_t made = 0, refused = 0;
  for (int trial = 0; trial < 1500 && !HasFailure(); ++trial) {
    std::vector<Point> ring = test::random_grid_ring(random, 4 + random.below(8), 4);
    const double step = trial % 2 == 0 ? 0x1p-52 : 0x1p-50;  // the doubles there are 2^-52 apart
    for (Point& p : ring) p = {1 + p.x * step, 1 + p.y * step};
    if (ring.empty()) continue;
    SCOPED_TRACE(test::text_of(ring));
    const Polygon polygon{{ring}};
    for (const OrderKind order : {OrderKind::kPath, OrderKind::kCycle}) {
      try {
        expect_certified(polygon, hamiltonian_triangulation_with_points(polygon, order), order);
        ++made;
      } catch (const Error& e) {
        ASSERT_EQ(e.code(), ErrorCode::kGuarantee) << e.what();
        ++refused;
      }
    }
  }
  EXPECT_GT(made, 500U);
  EXPECT_GT(refused, 50U);
}

TEST(PolygonWithPoints, Refusals) {
  const Polygon bow{{{{0, 0}, {4, 0}, {2, 2}, {4, 4}, {0, 4}, {2, 2}}}};
  const auto code_of = [](const Polygon& polygon, OrderKind order) {
    try {
      hamiltonian_triangulation_with_points(polygon, order);
    } catch (const Error& e) {
      return e.code();
    }
    return ErrorCode::kCancelled;
  };
  EXPECT_EQ(code_of(bow, OrderKind::kCycle), ErrorCode::kBadPolygon);
  EXPECT_EQ(code_of(bow, OrderKind::kSequential), ErrorCode::kBadOption);
  // No double is inside this triangle.
  const Polygon empty{{{{0, 0}, {0x1p-1074, 0}, {0, 0x1p-1074}}}};
  EXPECT_EQ(code_of(empty, OrderKind::kCycle), ErrorCode::kGuarantee);
}

}  // namespace
}  // namespace quadloom
