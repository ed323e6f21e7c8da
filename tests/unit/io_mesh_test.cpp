#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include "io/base64.hpp"
#include "io/mesh_formats.hpp"
#include "quadloom/io.hpp"
#include "support/grid_mesh.hpp"
#include "support/mesh_files.hpp"
#include "support/temporary_folder.hpp"

namespace quadloom::io {
namespace {

constexpr double kLeast = std::numeric_limits<double>::denorm_min();
constexpr double kMost = std::numeric_limits<double>::max();

/// A quad, a triangle and a quad over coordinates of every size; no geometry is meant. Every vertex
/// is used, in order, so that formats without vertices keep the numbering.
MeshFile hard_mesh() {
  MeshFile file;
  file.mesh.points = {{0.1, 1.0 / 3},
                      {1e-300, 1e300},
                      {kLeast, -kMost},
                      {-0.0, 5e22},
                      {-7, 2e-310},
                      {1e15 + 0.3, 9007199254740993.0},
                      {123456789.123456789, -1e-5}};
  file.z = {1, 0, -2.5, kLeast, 0.1, -0.0, 1e300};
  file.mesh.add_face(std::array<VertexId, 4>{0, 1, 2, 3});
  file.mesh.add_face(std::array<VertexId, 3>{1, 4, 2});
  file.mesh.add_face(std::array<VertexId, 4>{4, 5, 6, 2});
  return file;
}

class EveryMeshFormat : public ::testing::TestWithParam<MeshFormat> {
 protected:
  std::string format() const { return std::string(GetParam().name); }
  MeshFile there_and_back(const MeshFile& file) const {
    write_mesh(folder_.path("mesh"), file, format());
    EXPECT_EQ(folder_.file_count(), 1U);
    return read_mesh(folder_.path("mesh"), format());
  }

  test::TemporaryFolder folder_;
};

std::vector<MeshFormat> written_formats() {
  std::vector<MeshFormat> out(mesh_formats().begin(), mesh_formats().end());
  std::erase_if(out, [](const MeshFormat& format) { return format.write == nullptr; });
  return out;
}

INSTANTIATE_TEST_SUITE_P(Io, EveryMeshFormat, ::testing::ValuesIn(written_formats()),
                         [](const auto& at) {
                           std::string name(at.param.name);
                           std::erase(name, '-');
                           return name;
                         });

TEST_P(EveryMeshFormat, KeepsEveryBit) {
  expect_same_mesh(hard_mesh(), there_and_back(hard_mesh()));
}

TEST_P(EveryMeshFormat, HeightsOfZeroAreNone) {
  auto file = hard_mesh();
  file.z.clear();
  expect_same_mesh(file, there_and_back(file));
  file.z.assign(file.mesh.points.size(), 0);
  EXPECT_TRUE(there_and_back(file).z.empty());
}

TEST_P(EveryMeshFormat, KeepsABigMesh) {
  MeshFile file;
  file.mesh = test::grid_mesh(70, 50, 3);
  const auto back = there_and_back(file);
  EXPECT_EQ(back.mesh.face_count(), 3500U);
  if (format() != "geojson" && format() != "json") {
    expect_same_mesh(file, back);
    return;
  }
  for (std::size_t i = 0; i < file.mesh.face_vertex.size(); ++i) {  // vertices are renumbered
    EXPECT_EQ(back.mesh.points[back.mesh.face_vertex[i]],
              file.mesh.points[file.mesh.face_vertex[i]]);
  }
}

TEST_P(EveryMeshFormat, KeepsTheDataItCan) {
  auto file = hard_mesh();
  file.vertex_data = {{"height", {1, 2, 3, 4, 5, 6, 7}},
                      {"weight", {0.1, 1e-300, kLeast, -0.0, 1e300, -1, 0}}};
  file.face_data = {{"quality", {0.25, std::nan(""), 1e-17}}};
  const auto back = there_and_back(file);
  const bool both = format() == "ply" || format().starts_with("vtu") || format().starts_with("msh");
  expect_same_data(both ? file.vertex_data : std::vector<Attribute>{}, back.vertex_data);
  expect_same_data(both || format().ends_with("json") ? file.face_data : std::vector<Attribute>{},
                   back.face_data);
}

TEST_P(EveryMeshFormat, PolygonsOfAnyCornersButInMsh) {
  MeshFile file;
  std::vector<VertexId> corners;
  for (VertexId i = 0; i < 300; ++i) {
    file.mesh.points.push_back({std::cos(i * 0.02), std::sin(i * 0.02)});
    corners.push_back(i);
  }
  file.mesh.add_face(corners);
  if (!format().starts_with("msh")) {
    expect_same_mesh(file, there_and_back(file));
    return;
  }
  folder_.write("mesh", "old");
  try {
    write_mesh(folder_.path("mesh"), file, format());
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kBadOption);
    EXPECT_EQ(error.culprits(), std::vector<std::size_t>{0});
  }
  EXPECT_EQ(folder_.read("mesh"), "old");
  EXPECT_EQ(folder_.file_count(), 1U);
}

TEST_P(EveryMeshFormat, RefusesWhatNoFileShouldHold) {
  const auto expect_refused = [&](const MeshFile& file, ErrorCode code) {
    try {
      write_mesh(folder_.path("mesh"), file, format());
      ADD_FAILURE() << static_cast<int>(code);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), code) << error.what();
    }
    EXPECT_EQ(folder_.file_count(), 0U);
  };
  auto file = hard_mesh();
  file.mesh.face_vertex[1] = 7;
  expect_refused(file, ErrorCode::kIndexOutOfRange);
  file = hard_mesh();
  file.mesh.points[3].y = std::nan("");
  expect_refused(file, ErrorCode::kNotFinite);
  file = hard_mesh();
  file.z.pop_back();
  expect_refused(file, ErrorCode::kBadMesh);
  file = hard_mesh();
  file.edges = {{0, 1}, {7, 0}};
  expect_refused(file, ErrorCode::kIndexOutOfRange);
  file = hard_mesh();
  file.face_data = {{"q", {1}}};
  expect_refused(file, ErrorCode::kBadMesh);
  file = hard_mesh();
  file.mesh.add_face(std::array<VertexId, 2>{0, 1});
  expect_refused(file, ErrorCode::kBadMesh);
}

TEST_P(EveryMeshFormat, SurvivesDamage) {
  auto file = hard_mesh();
  file.vertex_data = {{"height", {1, 2, 3, 4, 5, 6, 7}}};
  file.edges = {{0, 1}, {5, 2}};
  write_mesh(folder_.path("mesh"), file, format());
  expect_survives_damage(format(), folder_.read("mesh"));
}

// ---- What else the readers understand. ----

TEST(ReadObj, WhatOthersWrite) {
  for (const char* text :
       {"v 0 0\nv 1 0\nv 1 1\nv 0 1\nf 1 2 3 4",
        "# by hand\r\nmtllib a.mtl\r\no square\r\nv 0 0 0 1\r\nv 1 0 0\r\nv 1 1 0\r\n"
        "v 0 1 0 # last\r\nvn 0 0 1\r\nvt 0 0\r\ng a b\r\nusemtl m\r\ns off\r\n"
        "f 1/1/1 2//1 3/1 4\r\n",
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf -4 -3 \\\n -2 -1\n",
        "f 1 2 3 4\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"}) {
    SCOPED_TRACE(text);
    expect_square(read("obj", text));
  }
}

TEST(ReadObj, LinesGroupsAndMaterials) {
  const auto file =
      read("obj",
           "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nl 1 2 -2 \\\n 5/7\nl 1 1\nf 1 2 3\ng a b\n"
           "f 1 3 4\nusemtl stone\ng\nf 1 2 4\ng a b\nf 2 3 4\nv 2 2 0\n");
  ASSERT_EQ(file.edges.size(), 3U);
  const std::array<std::array<VertexId, 2>, 3> expected = {{{0, 1}, {1, 2}, {2, 4}}};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ((std::array{file.edges[i].from, file.edges[i].to}), expected[i]);
  }
  expect_same_data({{"group", {0, 1, 0, 1}}, {"material", {0, 0, 1, 1}}}, file.face_data);
}

TEST_P(EveryMeshFormat, KeepsTheEdgesItCan) {
  auto file = hard_mesh();
  file.edges = {{2, 1}, {5, 0}, {2, 1}};
  const auto back = there_and_back(file);
  expect_same_mesh(file, back);
  const bool kept = format() == "obj" || format().starts_with("msh") || format().starts_with("vtu");
  ASSERT_EQ(back.edges.size(), kept ? file.edges.size() : 0);
  for (std::size_t i = 0; i < back.edges.size(); ++i) {
    EXPECT_EQ(back.edges[i].from, file.edges[i].from);
    EXPECT_EQ(back.edges[i].to, file.edges[i].to);
  }
}

TEST(ReadOff, WhatOthersWrite) {
  for (const char* text :
       {"OFF\n4 1 4\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n",
        "OFF 4 1\r\n# c\r\n0 0\r\n1 0\r\n\r\n1 1\r\n0 1 # d\r\n4 0 1 2 3 255 0 0\r\n"}) {
    expect_square(read("off", text));
  }
}

/// A .ply of the square in binary, with a colour, a list to skip and an element to skip.
std::string binary_ply(bool big) {
  std::string out = std::string("ply\nformat ") +
                    (big ? "binary_big_endian" : "binary_little_endian") +
                    " 1.0\ncomment x\nelement note 1\nproperty list uchar short words\n"
                    "element vertex 4\nproperty float x\nproperty float y\nproperty uchar red\n"
                    "element face 1\nproperty int16 group\nproperty list uint8 int32 vertex_index\n"
                    "end_header\n";
  const auto put = [&](auto value) {
    auto bytes = std::bit_cast<std::array<char, sizeof(value)>>(value);
    if (big) std::ranges::reverse(bytes);
    out.append(bytes.data(), bytes.size());
  };
  put(std::uint8_t{2});
  put(std::int16_t{7});
  put(std::int16_t{8});
  for (const auto& [x, y] : {std::array{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
    put(static_cast<float>(x));
    put(static_cast<float>(y));
    put(std::uint8_t{200});
  }
  put(std::int16_t{-3});
  put(std::uint8_t{4});
  for (int i = 0; i < 4; ++i) put(i);
  return out;
}

TEST(ReadPly, BinaryOfBothByteOrders) {
  for (const bool big : {false, true}) {
    const auto file = read("ply", binary_ply(big));
    expect_square(file);
    expect_same_data({{"red", {200, 200, 200, 200}}}, file.vertex_data);
    expect_same_data({{"group", {-3}}}, file.face_data);
    for (std::size_t cut = 1; cut < 60; ++cut) {
      const auto text = binary_ply(big);
      EXPECT_THROW(read("ply", text.substr(0, text.size() - cut)), Error);
    }
    EXPECT_THROW(read("ply", binary_ply(big) + "x"), Error);
  }
}

TEST(WritePly, NamesAreMadeToFit) {
  const test::TemporaryFolder folder;
  auto file = hard_mesh();
  file.face_data = {{"a b", {1, 2, 3}}, {"x", {1, 2, 3}}, {"a_b", {1, 2, 3}}, {"", {1, 2, 3}}};
  write_mesh(folder.path("m.ply"), file);
  const auto back = read_mesh(folder.path("m.ply"));
  ASSERT_EQ(back.face_data.size(), 4U);
  EXPECT_EQ(back.face_data[0].name, "a_b");
  EXPECT_EQ(back.face_data[1].name, "x_");
  EXPECT_EQ(back.face_data[2].name, "a_b_");
  EXPECT_EQ(back.face_data[3].name, "data");
}

std::string vtu(const std::string& cells, const std::string& head = "byte_order=\"LittleEndian\"") {
  return "<VTKFile type=\"UnstructuredGrid\" " + head +
         "><!-- c --><UnstructuredGrid><Piece NumberOfPoints=\"4\" NumberOfCells=\"1\"><Points>"
         "<DataArray type=\"Float32\" NumberOfComponents=\"3\" format=\"ascii\">0 0 0 1 0 0\n1 1 0 "
         "0 1 0"
         "</DataArray></Points><Cells>" +
         cells + "</Cells></Piece></UnstructuredGrid></VTKFile>";
}

std::string cell_arrays(const std::string& connectivity, const std::string& offsets,
                        const std::string& types) {
  const auto array = [](const std::string& name, const std::string& text) {
    return "<DataArray type=\"Int32\" Name=\"" + name + "\" format=\"ascii\">" + text +
           "</DataArray>";
  };
  return array("connectivity", connectivity) + array("offsets", offsets) + array("types", types);
}

TEST(ReadVtu, WhatOthersWrite) {
  expect_square(read("vtu", vtu(cell_arrays("0 1 2 3", "4", "9"))));
  expect_square(read("vtu", vtu(cell_arrays("0 1 2 3", "4", "7"))));
  expect_square(read("vtu", vtu(cell_arrays("0 1 3 2", "4", "8"))));
  // Offsets in big-endian base64 with a header of 32 bits, encoded in two pieces.
  const std::string offsets = "<DataArray type=\"Int32\" Name=\"offsets\" format=\"binary\"> " +
                              to_base64(std::string("\0\0\0\4", 4)) + "\n" +
                              to_base64(std::string("\0\0\0\4", 4)) + "</DataArray>";
  expect_square(
      read("vtu", vtu(offsets + cell_arrays("0 1 2 3", "", "9"), "byte_order=\"BigEndian\"")));
}

TEST(WriteVtu, NamesAreEscaped) {
  const test::TemporaryFolder folder;
  auto file = hard_mesh();
  file.face_data = {{"a <b> & \"c\"", {1, 2, 3}}};
  for (const char* format : {"vtu", "vtu-ascii"}) {
    write_mesh(folder.path("m.vtu"), file, format);
    expect_same_data(file.face_data, read_mesh(folder.path("m.vtu")).face_data);
  }
}

TEST(ReadMsh, WhatGmshWrites) {
  expect_square(
      read("msh",
           "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n2 1 \"a b\"\n"
           "$EndPhysicalNames\n$Entities\n1 0 1 0\n1 0 0 0 0\n1 0 0 0 1 1 0 0 0\n$EndEntities\n"
           "$Nodes\n2 4 1 40\n0 1 0 1\n40\n0 0 0\n2 1 1 3\n1\n7\n9\n1 0 0 0.5 0.5\n"
           "1 1 0 .5 .5\n0 1 0 .5 .5\n$EndNodes\n"
           "$Elements\n2 2 1 2\n0 1 15 1\n1 40\n2 1 3 1\n2 40 1 7 9\n$EndElements\n"));
  expect_square(
      read("msh",
           "$MeshFormat\r\n2.2 0 8\r\n$EndMeshFormat\r\n$Nodes\r\n4\r\n5 0 0 0\r\n6 1 0 0\r\n"
           "8 1 1 0\r\n7 0 1 0\r\n$EndNodes\r\n$Elements\r\n3\r\n1 15 2 0 1 5\r\n2 1 2 0 1 5 6\r\n"
           "3 3 2 0 1 5 6 8 7\r\n$EndElements\r\n$Periodic\r\n1\r\n\"x\"\r\n$EndPeriodic\r\n"));
}

TEST(ReadGeojsonMesh, MultiPolygonsAndProperties) {
  const auto file = read("geojson",
                         R"({"type":"FeatureCollection","features":[
      {"type":"Feature","properties":{"q":1,"r":5,"name":"x"},"geometry":{"type":"Polygon","coordinates":
        [[[0,0,1],[1,0,2],[1,1,3],[0,1,4],[0,0,9]]]}},
      {"type":"Feature","geometry":{"type":"MultiPolygon","coordinates":
        [[[[1,0,7],[2,0,8],[1,1],[1,0]]],[[[1,1],[2,0],[2,2],[1,1]]]]},"properties":{"q":null,"s":2}}]})");
  EXPECT_EQ(file.mesh.points.size(), 6U);
  EXPECT_EQ(file.mesh.face_vertex, (std::vector<VertexId>{0, 1, 2, 3, 1, 4, 2, 2, 4, 5}));
  EXPECT_EQ(file.z, (std::vector<double>{1, 2, 3, 4, 8, 0}));
  expect_same_data({{"q", {1, std::nan(""), std::nan("")}}}, file.face_data);
}

// ---- Faults. ----

TEST(BadMeshes, Obj) {
  for (const BadFile& bad : std::vector<BadFile>{
           {"obj", "", "no vertices"},
           {"obj", "v 0\n", "line 1: y is missing", kParse, {1}},
           {"obj", "v 0 0 q\n", "'q' is not a number, expected z", kParse, {1}},
           {"obj", "v 0 nan\n", "'nan' is not a finite number", kInfinite, {1}},
           {"obj", "v 0 1e400\n", "'1e400'", kInfinite, {1}},
           {"obj", "v 0 0\nf 1 2\n", "line 2: a face of 2 corners", kParse, {2}},
           {"obj", "v 0 0\nf\n", "a face of 0 corners", kParse, {2}},
           {"obj", "v 0 0\nf 1 0 1\n", "line 2: '0' is no vertex", kParse, {2}},
           {"obj", "v 0 0\nf 1 -2 1\n", "'-2' is no vertex", kParse, {2}},
           {"obj", "v 0 0\nf 1 a/b 1\n", "'a/b' is no vertex", kParse, {2}},
           {"obj", "v 0 0\nf 1 1.5 1\n", "'1.5' is no vertex", kParse, {2}},
           {"obj",
            "v 0 0\nf 1 1 1\nf 1 9 1\n",
            "line 3: face 2 names vertex 9, there are 1",
            kRange,
            {1, 8}},
           {"obj",
            "v 0 0\nf 1 1 9223372036854775807\n",
            "there are 1",
            kRange,
            {0, 9223372036854775806U}},
           {"obj", "v 0 0\nf 1 1 9223372036854775808\n", "is no vertex", kParse, {2}},
           {"obj", "v 0 0\nl 1\n", "line 2: a line of 1 vertices", kParse, {2}},
           {"obj", "v 0 0\nl 1 x\n", "'x' is no vertex of a line", kParse, {2}},
           {"obj",
            "v 0 0\n\nl 1 2\n",
            "line 3: edge 1 names vertex 2, there are 1",
            kRange,
            {0, 1}},
           {"obj", "hello world\n", "'hello' starts no line", kParse, {1}},
           {"obj", "v 0 0\nf 1 2 \\", "a face of 2 corners", kParse, {2}}}) {
    expect_fault(bad);
  }
}

TEST(BadMeshes, Off) {
  for (const BadFile& bad : std::vector<BadFile>{
           {"off", "", "the file ends here, expected the word OFF", kParse, {0}},
           {"off", "COFF\n1 0 0\n", "'COFF' instead", kParse, {1}},
           {"off", "OFF\n", "expected the counts", kParse, {1}},
           {"off", "OFF\nx y\n", "'x' is not a count", kParse, {2}},
           {"off", "OFF\n4\n", "expected the count of faces", kParse, {2}},
           {"off", "OFF\n-1 0 0\n", "'-1' is not a count", kParse, {2}},
           {"off",
            "OFF\n18446744073709551615 18446744073709551615 0\n0 0 0\n",
            "expected vertex 1",
            kParse,
            {3}},
           {"off", "OFF\n18446744073709551616 1 0\n", "is not a count", kParse, {2}},
           {"off", "OFF\n1 1 0\n0 0 0\n", "expected face 0 of 1", kParse, {3}},
           {"off", "OFF\n1 1 0\n0 0 0\n3 0 0\n", "expected a corner", kParse, {4}},
           {"off", "OFF\n1 1 0\n0 0 0\n99999999999999 0 0\n", "expected a corner", kParse, {4}},
           {"off", "OFF\n1 1 0\n0 0 0\n2 0 0\n", "a face of 2 corners", kParse, {4}},
           {"off", "OFF\n1 1 0\n0 0 0\n3 0 1 0\n", "names vertex 1, there are 1", kRange, {0, 1}},
           {"off", "OFF\n1 0 0\n0 inf 0\n", "'inf' is not a finite", kInfinite, {3}},
           {"off", "OFF\n1 0 0\n0 0 0\n1 1 1\n", "more lines than the counts say", kParse, {4}}}) {
    expect_fault(bad);
  }
}

TEST(BadMeshes, Ply) {
  const std::string start = "ply\nformat ascii 1.0\n";
  const std::string vertex = start + "element vertex 1\nproperty double x\nproperty double y\n";
  const std::string face =
      vertex + "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0\n";
  for (const BadFile& bad : std::vector<BadFile>{
           {"ply", "", "the first line is not 'ply'"},
           {"ply", "plyx\n", "the first line"},
           {"ply", start, "the header does not end", kParse, {2}},
           {"ply", "ply\nformat xml 1.0\n", "'xml' is no format", kParse, {2}},
           {"ply", start + "element vertex\n", "an element without a count", kParse, {3}},
           {"ply", start + "element vertex -1\n", "without a count", kParse, {3}},
           {"ply", start + "property int x\n", "before the first element", kParse, {3}},
           {"ply", start + "element vertex 1\nproperty real x\n", "'real' is no type", kParse, {4}},
           {"ply", start + "element vertex 1\nproperty int\n", "without a name", kParse, {4}},
           {"ply", start + "element vertex 1\nproperty list int\n", "'' is no type", kParse, {4}},
           {"ply", start + "elements vertex 1\n", "'elements' starts no line", kParse, {3}},
           {"ply", vertex + "element vertex 1\n", "occurs twice", kParse, {6}},
           {"ply", start + "end_header\n", "no element vertex"},
           {"ply", start + "element vertex 1\nproperty int x\nend_header\n1\n",
            "without the numbers x and y"},
           {"ply",
            start + "element vertex 1\nproperty list int int x\nproperty int y\nend_header\n",
            "without the numbers x and y"},
           {"ply",
            vertex + "end_header\n1\n",
            "the file ends here, expected a vertex coordinate",
            kParse,
            {8}},
           {"ply", vertex + "end_header\n1 q\n", "'q' is not a number", kParse, {7}},
           {"ply",
            vertex + "end_header\n1 nan\n",
            "a vertex coordinate is not finite",
            kInfinite,
            {7}},
           {"ply", vertex + "end_header\n1 2 3\n", "more data than the header says", kParse, {7}},
           {"ply",
            start + "element vertex 18446744073709551615\nproperty int x\nproperty int "
                    "y\nend_header\n1 2",
            "the file ends here",
            kParse,
            {7}},
           {"ply",
            start + "element junk 18446744073709551615\nelement vertex 0\nproperty int x\n"
                    "property int y\nend_header\n1",
            "more data",
            kParse,
            {8}},
           {"ply", vertex + "element face 1\nproperty int a\nend_header\n0 0\n1\n",
            "without the list"},
           {"ply", face + "2 0 0\n", "a face of 2 corners", kParse, {10}},
           {"ply", face + "-1 0 0\n", "-1 is not a count", kParse, {10}},
           {"ply", face + "3 0 0.5 0\n", "0.5 is not a count", kParse, {10}},
           {"ply", face + "3 0 1 0\n", "face 0 names vertex 1, there are 1", kRange, {0, 1}},
           {"ply", face + "4000000000 0 1 0\n", "the file ends here", kParse, {11}},
           {"ply",
            "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty double x\nproperty "
            "double y\n"
            "end_header\n1234567",
            "the file ends here, expected a vertex coordinate"}}) {
    expect_fault(bad);
  }
}

TEST(BadMeshes, Vtu) {
  const auto cells = cell_arrays("0 1 2 3", "4", "9");
  const auto replaced = [&](const std::string& what, const std::string& by) {
    auto text = vtu(cells);
    return text.replace(text.find(what), what.size(), by);
  };
  const std::string binary = "<DataArray type=\"Int32\" Name=\"connectivity\" format=\"binary\">";
  for (const BadFile& bad : std::vector<BadFile>{
           {"vtu", "", "no well-formed XML", kParse, {1}},
           {"vtu", "<a>\n<b>\n</a>", "no well-formed XML", kParse, {3}},
           {"vtu", "<a/>", "no element VTKFile"},
           {"vtu", replaced("UnstructuredGrid", "PolyData"), "of type 'PolyData'"},
           {"vtu", vtu(binary + "AAAA</DataArray>" + cells, "compressor=\"vtkLZ4DataCompressor\""),
            "'connectivity' is compressed by 'vtkLZ4DataCompressor'; only vtkZLibDataCompressor"},
           {"vtu", "<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid/></VTKFile>",
            "no element Piece"},
           {"vtu", replaced("NumberOfPoints=\"4\"", ""), "no NumberOfPoints"},
           {"vtu", replaced("NumberOfPoints=\"4\"", "NumberOfPoints=\"99999999999999999\""),
            "12 coordinates for"},
           {"vtu", replaced("NumberOfCells=\"1\"", "NumberOfCells=\"2\""),
            "'offsets' has 1 numbers, expected 2"},
           {"vtu", replaced("<Piece", "<Piece/><Piece"), "more than one piece"},
           {"vtu", replaced("Points>", "Pints>"), "no well-formed XML", kParse, {2}},
           {"vtu", replaced("0 0 0 1", "0 0 nan 1"), "point 0 is not finite", kInfinite},
           {"vtu", replaced("0 0 0 1", "0 0 zero 1"), "'zero' in the array '' is not a number"},
           {"vtu", replaced("0 0 0 1", "0 0 1"), "11 coordinates for 4 points"},
           {"vtu", vtu("<a/>"), "no DataArray connectivity"},
           {"vtu",
            vtu(cell_arrays("0 1 2 4", "4", "9")),
            "names vertex 4, there are 4",
            kRange,
            {0, 4}},
           {"vtu", vtu(cell_arrays("0 1 2 -1", "4", "9")), "-1 is no entry of connectivity"},
           {"vtu", vtu(cell_arrays("0 1 2 1.5", "4", "9")), "1.5 is no entry of connectivity"},
           {"vtu", vtu(cell_arrays("0 1 2 3", "5", "9")), "offset 0 is out of order"},
           {"vtu", vtu(cell_arrays("0 1 2 3", "3", "9")), "cell 0 of type 9 has 3 points"},
           {"vtu", vtu(cell_arrays("0 1 2 3", "4", "12")), "cell 0 has the type 12"},
           {"vtu", vtu(cell_arrays("0 1 2 3", "0", "7")), "a face of 0 corners"},
           {"vtu", vtu(binary + "!!!!</DataArray>" + cells), "'connectivity' is no base64"},
           {"vtu", vtu(binary + "AAA=</DataArray>" + cells), "has 2 bytes, its header needs 4"},
           {"vtu", vtu(binary + "/////wAAAAA=</DataArray>" + cells),
            "'connectivity' has a header that says 4294967295 bytes"},
           {"vtu", replaced("\"ascii\"", "\"appended\""), "'' has no offset into"},
           {"vtu", replaced("\"ascii\"", "\"xml\""), "has the format 'xml', only ascii"},
           {"vtu",
            vtu("<DataArray type=\"String\" Name=\"connectivity\" "
                "format=\"binary\">AAAA</DataArray>"),
            "'String' is no type"}}) {
    expect_fault(bad);
  }
}

TEST(BadMeshes, Msh) {
  const std::string v41 = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n",
                    v22 = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
  const std::string node = v22 + "$Nodes\n1\n1 0 0 0\n$EndNodes\n";
  for (const BadFile& bad : std::vector<BadFile>{
           {"msh", "", "does not begin with $MeshFormat", kParse, {1}},
           {"msh", "$MeshFormat\n4 0 8\n", "version '4' of .msh", kParse, {2}},
           {"msh", "$MeshFormat\n4.1 2 8\n", "file type 2, there are 0 and 1", kParse, {2}},
           {"msh",
            "$MeshFormat\n4.1 0 8\n$Nodes",
            "'$Nodes', expected $EndMeshFormat",
            kParse,
            {3}},
           {"msh", v41, "no nodes"},
           {"msh", v41 + "hello\n", "'hello' where a section should begin", kParse, {4}},
           {"msh", v41 + "$Stuff\n1 2 3\n", "the file ends here, expected $EndStuff", kParse, {6}},
           {"msh",
            v22 + "$Nodes\n1\n1 0 0\n$EndNodes\n",
            "'$EndNodes' is not a number",
            kParse,
            {7}},
           {"msh",
            v22 + "$Nodes\n1\n1 0 inf 0\n$EndNodes\n",
            "'inf' is not a finite",
            kInfinite,
            {6}},
           {"msh",
            v22 + "$Nodes\n2\n1 0 0 0\n1 1 0 0\n$EndNodes\n",
            "node 1 is there twice",
            kParse,
            {8}},
           {"msh",
            v22 + "$Nodes\n18446744073709551615\n1 0 0 0\n",
            "the file ends here",
            kParse,
            {7}},
           {"msh",
            v22 + "$Nodes\n1\n1 0 0 0\n2 0 0 0\n$EndNodes\n",
            "'2', expected $EndNodes",
            kParse,
            {7}},
           {"msh",
            node + "$Elements\n1\n1 3 0 1 1 1 2\n",
            "element names node 2, which is not there",
            kRange,
            {0, 2}},
           {"msh", node + "$Elements\n1\n1 3 0 1 1 1 0\n", "names node 0", kRange, {0, 0}},
           {"msh", node + "$Elements\n1\n1 4 0 1 1 1 1\n", "elements of type 4", kParse, {10}},
           {"msh",
            node + "$Elements\n1\n1 3 99999999999 1 1 1\n",
            "the file ends here",
            kParse,
            {11}},
           {"msh",
            v41 + "$Nodes\n1 1 1 1\n2 1 0 1\n1\n",
            "the file ends here, expected x",
            kParse,
            {8}},
           {"msh",
            v41 + "$Nodes\n99999999999 1 1 1\n2 1 0 99999999999999\n1\n",
            "the file ends here",
            kParse,
            {8}},
           {"msh",
            v41 + "$Nodes\n1 1 1 1\n2 1 1 1\n1\n0 0 0 0\n$EndNodes\n",
            "is not a number, expected a parameter",
            kParse,
            {9}}}) {
    expect_fault(bad);
  }
}

TEST(BadMeshes, Geojson) {
  const auto polygon = [](const std::string& rings) {
    return R"({"type":"Polygon","coordinates":)" + rings + "}";
  };
  for (const BadFile& bad : std::vector<BadFile>{
           {"geojson", "", "line 1", kParse, {1}},
           {"geojson", "{\n\"type\":}", "line 2", kParse, {2}},
           {"geojson", R"({"type":"FeatureCollection","features":[]})", "no polygons"},
           {"geojson", R"({"type":"Point","coordinates":[1,2]})", "it holds a Point"},
           {"geojson", polygon("[]"), "no polygons"},
           {"geojson", polygon("[[[0,0],[1,0],[0,0]]]"), "is not closed or has fewer"},
           {"geojson", polygon("[[[0,0],[1,0],[1,1],[0,1]]]"),
            "the ring of polygon 0 is not closed"},
           {"geojson", polygon("[[[0,0],[1,0],[1,1],[0,0]],[[0,0],[1,0],[1,1],[0,0]]]"),
            "polygon 0 has 2 rings"},
           {"geojson", polygon("[[0,0],[1,0],[1,1],[0,0]]"), "not those of a Polygon"},
           {"geojson", polygon("[[[0],[1],[1],[0]]]"), "not those of a Polygon"},
           {"geojson", polygon("[[[0,1e999]]]"), "1e999", kInfinite, {1}}}) {
    expect_fault(bad);
  }
}

TEST(MeshFormats, UnknownOnesAreNamed) {
  const test::TemporaryFolder folder;
  for (const char* name : {"mesh.step", "mesh", "folder.obj/mesh"}) {
    try {
      write_mesh(folder.path(name), hard_mesh());
      ADD_FAILURE() << name;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kBadOption);
      EXPECT_NE(std::string(error.what()).find("obj, off, ply, vtu, msh, geojson"),
                std::string::npos);
    }
  }
  EXPECT_THROW(read_mesh(folder.path("a.obj"), "step"), Error);
  EXPECT_THROW(read_mesh(folder.path("a.obj")), Error);
}

TEST(MeshFormats, SomeAreOnlyRead) {
  const test::TemporaryFolder folder;
  for (const auto& known : mesh_formats()) {
    if (known.write != nullptr) continue;
    try {
      require_mesh_format(folder.path("mesh." + std::string(known.name)));
      ADD_FAILURE() << known.name;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kBadOption);
      EXPECT_NE(std::string(error.what()).find("but not written to it; written are obj, off"),
                std::string::npos)
          << error.what();
    }
  }
}

TEST(Base64, ThereAndBack) {
  std::string bytes, back;
  for (int i = 0; i < 300; ++i) {
    EXPECT_TRUE(from_base64(to_base64(bytes), back));
    EXPECT_EQ(back, bytes);
    bytes += static_cast<char>(i * 7);
  }
  EXPECT_EQ(to_base64("Man"), "TWFu");
  EXPECT_EQ(to_base64("Ma"), "TWE=");
  EXPECT_EQ(to_base64("M"), "TQ==");
  for (const char* bad : {"A", "AA", "AAA", "=", "A===", "AA=A", "AA=", "AA.A", "====", "AAA=="}) {
    EXPECT_FALSE(from_base64(bad, back)) << bad;
  }
}

}  // namespace
}  // namespace quadloom::io
