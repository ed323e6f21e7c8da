#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "io/planar_readers.hpp"
#include "quadloom/io.hpp"
#include "support/temporary_folder.hpp"

namespace quadloom::io {
namespace {

std::string no_nodes() { throw Error(ErrorCode::kFile, "no nodes"); }

PlanarFile read(const std::string& format, std::string_view text) {
  return read_planar_text({"input", text}, format, no_nodes);
}

void expect_fault(const std::string& format, const std::string& text, ErrorCode code,
                  const std::string& words, const std::vector<std::size_t>& culprits = {}) {
  SCOPED_TRACE(text);
  try {
    read(format, text);
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), code) << error.what();
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    EXPECT_EQ(error.culprits(), culprits) << error.what();
  }
}

using Numbers = std::vector<double>;

TEST(PlanarGeojson, WritesWhatItReads) {
  const test::TemporaryFolder folder;
  std::vector<Polygon> polygons(2);
  polygons[0].rings = {{{0, 0}, {9, 0.1}, {0, 9}}, {{1, 1}, {1, 2}, {2, 1}}};
  polygons[1].rings = {{{20, 0}, {30, 1e-300}, {20, 9}, {19, 9}}};
  write_polygons(folder.path("p.geojson"), polygons);
  const PlanarFile file = read_planar(folder.path("p.geojson"));
  ASSERT_EQ(file.input.polygons.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ(file.input.polygons[i].rings, polygons[i].rings);
  polygons[1].rings.emplace_back();
  EXPECT_THROW(write_polygons(folder.path("q.geojson"), polygons), Error);
}

TEST(PlanarGeojson, PolygonsLinesAndPoints) {
  const PlanarFile file = read("geojson", R"({"type":"FeatureCollection","features":[
{"type":"Feature","properties":{"a":1},"geometry":{"type":"Polygon","coordinates":
 [[[0,0,1],[9,0,2],[0,9,3],[0,0,1]],[[1,1,4],[1,2,5],[2,1,6]]]}},
{"type":"Feature","properties":{"c":4},"geometry":{"type":"LineString","coordinates":
 [[1,3,7],[2,3,8],[2,4,9]]}},
{"type":"Feature","properties":{"b":2,"a":null},"geometry":{"type":"MultiPolygon","coordinates":
 [[[[9,9,1],[8,9,1],[9,8,1],[9,9,1]]],[[[7,9,1],[6,9,1],[7,8,1],[7,9,1]]]]}},
{"type":"Feature","properties":{},"geometry":{"type":"Point","coordinates":[3,3,10]}}]})");
  ASSERT_EQ(file.input.polygons.size(), 3U);
  ASSERT_EQ(file.input.polygons[0].rings.size(), 2U);
  EXPECT_EQ(file.input.polygons[0].rings[0], (std::vector<Point>{{0, 0}, {9, 0}, {0, 9}}));
  EXPECT_EQ(file.input.polygons[0].rings[1], (std::vector<Point>{{1, 1}, {1, 2}, {2, 1}}));
  EXPECT_EQ(file.input.points, (std::vector<Point>{{1, 3}, {2, 3}, {2, 4}, {3, 3}}));
  ASSERT_EQ(file.input.segments.size(), 2U);
  EXPECT_EQ(file.input.segments[1].from, 1U);
  EXPECT_EQ(file.input.segments[1].to, 2U);
  EXPECT_EQ(file.z, (Numbers{1, 2, 3, 4, 5, 6, 1, 1, 1, 1, 1, 1, 7, 8, 9, 10}));
  ASSERT_EQ(file.polygon_data.size(), 2U);
  EXPECT_EQ(file.polygon_data[0].name, "a");
  EXPECT_EQ(file.polygon_data[0].values[0], 1);
  EXPECT_TRUE(std::isnan(file.polygon_data[0].values[1]));
  EXPECT_EQ(file.polygon_data[1].name, "b");
  EXPECT_TRUE(std::isnan(file.polygon_data[1].values[0]));
  EXPECT_EQ(file.polygon_data[1].values[2], 2);
}

TEST(PlanarGeojson, Faults) {
  expect_fault("geojson", "", ErrorCode::kTooFewPoints, "empty");
  expect_fault("json", R"({"type":"FeatureCollection","features":[]})", ErrorCode::kTooFewPoints,
               "no polygons");
  expect_fault("geojson", R"({"type":"Polygon","coordinates":[[0,0],[1,0],[0,1]]})",
               ErrorCode::kParse, "not those of a Polygon");
  expect_fault("geojson", R"({"type":"Circle","coordinates":[0,0]})", ErrorCode::kParse,
               "'Circle'");
  expect_fault("poly2", "", ErrorCode::kBadOption, "'poly2'");
}

TEST(PlanarPoly, AllOfIt) {
  const PlanarFile file = read("poly", R"(# comment
4 2 1 1
 1 0 0 7 1
 2 4 0 8 1   # comment
 3 4 4 9 0

 4 0 4 10 1
4 1
1 1 2 5
2 2 3
3 3 4 6
4 4 1 7
1
1 1 1
2
1 3 3 2.5 0.1
2 1 3 4
)");
  EXPECT_EQ(file.input.points, (std::vector<Point>{{0, 0}, {4, 0}, {4, 4}, {0, 4}}));
  ASSERT_EQ(file.point_data.size(), 2U);
  EXPECT_EQ(file.point_data[0].name, "attribute0");
  EXPECT_EQ(file.point_data[0].values, (Numbers{7, 8, 9, 10}));
  EXPECT_EQ(file.point_data[1].values, (Numbers{1, 1, 0, 1}));
  ASSERT_EQ(file.input.segments.size(), 4U);
  EXPECT_EQ(file.input.segments[3].from, 3U);
  EXPECT_EQ(file.input.segments[3].to, 0U);
  EXPECT_EQ(file.segment_data[0].values, (Numbers{5, 0, 6, 7}));
  EXPECT_EQ(file.input.holes, (std::vector<Point>{{1, 1}}));
  EXPECT_EQ(file.input.regions, (std::vector<Point>{{3, 3}, {1, 3}}));
  EXPECT_EQ(file.region_data[0].values, (Numbers{2.5, 4}));
  EXPECT_EQ(file.region_data[1].values, (Numbers{0.1, -1}));
}

TEST(PlanarPoly, PointsInTheNodeFileBesideIt) {
  const test::TemporaryFolder folder;
  folder.write("a.poly", "0 2\n1\n0 0 2\n0\n");
  folder.write("a.node", "3 2 0 0\n0 0 0\n1 1 0\n2 0 1\n");
  const PlanarFile file = read_planar(folder.path("a.poly"));
  EXPECT_EQ(file.input.points.size(), 3U);
  EXPECT_EQ(file.input.segments[0].to, 2U);
  EXPECT_THROW(read_planar(folder.path("a.node")), Error);
  folder.write("b.poly", "0 2\n1\n0 0 2\n0\n");
  EXPECT_THROW(read_planar(folder.path("b.poly")), Error);
}

TEST(PlanarPoly, Faults) {
  const auto parse = ErrorCode::kParse;
  const std::string three = "3 2\n1 0 0\n2 1 0\n3 0 1\n";
  expect_fault("poly", "", parse, "expected the number of points", {0});
  expect_fault("poly", "x", parse, "'x' is not a count", {1});
  expect_fault("poly", "3 3\n", parse, "the dimension is not 2", {1});
  expect_fault("poly", "99999999999 2\n", parse, "too many", {1});
  expect_fault("poly", "3 2 5000\n", parse, "too many", {1});
  expect_fault("poly", "3 2\n1 0 0\n3 1 0\n", parse, "point number 3", {3});
  expect_fault("poly", "3 2\n5 0 0\n", parse, "point number 5", {2});
  expect_fault("poly", "3 2\n1 0 0\n2 1\n", parse, "y is missing", {3});
  expect_fault("poly", "3 2\n1 0 0\n2 1 inf\n", ErrorCode::kNotFinite, "'inf'", {3});
  expect_fault("poly", three, parse, "expected the number of segments", {4});
  expect_fault("poly", three + "2\n1 1 2\n", parse, "expected segment 2 of 2", {6});
  expect_fault("poly", three + "1\n1 1 4\n", ErrorCode::kIndexOutOfRange, "there is no point 4",
               {6});
  expect_fault("poly", three + "1\n1 0 1\n", ErrorCode::kIndexOutOfRange, "there is no point 0",
               {6});
  expect_fault("poly", three + "0\n1\n1 2\n", parse, "y is missing", {7});
  expect_fault("poly", three + "0\n0\n1\n1 0 0\n", parse, "the attribute is missing", {8});
  expect_fault("poly", "0 2\n", ErrorCode::kFile, "no nodes");
}

}  // namespace
}  // namespace quadloom::io
