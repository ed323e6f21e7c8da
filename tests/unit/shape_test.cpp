#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/random.hpp"
#include "quadloom/kernel.hpp"

namespace quadloom {
namespace {

TEST(QuadShape, KnownFigures) {
  EXPECT_DOUBLE_EQ(quad_shape({0, 0}, {2, 0}, {2, 1}, {0, 1}), 1);
  EXPECT_NEAR(quad_shape({0, 0}, {1, 0}, {2, 1}, {1, 1}), 0.5, 1e-12);
  EXPECT_EQ(quad_shape({0, 0}, {1, 0}, {2, 0}, {1, 1}), 0);  // flat corner
  EXPECT_EQ(quad_shape({0, 0}, {4, 0}, {1, 1}, {0, 4}), 0);  // reflex corner
  EXPECT_EQ(quad_shape({0, 0}, {0, 1}, {2, 1}, {2, 0}), 0);  // clockwise
  EXPECT_EQ(quad_shape({0, 0}, {1, 1}, {1, 0}, {0, 1}), 0);  // crossing itself
  EXPECT_EQ(quad_shape({0, 0}, {0, 0}, {1, 0}, {0, 1}), 0);  // repeated corner
}

TEST(QuadShape, EveryScale) {
  for (const double s : {0x1p-1070, 0x1p-600, 1.0, 0x1p600, 0x1p1021}) {
    EXPECT_NEAR(quad_shape({0, 0}, {s, 0}, {2 * s, s}, {s, s}), 0.5, 1e-12) << s;
    EXPECT_DOUBLE_EQ(quad_shape({-s, -s}, {s, -s}, {s, s}, {-s, s}), 1) << s;
  }
}

double slow_shape(const Point (&p)[4]) {
  double worst = 0;
  for (int i = 0; i < 4; ++i) {
    const Point a = p[i], b = p[(i + 1) % 4], c = p[(i + 3) % 4];
    const double angle = std::atan2(c.y - a.y, c.x - a.x) - std::atan2(b.y - a.y, b.x - a.x);
    const double turn = 2 * std::numbers::pi;
    const double inner = angle < 0 ? angle + turn : angle;
    worst = std::max(worst, std::fabs(std::numbers::pi / 2 - inner));
  }
  return 1 - worst * 2 / std::numbers::pi;
}

TEST(QuadShape, AgreesWithTheFormula) {
  Random random(7);
  int convex = 0;
  for (int i = 0; i < 20000; ++i) {
    Point p[4];
    for (Point& q : p) q = {random.uniform(), random.uniform()};
    const double shape = quad_shape(p[0], p[1], p[2], p[3]);
    if (shape == 0) continue;
    ++convex;
    ASSERT_NEAR(shape, slow_shape(p), 1e-9);
    ASSERT_NEAR(shape, quad_shape(p[1], p[2], p[3], p[0]), 1e-12);
  }
  EXPECT_GT(convex, 500);
}

}  // namespace
}  // namespace quadloom
