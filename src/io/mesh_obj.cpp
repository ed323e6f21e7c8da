// Wavefront .obj: v x y z, f i j k ..., from 1. Corners may carry texture and normal numbers
// (i/t/n), count from the end (-1 is the last vertex so far), and lines may go on after a \.
// Groups, materials, normals and the like are skipped.

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "io/mesh_builder.hpp"
#include "io/mesh_formats.hpp"
#include "io/text.hpp"

namespace quadloom::io {
namespace {

constexpr auto kSkipped = std::to_array<std::string_view>(
    {"vt",     "vn",         "vp",        "o",        "g",    "s",      "mg",     "usemtl",
     "mtllib", "l",          "p",         "deg",      "bmat", "step",   "curv",   "curv2",
     "cstype", "surf",       "parm",      "trim",     "hole", "scrv",   "sp",     "end",
     "con",    "bevel",      "c_interp",  "d_interp", "lod",  "usemap", "maplib", "ctech",
     "stech",  "shadow_obj", "trace_obj", "call",     "csh"});

class ObjReader {
 public:
  explicit ObjReader(const Source& source) : source_(source), lines_(source), mesh_(source, 1) {}

  MeshFile read() {
    while (lines_.next()) {
      std::string_view line = joined_line();
      line = line.substr(0, line.find('#'));
      const auto keyword = take_word(line);
      if (keyword == "v") {
        read_vertex(line);
      } else if (keyword == "f") {
        read_face(line);
      } else if (!keyword.empty() && std::ranges::find(kSkipped, keyword) == kSkipped.end()) {
        lines_.fail(fmt::format("{} starts no line of an .obj file", in_quotes(keyword)));
      }
    }
    if (mesh_.vertex_count() == 0) fail_in(source_, "no vertices");
    return mesh_.finish();
  }

 private:
  /// The line, with the next ones as long as it ends in a backslash.
  std::string_view joined_line() {
    first_line_ = lines_.number();
    if (!lines_.line().ends_with('\\')) return lines_.line();
    joined_.clear();
    do {
      joined_ += lines_.line();
      joined_.back() = ' ';
    } while (lines_.next() && lines_.line().ends_with('\\'));
    joined_ += lines_.line().ends_with('\\') ? "" : lines_.line();
    return joined_;
  }

  void read_vertex(std::string_view line) {
    const double x = finite_number(source_, first_line_, take_word(line), "x");
    const double y = finite_number(source_, first_line_, take_word(line), "y");
    const auto z = take_word(line);
    mesh_.add_vertex(x, y, z.empty() ? 0 : finite_number(source_, first_line_, z, "z"));
  }

  void read_face(std::string_view line) {
    corners_.clear();
    for (auto word = take_word(line); !word.empty(); word = take_word(line)) {
      const auto index = to_integer<std::int64_t>(word.substr(0, word.find('/')));
      const auto count = static_cast<std::int64_t>(mesh_.vertex_count());
      if (!index || *index == 0 || *index < -count) {
        fail_at(source_, first_line_, fmt::format("{} is no vertex of a face", in_quotes(word)));
      }
      corners_.push_back(static_cast<std::uint64_t>(*index > 0 ? *index - 1 : count + *index));
    }
    mesh_.add_face(corners_, first_line_);
  }

  const Source& source_;
  Lines lines_;
  MeshBuilder mesh_;
  std::size_t first_line_ = 0;
  std::string joined_;
  std::vector<std::uint64_t> corners_;
};

}  // namespace

MeshFile read_obj(const Source& source) { return ObjReader(source).read(); }

void write_obj(Output& out, const MeshFile& file) {
  const auto& mesh = file.mesh;
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    out << "v " << mesh.points[v].x << ' ' << mesh.points[v].y << ' ' << height(file, v) << '\n';
  }
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    out << 'f';
    for (const VertexId v : mesh.face(f)) out << ' ' << std::uint64_t{v} + 1;
    out << '\n';
  }
}

}  // namespace quadloom::io
