// Gmsh's .msh: binary files, groups, lines and data. Faults of text files are in io_mesh_test.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "support/mesh_files.hpp"
#include "support/temporary_folder.hpp"

namespace quadloom::io {
namespace {

/// Binary numbers of either byte order.
class Bytes {
 public:
  explicit Bytes(bool big) : swap_(big == (std::endian::native == std::endian::little)) {}

  Bytes& text(const std::string& words) {
    out_ += words;
    return *this;
  }
  template <class T>
  Bytes& put(std::initializer_list<T> values) {
    for (const T value : values) {
      auto bytes = std::bit_cast<std::array<char, sizeof(T)>>(value);
      if (swap_) std::ranges::reverse(bytes);
      out_.append(bytes.data(), bytes.size());
    }
    return *this;
  }
  Bytes& ints(std::initializer_list<std::int32_t> values) { return put(values); }
  Bytes& reals(std::initializer_list<double> values) { return put(values); }
  const std::string& str() const { return out_; }

 private:
  bool swap_;
  std::string out_;
};

/// Two triangles and a quad in two surfaces, a point and two lines, data of both kinds.
template <class Size>
std::string binary41(bool big) {
  Bytes b(big);
  const auto sizes = [&](std::initializer_list<Size> values) { b.put(values); };
  b.text("$MeshFormat\n4.1 1 " + std::to_string(sizeof(Size)) + "\n").ints({1});
  b.text("\n$EndMeshFormat\n$PhysicalNames\n1\n2 7 \"a $ b\"\n$EndPhysicalNames\n$Entities\n");
  sizes({1, 1, 2, 0});
  b.ints({1}).reals({0, 0, 0});
  sizes({0});
  b.ints({1}).reals({0, 0, 0, 1, 0, 0});
  sizes({1});
  b.ints({9});
  sizes({2});
  b.ints({1, -2});
  b.ints({4}).reals({0, 0, 0, 1, 1, 0});
  sizes({2});
  b.ints({7, 8});
  sizes({0});
  b.ints({5}).reals({0, 0, 0, 1, 1, 0});
  sizes({0});
  sizes({0});
  b.text("\n$EndEntities\n$Nodes\n");
  sizes({2, 6, 1, 60});
  b.ints({0, 1, 0});
  sizes({1, 60});
  b.reals({0, 0, 0});
  b.ints({2, 4, 1});
  sizes({5, 1, 2, 3, 4, 5});
  for (const auto& [x, y] : {std::array{1, 0}, {1, 1}, {0, 1}, {2, 0}, {2, 1}}) {
    b.reals({static_cast<double>(x), static_cast<double>(y), 0, 0.5, 0.5});
  }
  b.text("\n$EndNodes\n$Elements\n");
  sizes({4, 6, 1, 15});
  b.ints({0, 1, 15});
  sizes({1, 10, 60});
  b.ints({1, 1, 1});
  sizes({2, 11, 60, 1, 12, 1, 4});
  b.ints({2, 4, 2});
  sizes({2, 13, 60, 1, 2, 14, 60, 2, 3});
  b.ints({2, 5, 3});
  sizes({1, 15, 1, 4, 5, 2});
  b.text("\n$EndElements\n$NodeData\n1\n\"a b\"\n1\n0.0\n3\n0\n1\n2\n").ints({60}).reals({0.25});
  b.ints({5}).reals({-1}).text("\n$EndNodeData\n$ElementData\n1\n\"q\"\n1\n0\n3\n0\n1\n2\n");
  b.ints({15}).reals({3}).ints({11}).reals({8}).text("\n$EndElementData\n");
  return b.str();
}

std::string binary22(bool big) {
  Bytes b(big);
  b.text("$MeshFormat\n2.2 1 8\n").ints({1}).text("\n$EndMeshFormat\n$Nodes\n6\n");
  const std::array<std::array<int, 3>, 6> nodes = {
      {{60, 0, 0}, {1, 1, 0}, {2, 1, 1}, {3, 0, 1}, {4, 2, 0}, {5, 2, 1}}};
  for (const auto& [number, x, y] : nodes) {
    b.ints({number}).reals({static_cast<double>(x), static_cast<double>(y), 0});
  }
  b.text("\n$EndNodes\n$Elements\n6\n");
  b.ints({15, 1, 2, 10, 0, 1, 60});
  b.ints({1, 2, 3, 11, 9, 1, 0, 60, 1, 12, 9, 1, 0, 1, 4});
  b.ints({2, 2, 2, 13, 7, 4, 60, 1, 2, 14, 7, 4, 60, 2, 3});
  b.ints({3, 1, 2, 15, 0, 5, 1, 4, 5, 2});
  b.text("\n$EndElements\n$NodeData\n1\n\"a b\"\n1\n0.0\n3\n0\n1\n2\n").ints({60}).reals({0.25});
  b.ints({5}).reals({-1}).text("\n$EndNodeData\n$ElementData\n1\n\"q\"\n1\n0\n3\n0\n1\n1\n");
  b.ints({15}).reals({3}).text("\n$EndElementData\n");
  return b.str();
}

std::vector<std::string> binary_files() {
  std::vector<std::string> out;
  for (const bool big : {false, true}) {
    out.push_back(binary41<std::uint64_t>(big));
    out.push_back(binary41<std::uint32_t>(big));
    out.push_back(binary22(big));
  }
  return out;
}

void expect_edges(const std::vector<Segment>& a, const std::vector<Segment>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].from, b[i].from);
    EXPECT_EQ(a[i].to, b[i].to);
  }
}

TEST(ReadMsh, BinaryOfBothByteOrders) {
  const double nan = std::nan("");
  for (const std::string& text : binary_files()) {
    const auto file = read("msh", text);
    EXPECT_EQ(file.mesh.points,
              (std::vector<Point>{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {2, 0}, {2, 1}}));
    EXPECT_EQ(file.mesh.face_begin, (std::vector<std::uint32_t>{0, 3, 6, 10}));
    EXPECT_EQ(file.mesh.face_vertex, (std::vector<VertexId>{0, 1, 2, 0, 2, 3, 1, 4, 5, 2}));
    expect_edges(file.edges, {{0, 1}, {1, 4}});
    expect_same_data({{"a b", {0.25, nan, nan, nan, nan, -1}}}, file.vertex_data);
    expect_same_data({{"physical", {7, 7, 0}}, {"entity", {4, 4, 5}}, {"q", {nan, nan, 3}}},
                     file.face_data);
  }
}

TEST(ReadMsh, BinaryCutAnywhereIsRefused) {
  for (const std::string& text : binary_files()) {
    std::size_t read_whole = 0;
    for (std::size_t size = 0; size < text.size(); ++size) {
      try {
        read("msh", text.substr(0, size));
        ++read_whole;
      } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("mesh"), std::string::npos);
      }
    }
    EXPECT_LT(read_whole, 10U);  // between sections only
    expect_survives_damage("msh", text);
  }
}

TEST(ReadMsh, SecondOrderElementsByTheirCorners) {
  const auto file =
      read("msh",
           "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n9\n1 0 0 0\n2 2 0 0\n3 2 2 0\n4 0 2 0\n"
           "5 1 0 0\n6 2 1 0\n7 1 2 0\n8 0 1 0\n9 1 1 0\n$EndNodes\n$Elements\n4\n"
           "1 10 0 1 2 3 4 5 6 7 8 9\n2 16 0 1 2 3 4 5 6 7 8\n3 9 0 1 2 3 5 6 9\n4 8 0 1 2 5\n"
           "$EndElements\n");
  EXPECT_EQ(file.mesh.face_vertex, (std::vector<VertexId>{0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2}));
  expect_edges(file.edges, {{0, 1}});
}

TEST(ReadMsh, DataOfSeveralStepsAndComponents) {
  const std::string head = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
  const auto data = [](const std::string& step, const std::string& components,
                       const std::string& entry) {
    return "$NodeData\n1\n\"h\"\n1\n0\n4\n" + step + "\n" + components + "\n1\n0\n" + entry +
           "\n$EndNodeData\n";
  };
  // Data may even come before their nodes are complete.
  const auto file = read("msh", head + "$Nodes\n1\n1 0 0 0\n$EndNodes\n" + data("0", "1", "1 5") +
                                    data("3", "1", "1 inf") + data("0", "3", "1 1 2 3") +
                                    data("0", "1", "77 1") + "$Nodes\n1\n2 1 0 0\n$EndNodes\n");
  const double nan = std::nan("");
  expect_same_data({{"h", {5, nan}},
                    {"h_3", {std::numeric_limits<double>::infinity(), nan}},
                    {"h_0", {nan, nan}}},
                   file.vertex_data);
}

MeshFile two_regions() {
  MeshFile file;
  file.mesh.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {2, 0}, {2, 1}};
  file.mesh.add_face(std::array<VertexId, 3>{0, 1, 2});
  file.mesh.add_face(std::array<VertexId, 4>{1, 4, 5, 2});
  file.mesh.add_face(std::array<VertexId, 3>{0, 2, 3});
  file.edges = {{1, 2}, {5, 4}};
  return file;
}

TEST(WriteMsh, GroupsEntitiesAndEdgesAreKept) {
  const test::TemporaryFolder folder;
  for (const char* format : {"msh", "msh22"}) {
    auto file = two_regions();
    file.face_data = {
        {"physical", {-3, 12, -3}}, {"entity", {5, 2, 5}}, {"q", {1, 2, std::nan("")}}};
    write_mesh(folder.path("m.msh"), file, format);
    const auto back = read_mesh(folder.path("m.msh"));
    expect_same_mesh(file, back);
    expect_same_data(file.face_data, back.face_data);
    expect_edges(file.edges, back.edges);
    // One entity in two groups becomes two.
    file.face_data = {{"physical", {0, 12, 5}}, {"entity", {5, 5, 5}}};
    write_mesh(folder.path("m.msh"), file, format);
    expect_same_data({{"physical", {0, 12, 5}}, {"entity", {1, 3, 2}}},
                     read_mesh(folder.path("m.msh")).face_data);
    // What is no group is data.
    file.face_data = {{"physical", {0.5, 1, 2}}, {"entity", {0, 1, 3e9}}};
    write_mesh(folder.path("m.msh"), file, format);
    expect_same_data(file.face_data, read_mesh(folder.path("m.msh")).face_data);
  }
}

TEST(WriteMsh, NamesOfDataAreMadeToFit) {
  const test::TemporaryFolder folder;
  auto file = two_regions();
  file.vertex_data = {{"a \"b\"\nc", {1, 2, 3, 4, 5, 6}}, {"", {1, 2, 3, 4, 5, 6}}};
  write_mesh(folder.path("m.msh"), file);
  const auto back = read_mesh(folder.path("m.msh"));
  ASSERT_EQ(back.vertex_data.size(), 2U);
  EXPECT_EQ(back.vertex_data[0].name, "a 'b' c");
  EXPECT_EQ(back.vertex_data[1].name, "");
}

TEST(BadMeshes, BinaryMsh) {
  const std::string good = binary22(false);
  const auto replaced = [&](const std::string& what, const std::string& by) {
    auto text = good;
    return text.replace(text.find(what), what.size(), by);
  };
  const std::string head =
      "$MeshFormat\n4.1 1 8\n" + Bytes(false).ints({1}).str() + "\n$EndMeshFormat\n";
  const auto sizes = [](std::initializer_list<std::uint64_t> values) {
    return Bytes(false).put(values).str();
  };
  constexpr std::uint64_t huge = ~std::uint64_t{0};
  for (const BadFile& bad : std::vector<BadFile>{
           {"msh", "$MeshFormat\n4.1 1 8\n", "byte 20: the file ends here, expected the number 1"},
           {"msh", "$MeshFormat\n2.2 1 4\n", "numbers of 4 bytes cannot be read", kParse, {2}},
           {"msh", "$MeshFormat\n4.1 1 8 x\n", "byte 20: expected the end of a line of text"},
           {"msh", "$MeshFormat\n4.1 1 8\nabcd\n", "the byte order is not 1"},
           {"msh", replaced("\n6\n", "\n7\n"), "expected $EndNodes"},
           {"msh",
            head + "$Nodes\n" + sizes({1, 1, 0, 0}) + Bytes(false).ints({2, 1, 0}).str() +
                sizes({1, 1}) + Bytes(false).reals({std::nan(""), 0, 0}).str(),
            "byte 115: x is not finite", kInfinite},
           {"msh", replaced("$Nodes\n6\n", "$Nodes\n18446744073709551615\n"), "byte"},
           {"msh", replaced("$Elements\n6\n", "$Elements\n4\n"),
            "more elements than their count says"},
           {"msh", replaced("$EndElements", "$EndElephant"),
            "'$EndElephant', expected $EndElements"},
           {"msh", replaced("$NodeData", "$NoteData"), "the file ends here, expected $EndNoteData"},
           {"msh", head + "$Nodes\n" + sizes({huge, huge, 0, 0}),
            "the file ends here, expected a dimension"},
           {"msh",
            head + "$Nodes\n" + sizes({1, 1, 0, 0}) + Bytes(false).ints({2, 1, 0}).str() +
                sizes({huge, 1}),
            "the file ends here, expected a node's tag"},
           {"msh",
            head + "$Elements\n" + sizes({1, 1, 0, 0}) + Bytes(false).ints({2, 1, 2}).str() +
                sizes({1, 1, 5, 5, 5}),
            "element names node 5, which is not there",
            kRange,
            {0, 5}},
           {"msh",
            head + "$Elements\n" + sizes({1, 1, 0, 0}) + Bytes(false).ints({2, 1, 4}).str() +
                sizes({1}),
            "elements of type 4 cannot be read"},
           {"msh",
            head + "$Elements\n" + sizes({1, 1, 0, 0}) + Bytes(false).ints({2, 1, -1}).str() +
                sizes({1}),
            "-1 is not a count or index"}}) {
    expect_fault(bad);
  }
}

}  // namespace
}  // namespace quadloom::io
