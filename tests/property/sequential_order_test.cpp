// The linear test for sequential triangulations against the one from every start.
#include <gtest/gtest.h>

#include <iostream>
#include <map>

#include "core/random.hpp"
#include "quadloom/quadloom.hpp"
#include "support/grid_points.hpp"
#include "support/order_checks.hpp"
#include "support/point_triangulations.hpp"
#include "support/surfaces.hpp"

namespace quadloom {
namespace {

/// Compares; returns the answer.
std::optional<Closure> compare(const Triangulation& mesh) {
  const auto wanted = test::brute_sequential(mesh);
  const auto found = sequential_order(mesh);
  EXPECT_EQ(found.has_value(), wanted.has_value());
  if (!found || !wanted) return wanted;
  EXPECT_EQ(found->closure, *wanted);
  test::expect_order(mesh, found->order, OrderKind::kSequential);
  if (found->closure != Closure::kOpen) test::expect_order(mesh, found->order, OrderKind::kCycle);
  EXPECT_EQ(found->sequence.size(), mesh.triangle_count() + 2);
  for (std::size_t i = 0; i < found->order.size(); ++i) {
    std::array<VertexId, 3> corners, taken;
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] = mesh.tri_vertex[3 * found->order[i] + k];
      taken[k] = found->sequence[i + k];
    }
    EXPECT_TRUE(std::is_permutation(corners.begin(), corners.end(), taken.begin())) << i;
  }
  if (found->closure == Closure::kSequentialCycle) {
    EXPECT_EQ(found->sequence[0], found->sequence[found->order.size()]);
    EXPECT_EQ(found->sequence[1], found->sequence[found->order.size() + 1]);
  }
  return wanted;
}

TEST(SequentialOrder, AllTriangulationsOfRandomPointsAsFromEveryStart) {
  constexpr std::uint64_t kSeed = 20261130;
  Random random(kSeed);
  std::map<int, std::size_t> answers;
  for (int i = 0; i < 120; ++i) {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", set " + std::to_string(i));
    const auto points = i % 3 == 0 ? testing::uniform_points(random, 4 + random.below(5))
                                   : testing::random_grid_points(random, 4 + random.below(5), 4, 4);
    if (testing::all_collinear(points)) continue;
    test::for_all_point_triangulations(points, [&](const Triangulation& mesh) {
      const auto closure = compare(mesh);
      ++answers[closure ? static_cast<int>(*closure) : -1];
    });
    if (HasFailure()) return;
  }
  for (const auto& [answer, times] : answers) std::cout << answer << ": " << times << '\n';
  EXPECT_GT(answers[-1], 100U);
  EXPECT_GT(answers[static_cast<int>(Closure::kOpen)], 100U);
  EXPECT_GT(answers[static_cast<int>(Closure::kCycle)], 0U);
}

TEST(SequentialOrder, ClosedSurfacesAndTheirPatches) {
  std::map<int, std::size_t> answers;
  for (VertexId across = 3; across < 9; ++across) {
    for (VertexId along = 3; along < 9; ++along) {
      SCOPED_TRACE(std::to_string(across) + " x " + std::to_string(along));
      const auto torus = test::torus(across, along, false);
      auto faces = test::faces_of(torus.mesh);
      for (std::size_t left = faces.size(); left + 4 > faces.size() && left > 3; --left) {
        PolygonMesh part = torus.mesh;
        test::set_faces(part, {faces.begin(), faces.begin() + static_cast<std::ptrdiff_t>(left)});
        const auto closure = compare(connect_triangles(part, torus.z).triangles.mesh);
        ++answers[closure ? static_cast<int>(*closure) : -1];
      }
    }
  }
  const auto ball = test::sphere(0);
  compare(connect_triangles(ball.mesh, ball.z).triangles.mesh);
  for (const auto& [answer, times] : answers) std::cout << answer << ": " << times << '\n';
  EXPECT_GT(answers[-1], 0U);
  EXPECT_GT(answers[static_cast<int>(Closure::kSequentialCycle)], 0U);
}

TEST(SequentialOrder, ShortOnesAndSeveralComponents) {
  const std::vector<Point> points = {{0, 0}, {1, 0}, {0, 1}, {1, 1}, {5, 0}, {6, 0}, {5, 1}};
  const auto one = sequential_order(test::connected(points, {0, 1, 2}));
  ASSERT_TRUE(one.has_value());
  EXPECT_EQ(one->sequence.size(), 3U);
  const auto two = sequential_order(test::connected(points, {0, 1, 2, 3, 2, 1}));
  ASSERT_TRUE(two.has_value());
  EXPECT_EQ(two->closure, Closure::kOpen);
  EXPECT_FALSE(sequential_order(test::connected(points, {0, 1, 2, 4, 5, 6})).has_value());
  EXPECT_FALSE(sequential_order(Triangulation{}).has_value());
}

TEST(SequentialOrder, ALongStripInAnyOrder) {
  constexpr VertexId kLong = 200000;
  std::vector<Point> points;
  for (VertexId i = 0; i < kLong; ++i) points.push_back({i / 2 * 1.0, i % 2 * 1.0});
  Triangulation mesh{points, {}, {}};
  for (VertexId i = 0; i + 2 < kLong; ++i) {
    mesh.tri_vertex.insert(mesh.tri_vertex.end(),
                           {i, i % 2 == 0 ? i + 2 : i + 1, i % 2 == 0 ? i + 1 : i + 2});
  }
  PolygonMesh faces;
  faces.points = points;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    faces.add_face(std::span(mesh.tri_vertex).subspan(3 * t, 3));
  }
  Random random(1);
  test::shuffle_faces(faces, random, 0);
  const Triangulation shuffled = connect_triangles(faces).triangles.mesh;
  const auto found = sequential_order(shuffled);
  ASSERT_TRUE(found.has_value());
  test::expect_order(shuffled, found->order, OrderKind::kSequential);
}

}  // namespace
}  // namespace quadloom
