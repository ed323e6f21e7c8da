#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "quadloom/certify.hpp"
#include "support/grid_mesh.hpp"
#include "support/quality_checks.hpp"
#include "support/surfaces.hpp"

namespace quadloom {
namespace {

PolygonMesh one_face(std::vector<Point> points) {
  PolygonMesh mesh;
  mesh.points = std::move(points);
  std::vector<VertexId> corners(mesh.points.size());
  std::iota(corners.begin(), corners.end(), VertexId{0});
  mesh.add_face(corners);
  return mesh;
}

TEST(Quality, OfARectangle) {
  const auto q = measure_quality(one_face({{0, 0}, {4, 0}, {4, 1}, {0, 1}}));
  EXPECT_EQ(q.quads, 1U);
  EXPECT_EQ(q.strictly_convex, 1U);
  EXPECT_DOUBLE_EQ(q.min_angle, 90);
  EXPECT_DOUBLE_EQ(q.max_angle, 90);
  EXPECT_EQ(q.angle_histogram[9], 4U);
  EXPECT_DOUBLE_EQ(q.mean_shape, 1);
  EXPECT_DOUBLE_EQ(q.min_shape, 1);
  EXPECT_EQ(q.shape_histogram[9], 1U);
  EXPECT_DOUBLE_EQ(q.max_aspect, 4);
  EXPECT_DOUBLE_EQ(q.median_aspect, 4);
  EXPECT_DOUBLE_EQ(q.min_edge, 1);
  EXPECT_DOUBLE_EQ(q.max_edge, 4);
  EXPECT_DOUBLE_EQ(q.mean_edge, 2.5);
}

TEST(Quality, OfADartAndAFlatQuad) {
  const auto dart = measure_quality(one_face({{0, 0}, {4, 0}, {1, 1}, {0, 4}}));
  EXPECT_EQ(dart.non_convex, 1U);
  EXPECT_EQ(dart.min_shape, 0);
  EXPECT_NEAR(dart.max_angle, 233.13010235415598, 1e-9);
  const auto flat = measure_quality(one_face({{0, 0}, {1, 0}, {2, 0}, {1, 2}}));
  EXPECT_EQ(flat.flat_cornered, 1U);
  EXPECT_DOUBLE_EQ(flat.max_angle, 180);
  const auto clockwise = measure_quality(one_face({{0, 1}, {1, 1}, {1, 0}, {0, 0}}));
  EXPECT_EQ(clockwise.non_convex, 1U);
  EXPECT_DOUBLE_EQ(clockwise.min_angle, 270);
}

TEST(Quality, OfMixedFaces) {
  auto mesh = test::grid_mesh(2, 1);
  mesh.points.push_back({1, -7});
  mesh.add_face(std::array<VertexId, 3>{0, 6, 1});
  mesh.add_face(std::array<VertexId, 5>{0, 1, 4, 5, 3});
  const auto q = measure_quality(mesh);
  EXPECT_EQ(q.quads, 2U);
  EXPECT_EQ(q.triangles, 1U);
  EXPECT_EQ(q.other_faces, 1U);
  EXPECT_EQ(std::accumulate(q.angle_histogram.begin(), q.angle_histogram.end(), std::size_t{0}),
            16U);
}

TEST(Quality, CountsInnerEdgesOnce) {
  // Two unit squares: seven edges; one of them moved away makes the inner edge longer.
  PolygonMesh mesh;
  mesh.points = {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {1, 3}, {0, 1}};
  mesh.add_face(std::array<VertexId, 4>{0, 1, 4, 5});
  mesh.add_face(std::array<VertexId, 4>{1, 2, 3, 4});
  EXPECT_DOUBLE_EQ(measure_quality(mesh).mean_edge, (4 + 3 + 2 * std::sqrt(5)) / 7);
  EXPECT_EQ(measure_quality(mesh).edges, 7U);
}

TEST(Quality, AtTheEndsOfTheRange) {
  for (const double s : {5e-324, 1e-320, 1e-300, 1e300, 1.5e308}) {
    const auto q = measure_quality(one_face({{-s, -s}, {s, -s}, {s, s}, {-s, s}}));
    EXPECT_DOUBLE_EQ(q.min_angle, 90) << s;
    EXPECT_DOUBLE_EQ(q.max_angle, 90) << s;
    EXPECT_EQ(q.strictly_convex, 1U) << s;
    EXPECT_DOUBLE_EQ(q.max_aspect, 1) << s;
  }
}

TEST(Quality, IsTheSameAtAnyMagnitude) {
  PolygonMesh mesh;
  mesh.points = {{0, 0}, {4, 0}, {5, 2}, {1, 3}, {8, 1}, {6, 7}, {2, 2}};
  test::set_faces(mesh, {{0, 1, 2, 3}, {1, 4, 5, 2}, {3, 2, 5, 6}, {0, 4, 5}});
  const PolygonMesh at_one = mesh;
  const Quality wanted = measure_quality(mesh);
  // A double has 1022 binary places more at either end; products of lengths are taken to 2^232.
  for (const int exponent : {-1074, -1020, -600, -235, -232, -230, 100, 228, 230, 232, 600, 1020}) {
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
      const Point p = at_one.points[v];
      mesh.points[v] = {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent)};
    }
    SCOPED_TRACE(exponent);
    const Quality q = measure_quality(mesh);
    test::expect_same_counts(q, wanted);
    EXPECT_DOUBLE_EQ(q.min_angle, wanted.min_angle);
    EXPECT_DOUBLE_EQ(q.max_angle, wanted.max_angle);
    EXPECT_DOUBLE_EQ(q.mean_shape, wanted.mean_shape);
    if (exponent == -1074) continue;  // lengths are whole numbers of units there
    EXPECT_DOUBLE_EQ(q.max_aspect, wanted.max_aspect);
    EXPECT_DOUBLE_EQ(q.median_aspect, wanted.median_aspect);
    EXPECT_DOUBLE_EQ(q.min_edge, std::ldexp(wanted.min_edge, exponent));
    EXPECT_DOUBLE_EQ(q.max_edge, std::ldexp(wanted.max_edge, exponent));
  }
}

TEST(Quality, RefusesWhatIsNoMesh) {
  EXPECT_EQ(measure_quality({}).max_angle, 0);
  auto mesh = one_face({{0, 0}, {1, 0}, {0, 1}});
  mesh.points[2].y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(measure_quality(mesh), Error);
  mesh.face_vertex[2] = 3;
  EXPECT_THROW(measure_quality(mesh), Error);
  mesh.face_vertex.pop_back();
  mesh.face_begin.back() = 2;
  EXPECT_THROW(measure_quality(mesh), Error);
}

TEST(Quality, OfASurfaceInEveryCoordinatePlane) {
  // A rectangle, a dart and a triangle, in the planes x y, y z, z x; and as the plane has them.
  const std::vector<Point> flat = {{0, 0}, {4, 0}, {4, 1}, {0, 1}, {8, 0}, {5, 1}, {4, 4}, {-1, 5}};
  const std::vector<std::vector<VertexId>> faces = {{0, 1, 2, 3}, {1, 4, 5, 6}, {3, 2, 7}};
  PolygonMesh plane;
  plane.points = flat;
  test::set_faces(plane, faces);
  const Quality wanted = measure_quality(plane);
  EXPECT_EQ(wanted.non_convex, 1U);
  for (std::size_t turn = 0; turn < 3; ++turn) {
    PolygonMesh mesh = plane;
    std::vector<double> z;
    for (Point& p : mesh.points) {
      const std::array<double, 3> at = {p.x, p.y, 7};
      p = {at[(3 - turn) % 3], at[(4 - turn) % 3]};
      z.push_back(at[(5 - turn) % 3]);
    }
    const Quality q = measure_quality(mesh, z);
    EXPECT_EQ(q.strictly_convex, wanted.strictly_convex) << turn;
    EXPECT_EQ(q.non_convex, wanted.non_convex);
    EXPECT_EQ(q.angle_histogram, wanted.angle_histogram);
    EXPECT_NEAR(q.min_angle, wanted.min_angle, 1e-9);
    EXPECT_NEAR(q.max_angle, wanted.max_angle, 1e-9);
    EXPECT_NEAR(q.mean_shape, wanted.mean_shape, 1e-12);
    EXPECT_DOUBLE_EQ(q.mean_edge, wanted.mean_edge);
    EXPECT_DOUBLE_EQ(q.max_aspect, wanted.max_aspect);
  }
  EXPECT_EQ(measure_quality(plane, {}).mean_shape, wanted.mean_shape);
  EXPECT_THROW(measure_quality(plane, std::vector<double>(3, 0)), Error);
}

TEST(Quality, OfASkewQuadInSpace) {
  // A square with one corner lifted: the angle there is 60 degrees, the others stay right.
  const auto mesh = one_face({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  const Quality q = measure_quality(mesh, std::vector<double>{0, 0, 1, 0});
  EXPECT_DOUBLE_EQ(q.min_angle, 60);  // between (0, -1, -1) and (-1, 0, -1)
  EXPECT_DOUBLE_EQ(q.max_angle, 90);
  EXPECT_DOUBLE_EQ(q.min_shape, 1 - 30.0 / 90);
  EXPECT_DOUBLE_EQ(q.max_aspect, std::sqrt(2.0));
  EXPECT_EQ(q.strictly_convex, 1U);
  for (const double s : {1e-320, 1e-300, 1e300}) {
    const Quality far = measure_quality(one_face({{-s, -s}, {s, -s}, {s, s}, {-s, s}}),
                                        std::vector<double>{-s, -s, s, s});
    EXPECT_DOUBLE_EQ(far.min_angle, 90) << s;
    EXPECT_DOUBLE_EQ(far.max_angle, 90) << s;
  }
  EXPECT_THROW(measure_quality(mesh, std::vector<double>{0, 0, std::nan(""), 0}), Error);
}

}  // namespace
}  // namespace quadloom
