// Writes VTK's XML unstructured grids, .vtu: one piece, arrays as text or as base64 within the file.

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <limits>

#include "io/base64.hpp"
#include "io/mesh_formats.hpp"

namespace quadloom::io {
namespace {

constexpr int kLine = 3, kTriangle = 5, kPolygon = 7, kQuad = 9;

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
         << "\" NumberOfCells=\"" << mesh_.face_count() + file_.edges.size() << "\">\n";
    write_points();
    write_cells();
    write_data("PointData", file_.vertex_data, 0);
    write_data("CellData", file_.face_data, file_.edges.size());
    out_ << "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
  }

 private:
  /// One array of `count` numbers; value(i) is the i-th. In base64 a header of 8 bytes says how many
  /// bytes follow; it is encoded with the data, in pieces of whole groups and numbers.
  template <class T, class Value>
  void write_array(const char* type, const std::string& name, int components, std::size_t count,
                   Value value) {
    out_ << "<DataArray type=\"" << type << "\" Name=\"" << xml_text(name);
    if (components > 1) out_ << "\" NumberOfComponents=\"" << components;
    out_ << "\" format=\"" << (ascii_ ? "ascii" : "binary") << "\">\n";
    if (ascii_) {
      out_.each(count, [&](TextBuffer& to, std::size_t i) {
        to << value(i) << (i % 12 == 11 ? '\n' : ' ');
      });
    } else {
      write_base64<T>(count, value);
    }
    out_ << "\n</DataArray>\n";
  }

  template <class T, class Value>
  void write_base64(std::size_t count, Value value) {
    constexpr std::size_t numbers = 3 << 10,
                          header = 8 / sizeof(T);  // of a piece; in place of the header
    out_.each((count + header + numbers - 1) / numbers,
              [&](TextBuffer& to, std::size_t piece) {
                std::array<char, numbers * sizeof(T)> bytes;
                const std::size_t first = piece * numbers,
                                  last = std::min(first + numbers, count + header);
                for (std::size_t i = std::max(first, header); i < last; ++i) {
                  const auto number = static_cast<T>(value(i - header));
                  std::memcpy(&bytes[(i - first) * sizeof(T)], &number, sizeof(T));
                }
                const auto size = static_cast<std::uint64_t>(count * sizeof(T));
                if (piece == 0) std::memcpy(bytes.data(), &size, sizeof(size));
                append_base64({bytes.data(), (last - first) * sizeof(T)}, to);
              },
              16);
  }

  void write_points() {
    out_ << "<Points>\n";
    write_array<double>("Float64", "Points", 3, 3 * mesh_.points.size(), [&](std::size_t i) {
      const Point p = mesh_.points[i / 3];
      return (i % 3 == 0 ? p.x : i % 3 == 1 ? p.y : height(file_, i / 3)) + 0.0;
    });
    out_ << "</Points>\n";
  }

  /// The faces, then the edges as lines.
  void write_cells() {
    const std::size_t corners = mesh_.face_vertex.size(), faces = mesh_.face_count();
    const std::size_t edges = file_.edges.size();
    out_ << "<Cells>\n";
    write_array<std::int64_t>("Int64", "connectivity", 1, corners + 2 * edges, [&](std::size_t i) {
      if (i < corners) return mesh_.face_vertex[i];
      const Segment& edge = file_.edges[(i - corners) / 2];
      return (i - corners) % 2 == 0 ? edge.from : edge.to;
    });
    write_array<std::int64_t>("Int64", "offsets", 1, faces + edges, [&](std::size_t i) {
      return i < faces ? mesh_.face_begin[i + 1] : corners + 2 * (i - faces + 1);
    });
    write_array<std::uint8_t>("UInt8", "types", 1, faces + edges, [&](std::size_t i) {
      if (i >= faces) return kLine;
      const std::size_t size = mesh_.face(i).size();
      return size == 3 ? kTriangle : size == 4 ? kQuad : kPolygon;
    });
    out_ << "</Cells>\n";
  }

  /// NaN for the last `lines` cells.
  void write_data(const char* group, const std::vector<Attribute>& data, std::size_t lines) {
    out_ << '<' << group << ">\n";
    for (const Attribute& attribute : data) {
      const auto& values = attribute.values;
      write_array<double>("Float64", attribute.name, 1, values.size() + lines, [&](std::size_t i) {
        return i < values.size() ? values[i] + 0.0 : std::numeric_limits<double>::quiet_NaN();
      });
    }
    out_ << "</" << group << ">\n";
  }

  Output& out_;
  const MeshFile& file_;
  const PolygonMesh& mesh_;
  bool ascii_;
};

}  // namespace

void write_vtu_base64(Output& out, const MeshFile& file) { VtuWriter(out, file, false).write(); }

void write_vtu_ascii(Output& out, const MeshFile& file) { VtuWriter(out, file, true).write(); }

}  // namespace quadloom::io
