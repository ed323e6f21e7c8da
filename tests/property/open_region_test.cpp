// Places in thin regions: found whenever there is one, never outside.
#include "convex/open_region.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "core/random.hpp"
#include "quadloom/kernel.hpp"

namespace quadloom::convex {
namespace {

constexpr int kWidth = 12;
constexpr std::uint64_t kSeed = 20261122;

/// Neighbouring doubles: the points (1 + i 2^-52, 1 + j 2^-52) are all there are between them.
Point double_number(std::uint64_t i, std::uint64_t j) {
  return {1 + std::ldexp(static_cast<double>(i), -52), 1 + std::ldexp(static_cast<double>(j), -52)};
}

TEST(OpenRegion, FindsADoubleIfAndOnlyIfThereIsOne) {
  Random random(kSeed);
  const std::array<Point, 2> box = {double_number(0, 0), double_number(kWidth, kWidth)};
  std::size_t with = 0, without = 0;
  for (int run = 0; run < 20'000; ++run) {
    SCOPED_TRACE("seed 20261122, run " + std::to_string(run));
    OpenRegion region(box);
    std::vector<HalfPlane> sides = {{box[0], double_number(kWidth, 0)},
                                    {double_number(kWidth, 0), box[1]},
                                    {box[1], double_number(0, kWidth)},
                                    {double_number(0, kWidth), box[0]}};
    for (std::uint64_t k = 2 + random.below(4); k > 0; --k) {
      const auto any = [&] {
        return double_number(random.below(kWidth + 1), random.below(kWidth + 1));
      };
      const HalfPlane side{any(), any()};
      if (side.from == side.to) continue;
      sides.push_back(side);
    }
    for (const HalfPlane& side : sides) region.add(side);
    bool there_is_one = false;
    for (std::uint64_t i = 0; i <= kWidth; ++i) {
      for (std::uint64_t j = 0; j <= kWidth; ++j) {
        bool inside = true;
        for (const HalfPlane& side : sides) {
          inside = inside && orient2d(side.from, side.to, double_number(i, j)) > 0;
        }
        there_is_one = there_is_one || inside;
      }
    }
    const auto place = region.place(Effort::kExact);
    ASSERT_EQ(place.has_value(), there_is_one);
    if (place) {
      for (const HalfPlane& side : sides) ASSERT_GT(orient2d(side.from, side.to, *place), 0);
    }
    ++(there_is_one ? with : without);
  }
  EXPECT_GT(with, 1000U);
  EXPECT_GT(without, 1000U);
}

/// The triangle p, q, r.
OpenRegion triangle(const std::array<Point, 3>& corner) {
  OpenRegion region(corner);
  for (int i = 0; i < 3; ++i) region.add(corner[i], corner[(i + 1) % 3]);
  return region;
}

TEST(OpenRegion, FindsPlacesInSlivers) {
  Random random(kSeed);
  for (int run = 0; run < 3000; ++run) {
    SCOPED_TRACE("seed 20261122, run " + std::to_string(run));
    const Point p = {random.uniform() - 0.5, random.uniform() - 0.5};
    const Point q = {random.uniform() - 0.5, random.uniform() - 0.5};
    const double thin = std::ldexp(1.0, -static_cast<int>(random.below(50)));
    const Point r = {q.x - thin * (q.y - p.y), q.y + thin * (q.x - p.x)};
    if (orient2d(p, q, r) <= 0) continue;
    for (const int scale : {0, 1020, -1000}) {
      const auto scaled = [&](Point s) {
        return Point{std::ldexp(s.x, scale), std::ldexp(s.y, scale)};
      };
      const std::array<Point, 3> corner = {scaled(p), scaled(q), scaled(r)};
      const auto place = triangle(corner).place(Effort::kExact);
      ASSERT_TRUE(place.has_value());
      for (int i = 0; i < 3; ++i) ASSERT_GT(orient2d(corner[i], corner[(i + 1) % 3], *place), 0);
    }
  }
}

TEST(OpenRegion, OneStepOfTheLastBit) {
  const double up = std::nextafter(2.0, 3.0);
  // Between the corners' columns the triangle is less than one step wide; doubles are nevertheless in it.
  const std::array<Point, 3> slanted = {{{0, 0}, {3, 2}, {3, up}}};
  const auto place = triangle(slanted).place(Effort::kExact);
  ASSERT_TRUE(place.has_value());
  // No double is strictly between y = 2 and the next one.
  OpenRegion slab(std::array<Point, 2>{{{0, 0}, {4, 4}}});
  slab.add({0, 2}, {1, 2});
  slab.add({1, up}, {0, up});
  EXPECT_FALSE(slab.place(Effort::kExact).has_value());
}

TEST(OpenRegion, EmptyOnesAreEmpty) {
  OpenRegion region(std::array<Point, 3>{{{0, 0}, {4, 0}, {0, 4}}});
  region.add({0, 1}, {1, 1});
  region.add({1, 1}, {0, 1});  // both sides of one line
  EXPECT_FALSE(region.place(Effort::kExact).has_value());
  EXPECT_TRUE(region.places(Effort::kExact).empty());
}

TEST(OpenRegion, PlacesAreInside) {
  const std::array<Point, 3> corner = {{{0, 0}, {5, 1}, {2, 7}}};
  const OpenRegion region = triangle(corner);
  const OpenRegion::Places places = region.places(Effort::kFloat);
  EXPECT_EQ(places.size(), 10U);
  for (const Point p : places) EXPECT_TRUE(region.contains(p));
  EXPECT_FALSE(region.contains({0, 0}));
  EXPECT_FALSE(region.contains({std::nan(""), 1}));
}

}  // namespace
}  // namespace quadloom::convex
