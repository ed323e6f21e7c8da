#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "quadloom/kernel.hpp"
#include "support/delaunay_checks.hpp"

namespace quadloom {
namespace {

TEST(Delaunay, OneTriangle) {
  for (const std::vector<Point>& points :
       {std::vector<Point>{{0, 0}, {1, 0}, {0, 1}}, std::vector<Point>{{0, 0}, {0, 1}, {1, 0}}}) {
    const DelaunayResult result = delaunay(points);
    expect_delaunay(points, result);
    EXPECT_EQ(result.mesh.triangle_count(), 1U);
  }
}

TEST(Delaunay, TheSquaresOfAGridHaveParallelDiagonals) {
  std::vector<Point> points;
  for (int x = 0; x < 6; ++x) {
    for (int y = 0; y < 5; ++y) points.push_back({x + 0.0, y + 0.0});
  }
  const DelaunayResult result = delaunay(points);
  expect_delaunay(points, result);
  int falling = 0;
  for (HalfedgeId h = 0; h < result.mesh.twin.size(); ++h) {
    const Point a = result.mesh.points[result.mesh.origin(h)];
    const Point b = result.mesh.points[result.mesh.target(h)];
    const double slope = (b.x - a.x) * (b.y - a.y);
    EXPECT_LE(slope, 0);
    falling += slope < 0 ? 1 : 0;
  }
  EXPECT_EQ(falling, 2 * 5 * 4);
}

TEST(Delaunay, PointsOnAHullEdgeStayOnTheBoundary) {
  const std::vector<Point> points = {{0, 0}, {4, 0}, {0, 4}, {1, 0}, {3, 0}, {2, 0}, {2, 2},
                                     {1, 3}, {0, 1}, {3, 1}, {0, 3}, {0, 2}, {1, 1}};
  const DelaunayResult result = delaunay(points);
  expect_delaunay(points, result);
  EXPECT_EQ(result.mesh.triangle_count(), 2 * 13 - 2 - 12U);
}

TEST(Delaunay, DuplicatesAreMerged) {
  const std::vector<Point> points = {{2, 2}, {0, 0}, {2, 2}, {1, 0},     {0.0, -0.0},
                                     {0, 1}, {1, 0}, {2, 2}, {-0.0, 0.0}};
  const DelaunayResult result = delaunay(points);
  expect_delaunay(points, result);
  EXPECT_EQ(result.input_to_vertex, (std::vector<VertexId>{0, 1, 0, 2, 1, 3, 2, 0, 1}));
  EXPECT_EQ(result.mesh.triangle_count(), 2U);
}

TEST(Delaunay, TheSameInputGivesTheSameArrays) {
  std::vector<Point> points;
  for (int i = 0; i < 500; ++i)
    points.push_back({std::fmod(i * 0.618, 1), std::fmod(i * 0.414, 1)});
  const DelaunayResult first = delaunay(points), second = delaunay(points);
  EXPECT_EQ(first.mesh.tri_vertex, second.mesh.tri_vertex);
  EXPECT_EQ(first.mesh.twin, second.mesh.twin);
}

ErrorCode code_of(const std::vector<Point>& points) {
  try {
    delaunay(points);
  } catch (const Error& e) {
    EXPECT_FALSE(std::string(e.what()).empty());
    return e.code();
  }
  ADD_FAILURE() << "no error";
  return ErrorCode::kCancelled;
}

TEST(Delaunay, Errors) {
  EXPECT_EQ(code_of({}), ErrorCode::kTooFewPoints);
  EXPECT_EQ(code_of({{1, 1}, {2, 2}}), ErrorCode::kTooFewPoints);
  EXPECT_EQ(code_of(std::vector<Point>(100, Point{3, 3})), ErrorCode::kTooFewPoints);
  EXPECT_EQ(code_of({{1, 1}, {2, 2}, {1, 1}, {2, 2}}), ErrorCode::kTooFewPoints);
  EXPECT_EQ(code_of({{1, 1}, {2, 2}, {5, 5}, {3, 3}}), ErrorCode::kAllCollinear);
  EXPECT_EQ(code_of({{0, 0}, {1, 0}, {0, 1}, {0, NAN}}), ErrorCode::kNotFinite);
  EXPECT_EQ(code_of({{0, 0}, {1, 0}, {0, 1}, {HUGE_VAL, 0}}), ErrorCode::kNotFinite);
  std::vector<Point> line;
  for (int i = 0; i < 5000; ++i) line.push_back({i * 3.0, i * -7.0});
  EXPECT_EQ(code_of(line), ErrorCode::kAllCollinear);
}

}  // namespace
}  // namespace quadloom
