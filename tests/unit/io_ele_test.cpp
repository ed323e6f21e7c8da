// Triangle's .ele with the .node, .poly and .edge beside it.
#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <map>
#include <optional>

#include "support/mesh_files.hpp"
#include "support/temporary_folder.hpp"

namespace quadloom::io {
namespace {

const std::string kNodes = "4 2 1 1\n1 0 0 10 1\n2 1 0 11 1\n3 1 1 12 0\n4 0 1 13 0 # last\n";
const std::string kTriangles = "2 3 1\n1 1 2 3 7\n2 1 3 4 8\n";

using Beside = std::map<std::string, std::string, std::less<>>;

MeshFile read_with(const std::string& ele, const Beside& files) {
  return read_ele({"mesh", ele, [&](std::string_view extension) -> std::optional<std::string> {
                     const auto at = files.find(extension);
                     if (at == files.end()) return {};
                     return at->second;
                   }});
}

void expect_edges(const std::vector<Segment>& edges,
                  const std::vector<std::array<VertexId, 2>>& expected) {
  ASSERT_EQ(edges.size(), expected.size());
  for (std::size_t i = 0; i < edges.size(); ++i) {
    EXPECT_EQ((std::array{edges[i].from, edges[i].to}), expected[i]) << i;
  }
}

TEST(ReadEle, AttributesAndMarkersAreData) {
  const auto file = read_with(kTriangles, {{"node", kNodes}});
  EXPECT_EQ(file.mesh.points, (std::vector<Point>{{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
  EXPECT_EQ(file.mesh.face_vertex, (std::vector<VertexId>{0, 1, 2, 0, 2, 3}));
  expect_same_data({{"attribute0", {10, 11, 12, 13}}, {"marker", {1, 1, 0, 0}}}, file.vertex_data);
  expect_same_data({{"attribute0", {7, 8}}}, file.face_data);
  EXPECT_TRUE(file.z.empty());
  EXPECT_TRUE(file.edges.empty());
}

TEST(ReadEle, NumbersFromZeroAndSixPoints) {
  const auto file =
      read_with("1 6\n0 0 1 2 4 5 3", {{"node", "6\n0 0 0\n1 2 0\n2 0 2\n3 1 0\n4 1 1\n5 0 1\n"}});
  EXPECT_EQ(file.mesh.face_vertex, (std::vector<VertexId>{0, 1, 2}));
  EXPECT_EQ(file.mesh.points.size(), 6U);
}

TEST(ReadEle, EdgesAreSegmentsOrElseMarkedEdges) {
  const std::string edge = "3 1\n1 1 2 1\n2 1 3 0\n3 4 4 1\n", poly = "0 2 0 1\n1 0\n1 2 3\n0\n";
  const Beside nodes = {{"node", kNodes}};
  auto files = nodes;
  files["edge"] = edge;
  expect_edges(read_with(kTriangles, files).edges, {{0, 1}});  // one of no length is none
  files["poly"] = poly;
  expect_edges(read_with(kTriangles, files).edges, {{1, 2}});
  files["poly"] = "3 2\n1 5 5\n2 6 6\n3 7 7\n1 0\n1 2 3\n0\n";  // another drawing
  expect_edges(read_with(kTriangles, files).edges, {{0, 1}});
  files = nodes;
  files["edge"] = "2 0\n1 1 2\n2 1 3\n";
  EXPECT_TRUE(read_with(kTriangles, files).edges.empty());
}

TEST(ReadEle, FindsTheFilesBesideIt) {
  const test::TemporaryFolder folder;
  folder.write("box.1.node", kNodes);
  folder.write("box.1.edge", "1 1\n1 4 1 1\n");
  const auto file = read_mesh(folder.write("box.1.ele", kTriangles));
  EXPECT_EQ(file.mesh.face_count(), 2U);
  expect_edges(file.edges, {{3, 0}});
  try {
    read_mesh(folder.write("alone.ele", kTriangles));
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kFile);
    EXPECT_NE(std::string(error.what()).find("alone.ele: the points are in the .node"),
              std::string::npos);
  }
}

TEST(BadMeshes, Ele) {
  struct Bad {
    std::string ele;
    Beside beside;
    std::string words;
    ErrorCode code = kParse;
    std::vector<std::size_t> culprits = {};
  };
  const Beside good = {{"node", kNodes}};
  const auto with = [&](const std::string& extension, const std::string& text) {
    auto out = good;
    out[extension] = text;
    return out;
  };
  for (const Bad& bad : std::vector<Bad>{
           {kTriangles, {}, "mesh: the points are in the .node", ErrorCode::kFile},
           {"", good, "expected the number of triangles", kParse, {0}},
           {"x\n", good, "'x' is not a count", kParse, {1}},
           {"1 4\n", good, "4 points an element, triangles have 3 or 6", kParse, {1}},
           {"1 3 1001\n", good, "1001 attributes", kParse, {1}},
           {"18446744073709551615 3 1000\n1 1 2 3\n", good, "attribute0 is missing", kParse, {2}},
           {"18446744073709551615\n1 1 2 3\n", good, "expected triangle 2", kParse, {2}},
           {"1\n1 1 2 3\n2 1 2 3\n", good, "more lines than the number", kParse, {3}},
           {"1\n1 1 2\n", good, "a point's number is missing", kParse, {2}},
           {"1\n1 1 2 5\n",
            good,
            "line 2: there is no point 5, the points are 1 to 4",
            kRange,
            {2}},
           {"1\n1 0 2 3\n", good, "there is no point 0", kRange, {2}},
           {"1 3 1\n1 1 2 3 nan\n", good, "'nan' is not a finite", kInfinite, {2}},
           {kTriangles,
            with("node", "1 3\n1 0 0 0\n"),
            "the .node of mesh, line 1: the dimension",
            kParse,
            {1}},
           {kTriangles,
            with("edge", "1 1\n1 1 5 1\n"),
            "the .edge of mesh, line 2: there is no point 5",
            kRange,
            {2}},
           {kTriangles,
            with("poly", "0 2\n2 0\n1 1 2\n"),
            "the .poly of mesh, line 3: the file ends here",
            kParse,
            {3}}}) {
    SCOPED_TRACE(bad.ele + bad.words);
    try {
      read_with(bad.ele, bad.beside);
      ADD_FAILURE() << "no error";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), bad.code) << error.what();
      EXPECT_NE(std::string(error.what()).find(bad.words), std::string::npos) << error.what();
      EXPECT_EQ(error.culprits(), bad.culprits) << error.what();
    }
  }
}

}  // namespace
}  // namespace quadloom::io
