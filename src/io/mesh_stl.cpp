// .stl, text or binary: triangles with the coordinates of their corners, and nothing that says which
// corners are the same. Corners with the same three coordinates, bit by bit (-0.0 is 0), become one
// vertex; facets of which two corners are the same are left out and counted.
//
//    solid NAME                         80 bytes of any text (it may begin with "solid")
//    facet normal 0 0 1                 the count of facets, 32 bits
//      outer loop                       a facet: the normal and three corners, 12 floats,
//        vertex 0 0 0                     and 16 bits
//        vertex 1 0 0
//        vertex 0 1 0                   All in little-endian order. A file of exactly
//      endloop                          84 + 50 * count bytes is binary.
//    endfacet
//    endsolid NAME
//
// Normals are skipped: the order of the corners says the same. The facets of several solids in one
// text get the solid's number (from 0) as the face data "solid", 16 bits that are not all 0 become
// the face data "attribute".

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <tuple>

#include "io/binary.hpp"
#include "io/mesh_builder.hpp"
#include "io/mesh_formats.hpp"
#include "io/text.hpp"

namespace quadloom::io {
namespace {

constexpr std::size_t kHeader = 84, kFacet = 50;
constexpr bool kSwap = std::endian::native == std::endian::big;

struct Corner {
  double x, y, z;
  std::uint32_t index;
};

bool same_place(const Corner& a, const Corner& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

/// Facets as they come; finish() makes the mesh.
class Facets {
 public:
  explicit Facets(const Source& source) : source_(source) {}

  void reserve(std::size_t facets) {
    corners_.reserve(3 * facets);
    label_.reserve(facets);
  }

  void add_corner(double x, double y, double z) {
    if (corners_.size() >= kNone - 3) {
      fail_in(source_, "more corners than 32-bit indices can number", ErrorCode::kTooManyPoints);
    }
    corners_.push_back({x + 0.0, y + 0.0, z + 0.0, static_cast<std::uint32_t>(corners_.size())});
  }

  /// After its three corners.
  void end_facet(double label) { label_.push_back(label); }

  /// Vertices are numbered in the order of their first corner.
  MeshFile finish(std::string_view label_name) {
    if (corners_.empty()) fail_in(source_, "no facets");
    MeshBuilder mesh(source_);
    const auto vertex = merge_corners(mesh);
    std::vector<double> labels;
    std::size_t left_out = 0;
    for (std::size_t f = 0; f < label_.size(); ++f) {
      const std::array<std::uint64_t, 3> face = {vertex[3 * f], vertex[3 * f + 1],
                                                 vertex[3 * f + 2]};
      if (face[0] == face[1] || face[1] == face[2] || face[2] == face[0]) {
        ++left_out;
        continue;
      }
      mesh.add_face(face, 0);
      labels.push_back(label_[f]);
    }
    MeshFile out = mesh.finish();
    out.faces_left_out = left_out;
    if (std::ranges::any_of(labels, [](double label) { return label != 0; })) {
      out.face_data.push_back({std::string(label_name), std::move(labels)});
    }
    return out;
  }

 private:
  /// Sorts the corners by place, then gives each place the number of its first corner's turn.
  std::vector<VertexId> merge_corners(MeshBuilder& mesh) const {
    std::vector<Corner> sorted = corners_;
    std::ranges::sort(sorted, [](const Corner& a, const Corner& b) {
      return std::tie(a.x, a.y, a.z, a.index) < std::tie(b.x, b.y, b.z, b.index);
    });
    std::vector<std::uint32_t> first(corners_.size());  // the first corner at the same place
    for (std::size_t i = 0; i < sorted.size(); ++i) {
      const bool again = i > 0 && same_place(sorted[i - 1], sorted[i]);
      first[sorted[i].index] = again ? first[sorted[i - 1].index] : sorted[i].index;
    }
    std::vector<VertexId> vertex(corners_.size());
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      if (first[i] == i) {
        vertex[i] = static_cast<VertexId>(mesh.vertex_count());
        mesh.add_vertex(corners_[i].x, corners_[i].y, corners_[i].z);
      } else {
        vertex[i] = vertex[first[i]];
      }
    }
    return vertex;
  }

  const Source& source_;
  std::vector<Corner> corners_;  // three a facet
  std::vector<double> label_;    // one a facet
};

// ---- Binary. ----

std::uint64_t facet_count(const Source& source) {
  return source.text.size() < kHeader ? 0 : load<std::uint32_t>(source.text.data() + 80, kSwap);
}

bool is_binary(const Source& source) {
  return source.text.size() >= kHeader &&
         source.text.size() == kHeader + kFacet * facet_count(source);
}

MeshFile read_binary(const Source& source) {
  const auto count = static_cast<std::size_t>(facet_count(source));
  Facets facets(source);
  facets.reserve(count);
  for (std::size_t f = 0; f < count; ++f) {
    const char* const at = source.text.data() + kHeader + kFacet * f;
    for (std::size_t corner = 1; corner <= 3; ++corner) {
      std::array<double, 3> p;
      for (std::size_t i = 0; i < 3; ++i) {
        p[i] = load_number(at + 12 * corner + 4 * i, NumberType::kF32, kSwap);
        if (std::isfinite(p[i])) continue;
        fail_in(source, fmt::format("facet {} has a corner that is not finite", f),
                ErrorCode::kNotFinite, {f});
      }
      facets.add_corner(p[0], p[1], p[2]);
    }
    facets.end_facet(load<std::uint16_t>(at + 48, kSwap));
  }
  return facets.finish("attribute");
}

// ---- Text. ----

class StlReader {
 public:
  explicit StlReader(const Source& source) : source_(source), lines_(source), facets_(source) {}

  /// Names of solids are any words, so the file is read line by line.
  MeshFile read() {
    while (next_line()) {
      expect_word("solid");
      read_solid();
      ++solid_;
    }
    return facets_.finish("solid");
  }

 private:
  bool next_line() {
    if (!lines_.next_filled()) return false;
    rest_ = lines_.line();
    return true;
  }

  void require_line(std::string_view what) {
    lines_.require(what);
    rest_ = lines_.line();
  }

  void expect_word(std::string_view word) {
    const auto found = take_word(rest_);
    if (lower_case(found) == word) return;
    lines_.fail(fmt::format("{} instead of the word {}", in_quotes(found), word));
  }

  void read_solid() {
    for (;;) {
      require_line("a facet or the word endsolid");
      const auto word = lower_case(take_word(rest_));
      if (word == "endsolid") return;
      if (word != "facet") {
        lines_.fail(fmt::format("{} instead of a facet or the word endsolid", in_quotes(word)));
      }
      read_facet();
    }
  }

  void read_facet() {
    require_line("the words outer loop");
    expect_word("outer");
    expect_word("loop");
    for (int i = 0; i < 3; ++i) {
      require_line("a vertex");
      expect_word("vertex");
      const double x = finite_number(source_, lines_.number(), take_word(rest_), "x");
      const double y = finite_number(source_, lines_.number(), take_word(rest_), "y");
      const double z = finite_number(source_, lines_.number(), take_word(rest_), "z");
      facets_.add_corner(x, y, z);
    }
    require_line("the word endloop");
    expect_word("endloop");
    require_line("the word endfacet");
    expect_word("endfacet");
    facets_.end_facet(solid_);
  }

  const Source& source_;
  Lines lines_;
  Facets facets_;
  std::string_view rest_;
  double solid_ = 0;
};

}  // namespace

MeshFile read_stl(const Source& source) {
  if (is_binary(source)) return read_binary(source);
  const std::string_view text = without_mark(source.text);
  const auto begin = std::min(text.find_first_not_of(" \t\r\n"), text.size());
  if (lower_case(text.substr(begin, 5)) == "solid") return StlReader(source).read();
  fail_in(source, fmt::format("neither a text that begins with the word solid nor binary: {} "
                              "facets take {} bytes, there are {}",
                              facet_count(source), kHeader + kFacet * facet_count(source),
                              source.text.size()));
}

}  // namespace quadloom::io
