#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include "quadloom/kernel.hpp"
#include "support/constrained_checks.hpp"
#include "support/delaunay_checks.hpp"

namespace quadloom {
namespace {

using Ring = std::vector<Point>;

Ring box(double x, double y, double width, double height) {
  return {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
}

PlanarInput polygons(std::vector<Polygon> list) {
  PlanarInput input;
  input.polygons = std::move(list);
  return input;
}

/// Runs it and gives the error; the test fails if there is none.
Error error_of(const PlanarInput& input, Extent extent = Extent::kInside) {
  try {
    (void)constrained_delaunay(input, extent);
  } catch (const Error& error) {
    return error;
  }
  ADD_FAILURE() << "no error";
  return {ErrorCode::kCancelled, "no error"};
}

void expect_error(const PlanarInput& input, ErrorCode code, const std::string& words,
                  const std::vector<std::size_t>& culprits) {
  const Error error = error_of(input);
  EXPECT_EQ(error.code(), code) << error.what();
  EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
  EXPECT_EQ(error.culprits(), culprits) << error.what();
}

TEST(Constrained, ASquareEitherWayAroundClosedOrNot) {
  for (const Ring& ring :
       {Ring{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, Ring{{0, 1}, {1, 1}, {1, 0}, {0, 0}},
        Ring{{0, 0}, {1, 0}, {1, 1}, {1, 1}, {0, 1}, {0, 0}}}) {
    const PlanarInput input = polygons({{{ring}}});
    const ConstrainedResult r = constrained_delaunay(input);
    expect_polygons(input, r);
    EXPECT_EQ(r.mesh.triangle_count(), 2U);
    EXPECT_EQ(r.mesh.points.size(), 4U);
  }
}

TEST(Constrained, AHoleAndInnerPoints) {
  PlanarInput input = polygons({{{box(0, 0, 10, 10), box(4, 4, 2, 2)}}});
  input.points = {{1, 1}, {5, 5}, {9, 5}, {4, 5}, {0, 0}, {10, 3}, {11, 3}};
  const ConstrainedResult r = constrained_delaunay(input);
  expect_polygons(input, r);
  EXPECT_EQ(r.input_to_vertex[9], kNone);   // in the hole
  EXPECT_EQ(r.input_to_vertex[14], kNone);  // outside
  EXPECT_EQ(r.input_to_vertex[12], 0U);     // a corner
  EXPECT_EQ(r.mesh.points.size(), 12U);
  const ConstrainedResult whole = constrained_delaunay(input, Extent::kHull);
  expect_polygons(input, whole);
  EXPECT_EQ(whole.mesh.points.size(), 14U);
}

TEST(Constrained, TheConvenientDoor) {
  const ConstrainedResult r = constrained_delaunay(Polygon{{box(0, 0, 4, 4)}}, Ring{{1, 2}});
  EXPECT_EQ(r.mesh.triangle_count(), 4U);
}

TEST(Constrained, PartsApartNestedAndBesideEachOther) {
  // 1 is an island in the hole of 0; 2 shares a whole edge with 0; 3 touches 2 at a corner.
  const PlanarInput input = polygons({{{box(0, 0, 10, 10), box(2, 2, 6, 6)}},
                                      {{box(4, 4, 2, 2)}},
                                      {{Ring{{10, 0}, {20, 0}, {20, 10}, {10, 10}}}},
                                      {{box(20, 10, 5, 5)}}});
  const ConstrainedResult r = constrained_delaunay(input);
  expect_positive_triangles_and_twins(r);
  expect_constrained_delaunay_edges(r);
  expect_input_edges_forced(input, r, true);
  expect_parts_tiled(input, r);
}

// Long edges that are no Delaunay edges, forced in random order: each counts as the first one.
TEST(Constrained, SharedAndRepeatedEdgesHaveTheSmallestNumber) {
  PlanarInput input;
  for (int i = 0; i < 40; ++i) {
    const double y = 3.0 * i;
    input.polygons.push_back({{{{0, y}, {900, y}, {900, y + 3}, {0, y + 3}}}});
    for (int x = 1; x < 30; ++x) input.points.push_back({30.0 * x + i % 7, y + 1 + x % 2});
  }
  input.points.insert(input.points.end(), {{0, -9}, {900, -8}});
  const auto end = static_cast<VertexId>(input.points.size());
  for (int i = 0; i < 5; ++i) input.segments.push_back({end - 1 - i % 2, end - 2 + i % 2});
  for (int x = 1; x < 60; ++x) input.points.push_back({15.0 * x, x % 2 == 0 ? -5.0 : -12.0});
  const ConstrainedResult r = constrained_delaunay(input, Extent::kHull);
  expect_polygons(input, r);
  expect_input_edges_forced(input, r, false);
  std::set<std::uint32_t> numbers(r.edge.begin(), r.edge.end());
  for (std::uint32_t p = 1; p < 40; ++p) {
    EXPECT_TRUE(numbers.contains(4 * p - 2));  // the upper edge of the polygon below
    EXPECT_FALSE(numbers.contains(4 * p));     // the lower one, the same
  }
  EXPECT_TRUE(numbers.contains(160));
  EXPECT_EQ(std::count_if(numbers.begin(), numbers.end(), [](auto e) { return e > 160; }), 1);
}

TEST(Constrained, APolygonInAnothersHoleThatItFills) {
  const PlanarInput input = polygons({{{box(0, 0, 10, 10), box(2, 2, 6, 6)}}, {{box(2, 2, 6, 6)}}});
  const ConstrainedResult r = constrained_delaunay(input);
  expect_parts_tiled(input, r);
  EXPECT_EQ(std::count(r.part.begin(), r.part.end(), 1U), 2);
}

TEST(Constrained, RingsThatTouchAtCorners) {
  const Ring touching_inside = {{0, 0}, {4, 4}, {2, 5}, {1, 3}};  // at a corner of the outer ring
  const Ring on_an_edge = {{10, 5}, {7, 6}, {7, 4}};              // a corner inside an outer edge
  const Ring by_the_first = {{4, 4}, {6, 4}, {6, 5}};             // at a corner of another hole
  const PlanarInput input =
      polygons({{{box(0, 0, 10, 10), touching_inside, on_an_edge, by_the_first}}});
  expect_polygons(input, constrained_delaunay(input));
  // A ring that touches itself: two boxes joined at a corner, and a box with its hole on one ring.
  const PlanarInput pinched =
      polygons({{{Ring{{0, 0}, {2, 0}, {2, 2}, {4, 2}, {4, 4}, {2, 4}, {2, 2}, {0, 2}}}},
                {{Ring{{10, 0}, {14, 0}, {14, 4}, {10, 4}, {10, 0}, {12, 3}, {13, 3}, {13, 2}}}}});
  const ConstrainedResult r = constrained_delaunay(pinched);
  expect_positive_triangles_and_twins(r);
  EXPECT_EQ(std::count(r.part.begin(), r.part.end(), 0U), 4);
}

TEST(Constrained, SegmentsThroughPoints) {
  PlanarInput input;
  for (int x = 0; x < 6; ++x) {
    for (int y = 0; y < 6; ++y) input.points.push_back({x + 0.0, y + 0.0});
  }
  input.segments = {{0, 35}, {1, 17}, {3, 3}, {35, 0}};
  const ConstrainedResult r = constrained_delaunay(input, Extent::kHull);
  expect_tiling(r.mesh);
  expect_constrained_delaunay_edges(r);
  expect_forced_edges_on_input(input, r);
  expect_input_edges_forced(input, r, false);
}

TEST(Constrained, WhatSegmentsEnclose) {
  PlanarInput input;
  for (const Ring& ring : {box(0, 0, 10, 10), box(2, 2, 2, 2), box(6, 6, 2, 2)}) {
    const auto first = static_cast<VertexId>(input.points.size());
    for (VertexId i = 0; i < 4; ++i) {
      input.points.push_back(ring[i]);
      input.segments.push_back({first + i, first + (i + 1) % 4});
    }
  }
  input.points.push_back({12, 5});
  input.holes = {{3, 2.5}, {100, 100}};
  input.regions = {{7, 7.5}, {1, 1}};
  const ConstrainedResult r = constrained_delaunay(input);
  expect_positive_triangles_and_twins(r);
  EXPECT_EQ(std::count(r.part.begin(), r.part.end(), 0U), 2);
  EXPECT_EQ(std::count(r.part.begin(), r.part.end(), 1U), 14);
  EXPECT_EQ(r.mesh.triangle_count(), 16U);
  EXPECT_EQ(r.input_to_vertex.back(), kNone);

  input.holes = {{2, 3}};
  EXPECT_EQ(error_of(input).code(), ErrorCode::kBadOption);
  input.holes.clear();
  input.segments.erase(input.segments.begin(), input.segments.begin() + 1);
  const ConstrainedResult open = constrained_delaunay(input);  // the big box leaks
  EXPECT_EQ(open.mesh.triangle_count(), 4U);
  input.segments.clear();
  EXPECT_EQ(error_of(input).code(), ErrorCode::kBadPolygon);
}

TEST(ConstrainedErrors, CrossingsNameBothEdges) {
  const Ring bow_tie = {{0, 0}, {4, 0}, {0, 3}, {4, 3}};
  expect_error(polygons({{{bow_tie}}}), ErrorCode::kCrossing,
               "the edge from (4, 3) to (0, 0) (polygon 0, ring 0, edge 3) crosses the edge from "
               "(4, 0) to (0, 3) (polygon 0, ring 0, edge 1)",
               {1, 3});
  // Rings cross twice, either crossing may be named.
  const Error hole = error_of(polygons({{{box(0, 0, 4, 4), box(3, 1, 3, 1)}}}));
  EXPECT_EQ(hole.code(), ErrorCode::kCrossing);
  ASSERT_EQ(hole.culprits().size(), 2U);
  EXPECT_EQ(hole.culprits()[0], 1U) << hole.what();
  EXPECT_TRUE(hole.culprits()[1] == 4 || hole.culprits()[1] == 6) << hole.what();
  const Error other = error_of(polygons({{{box(0, 0, 4, 4)}}, {{box(3, 3, 4, 4)}}}));
  EXPECT_EQ(other.code(), ErrorCode::kCrossing);
  const auto named = other.culprits();
  EXPECT_TRUE(named == std::vector<std::size_t>({1, 4}) ||
              named == std::vector<std::size_t>({2, 7}))
      << other.what();
  PlanarInput input = polygons({{{box(0, 0, 4, 4)}}});
  input.points = {{1, 1}, {7, 2}};
  input.segments = {{1, 0}};
  expect_error(input, ErrorCode::kCrossing,
               "the segment from (7, 2) to (1, 1) (segment 0) crosses the edge from (4, 0)",
               {1, 4});
}

TEST(ConstrainedErrors, OverlapsNameBothEdges) {
  expect_error(polygons({{{box(0, 0, 4, 4)}}, {{box(4, 1, 4, 4)}}}), ErrorCode::kCrossing,
               "overlaps the edge from (4, 0) to (4, 4)", {1, 7});
  const Ring spike = {{0, 0}, {4, 0}, {4, 4}, {6, 7}, {4, 4}, {0, 4}};
  expect_error(polygons({{{spike}}}), ErrorCode::kCrossing,
               "the edge from (6, 7) to (4, 4) (polygon 0, ring 0, edge 3) overlaps", {2, 3});
  const Error third =
      error_of(polygons({{{box(0, 0, 4, 4)}}, {{box(4, 0, 4, 4)}}, {{box(4, 0, 5, 4)}}}));
  EXPECT_EQ(third.code(), ErrorCode::kCrossing);
  EXPECT_NE(std::string(third.what()).find("overlaps"), std::string::npos) << third.what();
  PlanarInput input;
  input.points = {{0, 0}, {3, 0}, {1, 0}, {2, 0}, {0, 9}};
  input.segments = {{0, 3}, {1, 2}};
  expect_error(input, ErrorCode::kCrossing,
               "the segment from (3, 0) to (1, 0) (segment 1) overlaps", {0, 1});
  input.segments = {{0, 3}, {3, 0}, {0, 3}};  // one and the same
  const ConstrainedResult same = constrained_delaunay(input, Extent::kHull);
  EXPECT_EQ(same.mesh.triangle_count(), 3U);
  EXPECT_EQ(std::count(same.edge.begin(), same.edge.end(), 0U), 2);
  EXPECT_EQ(std::count(same.edge.begin(), same.edge.end(), kNone), 7);
}

TEST(ConstrainedErrors, RingsThatBoundNoRegion) {
  // Which edge of a ring is named is of no account: its ring is checked.
  const auto expect_bad = [](const PlanarInput& input, const std::string& words,
                             std::vector<std::size_t> rings) {
    const Error error = error_of(input);
    EXPECT_EQ(error.code(), ErrorCode::kBadPolygon) << error.what();
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    std::vector<std::size_t> named;
    for (const std::size_t edge : error.culprits()) named.push_back(edge / 4);  // boxes all
    EXPECT_EQ(named, rings) << error.what();
  };
  const auto apart = "the rings of polygon 0 are not an outer ring and holes";
  const Error beside = error_of(polygons({{{box(0, 0, 4, 4), box(8, 0, 1, 1)}}}));
  EXPECT_EQ(beside.code(), ErrorCode::kBadPolygon);
  EXPECT_EQ(beside.culprits().back() / 4, 1U) << beside.what();
  expect_bad(polygons({{{box(0, 0, 9, 9), box(2, 2, 5, 5), box(3, 3, 1, 1)}}}), apart, {1, 2});
  expect_bad(polygons({{{box(3, 3, 1, 1), box(0, 0, 9, 9)}}}), "is of a hole that is not", {1});
  const auto overlap = "polygons 0 and 1 overlap";
  expect_bad(polygons({{{box(0, 0, 9, 9)}}, {{box(3, 3, 1, 1)}}}), overlap, {0, 1});
  expect_bad(polygons({{{box(0, 0, 9, 9)}}, {{box(0, 0, 9, 9)}}}), overlap, {0, 1});
  const Ring eight = {{0, 0}, {2, 2}, {4, 4}, {4, 0}, {2, 2}, {0, 4}};
  EXPECT_EQ(error_of(polygons({{{eight}}})).code(), ErrorCode::kBadPolygon);
  const Ring twice = {{0, 0}, {9, 0}, {9, 9}, {0, 0}, {8, 1}, {8, 3}};
  const Error error = error_of(polygons({{{twice}}}));
  EXPECT_EQ(error.code(), ErrorCode::kBadPolygon);
  EXPECT_NE(std::string(error.what()).find("crosses itself at a corner or goes around twice"),
            std::string::npos);
}

TEST(ConstrainedErrors, RingsWithTooFewCorners) {
  const auto bad = ErrorCode::kBadPolygon;
  expect_error(polygons({{{box(0, 0, 4, 4), {{1, 1}, {2, 2}, {1, 1}, {2, 2}}}}}), bad,
               "ring 1 of polygon 0 has fewer than three different corners", {0, 1});
  expect_error(polygons({{{box(0, 0, 4, 4)}}, {}, {{Ring{}}}}), bad, "polygon 2 has fewer", {2, 0});
}

TEST(ConstrainedErrors, TheRest) {
  PlanarInput input;
  input.points = {{0, 0}, {3, 0}, {1, 1}};
  input.segments = {{0, 1}, {2, 3}};
  expect_error(input, ErrorCode::kIndexOutOfRange, "segment 1 names point 3, there are 3", {1, 3});
  input.segments.clear();
  input.holes = {{0.5, std::numeric_limits<double>::infinity()}};
  EXPECT_EQ(error_of(input).code(), ErrorCode::kNotFinite);
  input.holes = {{0.5, 0.2}};
  input.polygons = {{{box(0, 0, 4, 4)}}};
  EXPECT_EQ(error_of(input).code(), ErrorCode::kBadOption);
  input.holes.clear();
  input.points[1].x = std::numeric_limits<double>::quiet_NaN();
  expect_error(input, ErrorCode::kNotFinite, "point 5", {5});
  EXPECT_EQ(error_of(polygons({{{Ring{{0, 0}, {1, 1}, {2, 2}}}}})).code(),
            ErrorCode::kAllCollinear);
}

}  // namespace
}  // namespace quadloom
