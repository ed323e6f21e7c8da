// VTK's XML unstructured grids, .vtu: one piece; arrays as text or as base64 within the file, either
// byte order, not compressed. Cells are triangles, quads and polygons (types 5, 9 and 7; pixels,
// type 8, are turned into quads). Arrays of one number a point or cell are carried; others skipped.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <pugixml.hpp>
#include <span>

#include "io/base64.hpp"
#include "io/binary.hpp"
#include "io/mesh_builder.hpp"
#include "io/mesh_formats.hpp"
#include "io/text.hpp"

namespace quadloom::io {
namespace {

constexpr int kTriangle = 5, kPolygon = 7, kPixel = 8, kQuad = 9;

// ---- Reading. ----

class VtuReader {
 public:
  explicit VtuReader(const Source& source) : source_(source), mesh_(source) {}

  MeshFile read() {
    open();
    read_points();
    read_cells();
    MeshFile out = mesh_.finish();
    out.vertex_data = read_data("PointData", points_);
    out.face_data = read_data("CellData", cells_);
    return out;
  }

 private:
  [[noreturn]] void fail(const std::string& what, ErrorCode code = ErrorCode::kParse) const {
    fail_in(source_, what, code);
  }

  void open();
  void read_points();
  void read_cells();
  std::vector<Attribute> read_data(const char* group, std::uint64_t size) const;
  void add_cell(std::span<const double> corners, int type);

  pugi::xml_node child(pugi::xml_node parent, const char* name) const {
    const auto out = parent.child(name);
    if (!out) fail(fmt::format("no element {}", name));
    return out;
  }
  pugi::xml_node array_named(pugi::xml_node parent, const char* name) const {
    const auto out = parent.find_child_by_attribute("DataArray", "Name", name);
    if (!out) fail(fmt::format("no DataArray {}", name));
    return out;
  }
  std::uint64_t count_of(const char* attribute) const {
    const auto value = to_integer<std::uint64_t>(piece_.attribute(attribute).value());
    if (!value) fail(fmt::format("the piece has no {}", attribute));
    return *value;
  }

  NumberType type_of(pugi::xml_node array) const;
  std::vector<double> numbers_of(pugi::xml_node array) const;
  std::vector<double> decoded(pugi::xml_node array) const;
  std::vector<double> numbers_of(pugi::xml_node array, std::uint64_t expected) const;
  std::uint64_t index_from(double value, const char* what) const {
    if (value >= 0 && value < 0x1p53 && value == std::floor(value)) {
      return static_cast<std::uint64_t>(value);
    }
    fail(fmt::format("{} is no entry of {}", value, what));
  }

  const Source& source_;
  MeshBuilder mesh_;
  pugi::xml_document document_;
  pugi::xml_node piece_;
  bool swap_ = false;
  bool long_header_ = false;
  std::uint64_t points_ = 0;
  std::uint64_t cells_ = 0;
  std::vector<std::uint64_t> corners_;
};

void VtuReader::open() {
  const auto result = document_.load_buffer(source_.text.data(), source_.text.size());
  if (!result) {
    const auto read = source_.text.substr(0, static_cast<std::size_t>(result.offset));
    fail_at(source_, static_cast<std::size_t>(std::ranges::count(read, '\n')) + 1,
            fmt::format("no well-formed XML: {}", result.description()));
  }
  const auto file = child(document_, "VTKFile");
  const std::string_view type = file.attribute("type").value();
  if (type != "UnstructuredGrid") {
    fail(fmt::format("a VTK file of type {}, expected UnstructuredGrid", in_quotes(type)));
  }
  if (file.attribute("compressor")) fail("compressed data cannot be read; write it uncompressed");
  const bool big = std::string_view(file.attribute("byte_order").value()) == "BigEndian";
  swap_ = big == (std::endian::native == std::endian::little);
  long_header_ = std::string_view(file.attribute("header_type").value()) == "UInt64";
  const auto grid = child(file, "UnstructuredGrid");
  piece_ = child(grid, "Piece");
  if (piece_.next_sibling("Piece")) fail("more than one piece");
  points_ = count_of("NumberOfPoints");
  cells_ = count_of("NumberOfCells");
  mesh_.reserve(points_, cells_);
}

NumberType VtuReader::type_of(pugi::xml_node array) const {
  constexpr std::array<std::string_view, 10> names = {"Int8",    "UInt8",  "Int16", "UInt16",
                                                      "Int32",   "UInt32", "Int64", "UInt64",
                                                      "Float32", "Float64"};
  const std::string_view name = array.attribute("type").value();
  const auto at = std::ranges::find(names, name);
  if (at == names.end()) fail(fmt::format("{} is no type of numbers", in_quotes(name)));
  return static_cast<NumberType>(at - names.begin());
}

std::vector<double> VtuReader::decoded(pugi::xml_node array) const {
  const std::size_t header = long_header_ ? 8 : 4;
  const NumberType type = type_of(array);
  std::string bytes;
  if (!from_base64(array.text().get(), bytes) || bytes.size() < header) {
    fail(fmt::format("the array {} is no base64", in_quotes(array.attribute("Name").value())));
  }
  const std::uint64_t size = long_header_ ? load<std::uint64_t>(bytes.data(), swap_)
                                          : load<std::uint32_t>(bytes.data(), swap_);
  if (size != bytes.size() - header || size % size_of(type) != 0) {
    fail(fmt::format("the array {} has {} bytes, its header says {}",
                     in_quotes(array.attribute("Name").value()), bytes.size() - header, size));
  }
  std::vector<double> out;
  out.reserve(size / size_of(type));
  for (std::size_t at = header; at < bytes.size(); at += size_of(type)) {
    out.push_back(load_number(bytes.data() + at, type, swap_));
  }
  return out;
}

std::vector<double> VtuReader::numbers_of(pugi::xml_node array) const {
  const std::string_view format = array.attribute("format").value();
  if (format == "binary") return decoded(array);
  if (format != "ascii") {
    fail(fmt::format("arrays in the format {} cannot be read, only ascii and binary",
                     in_quotes(format)));
  }
  const Source text{source_.name, array.text().get()};
  Words words(text);
  std::vector<double> out;
  for (auto word = words.next(); !word.empty(); word = words.next()) {
    const auto value = to_number(word);
    if (!value) {
      fail(fmt::format("{} in the array {} is not a number", in_quotes(word),
                       in_quotes(array.attribute("Name").value())));
    }
    out.push_back(*value);
  }
  return out;
}

std::vector<double> VtuReader::numbers_of(pugi::xml_node array, std::uint64_t expected) const {
  auto out = numbers_of(array);
  if (out.size() != expected) {
    fail(fmt::format("the array {} has {} numbers, expected {}",
                     in_quotes(array.attribute("Name").value()), out.size(), expected));
  }
  return out;
}

void VtuReader::read_points() {
  const auto array = child(child(piece_, "Points"), "DataArray");
  const auto at = numbers_of(array);
  if (at.size() % 3 != 0 || at.size() / 3 != points_) {
    fail(fmt::format("{} coordinates for {} points", at.size(), points_));
  }
  for (std::size_t i = 0; i < at.size(); i += 3) {
    if (!std::isfinite(at[i]) || !std::isfinite(at[i + 1]) || !std::isfinite(at[i + 2])) {
      fail(fmt::format("point {} is not finite", i / 3), ErrorCode::kNotFinite);
    }
    mesh_.add_vertex(at[i], at[i + 1], at[i + 2]);
  }
}

void VtuReader::add_cell(std::span<const double> corners, int type) {
  const std::size_t expected = type == kTriangle ? 3 : type == kPolygon ? corners.size() : 4;
  if (type != kTriangle && type != kPolygon && type != kPixel && type != kQuad) {
    fail(
        fmt::format("cell {} has the type {}, only triangles (5), polygons (7), pixels (8) and "
                    "quads (9) can be read",
                    mesh_.face_count(), type));
  }
  if (corners.size() != expected) {
    fail(fmt::format("cell {} of type {} has {} points", mesh_.face_count(), type, corners.size()));
  }
  corners_.clear();
  for (const double corner : corners) corners_.push_back(index_from(corner, "connectivity"));
  if (type == kPixel) std::swap(corners_[2], corners_[3]);
  mesh_.add_face(corners_, 0);
}

void VtuReader::read_cells() {
  const auto cells = child(piece_, "Cells");
  const auto connectivity = numbers_of(array_named(cells, "connectivity"));
  const auto offsets = numbers_of(array_named(cells, "offsets"), cells_);
  const auto types = numbers_of(array_named(cells, "types"), cells_);
  std::uint64_t begin = 0;
  for (std::size_t i = 0; i < offsets.size(); ++i) {
    const auto end = index_from(offsets[i], "offsets");
    if (end < begin || end > connectivity.size()) fail(fmt::format("offset {} is out of order", i));
    const auto type = index_from(types[i], "types");
    add_cell(std::span(connectivity).subspan(begin, end - begin),
             static_cast<int>(std::min<std::uint64_t>(type, 255)));
    begin = end;
  }
}

std::vector<Attribute> VtuReader::read_data(const char* group, std::uint64_t size) const {
  std::vector<Attribute> out;
  for (const auto array : piece_.child(group).children("DataArray")) {
    const auto components = array.attribute("NumberOfComponents");
    if (components && components.as_uint() != 1) continue;
    out.push_back({array.attribute("Name").value(), numbers_of(array, size)});
  }
  return out;
}

// ---- Writing. ----

std::string xml_text(std::string_view text) {
  std::string out;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        if (byte < 32) {
          out += ' ';
        } else {
          out += c;
        }
    }
  }
  return out;
}

class VtuWriter {
 public:
  VtuWriter(Output& out, const MeshFile& file, bool ascii)
      : out_(out), file_(file), mesh_(file.mesh), ascii_(ascii) {}

  void write() {
    constexpr bool little = std::endian::native == std::endian::little;
    out_ << "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
            "byte_order=\""
         << (little ? "LittleEndian" : "BigEndian") << "\" header_type=\"UInt64\">\n"
         << "<UnstructuredGrid>\n<Piece NumberOfPoints=\"" << mesh_.points.size()
         << "\" NumberOfCells=\"" << mesh_.face_count() << "\">\n";
    write_points();
    write_cells();
    write_data("PointData", file_.vertex_data);
    write_data("CellData", file_.face_data);
    out_ << "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
  }

 private:
  /// One array of `count` numbers; value(i) is the i-th. In base64 a header of 8 bytes says how many
  /// bytes follow; it is encoded with the data, in pieces of whole groups.
  template <class T, class Value>
  void write_array(const char* type, const std::string& name, int components, std::size_t count,
                   Value value) {
    out_ << "<DataArray type=\"" << type << "\" Name=\"" << xml_text(name);
    if (components > 1) out_ << "\" NumberOfComponents=\"" << components;
    out_ << "\" format=\"" << (ascii_ ? "ascii" : "binary") << "\">\n";
    if (ascii_) {
      for (std::size_t i = 0; i < count; ++i) out_ << value(i) << (i % 12 == 11 ? '\n' : ' ');
    } else {
      write_base64<T>(count, value);
    }
    out_ << "\n</DataArray>\n";
  }

  template <class T, class Value>
  void write_base64(std::size_t count, Value value) {
    constexpr std::size_t piece = 3 << 14;
    std::string bytes;
    append(bytes, static_cast<std::uint64_t>(count * sizeof(T)));
    for (std::size_t i = 0; i < count; ++i) {
      append(bytes, static_cast<T>(value(i)));
      if (bytes.size() < piece) continue;
      out_ << to_base64(std::string_view(bytes).substr(0, piece));
      bytes.erase(0, piece);
    }
    out_ << to_base64(bytes);
  }

  template <class T>
  static void append(std::string& bytes, T value) {
    const auto raw = std::bit_cast<std::array<char, sizeof(T)>>(value);
    bytes.append(raw.data(), raw.size());
  }

  void write_points() {
    out_ << "<Points>\n";
    write_array<double>("Float64", "Points", 3, 3 * mesh_.points.size(), [&](std::size_t i) {
      const Point p = mesh_.points[i / 3];
      return (i % 3 == 0 ? p.x : i % 3 == 1 ? p.y : height(file_, i / 3)) + 0.0;
    });
    out_ << "</Points>\n";
  }

  void write_cells() {
    out_ << "<Cells>\n";
    write_array<std::int64_t>("Int64", "connectivity", 1, mesh_.face_vertex.size(),
                              [&](std::size_t i) { return mesh_.face_vertex[i]; });
    write_array<std::int64_t>("Int64", "offsets", 1, mesh_.face_count(),
                              [&](std::size_t i) { return mesh_.face_begin[i + 1]; });
    write_array<std::uint8_t>("UInt8", "types", 1, mesh_.face_count(), [&](std::size_t f) {
      const std::size_t corners = mesh_.face(f).size();
      return corners == 3 ? kTriangle : corners == 4 ? kQuad : kPolygon;
    });
    out_ << "</Cells>\n";
  }

  void write_data(const char* group, const std::vector<Attribute>& data) {
    out_ << '<' << group << ">\n";
    for (const Attribute& attribute : data) {
      write_array<double>("Float64", attribute.name, 1, attribute.values.size(),
                          [&](std::size_t i) { return attribute.values[i] + 0.0; });
    }
    out_ << "</" << group << ">\n";
  }

  Output& out_;
  const MeshFile& file_;
  const PolygonMesh& mesh_;
  bool ascii_;
};

}  // namespace

MeshFile read_vtu(const Source& source) { return VtuReader(source).read(); }

void write_vtu_base64(Output& out, const MeshFile& file) { VtuWriter(out, file, false).write(); }

void write_vtu_ascii(Output& out, const MeshFile& file) { VtuWriter(out, file, true).write(); }

}  // namespace quadloom::io
