#include <gtest/gtest.h>

#include "quadloom/quadloom.hpp"

namespace quadloom {
namespace {

TEST(PolygonMesh, ListsQuadsThenTriangles) {
  const Quadrangulation mesh{{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {2, 0}}, {0, 1, 2, 3}, {1, 4, 2}};
  const PolygonMesh polygons = to_polygon_mesh(mesh);
  ASSERT_EQ(polygons.face_count(), 2U);
  EXPECT_EQ(polygons.face(0).size(), 4U);
  EXPECT_EQ(polygons.face(1)[1], 4U);
}

TEST(Progress, StopsWhenTheCallbackSaysSo) {
  EXPECT_NO_THROW(report_progress({}, "stage", 0));
  EXPECT_THROW(report_progress([](auto, double) { return false; }, "stage", 0), Error);
}

TEST(Orient2d, KnowsLeftRightAndCollinear) {
  EXPECT_EQ(orient2d({0, 0}, {1, 0}, {0, 1}), 1);
  EXPECT_EQ(orient2d({0, 0}, {0, 1}, {1, 0}), -1);
  EXPECT_EQ(orient2d({0, 0}, {1, 1}, {3, 3}), 0);
  EXPECT_EQ(dot_sign({0, 0}, {1, 0}, {0, 0}, {1, 5}), 1);
  EXPECT_EQ(dot_sign({0, 0}, {1, 0}, {0, 0}, {0, 5}), 0);
}

}  // namespace
}  // namespace quadloom
