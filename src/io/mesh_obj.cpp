// Wavefront .obj: v x y z, f i j k ..., from 1. Corners may carry texture and normal numbers
// (i/t/n), count from the end (-1 is the last vertex so far), and lines may go on after a \. Lines
// l i j k ... are edges. If the faces are in several groups (g) or of several materials (usemtl), these
// are numbered from 0 in the order of their first lines, as face data "group" and "material". Normals
// and the like are skipped.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <unordered_map>

#include "io/mesh_builder.hpp"
#include "io/mesh_formats.hpp"
#include "io/text.hpp"

namespace quadloom::io {
namespace {

constexpr auto kSkipped = std::to_array<std::string_view>(
    {"vt",    "vn",    "vp",         "o",         "s",    "mg",     "mtllib",
     "p",     "deg",   "bmat",       "step",      "curv", "curv2",  "cstype",
     "surf",  "parm",  "trim",       "hole",      "scrv", "sp",     "end",
     "con",   "bevel", "c_interp",   "d_interp",  "lod",  "usemap", "maplib",
     "ctech", "stech", "shadow_obj", "trace_obj", "call", "csh"});

/// The name that holds for the faces that follow, as a number.
class Names {
 public:
  void select(std::string_view name) {
    const auto [at, added] = numbers_.try_emplace(std::string(name), numbers_.size());
    current_ = static_cast<double>(at->second);
  }

  /// Faces before the first name have a number of their own.
  void add_face() {
    if (current_ < 0) select("");
    of_face_.push_back(current_);
  }

  void add_to(MeshFile& file, const std::string& name) {
    const bool several = std::ranges::any_of(of_face_, [&](double n) { return n != of_face_[0]; });
    if (several) file.face_data.push_back({name, std::move(of_face_)});
  }

 private:
  std::unordered_map<std::string, std::size_t> numbers_;
  double current_ = -1;
  std::vector<double> of_face_;
};

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
      } else if (keyword == "l") {
        read_line(line);
      } else if (keyword == "g") {
        groups_.select(trimmed(line));
      } else if (keyword == "usemtl") {
        materials_.select(trimmed(line));
      } else if (!keyword.empty() && std::ranges::find(kSkipped, keyword) == kSkipped.end()) {
        lines_.fail(fmt::format("{} starts no line of an .obj file", in_quotes(keyword)));
      }
    }
    if (mesh_.vertex_count() == 0) fail_in(source_, "no vertices");
    MeshFile out = mesh_.finish();
    groups_.add_to(out, "group");
    materials_.add_to(out, "material");
    return out;
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
    read_corners(line, "face");
    mesh_.add_face(corners_, first_line_);
    groups_.add_face();
    materials_.add_face();
  }

  void read_line(std::string_view line) {
    read_corners(line, "line");
    if (corners_.size() < 2) {
      fail_at(source_, first_line_, fmt::format("a line of {} vertices", corners_.size()));
    }
    for (std::size_t i = 1; i < corners_.size(); ++i) {
      mesh_.add_edge(corners_[i - 1], corners_[i], first_line_);
    }
  }

  void read_corners(std::string_view line, std::string_view what) {
    corners_.clear();
    for (auto word = take_word(line); !word.empty(); word = take_word(line)) {
      const auto index = to_integer<std::int64_t>(word.substr(0, word.find('/')));
      const auto count = static_cast<std::int64_t>(mesh_.vertex_count());
      if (!index || *index == 0 || *index < -count) {
        fail_at(source_, first_line_,
                fmt::format("{} is no vertex of a {}", in_quotes(word), what));
      }
      corners_.push_back(static_cast<std::uint64_t>(*index > 0 ? *index - 1 : count + *index));
    }
  }

  const Source& source_;
  Lines lines_;
  MeshBuilder mesh_;
  std::size_t first_line_ = 0;
  std::string joined_;
  Names groups_;
  Names materials_;
  std::vector<std::uint64_t> corners_;
};

}  // namespace

MeshFile read_obj(const Source& source) { return ObjReader(source).read(); }

void write_obj(Output& out, const MeshFile& file) {
  const auto& mesh = file.mesh;
  out.each(mesh.points.size(), [&](TextBuffer& to, std::size_t v) {
    to << "v " << mesh.points[v].x << ' ' << mesh.points[v].y << ' ' << height(file, v) << '\n';
  });
  out.each(mesh.face_count(), [&](TextBuffer& to, std::size_t f) {
    to << 'f';
    for (const VertexId v : mesh.face(f)) to << ' ' << std::uint64_t{v} + 1;
    to << '\n';
  });
  for (const Segment& edge : file.edges) {
    out << "l " << std::uint64_t{edge.from} + 1 << ' ' << std::uint64_t{edge.to} + 1 << '\n';
  }
}

}  // namespace quadloom::io
