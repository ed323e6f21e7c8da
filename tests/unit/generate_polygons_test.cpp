#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "quadloom/generate.hpp"

namespace quadloom {
namespace {

// That they are simple is shown by triangulating them: tests/property/constrained_test.cpp.
TEST(GeneratePolygons, AboutNCornersWholeAndTheSameAgain) {
  for (const PolygonGenerator& g : polygon_generators()) {
    for (const std::size_t n : {g.min_corners, std::size_t{20}, std::size_t{301}}) {
      SCOPED_TRACE(std::string(g.name) + " " + std::to_string(n) + ", seed 3");
      const Polygon polygon = generate_polygon(g.name, n, 3);
      ASSERT_EQ(polygon.rings.size(), 1U);
      const auto& ring = polygon.rings[0];
      EXPECT_GE(ring.size() + 2, n);
      EXPECT_LE(ring.size(), n);
      for (const Point p : ring) {
        EXPECT_EQ(p.x, std::floor(p.x));
        EXPECT_EQ(p.y, std::floor(p.y));
        EXPECT_LT(std::fabs(p.x) + std::fabs(p.y), 0x1p32);
      }
      EXPECT_EQ(ring, generate_polygon(g.name, n, 3).rings[0]);
    }
  }
}

TEST(GeneratePolygons, HolesAsAskedFor) {
  const Polygon polygon = generate_polygon("star", 30, 1);
  EXPECT_EQ(with_holes(polygon, 5, 2).rings.size(), 6U);
  EXPECT_EQ(with_holes(polygon, 500, 2).rings.size(), 29U);
  EXPECT_EQ(with_holes(polygon, 5, 2).rings, with_holes(polygon, 5, 2).rings);
}

TEST(GeneratePolygons, UnknownKindsAndTooFewCorners) {
  EXPECT_THROW(generate_polygon("stern", 10), Error);
  EXPECT_THROW(generate_polygon("comb", 4), Error);
}

}  // namespace
}  // namespace quadloom
