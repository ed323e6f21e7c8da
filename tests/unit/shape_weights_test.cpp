// Weights of pairs: the plane and surfaces.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/random.hpp"
#include "quadloom/dual.hpp"
#include "quadloom/generate.hpp"
#include "quadloom/kernel.hpp"
#include "support/surfaces.hpp"

namespace quadloom {
namespace {

using Place = std::array<double, 3>;

Place direction(const Place& from, const Place& to) {
  return {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
}

double angle(const Place& before, const Place& at, const Place& after) {
  const Place u = direction(at, before), v = direction(at, after);
  const double length = std::hypot(u[0], u[1], u[2]) * std::hypot(v[0], v[1], v[2]);
  return std::acos((u[0] * v[0] + u[1] * v[1] + u[2] * v[2]) / length);
}

/// The weight by the definition, with the arc cosine of the standard library.
double weight_by_angles(const TriangleMesh& mesh, HalfedgeId h) {
  const auto at = [&](VertexId v) {
    return Place{mesh.mesh.points[v].x, mesh.mesh.points[v].y, mesh.z[v]};
  };
  const std::array<Place, 4> q = {at(mesh.mesh.origin(h)), at(mesh.mesh.apex(mesh.mesh.twin[h])),
                                  at(mesh.mesh.target(h)), at(mesh.mesh.apex(h))};
  double worst = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const double off = std::numbers::pi / 2 - angle(q[(i + 3) % 4], q[i], q[(i + 1) % 4]);
    worst = std::max(worst, std::fabs(off));
  }
  return 1 + 65535 * (1 - worst * 2 / std::numbers::pi);
}

TEST(ShapeWeights, HeightsOfNothingChangeNothing) {
  const auto plane = delaunay(generate_points("uniform", 500, 7)).mesh;
  const auto weight = shape_weights(plane);
  EXPECT_EQ(shape_weights(plane, std::vector<double>(plane.points.size(), 0)), weight);
  EXPECT_EQ(shape_weights(plane, std::vector<double>(plane.points.size(), 8)), weight);
  EXPECT_EQ(shape_weights(TriangleMesh{plane, {}, {}, {}, {}}), weight);
  EXPECT_THROW(shape_weights(plane, std::vector<double>(3, 0)), Error);
}

TEST(ShapeWeights, InEveryCoordinatePlane) {
  // A lattice of triangles in the planes x y, y z and z x, from both sides.
  PolygonMesh flat = test::height_field(5, 4, false, 1).mesh;
  for (Point& p : flat.points) p.y *= 3;
  std::vector<std::int32_t> expected = shape_weights(connect_triangles(flat).triangles);
  std::ranges::sort(expected);
  EXPECT_EQ(std::ranges::count(expected, expected.back()), 40);  // the rectangles, from both sides
  for (std::size_t plane = 0; plane < 3; ++plane) {
    for (const double side : {1.0, -1.0}) {
      PolygonMesh mesh = flat;
      std::vector<double> z;
      for (Point& p : mesh.points) {
        const std::array<double, 3> at = {side * p.x, p.y, 0};
        p = {at[(3 - plane) % 3], at[(4 - plane) % 3]};
        z.push_back(at[(5 - plane) % 3]);
      }
      auto weight = shape_weights(connect_triangles(mesh, z, {.space = Space::kSurface}).triangles);
      std::ranges::sort(weight);
      EXPECT_EQ(weight, expected) << plane << ' ' << side;
    }
  }
}

TEST(ShapeWeights, AreThoseOfTheAnglesInSpace) {
  const auto sphere = test::sphere(4);
  const auto torus = test::torus(11, 17, false);
  for (const auto& surface : {sphere, torus}) {
    const auto mesh = connect_triangles(surface.mesh, surface.z).triangles;
    const auto weight = shape_weights(mesh);
    std::size_t heavy = 0;
    for (HalfedgeId h = 0; h < weight.size(); ++h) {
      ASSERT_EQ(weight[h], weight[mesh.mesh.twin[h]]);
      if (weight[h] == 0) continue;
      ++heavy;
      ASSERT_NEAR(weight[h], weight_by_angles(mesh, h), 2) << h;
    }
    EXPECT_GT(heavy, weight.size() * 9 / 10);
  }
}

TEST(ShapeWeights, FoldedPairsWeighNothing) {
  for (const double degrees : {0.0, 45.0, 89.0, 91.0, 135.0, 179.0}) {
    // Two triangles of a square, folded along its diagonal, which is the y axis.
    const double t = degrees * std::numbers::pi / 180;
    PolygonMesh mesh;
    mesh.points = {{0, -1}, {std::cos(t), 0}, {0, 1}, {-1, 0}};
    mesh.add_face(std::array<VertexId, 3>{0, 1, 2});
    mesh.add_face(std::array<VertexId, 3>{0, 2, 3});
    const auto out = connect_triangles(mesh, std::vector<double>{0, std::sin(t), 0, 0},
                                       {.space = Space::kSurface});
    const auto weight = shape_weights(out.triangles);
    EXPECT_EQ(*std::ranges::max_element(weight) > 0, degrees < 90) << degrees;
  }
}

}  // namespace
}  // namespace quadloom
