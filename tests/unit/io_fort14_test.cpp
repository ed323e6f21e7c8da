// ADCIRC's fort.14.
#include <gtest/gtest.h>

#include "support/mesh_files.hpp"

namespace quadloom::io {
namespace {

// Node numbers in any order, a triangle and a quad, a line of comment words, no boundaries.
const std::string kSmall =
    "\n2 5 ! counts\n-7 0 0 1.5\n100 1 0 2.5D+00\n3 1 1 -1\n8 0 1 0 extra\n2000000000 2 0.5 4\n"
    "11 4 -7 100 3 8\n7 3 100 2000000000 3\n";

TEST(ReadFort14, NumbersOfNodesAreAny) {
  for (const char* format : {"14", "gr3"}) {
    const auto file = read(format, kSmall);
    EXPECT_EQ(file.mesh.points, (std::vector<Point>{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {2, 0.5}}));
    EXPECT_EQ(file.mesh.face_begin, (std::vector<std::uint32_t>{0, 4, 7}));
    EXPECT_EQ(file.mesh.face_vertex, (std::vector<VertexId>{0, 1, 2, 3, 1, 4, 2}));
    EXPECT_EQ(file.z, (std::vector<double>{1.5, 2.5, -1, 0, 4}));
    EXPECT_TRUE(file.z_is_data);
    EXPECT_TRUE(file.vertex_data.empty());
  }
}

TEST(ReadFort14, Boundaries) {
  const std::string open = "1 = open\r\n2\r\n2\r\n-7\r\n100\r\n";
  const auto only_open = read("14", kSmall + open);
  expect_same_data({{"boundary", {1, 1, 0, 0, 0}}}, only_open.vertex_data);
  // An open boundary's end is also the land boundary's; a weir of type 24 has two sides.
  const auto both =
      read("14", kSmall + open + "2\n5\n3 20 = land\n100\n2000000000\n3\n1 24\n8 3 0.5 1 1\n");
  expect_same_data({{"boundary", {1, 1, 22, 26, 22}}}, both.vertex_data);
  const auto none = read("14", kSmall + "0\n0\n0\n0\n");
  expect_same_data({{"boundary", {0, 0, 0, 0, 0}}}, none.vertex_data);
}

TEST(ReadFort14, SurvivesDamage) {
  expect_survives_damage("14", kSmall + "1\n2\n2\n-7\n100\n1\n2\n1 24\n8 3 0.5 1 1\n");
}

TEST(BadMeshes, Fort14) {
  const std::string four = "t\n1 3\n1 0 0 1\n2 1 0 1\n3 0 1 1\n";
  const std::string all = four + "1 3 1 2 3\n";
  for (const BadFile& bad : std::vector<BadFile>{
           {"14", "", "expected the title", kParse, {0}},
           {"14", "title\n", "expected the counts", kParse, {1}},
           {"14", "title\n1\n", "'' is not a count, expected the count of nodes", kParse, {2}},
           {"14", "title\n-1 3\n", "'-1' is not a count", kParse, {2}},
           {"14",
            "t\n18446744073709551615 18446744073709551615\n1 0 0 0\n",
            "expected node 2",
            kParse,
            {3}},
           {"14", "t\n1 1\n1.5 0 0 0\n", "'1.5' is not a whole number", kParse, {3}},
           {"14", "t\n1 1\n1 0 0\n", "the depth is missing", kParse, {3}},
           {"14", "t\n1 1\n1 0 nan 0\n", "'nan' is not a finite", kInfinite, {3}},
           {"14", "t\n1 1\n1 0 0 1D999\n", "'1e999' is not a finite", kInfinite, {3}},
           {"14", "t\n1 2\n-4 0 0 0\n-4 0 0 0\n", "node -4 is there twice", kParse, {4}},
           {"14", four, "expected element 1 of 1", kParse, {5}},
           {"14", four + "1 5 1 2 3\n", "an element of 5 corners", kParse, {6}},
           {"14", four + "1 3 1 2\n", "'' is not a whole number, expected a node", kParse, {6}},
           {"14", four + "1 3 1 2 4\n", "line 6: there is no node 4", kRange, {6}},
           {"14", all + "x\n", "'x' is not a count, expected the count of boundaries", kParse, {7}},
           {"14", all + "1\n", "expected the count of boundary nodes", kParse, {7}},
           {"14", all + "1\n2\n", "expected boundary 1 of 1", kParse, {8}},
           {"14", all + "1\n2\n2\n1\n", "expected node 2 of 2 of a boundary", kParse, {10}},
           {"14", all + "99999999999\n2\n99999999999\n1\n", "the file ends here", kParse, {10}},
           {"14", all + "1\n2\n1\n9\n", "line 10: there is no node 9", kRange, {10}},
           {"14", all + "0\n0\n1\n1\n1 4\n2\n", "expected a node's number", kParse, {12}}}) {
    expect_fault(bad);
  }
}

}  // namespace
}  // namespace quadloom::io
