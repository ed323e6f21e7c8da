// Reads VTK's XML unstructured grids, .vtu: one piece. Cells are triangles, quads and polygons (types
// 5, 9 and 7; pixels, type 8, are turned into quads); lines (3 and 4) become edges, points (1 and 2)
// are skipped. Arrays of one number a point or cell are carried; others skipped. See vtu_arrays.hpp
// for how numbers are encoded.

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <pugixml.hpp>
#include <span>

#include "io/mesh_builder.hpp"
#include "io/mesh_formats.hpp"
#include "io/text.hpp"
#include "io/vtu_arrays.hpp"

namespace quadloom::io {
namespace {

constexpr int kVertex = 1, kVertices = 2, kLine = 3, kPolyline = 4, kTriangle = 5, kPolygon = 7,
              kPixel = 8, kQuad = 9;

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
    for (Attribute& data : out.face_data) take_faces(data.values);
    return out;
  }

 private:
  [[noreturn]] void fail(const std::string& what, ErrorCode code = ErrorCode::kParse) const {
    fail_in(source_, what, code);
  }

  void open();
  std::string cut_appended_data();
  void read_encoding(pugi::xml_node file);
  void read_points();
  void read_cells();
  std::vector<Attribute> read_data(const char* group, std::uint64_t size) const;
  void add_cell(std::span<const double> points, std::size_t cell, int type);

  /// Numbers of cells become numbers of faces.
  void take_faces(std::vector<double>& values) const {
    for (std::size_t f = 0; f < face_cell_.size(); ++f) values[f] = values[face_cell_[f]];
    values.resize(face_cell_.size());
  }

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

  std::vector<double> numbers_of(pugi::xml_node array) const {
    return read_vtu_array(source_, encoding_, array);
  }
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
  VtuEncoding encoding_;
  std::uint64_t points_ = 0;
  std::uint64_t cells_ = 0;
  std::vector<std::size_t> face_cell_;  // the cell that is face f
  std::vector<std::uint64_t> corners_;
};

/// Appended data may be any bytes, so they are cut out of the XML: from after the first underscore of
/// the element AppendedData to its end tag, the last of the file.
std::string VtuReader::cut_appended_data() {
  const std::string_view text = source_.text;
  const auto element = text.find("<AppendedData");
  if (element == std::string_view::npos) return std::string(text);
  const auto end_of_tag = std::min(text.find('>', element), text.size() - 1);
  const auto begin = text.find('_', end_of_tag);
  const auto end = text.rfind("</AppendedData>");
  if (begin == std::string_view::npos || end == std::string_view::npos || end <= begin) {
    fail("the appended data do not begin with an underscore or do not end");
  }
  encoding_.appended = text.substr(begin + 1, end - begin - 1);
  return std::string(text.substr(0, end_of_tag + 1)) + std::string(text.substr(end));
}

void VtuReader::read_encoding(pugi::xml_node file) {
  const bool big = std::string_view(file.attribute("byte_order").value()) == "BigEndian";
  encoding_.swap = big == (std::endian::native == std::endian::little);
  encoding_.long_header = std::string_view(file.attribute("header_type").value()) == "UInt64";
  encoding_.compressor = file.attribute("compressor").value();
  const std::string_view appended = file.child("AppendedData").attribute("encoding").value();
  if (!appended.empty() && appended != "raw" && appended != "base64") {
    fail(fmt::format("appended data in the encoding {} cannot be read, only raw and base64",
                     in_quotes(appended)));
  }
  encoding_.raw = appended == "raw";
}

void VtuReader::open() {
  const std::string text = cut_appended_data();
  const auto result = document_.load_buffer(text.data(), text.size());
  if (!result) {
    const auto read = std::string_view(text).substr(0, static_cast<std::size_t>(result.offset));
    fail_at(source_, static_cast<std::size_t>(std::ranges::count(read, '\n')) + 1,
            fmt::format("no well-formed XML: {}", result.description()));
  }
  const auto file = child(document_, "VTKFile");
  const std::string_view type = file.attribute("type").value();
  if (type != "UnstructuredGrid") {
    fail(fmt::format("a VTK file of type {}, expected UnstructuredGrid", in_quotes(type)));
  }
  read_encoding(file);
  const auto grid = child(file, "UnstructuredGrid");
  piece_ = child(grid, "Piece");
  if (piece_.next_sibling("Piece")) fail("more than one piece");
  points_ = count_of("NumberOfPoints");
  cells_ = count_of("NumberOfCells");
  mesh_.reserve(points_, cells_);
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

void VtuReader::add_cell(std::span<const double> points, std::size_t cell, int type) {
  if (type == kVertex || type == kVertices) return;
  const bool line = type == kLine || type == kPolyline;
  if (!line && type != kTriangle && type != kPolygon && type != kPixel && type != kQuad) {
    fail(fmt::format(
        "cell {} has the type {}, only points (1 and 2), lines (3 and 4), triangles (5), "
        "polygons (7), pixels (8) and quads (9) can be read",
        cell, type));
  }
  const bool any_size = type == kPolygon || type == kPolyline;
  const std::size_t expected = type == kTriangle ? 3 : type == kLine ? 2 : 4;
  if (!any_size && points.size() != expected) {
    fail(fmt::format("cell {} of type {} has {} points", cell, type, points.size()));
  }
  corners_.clear();
  for (const double point : points) corners_.push_back(index_from(point, "connectivity"));
  if (line) {
    for (std::size_t i = 1; i < corners_.size(); ++i) {
      mesh_.add_edge(corners_[i - 1], corners_[i], 0);
    }
    return;
  }
  if (type == kPixel) std::swap(corners_[2], corners_[3]);
  mesh_.add_face(corners_, 0);
  face_cell_.push_back(cell);
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
    add_cell(std::span(connectivity).subspan(begin, end - begin), i,
             static_cast<int>(std::min<std::uint64_t>(type, 255)));
    begin = end;
  }
}

std::vector<Attribute> VtuReader::read_data(const char* group, std::uint64_t size) const {
  std::vector<Attribute> out;
  for (const auto array : piece_.child(group).children("DataArray")) {
    const auto components = array.attribute("NumberOfComponents");
    if (components && components.as_uint() != 1) continue;
    if (std::string_view(array.attribute("type").value()) == "String") continue;
    out.push_back({array.attribute("Name").value(), numbers_of(array, size)});
  }
  return out;
}

}  // namespace

MeshFile read_vtu(const Source& source) { return VtuReader(source).read(); }

}  // namespace quadloom::io
