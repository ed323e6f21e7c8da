#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "io/point_readers.hpp"
#include "io/text.hpp"
#include "quadloom/io.hpp"
#include "support/temporary_folder.hpp"

namespace quadloom::io {
namespace {

using Points = std::vector<Point>;
using Numbers = std::vector<double>;
using Line = std::vector<std::size_t>;

PointTable read(const std::string& format, std::string_view text, const std::string& columns = {}) {
  return read_points_text({"input", text}, format, columns);
}

struct Fault {
  std::string format, text, columns, words;
  ErrorCode code = ErrorCode::kParse;
  std::vector<std::size_t> culprits;
};

void expect_fault(const Fault& fault) {
  SCOPED_TRACE(fault.format + ": " + fault.text);
  try {
    read(fault.format, fault.text, fault.columns);
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), fault.code) << error.what();
    EXPECT_NE(std::string(error.what()).find(fault.words), std::string::npos) << error.what();
    EXPECT_EQ(error.culprits(), fault.culprits) << error.what();
  }
}

TEST(ToNumber, ReadsWholeWordsCorrectlyRounded) {
  EXPECT_EQ(to_number("1"), 1);
  EXPECT_EQ(to_number("+1.5e3"), 1500);
  EXPECT_EQ(to_number("-.5"), -0.5);
  EXPECT_EQ(to_number("4.9406564584124654e-324"), std::numeric_limits<double>::denorm_min());
  EXPECT_EQ(to_number("1.7976931348623157e308"), std::numeric_limits<double>::max());
  EXPECT_EQ(to_number("1e-999"), 0);
  EXPECT_EQ(to_number("-0.0000001e-99999999999999999999"), 0);
  EXPECT_EQ(to_number("1e999"), std::numeric_limits<double>::infinity());
  EXPECT_EQ(to_number("-1e99999999999999999999"), -std::numeric_limits<double>::infinity());
  EXPECT_EQ(to_number("0." + std::string(400, '0') + "1"), 0);
  EXPECT_EQ(to_number("1" + std::string(400, '0')), std::numeric_limits<double>::infinity());
  EXPECT_EQ(to_number("1" + std::string(400, '0') + "e-400"), 1);
  EXPECT_TRUE(std::isnan(to_number("nan").value()));
  for (const char* bad : {"", "+", "-", "1a", "1,5", "0x10", "--1", "+-1", "1 ", " 1", "e5"}) {
    EXPECT_FALSE(to_number(bad)) << bad;
  }
}

TEST(Csv, HeaderNamesInAnyOrderAndCase) {
  const auto table = read("csv", "id,Lat,name,LON,Elevation\n7,1,a,2,3\n8,4,b,5,6\n");
  EXPECT_EQ(table.points, (Points{{2, 1}, {5, 4}}));
  EXPECT_EQ(table.z, (Numbers{3, 6}));
  EXPECT_EQ(table.line, (Line{2, 3}));
  EXPECT_TRUE(read("csv", "x,y\n1,2\n").z.empty());
}

TEST(Csv, SeparatorsQuotesMarksLineEndsAndComments) {
  const Points two = {{1, 2}, {3, 4}};
  for (const char* text :
       {"x,y\n1,2\n3,4", "x;y\r\n1;2\r\n3;4\r\n", "x\ty\n1\t2\n3\t4\n",
        "\xef\xbb\xbfx,y\n1,2\n3,4\n", "1,2\n3,4\n", " 1 , 2 \n\n 3 ,4  \n\n",
        "# by hand\nx,y\n1,2\n# more\n3,4\n", "# \"a; b;\"\nx,y\n1,2\n# 3\" more\n3,4\n",
        "\"x\",\"y\"\n\"1\",\"2\"\n3,4\n", "y,note,x\n2,\"a, \"\"b\"\"\n; c\",1\n4,,3\n",
        "x,y,,\n1,2,,\n3,4,,\n", "name\tx\ty\n\t1\t2\n\t3\t4\n",
        "x , \"y;z\", y\n1,0,2\n3,0,4\n"}) {
    EXPECT_EQ(read("csv", text).points, two) << text;
  }
  EXPECT_EQ(read("csv", "n,x,y\n\"two\nlines\",1,2\nb,3,4\n").line, (Line{2, 4}));
}

TEST(Csv, ColumnsByNameAndNumber) {
  const std::string text = "a,b,c\n1,2,3\n4,5,6\n";
  EXPECT_EQ(read("csv", text, "c,A").points, (Points{{3, 1}, {6, 4}}));
  EXPECT_EQ(read("csv", text, "3,1,2").z, (Numbers{2, 5}));
  EXPECT_EQ(read("csv", "9,1,2\n9,3,4\n", "2,3").points, (Points{{1, 2}, {3, 4}}));
  EXPECT_EQ(read("csv", "p1,1,2\np2,3,4\n", "2,3").points, (Points{{1, 2}, {3, 4}}));
}

TEST(Csv, Faults) {
  const auto empty = ErrorCode::kTooFewPoints;
  for (const Fault& f : std::vector<Fault>{
           {"csv", "", "", "input: the file holds no points", empty, {}},
           {"csv", " \n\n# nothing\n", "", "no points", empty, {}},
           {"csv", "x,y\n", "", "a header but no points", empty, {}},
           {"csv",
            "a,b\n1,2\n",
            "",
            "line 1: no columns x and y, or lon and lat; the columns are 'a', 'b'",
            ErrorCode::kParse,
            {1}},
           {"csv",
            "x,y\n1,2\n1,two\n",
            "",
            "line 3: 'two' is not a number, expected a number in column 'y'",
            ErrorCode::kParse,
            {3}},
           {"csv",
            "x,y\n1,2\n3\n",
            "",
            "line 3: the line has 1 columns, column 'y' is missing",
            ErrorCode::kParse,
            {3}},
           {"csv",
            "x,y\n1,\n",
            "",
            "line 2: a number in column 'y' is missing",
            ErrorCode::kParse,
            {2}},
           {"csv",
            "x,y\n1,nan\n",
            "",
            "line 2: 'nan' is not a finite number",
            ErrorCode::kNotFinite,
            {2}},
           {"csv", "x,y\r\n1e999,0\r\n", "", "'1e999' is not a finite", ErrorCode::kNotFinite, {2}},
           {"csv", "x,y,z\n1,2,inf\n", "", "column 'z'", ErrorCode::kNotFinite, {2}},
           {"csv",
            "a,b\n1,2\n",
            "a,q",
            "there is no column 'q'; the columns are 'a', 'b'",
            ErrorCode::kParse,
            {1}},
           {"csv", "1,2\n", "1,3", "there is no column 3, the line has 2", ErrorCode::kParse, {1}},
           {"csv", "1,2\n", "0,1", "there is no column 0", ErrorCode::kParse, {1}},
           {"csv", "1,2\n", "1", "two or three", ErrorCode::kBadOption, {}},
           {"csv",
            "x,y\n\"1,2\n",
            "",
            "line 2: a quoted field does not end",
            ErrorCode::kParse,
            {2}},
           {"csv", "x,y\n\"1\"0,2\n", "", "after the closing quote", ErrorCode::kParse, {2}},
           {"csv", "7\n", "", "found one number", ErrorCode::kParse, {1}},
           {"off", "7\n", "", "there are csv, xyz, geojson and node", ErrorCode::kBadOption, {}}}) {
    expect_fault(f);
  }
}

TEST(Xyz, NumbersWithBlanksOrCommas) {
  const Points two = {{1, 2}, {3, 4}};
  for (const char* text :
       {"1 2\n3 4\n", "  1\t2 \r\n\r\n3   4", "1, 2\n3;4 # last\n", "# c\n1 2\n3 4\n",
        "x y\n1 2\n3 4\n", "some points\n1 2\n3 4\n", "y x\n2 1\n4 3\n"}) {
    EXPECT_EQ(read("xyz", text).points, two) << text;
  }
  EXPECT_EQ(read("xyz", "1 2 3\n4 5 6\n").z, (Numbers{3, 6}));
  EXPECT_EQ(read("xyz", "1 2 3\n4 5 6\n", "3,1").points, (Points{{3, 1}, {6, 4}}));
  EXPECT_FALSE(std::signbit(read("xyz", "-0.0 -0\n1 1\n").points[0].x));
}

TEST(Xyz, Faults) {
  for (const Fault& f : std::vector<Fault>{
           {"xyz", "", "", "no points", ErrorCode::kTooFewPoints, {}},
           {"xyz",
            "1 2\n3\n",
            "",
            "line 2: the line has 1 columns, column 2 is missing",
            ErrorCode::kParse,
            {2}},
           {"xyz", "1 2\n\n3 b4\n", "", "line 3: 'b4' is not a number", ErrorCode::kParse, {3}},
           {"xyz", "1 2\n3 -inf\n", "", "'-inf' is not a finite", ErrorCode::kNotFinite, {2}},
           {"xyz", "1 2 3\n4 5\n", "", "column 3 is missing", ErrorCode::kParse, {2}},
           {"xyz",
            std::string("1 2\n\x01\x02\xff 3\n", 10),
            "",
            "line 2",
            ErrorCode::kParse,
            {2}}}) {
    expect_fault(f);
  }
}

TEST(GeojsonPoints, EveryKindOfHolder) {
  const Points two = {{1, 2}, {3, 4}};
  for (
      const char* text :
      {R"({"type":"MultiPoint","coordinates":[[1,2],[3,4]]})",
       R"({"coordinates":[[1,2,9],[3,4]],"type":"MultiPoint"})",
       R"({"type":"Feature","geometry":{"type":"MultiPoint","coordinates":[[1,2],[3,4]]},"properties":null})",
       R"({"type":"GeometryCollection","geometries":[{"type":"Point","coordinates":[1,2]},
            {"type":"Point","coordinates":[]},{"type":"MultiPoint","coordinates":[[3,4]]}]})",
       R"({"type":"FeatureCollection","crs":{"type":"name","properties":{"coordinates":[[7]]}},
            "features":[{"type":"Feature","id":3,"properties":{"coordinates":[5,6],"a":[{"type":"x"}]},
            "geometry":{"type":"Point","coordinates":[1,2]}},
            {"type":"Feature","geometry":null,"properties":{}},
            {"geometry":{"coordinates":[3.0,4e0],"type":"Point"},"type":"Feature"}]})"}) {
    const auto table = read("geojson", text);
    EXPECT_EQ(table.points, two) << text;
    EXPECT_TRUE(table.z.empty());
    EXPECT_TRUE(table.line.empty());
  }
  EXPECT_EQ(read("geojson", R"({"type":"MultiPoint","coordinates":[[1,2,3],[3,4,5]]})").z,
            (Numbers{3, 5}));
}

TEST(GeojsonPoints, Faults) {
  const auto parse = ErrorCode::kParse;
  for (const Fault& f : std::vector<Fault>{
           {"geojson", "", "", "empty", ErrorCode::kTooFewPoints, {}},
           {"geojson",
            R"({"type":"FeatureCollection","features":[]})",
            "",
            "no points",
            ErrorCode::kTooFewPoints,
            {}},
           {"geojson", "{\n\"type\":\n\"Point\",,}", "", "line 3", parse, {3}},
           {"geojson", R"({"type":"Point","coordinates":[1,2])", "", "line 1", parse, {1}},
           {"geojson", R"({"type":"Point","coordinates":[NaN,2]})", "", "line 1", parse, {1}},
           {"geojson",
            R"({"type":"Point","coordinates":[1e999,2]})",
            "",
            "1e999",
            ErrorCode::kNotFinite,
            {1}},
           {"geojson",
            R"({"type":"Point","coordinates":[1]})",
            "",
            "not those of a Point",
            parse,
            {}},
           {"geojson",
            R"({"type":"Point","coordinates":[[1,2]]})",
            "",
            "not those of a Point",
            parse,
            {}},
           {"geojson",
            R"({"type":"MultiPoint","coordinates":[1,2]})",
            "",
            "not those of a MultiPoint",
            parse,
            {}},
           {"geojson",
            R"({"type":"Point","coordinates":["1",2]})",
            "",
            "something else than numbers",
            parse,
            {}},
           {"geojson", R"({"type":"Point","coordinates":[null,2]})", "", "null among", parse, {}},
           {"geojson", R"({"type":"Point","coordinates":[{},2]})", "", "an object", parse, {}},
           {"geojson",
            R"({"type":"LineString","coordinates":[[1,2],[3,4]]})",
            "",
            "a LineString",
            parse,
            {}},
           {"geojson", R"({"type":"Topology"})", "", "'Topology' without coordinates", parse, {}},
           {"geojson", R"({"coordinates":[1,2]})", "", "without a type", parse, {}},
           {"geojson", "[1,2]", "", "an array instead", parse, {}},
           {"geojson", "7", "", "no object", parse, {}},
           {"geojson", std::string(100000, '['), "", "an array instead", parse, {}}}) {
    expect_fault(f);
  }
  // Deep nesting within coordinates and in a member that is skipped.
  EXPECT_THROW(read("geojson", R"({"type":"Point","coordinates":)" + std::string(200000, '[')),
               Error);
  EXPECT_THROW(
      read("geojson", R"({"other":)" + std::string(200000, '[') + std::string(200000, ']') + "}"),
      Error);
}

TEST(ReadPoints, ByExtensionAndRoundTrip) {
  const test::TemporaryFolder folder;
  const double least = std::numeric_limits<double>::denorm_min();
  const double most = std::numeric_limits<double>::max();
  const Points points = {
      {0.1, 1.0 / 3}, {1e-300, 1e300}, {least, -most}, {-0.0, 5e22}, {-7, 1e15 + 0.3}};
  const Numbers z = {1, 2e-310, 3, 0.7, -5};
  for (const char* name : {"p.csv", "p.xyz", "p.txt", "p.geojson", "p.json", "p.tsv", "P.CSV"}) {
    SCOPED_TRACE(name);
    write_points(folder.path(name), points, z);
    auto back = read_points(folder.path(name));
    EXPECT_EQ(back.points, points);
    EXPECT_EQ(back.z, z);
    EXPECT_FALSE(std::signbit(back.points[3].x));
    write_points(folder.path(name), points);
    back = read_points(folder.path(name));
    EXPECT_EQ(back.points, points);
    EXPECT_TRUE(back.z.empty());
  }
  EXPECT_EQ(folder.file_count(), 7U);
  EXPECT_THROW(read_points(folder.path("p.dat")), Error);
  EXPECT_EQ(
      read_points(folder.write("p.dat", "1 2\n"), {.format = "xyz", .columns = {}}).points.size(),
      1U);
  try {
    read_points(folder.path("missing.xyz"));
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kFile);
    EXPECT_NE(std::string(error.what()).find("missing.xyz: No such file"), std::string::npos);
  }
  EXPECT_THROW(read_points(folder.path("")), Error);
}

TEST(Output, LeavesTheOldFileOnFailure) {
  const test::TemporaryFolder folder;
  const auto path = folder.write("p.xyz", "old\n");
  const Points bad = {{1, 2}, {std::nan(""), 3}};
  EXPECT_THROW(write_points(path, bad), Error);
  EXPECT_EQ(folder.read("p.xyz"), "old\n");
  EXPECT_EQ(folder.file_count(), 1U);
  write_text(path, "new\n");
  EXPECT_EQ(folder.read("p.xyz"), "new\n");
  EXPECT_EQ(folder.file_count(), 1U);
  EXPECT_THROW(write_text(folder.path("no/such/folder.txt"), "x"), Error);
  EXPECT_THROW(write_text(folder.path(""), "x"), Error);
  EXPECT_NO_THROW(write_text("/dev/null", "x"));
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

TEST(Output, FollowsLinksAndReportsAFullDisk) {
  const test::TemporaryFolder folder;
  folder.write("real.txt", "old");
  std::filesystem::create_symlink(folder.path("real.txt"), folder.path("link.txt"));
  write_text(folder.path("link.txt"), "new");
  EXPECT_EQ(folder.read("real.txt"), "new");
  EXPECT_TRUE(std::filesystem::is_symlink(folder.path("link.txt")));
  if (std::filesystem::exists("/dev/full")) {
    try {
      write_text("/dev/full", "x");
      ADD_FAILURE();
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kFile);
      EXPECT_NE(std::string(error.what()).find("No space left"), std::string::npos) << error.what();
    }
  }
}

TEST(Polylines, AsGeojson) {
  const test::TemporaryFolder folder;
  const std::vector<Polyline> lines = {{{{0, 0}, {1, 0.5}}, false, 3},
                                       {{{0, 0}, {1, 0}, {0, 1}}, true, 1}};
  write_polylines(folder.path("l.geojson"), lines, "layer \"n\"");
  EXPECT_EQ(
      folder.read("l.geojson"),
      "{\"type\":\"FeatureCollection\",\"features\":[\n"
      R"({"type":"Feature","properties":{"layer \"n\"":3},"geometry":{"type":"LineString","coordinates":[[0,0],[1,0.5]]}},)"
      "\n"
      R"({"type":"Feature","properties":{"layer \"n\"":1},"geometry":{"type":"Polygon","coordinates":[[[0,0],[1,0],[0,1],[0,0]]]}})"
      "\n]}\n");
}

}  // namespace
}  // namespace quadloom::io
