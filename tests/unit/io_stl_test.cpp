#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include "support/mesh_files.hpp"

namespace quadloom::io {
namespace {

std::string facet(const std::string& a, const std::string& b, const std::string& c) {
  return "facet normal 0 0 1\n outer loop\n  vertex " + a + "\n  vertex " + b + "\n  vertex " + c +
         "\n endloop\nendfacet\n";
}

std::string solid(const std::string& facets, const std::string& name = "") {
  return "solid " + name + "\n" + facets + "endsolid " + name + "\n";
}

using Facet = std::array<float, 9>;

std::string binary_stl(const std::vector<Facet>& facets, const std::string& header = "solid x",
                       std::uint16_t attribute = 0) {
  std::string out = header;
  out.resize(80, ' ');
  const auto put = [&](auto value) {
    auto bytes = std::bit_cast<std::array<char, sizeof(value)>>(value);
    if (std::endian::native == std::endian::big) std::ranges::reverse(bytes);
    out.append(bytes.data(), bytes.size());
  };
  put(static_cast<std::uint32_t>(facets.size()));
  for (const Facet& facet : facets) {
    for (int i = 0; i < 3; ++i) put(0.0F);
    for (const float x : facet) put(x);
    put(attribute);
  }
  return out;
}

const std::vector<Facet> kTwo = {{0, 0, 0, 1, 0, 0, 1, 1, 2}, {1, 1, 2, 0, 1, 0, -0.0F, 0, 0}};

void expect_two(const MeshFile& file) {
  EXPECT_EQ(file.mesh.points, (std::vector<Point>{{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
  EXPECT_EQ(file.z, (std::vector<double>{0, 0, 2, 0}));
  EXPECT_EQ(file.mesh.face_begin, (std::vector<std::uint32_t>{0, 3, 6}));
  EXPECT_EQ(file.mesh.face_vertex, (std::vector<VertexId>{0, 1, 2, 2, 3, 0}));
}

TEST(ReadStl, TextAndBinaryMergeTheSamePlaces) {
  const auto file = read(
      "stl", solid(facet("0 0 0", "1 0 0", "1 1 2") + facet("1.0 10e-1 +2", "0 1 0", "-0 0 0")));
  expect_two(file);
  EXPECT_TRUE(file.face_data.empty());
  expect_two(read("stl",
                  "SOLID\r\n\tFacet Normal 0 0 1\r\nOUTER LOOP\r\nVERTEX 0 0 0\r\nvertex 1 0 0\r\n"
                  "vertex 1 1 2\r\nendloop\r\nendfacet\r\n\r\n" +
                      facet("1 1 2", "0 1 0", "0 0 0") + "endsolid"));
  for (const char* header : {"solid of a binary file", "exported", ""}) {
    const auto binary = read("stl", binary_stl(kTwo, header));
    expect_two(binary);
    EXPECT_TRUE(binary.face_data.empty());
  }
  expect_same_data({{"attribute", {77, 77}}}, read("stl", binary_stl(kTwo, "", 77)).face_data);
}

TEST(ReadStl, PlacesThatDifferInTheLastBitStayApart) {
  const auto file =
      read("stl", solid(facet("0 0 0", "1 0 0", "0 1 0") + facet("0 0 5e-324", "1 0 0", "0 1 0")));
  EXPECT_EQ(file.mesh.points.size(), 4U);
  const float next = std::nextafter(1.0F, 2.0F);
  const auto binary =
      read("stl", binary_stl({{0, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 0, 0, next, 0, 0, 0, 1, 0}}));
  EXPECT_EQ(binary.mesh.points.size(), 4U);
}

TEST(ReadStl, FacetsWithACornerTwiceAreLeftOut) {
  const auto file =
      read("stl", solid(facet("0 0 0", "0 0 0", "1 0 0") + facet("0 0 0", "1 0 0", "0 1 0") +
                        facet("0 1 0", "2 2 0", "0 1 0")));
  EXPECT_EQ(file.mesh.face_count(), 1U);
  EXPECT_EQ(file.faces_left_out, 2U);
  EXPECT_EQ(file.mesh.points.size(), 4U);
  EXPECT_TRUE(file.z.empty());
}

TEST(ReadStl, SolidsAreFaceData) {
  const auto file = read("stl", solid(facet("0 0 0", "1 0 0", "0 1 0"), "facet endsolid") +
                                    solid("", "nothing") + solid(facet("1 0 0", "1 1 0", "0 1 0")));
  expect_same_data({{"solid", {0, 2}}}, file.face_data);
  EXPECT_EQ(file.mesh.points.size(), 4U);
}

TEST(ReadStl, SurvivesDamage) {
  expect_survives_damage("stl", binary_stl(kTwo));
  expect_survives_damage(
      "stl", solid(facet("0 0 0", "1 0 0", "1 1 2")) + solid(facet("0 0 0", "1 0 0", "1 1 2")));
}

TEST(BadMeshes, Stl) {
  auto infinite = kTwo;
  infinite[1][4] = std::numeric_limits<float>::infinity();
  auto many = binary_stl(kTwo, "x");
  many.replace(80, 4, "\xff\xff\xff\xff");
  const std::string vertices =
      "solid\nfacet\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n";
  for (const BadFile& bad : std::vector<BadFile>{
           {"stl", "", "neither a text that begins with the word solid nor binary"},
           {"stl", many, "4294967295 facets take 214748364834 bytes, there are 184"},
           {"stl", binary_stl(kTwo, "x") + "y", "2 facets take 184 bytes, there are 185"},
           {"stl", binary_stl(infinite), "facet 1 has a corner that is not finite", kInfinite, {1}},
           {"stl", binary_stl({}), "no facets"},
           {"stl", "solid\nendsolid\n", "no facets"},
           {"stl", "solid\n", "the file ends here, expected a facet", kParse, {1}},
           {"stl", "solid\nfacets\n", "'facets' instead of a facet", kParse, {2}},
           {"stl", "solid\nfacet\nouter lop\n", "'lop' instead of the word loop", kParse, {3}},
           {"stl", "solid\nfacet\nouter loop\nvertex 0 0\n", "z is missing", kParse, {4}},
           {"stl",
            "solid\nfacet\nouter loop\nvertex 0 nan 0\n",
            "'nan' is not a finite",
            kInfinite,
            {4}},
           {"stl",
            vertices + "vertex 1 1 0\n",
            "'vertex' instead of the word endloop",
            kParse,
            {7}},
           {"stl", vertices + "endloop\n", "expected the word endfacet", kParse, {7}},
           {"stl", "solid\nendsolid\nfacet\n", "'facet' instead of the word solid", kParse, {3}}}) {
    expect_fault(bad);
  }
}

}  // namespace
}  // namespace quadloom::io
