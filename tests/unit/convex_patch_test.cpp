// The check that every strictly convex patch passes before it is returned: it can fail.
#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <utility>
#include <vector>

#include "convex/hexagon.hpp"
#include "convex/patch.hpp"
#include "convex/quad.hpp"

namespace quadloom::convex {
namespace {

const std::array<Point, 6> kHexagon = {{{0, 0}, {3, 1}, {6, 0}, {4, 3}, {3, 6}, {2, 3}}};

Patch good_patch() {
  const auto patch = patch_hexagon(kHexagon);
  EXPECT_TRUE(patch.has_value());
  return *patch;
}

TEST(ConvexPatch, AGoodOnePasses) {
  const Patch patch = good_patch();
  EXPECT_EQ(patch.steiner.size(), 1U);
  EXPECT_EQ(patch.quads.size(), 3U);
  EXPECT_TRUE(tiles(kHexagon, 6, patch));
}

TEST(ConvexPatch, DamagedOnesFail) {
  const std::vector<std::function<void(Patch&)>> damages = {
      [](Patch& p) { p.quads.pop_back(); },
      [](Patch& p) { p.quads.push_back(p.quads.front()); },
      [](Patch& p) { p.quads.clear(); },
      [](Patch& p) { std::swap(p.quads[0][1], p.quads[0][3]); },  // clockwise
      [](Patch& p) { p.quads[0][0] = 7; },                        // no such point
      [](Patch& p) {
        p.steiner[0] = {9, 9};
      },                                             // outside
      [](Patch& p) { p.steiner[0] = kHexagon[3]; },  // on a corner
      [](Patch& p) {
        p.steiner.push_back({1, 1});
      },  // in no quad
      [](Patch& p) {
        p.quads[0] = {0, 1, 2, 3};
      },  // twice the same edges, or gaps
  };
  for (std::size_t i = 0; i < damages.size(); ++i) {
    Patch patch = good_patch();
    damages[i](patch);
    EXPECT_FALSE(tiles(kHexagon, 6, patch)) << "damage " << i;
  }
}

TEST(ConvexPatch, AFlatCornerFails) {
  const std::array<Point, 4> flat = {{{0, 0}, {1, 0}, {2, 0}, {1, 1}}};
  Patch patch;
  patch.given = 4;
  patch.quads = {{0, 1, 2, 3}};
  EXPECT_FALSE(tiles(flat, 4, patch));
  const auto four = patch_quad(flat);
  ASSERT_TRUE(four.has_value());
  EXPECT_EQ(four->steiner.size(), 4U);
  EXPECT_EQ(four->quads.size(), 5U);
  EXPECT_TRUE(tiles(flat, 4, *four));
}

}  // namespace
}  // namespace quadloom::convex
