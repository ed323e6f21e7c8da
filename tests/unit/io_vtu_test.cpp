// VTK's .vtu: appended and compressed data, lines. Other faults are in io_mesh_test.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "io/base64.hpp"
#include "support/mesh_files.hpp"
#include "support/temporary_folder.hpp"

namespace quadloom::io {
namespace {

/// The bytes in zlib's format without making them shorter: one stored block.
std::string stored(const std::string& bytes) {
  std::uint32_t a = 1, b = 0;
  for (const char c : bytes) {
    a = (a + static_cast<unsigned char>(c)) % 65521;
    b = (b + a) % 65521;
  }
  const auto size = static_cast<std::uint16_t>(bytes.size());
  std::string out = "\x78\x01\x01";
  for (const unsigned n : {unsigned{size}, 65535U - size}) {
    out += {static_cast<char>(n & 255U), static_cast<char>(n >> 8U)};
  }
  out += bytes;
  for (const std::uint32_t n : {b, a}) {
    out += {static_cast<char>(n >> 8U), static_cast<char>(n & 255U)};
  }
  return out;
}

/// How a file is encoded.
struct Encoding {
  bool big = false;
  bool long_header = false;
  bool compressed = false;
  bool appended = false;
  bool raw = false;  // of appended data
};

/// Writes a square with a line and a point beside it, as `encoding` says.
class VtuText {
 public:
  explicit VtuText(const Encoding& encoding) : encoding_(encoding) {}

  std::string write() {
    std::string out = "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" byte_order=\"";
    out += encoding_.big ? "BigEndian\"" : "LittleEndian\"";
    if (encoding_.long_header) out += " header_type=\"UInt64\"";
    if (encoding_.compressed) out += " compressor=\"vtkZLibDataCompressor\"";
    out += ">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"4\" NumberOfCells=\"4\">\n<CellData>";
    out += array<double>("Float64", "q", {7, 8, 9, 10});
    out += "<DataArray type=\"String\" Name=\"names\" format=\"ascii\">65 0</DataArray></CellData>";
    out += "<Points>" + array<float>("Float32", "Points", {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
    out += "</Points><Cells>";
    out += array<std::int64_t>("Int64", "connectivity", {3, 0, 1, 2, 0, 1, 2, 3, 1, 3});
    out += array<std::int32_t>("Int32", "offsets", {3, 4, 8, 10});
    out += array<std::uint8_t>("UInt8", "types", {4, 1, 9, 3});
    out += "</Cells></Piece></UnstructuredGrid>\n";
    if (encoding_.appended) {
      out += std::string("<AppendedData encoding=\"") + (encoding_.raw ? "raw" : "base64") +
             "\">\n _" + appended_ + "\n</AppendedData>\n";
    }
    return out + "</VTKFile>\n";
  }

 private:
  template <class T>
  std::string bytes_of(const std::vector<T>& values) const {
    std::string out;
    for (const T value : values) {
      auto bytes = std::bit_cast<std::array<char, sizeof(T)>>(value);
      if (encoding_.big == (std::endian::native == std::endian::little))
        std::ranges::reverse(bytes);
      out.append(bytes.data(), bytes.size());
    }
    return out;
  }

  std::string header(const std::vector<std::uint64_t>& numbers) const {
    if (encoding_.long_header) return bytes_of(numbers);
    return bytes_of(std::vector<std::uint32_t>(numbers.begin(), numbers.end()));
  }

  /// In blocks of 16 bytes if compressed; header and data are encoded apart, as VTK does.
  std::string encoded(const std::string& bytes) const {
    const auto text = [&](const std::string& piece) {
      return encoding_.appended && encoding_.raw ? piece : to_base64(piece);
    };
    if (!encoding_.compressed) return text(header({bytes.size()}) + bytes);
    std::vector<std::uint64_t> numbers = {(bytes.size() + 15) / 16, 16, bytes.size() % 16};
    std::string blocks;
    for (std::size_t i = 0; i < bytes.size(); i += 16) {
      const std::string block = stored(bytes.substr(i, 16));
      numbers.push_back(block.size());
      blocks += block;
    }
    return text(header(numbers)) + text(blocks);
  }

  template <class T>
  std::string array(const std::string& type, const std::string& name,
                    const std::vector<T>& values) {
    std::string out = "<DataArray type=\"" + type + "\" Name=\"" + name + "\"";
    if (name == "Points") out += " NumberOfComponents=\"3\"";
    if (!encoding_.appended) {
      return out + " format=\"binary\">\n  " + encoded(bytes_of(values)) + "\n</DataArray>";
    }
    out += " format=\"appended\" offset=\"" + std::to_string(appended_.size()) + "\"/>";
    appended_ += encoded(bytes_of(values));
    return out;
  }

  Encoding encoding_;
  std::string appended_;
};

std::vector<Encoding> all_encodings() {
  std::vector<Encoding> out;
  for (unsigned i = 0; i < 32; ++i) {
    const Encoding e{(i & 1U) != 0, (i & 2U) != 0, (i & 4U) != 0, (i & 8U) != 0, (i & 16U) != 0};
    if (e.appended || !e.raw) out.push_back(e);
  }
  return out;
}

void expect_square_and_lines(const MeshFile& file) {
  expect_square(file);
  ASSERT_EQ(file.edges.size(), 3U);
  const std::array<std::array<VertexId, 2>, 3> expected = {{{3, 0}, {0, 1}, {1, 3}}};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ((std::array{file.edges[i].from, file.edges[i].to}), expected[i]);
  }
  expect_same_data({{"q", {9}}}, file.face_data);
}

TEST(ReadVtu, EveryEncoding) {
  for (const Encoding& encoding : all_encodings()) {
    expect_square_and_lines(read("vtu", VtuText(encoding).write()));
  }
}

TEST(ReadVtu, SurvivesDamageInEveryEncoding) {
  for (const Encoding& encoding : all_encodings()) {
    if (!encoding.big) expect_survives_damage("vtu", VtuText(encoding).write());
  }
}

TEST(WriteVtu, EdgesAreLines) {
  const test::TemporaryFolder folder;
  auto file = read("vtu", VtuText({}).write());
  for (const char* format : {"vtu", "vtu-ascii"}) {
    write_mesh(folder.path("m.vtu"), file, format);
    expect_square_and_lines(read_mesh(folder.path("m.vtu")));
  }
}

TEST(BadMeshes, VtuBinary) {
  const auto replaced = [](const Encoding& encoding, const std::string& what,
                           const std::string& by) {
    auto text = VtuText(encoding).write();
    return text.replace(text.find(what), what.size(), by);
  };
  const Encoding raw{false, false, false, true, true}, base64{false, false, false, true, false};
  const Encoding packed{false, false, true, true, true};
  const auto number = [](std::uint32_t n) {
    std::string out;
    for (int i = 0; i < 4; ++i) out += static_cast<char>(n >> (8 * i) & 255U);
    return out;
  };
  const std::string first =
      number(2) + number(16) + number(0) + number(27);  // 4 doubles in 2 blocks
  for (const BadFile& bad : std::vector<BadFile>{
           {"vtu", replaced(raw, "\"raw\"", "\"hex\""), "in the encoding 'hex' cannot be read"},
           {"vtu", replaced(raw, "</AppendedData>", ""), "do not end"},
           {"vtu", replaced(raw, "offset=\"0\"", "offset=\"9999\""), "'q' has no offset into"},
           {"vtu", replaced(raw, "offset=\"0\"", "offset=\"-1\""), "'q' has no offset into"},
           {"vtu", replaced(raw, "_" + number(32), "_" + number(33)),
            "33 bytes, which are no whole"},
           {"vtu", replaced(raw, "_" + number(32), "_" + number(40)),
            "'q' has 5 numbers, expected 4"},
           {"vtu", replaced(raw, "_" + number(32), "_" + number(300)),
            "bytes, its header needs 304"},
           {"vtu", replaced(raw, "_" + number(32), "_" + number(~0U)), "says 4294967295 bytes"},
           {"vtu", replaced(base64, "_IAAA", "_!AAA"), "'q' is no base64"},
           {"vtu", replaced(packed, first, number(~0U) + first.substr(4)), "says 4294967295 bytes"},
           {"vtu", replaced(packed, first, number(2) + number(~0U) + number(0) + number(27)),
            "a block of 27 bytes that says it holds 4294967295"},
           {"vtu", replaced(packed, first, number(2) + number(16) + number(~0U) + number(27)),
            "a block of 27 bytes that says it holds 4294967295"},
           {"vtu", replaced(packed, first, number(2) + number(15) + number(0) + number(27)),
            "a block that zlib cannot uncompress"},
           {"vtu", replaced(packed, first, number(2) + number(17) + number(0) + number(27)),
            "a block that zlib cannot uncompress"},
           {"vtu", replaced(packed, first, number(2) + number(16) + number(0) + number(26)),
            "a block that zlib cannot uncompress"},
           {"vtu", replaced(packed, first, number(0) + first.substr(4)), "'q' has 0 numbers"}}) {
    expect_fault(bad);
  }
}

}  // namespace
}  // namespace quadloom::io
