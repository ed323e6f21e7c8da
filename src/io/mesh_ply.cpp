// .ply, read in its three encodings, written as text. Of the element "vertex" the properties x, y
// and z are coordinates and other numbers vertex data; of the element "face" the list vertex_indices
// (or vertex_index) holds the corners and other numbers are face data. Other lists and elements are
// skipped.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "io/binary.hpp"
#include "io/mesh_builder.hpp"
#include "io/mesh_formats.hpp"
#include "io/text.hpp"

namespace quadloom::io {
namespace {

enum class Encoding : std::uint8_t { kText, kLittle, kBig };

struct Property {
  std::string name;
  NumberType type = NumberType::kF64;
  bool is_list = false;
  NumberType count_type = NumberType::kU8;
};

struct Element {
  std::string name;
  std::uint64_t count = 0;
  std::vector<Property> properties;

  std::size_t find(std::string_view property) const {
    const auto at = std::ranges::find(properties, property, &Property::name);
    return static_cast<std::size_t>(at - properties.begin());
  }
};

NumberType number_type(const Lines& lines, std::string_view word) {
  constexpr std::array<std::array<std::string_view, 2>, 10> names = {{{"char", "int8"},
                                                                      {"uchar", "uint8"},
                                                                      {"short", "int16"},
                                                                      {"ushort", "uint16"},
                                                                      {"int", "int32"},
                                                                      {"uint", "uint32"},
                                                                      {"int64", "long"},
                                                                      {"uint64", "ulong"},
                                                                      {"float", "float32"},
                                                                      {"double", "float64"}}};
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (word == names[i][0] || word == names[i][1]) return static_cast<NumberType>(i);
  }
  lines.fail(fmt::format("{} is no type of numbers", in_quotes(word)));
}

struct Header {
  Encoding encoding = Encoding::kText;
  std::vector<Element> elements;
  std::size_t lines = 0;  // that it takes
  std::size_t bytes = 0;
};

Property read_property(const Lines& lines, std::string_view rest) {
  Property out;
  auto word = take_word(rest);
  if (word == "list") {
    out.is_list = true;
    out.count_type = number_type(lines, take_word(rest));
    word = take_word(rest);
  }
  out.type = number_type(lines, word);
  out.name = take_word(rest);
  if (out.name.empty()) lines.fail("a property without a name");
  return out;
}

Encoding read_encoding(const Lines& lines, std::string_view word) {
  if (word == "ascii") return Encoding::kText;
  if (word == "binary_little_endian") return Encoding::kLittle;
  if (word == "binary_big_endian") return Encoding::kBig;
  lines.fail(fmt::format("{} is no format of .ply files", in_quotes(word)));
}

void read_header_line(const Lines& lines, Header& header) {
  std::string_view rest = lines.line();
  const auto keyword = take_word(rest);
  if (keyword == "format") {
    header.encoding = read_encoding(lines, take_word(rest));
  } else if (keyword == "element") {
    Element element;
    element.name = take_word(rest);
    const auto count = to_integer<std::uint64_t>(take_word(rest));
    if (!count) lines.fail("an element without a count");
    if (std::ranges::find(header.elements, element.name, &Element::name) != header.elements.end()) {
      lines.fail(fmt::format("the element {} occurs twice", in_quotes(element.name)));
    }
    element.count = *count;
    header.elements.push_back(std::move(element));
  } else if (keyword == "property") {
    if (header.elements.empty()) lines.fail("a property before the first element");
    header.elements.back().properties.push_back(read_property(lines, rest));
  } else if (!keyword.empty() && keyword != "comment" && keyword != "obj_info") {
    lines.fail(fmt::format("{} starts no line of a .ply header", in_quotes(keyword)));
  }
}

Header read_header(const Source& source) {
  Lines lines(source);
  if (!lines.next() || lines.line() != "ply") fail_in(source, "the first line is not 'ply'");
  Header header;
  while (lines.next()) {
    if (lines.line() == "end_header") {
      header.lines = lines.number();
      header.bytes = source.text.size() - lines.bytes_left();
      return header;
    }
    read_header_line(lines, header);
  }
  lines.fail("the header does not end");
}

/// The numbers after the header, one after the other, in any encoding.
class Numbers {
 public:
  Numbers(const Source& source, const Header& header)
      : source_(source),
        body_{source.name, source.text.substr(header.bytes)},
        words_(body_, header.lines + 1),
        text_(header.encoding == Encoding::kText),
        swap_(!text_ && (header.encoding == Encoding::kBig) ==
                            (std::endian::native == std::endian::little)) {}

  double next(NumberType type, std::string_view what) {
    if (text_) return words_.number(what);
    const std::size_t size = size_of(type);
    if (body_.text.size() - at_ < size) {
      fail_in(source_, fmt::format("the file ends here, expected {}", what));
    }
    const double value = load_number(body_.text.data() + at_, type, swap_);
    at_ += size;
    return value;
  }

  std::uint64_t next_index(NumberType type, std::string_view what) {
    const double value = next(type, what);
    if (value >= 0 && value < 0x1p53 && value == std::floor(value)) {
      return static_cast<std::uint64_t>(value);
    }
    fail(fmt::format("{} is not a count or index, expected {}", value, what));
  }

  double next_finite(NumberType type, std::string_view what) {
    const double value = next(type, what);
    if (!std::isfinite(value)) {
      fail(fmt::format("{} is not finite", what), ErrorCode::kNotFinite);
    }
    return value;
  }

  bool at_end() { return text_ ? words_.next().empty() : at_ == body_.text.size(); }
  std::size_t line() const { return text_ ? words_.line() : 0; }
  [[noreturn]] void fail(const std::string& what, ErrorCode code = ErrorCode::kParse) const {
    if (text_) fail_at(source_, words_.line(), what, code);
    fail_in(source_, what, code);
  }

 private:
  const Source& source_;
  Source body_;
  Words words_;
  bool text_;
  bool swap_;
  std::size_t at_ = 0;
};

class PlyReader {
 public:
  explicit PlyReader(const Source& source)
      : source_(source), header_(read_header(source)), numbers_(source, header_), mesh_(source) {}

  MeshFile read() {
    bool any = false;
    for (const auto& element : header_.elements) {
      if (element.name == "vertex") any = true;
      if (element.properties.empty()) continue;
      if (element.name == "vertex") {
        read_vertices(element);
      } else if (element.name == "face") {
        read_faces(element);
      } else {
        for (std::uint64_t i = 0; i < element.count; ++i) skip(element);
      }
    }
    if (!any) fail_in(source_, "no element vertex");
    if (!numbers_.at_end()) numbers_.fail("more data than the header says");
    MeshFile out = mesh_.finish();
    out.vertex_data = std::move(vertex_data_);
    out.face_data = std::move(face_data_);
    return out;
  }

 private:
  static constexpr std::size_t kNowhere = static_cast<std::size_t>(-1);

  /// An attribute for each number among the properties that is not one of `known`; data_[i] is the
  /// attribute of property i or kNowhere.
  template <class IsKnown>
  void make_attributes(const Element& element, std::vector<Attribute>& out, IsKnown is_known) {
    data_.assign(element.properties.size(), kNowhere);
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      if (element.properties[i].is_list || is_known(i)) continue;
      data_[i] = out.size();
      out.push_back({element.properties[i].name, {}});
    }
  }

  void skip_list(const Property& property) {
    const auto count = numbers_.next_index(property.count_type, "the length of a list");
    for (std::uint64_t i = 0; i < count; ++i) numbers_.next(property.type, "an entry of a list");
  }

  void skip(const Element& element) {
    for (const auto& property : element.properties) {
      if (property.is_list) {
        skip_list(property);
      } else {
        numbers_.next(property.type, "a number");
      }
    }
  }

  void read_vertices(const Element& element) {
    const auto& properties = element.properties;
    const std::size_t x = element.find("x"), y = element.find("y"), z = element.find("z");
    if (x == properties.size() || y == properties.size() || properties[x].is_list ||
        properties[y].is_list) {
      fail_in(source_, "vertices without the numbers x and y");
    }
    mesh_.reserve(element.count, 0);
    make_attributes(element, vertex_data_,
                    [&](std::size_t i) { return i == x || i == y || i == z; });
    for (std::uint64_t v = 0; v < element.count; ++v) {
      std::array<double, 3> at = {0, 0, 0};
      for (std::size_t i = 0; i < properties.size(); ++i) {
        if (properties[i].is_list) {
          skip_list(properties[i]);
        } else if (data_[i] != kNowhere) {
          vertex_data_[data_[i]].values.push_back(numbers_.next(properties[i].type, "a number"));
        } else {
          at[i == x   ? 0
             : i == y ? 1
                      : 2] = numbers_.next_finite(properties[i].type, "a vertex coordinate");
        }
      }
      mesh_.add_vertex(at[0], at[1], at[2]);
    }
  }

  void read_faces(const Element& element) {
    const auto& properties = element.properties;
    const std::size_t list = std::min(element.find("vertex_indices"), element.find("vertex_index"));
    if (list == properties.size() || !properties[list].is_list) {
      fail_in(source_, "faces without the list vertex_indices");
    }
    mesh_.reserve(0, element.count);
    make_attributes(element, face_data_, [](std::size_t) { return false; });
    for (std::uint64_t f = 0; f < element.count; ++f) {
      for (std::size_t i = 0; i < properties.size(); ++i) {
        if (i == list) {
          read_corners(properties[i]);
        } else if (properties[i].is_list) {
          skip_list(properties[i]);
        } else {
          face_data_[data_[i]].values.push_back(numbers_.next(properties[i].type, "a number"));
        }
      }
    }
  }

  void read_corners(const Property& property) {
    const auto count = numbers_.next_index(property.count_type, "the count of corners");
    corners_.clear();
    for (std::uint64_t i = 0; i < count; ++i) {
      corners_.push_back(numbers_.next_index(property.type, "a corner"));
    }
    mesh_.add_face(corners_, numbers_.line());
  }

  const Source& source_;
  Header header_;
  Numbers numbers_;
  MeshBuilder mesh_;
  std::vector<Attribute> vertex_data_;
  std::vector<Attribute> face_data_;
  std::vector<std::size_t> data_;
  std::vector<std::uint64_t> corners_;
};

/// Names without blanks, none twice and none that means something else.
std::vector<std::string> property_names(const std::vector<Attribute>& data) {
  std::set<std::string> taken = {"x", "y", "z", "vertex_indices", "vertex_index"};
  std::vector<std::string> out;
  for (const auto& attribute : data) {
    std::string name = attribute.name.empty() ? "data" : attribute.name;
    for (char& c : name) {
      if (static_cast<unsigned char>(c) <= 32) c = '_';
    }
    while (!taken.insert(name).second) name += '_';
    out.push_back(std::move(name));
  }
  return out;
}

void write_data(TextBuffer& out, const std::vector<Attribute>& data, std::size_t i) {
  for (const auto& attribute : data) out << ' ' << attribute.values[i];
  out << '\n';
}

}  // namespace

MeshFile read_ply(const Source& source) { return PlyReader(source).read(); }

void write_ply(Output& out, const MeshFile& file) {
  const auto& mesh = file.mesh;
  std::size_t most = 0;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) most = std::max(most, mesh.face(f).size());
  out << "ply\nformat ascii 1.0\nelement vertex " << mesh.points.size()
      << "\nproperty double x\nproperty double y\nproperty double z\n";
  for (const auto& name : property_names(file.vertex_data))
    out << "property double " << name << '\n';
  out << "element face " << mesh.face_count() << "\nproperty list "
      << (most < 256 ? "uchar" : "uint") << " uint vertex_indices\n";
  for (const auto& name : property_names(file.face_data)) out << "property double " << name << '\n';
  out << "end_header\n";
  out.each(mesh.points.size(), [&](TextBuffer& to, std::size_t v) {
    to << mesh.points[v].x << ' ' << mesh.points[v].y << ' ' << height(file, v);
    write_data(to, file.vertex_data, v);
  });
  out.each(mesh.face_count(), [&](TextBuffer& to, std::size_t f) {
    to << mesh.face(f).size();
    for (const VertexId v : mesh.face(f)) to << ' ' << v;
    write_data(to, file.face_data, f);
  });
}

}  // namespace quadloom::io
