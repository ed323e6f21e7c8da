// .off: the word OFF, the counts of vertices, faces and edges, a vertex a line, a face a line (its
// number of corners, the corners from 0, perhaps a colour). # starts a comment.

#include <fmt/format.h>

#include "io/mesh_builder.hpp"
#include "io/mesh_formats.hpp"
#include "io/text.hpp"

namespace quadloom::io {
namespace {

class OffReader {
 public:
  explicit OffReader(const Source& source) : source_(source), lines_(source), mesh_(source) {}

  MeshFile read() {
    read_header();
    for (std::uint64_t v = 0; v < vertices_; ++v) read_vertex();
    for (std::uint64_t f = 0; f < faces_; ++f) read_face();
    if (lines_.next_filled()) lines_.fail("more lines than the counts say");
    return mesh_.finish();
  }

 private:
  std::string_view line() const { return lines_.line().substr(0, lines_.line().find('#')); }

  std::uint64_t take_count(std::string_view& rest, std::string_view what) const {
    const auto word = take_word(rest);
    const auto value = to_integer<std::uint64_t>(word);
    if (!value) {
      lines_.fail(fmt::format("{} is not a count or index, expected {}", in_quotes(word), what));
    }
    return *value;
  }

  void read_header() {
    lines_.require("the word OFF");
    std::string_view rest = line();
    const auto word = take_word(rest);
    if (word != "OFF") {
      lines_.fail(fmt::format("{} instead of the word OFF", in_quotes(word)));
    }
    if (trimmed(rest).empty()) {
      lines_.require("the counts of vertices, faces and edges");
      rest = line();
    }
    vertices_ = take_count(rest, "the count of vertices");
    faces_ = take_count(rest, "the count of faces");
    mesh_.reserve(vertices_, faces_);
  }

  void read_vertex() {
    lines_.require(fmt::format("vertex {} of {}", mesh_.vertex_count(), vertices_));
    std::string_view rest = line();
    const double x = finite_number(source_, lines_.number(), take_word(rest), "x");
    const double y = finite_number(source_, lines_.number(), take_word(rest), "y");
    const auto z = take_word(rest);
    mesh_.add_vertex(x, y, z.empty() ? 0 : finite_number(source_, lines_.number(), z, "z"));
  }

  void read_face() {
    lines_.require(fmt::format("face {} of {}", mesh_.face_count(), faces_));
    std::string_view rest = line();
    const auto count = take_count(rest, "the count of corners");
    corners_.clear();
    for (std::uint64_t i = 0; i < count; ++i) corners_.push_back(take_count(rest, "a corner"));
    mesh_.add_face(corners_, lines_.number());
  }

  const Source& source_;
  Lines lines_;
  MeshBuilder mesh_;
  std::uint64_t vertices_ = 0;
  std::uint64_t faces_ = 0;
  std::vector<std::uint64_t> corners_;
};

}  // namespace

MeshFile read_off(const Source& source) { return OffReader(source).read(); }

void write_off(Output& out, const MeshFile& file) {
  const auto& mesh = file.mesh;
  out << "OFF\n" << mesh.points.size() << ' ' << mesh.face_count() << " 0\n";
  out.each(mesh.points.size(), [&](TextBuffer& to, std::size_t v) {
    to << mesh.points[v].x << ' ' << mesh.points[v].y << ' ' << height(file, v) << '\n';
  });
  out.each(mesh.face_count(), [&](TextBuffer& to, std::size_t f) {
    to << mesh.face(f).size();
    for (const VertexId v : mesh.face(f)) to << ' ' << v;
    to << '\n';
  });
}

}  // namespace quadloom::io
