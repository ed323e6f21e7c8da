// Gmsh's .msh as text, versions 4.1 and 2.2: sections $Name ... $EndName. Read are the nodes (any
// numbers as tags) and the elements that are triangles (type 2) or quadrilaterals (type 3); points
// and lines are skipped, and so are other sections.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

#include "io/mesh_builder.hpp"
#include "io/mesh_formats.hpp"
#include "io/text.hpp"

namespace quadloom::io {
namespace {

constexpr std::uint64_t kLine = 1, kTriangle = 2, kQuad = 3, kPoint = 15;

// ---- Reading. ----

class MshReader {
 public:
  explicit MshReader(const Source& source) : source_(source), words_(source), mesh_(source) {}

  MeshFile read() {
    if (words_.next() != "$MeshFormat") words_.fail("the file does not begin with $MeshFormat");
    read_format();
    for (auto word = words_.next(); !word.empty(); word = words_.next()) {
      if (!word.starts_with('$')) {
        words_.fail(fmt::format("{} where a section should begin", in_quotes(word)));
      }
      if (word == "$Nodes") {
        new_format_ ? read_nodes41() : read_nodes22();
        sort_tags();
      } else if (word == "$Elements") {
        new_format_ ? read_elements41() : read_elements22();
      } else {
        skip_section(word);
      }
    }
    if (mesh_.vertex_count() == 0) fail_in(source_, "no nodes");
    return mesh_.finish();
  }

 private:
  void read_format() {
    const auto version = words_.require("the version");
    if (version != "4.1" && version != "2.2") {
      words_.fail(
          fmt::format("version {} of .msh cannot be read, only 4.1 and 2.2", in_quotes(version)));
    }
    new_format_ = version == "4.1";
    if (words_.require("the file type") != "0")
      words_.fail("a binary .msh cannot be read, only text");
    words_.require("the size of numbers");
    end_section("$EndMeshFormat");
  }

  void end_section(std::string_view name) {
    const auto word = words_.require(name);
    if (word != name) words_.fail(fmt::format("{}, expected {}", in_quotes(word), name));
  }

  void skip_section(std::string_view name) {
    const std::string end = "$End" + std::string(name.substr(1));
    while (words_.require(end) != end) {
    }
  }

  void add_node(std::uint64_t tag) {
    const double x = words_.finite("x"), y = words_.finite("y"), z = words_.finite("z");
    tags_.push_back({tag, static_cast<VertexId>(mesh_.vertex_count())});
    mesh_.add_vertex(x, y, z);
  }

  void read_nodes22() {
    const auto count = words_.index("the count of nodes");
    mesh_.reserve(count, 0);
    for (std::uint64_t i = 0; i < count; ++i) add_node(words_.index("a node's number"));
    end_section("$EndNodes");
  }

  void read_nodes41() {
    const auto blocks = words_.index("the count of blocks");
    mesh_.reserve(words_.index("the count of nodes"), 0);
    words_.index("the least tag");
    words_.index("the greatest tag");
    std::vector<std::uint64_t> tags;
    for (std::uint64_t b = 0; b < blocks; ++b) {
      const auto dimension = words_.index("a dimension");
      words_.number("an entity");
      const bool parametric = words_.index("0 or 1 for parametric") != 0;
      const auto count = words_.index("the count of nodes");
      tags.clear();
      for (std::uint64_t i = 0; i < count; ++i) tags.push_back(words_.index("a node's tag"));
      for (const auto tag : tags) {
        add_node(tag);
        for (std::uint64_t i = 0; parametric && i < std::min<std::uint64_t>(dimension, 3); ++i) {
          words_.number("a parameter");
        }
      }
    }
    end_section("$EndNodes");
  }

  void sort_tags() {
    std::ranges::sort(tags_, {}, &Tag::number);
    const auto same = [](const Tag& a, const Tag& b) { return a.number == b.number; };
    const auto twice = std::ranges::adjacent_find(tags_, same);
    if (twice != tags_.end()) words_.fail(fmt::format("node {} is there twice", twice->number));
  }

  VertexId vertex_of(std::uint64_t tag) {
    if (tag - 1 < tags_.size() && tags_[tag - 1].number == tag) return tags_[tag - 1].vertex;
    const auto at = std::ranges::lower_bound(tags_, tag, {}, &Tag::number);
    if (at != tags_.end() && at->number == tag) return at->vertex;
    throw Error(ErrorCode::kIndexOutOfRange,
                fmt::format("{}, line {}: element names node {}, which is not there", source_.name,
                            words_.line(), tag),
                {mesh_.face_count(), static_cast<std::size_t>(tag)});
  }

  void read_corners(std::uint64_t type) {
    corners_.clear();
    const std::size_t count = corner_count(type);
    for (std::size_t i = 0; i < count; ++i) {
      const auto tag = words_.index("a node's tag");
      if (type == kTriangle || type == kQuad) corners_.push_back(vertex_of(tag));
    }
    if (!corners_.empty()) mesh_.add_face(corners_, words_.line());
  }

  std::size_t corner_count(std::uint64_t type) const {
    if (type == kPoint) return 1;
    if (type == kLine) return 2;
    if (type == kTriangle) return 3;
    if (type == kQuad) return 4;
    words_.fail(
        fmt::format("elements of type {} cannot be read, only triangles (2), quads (3), "
                    "lines (1) and points (15)",
                    type));
  }

  void read_elements22() {
    const auto count = words_.index("the count of elements");
    for (std::uint64_t i = 0; i < count; ++i) {
      words_.index("an element's number");
      const auto type = words_.index("an element's type");
      const auto tags = words_.index("the count of tags");
      for (std::uint64_t t = 0; t < tags; ++t) words_.number("a tag");
      read_corners(type);
    }
    end_section("$EndElements");
  }

  void read_elements41() {
    const auto blocks = words_.index("the count of blocks");
    words_.index("the count of elements");
    words_.index("the least tag");
    words_.index("the greatest tag");
    for (std::uint64_t b = 0; b < blocks; ++b) {
      words_.index("a dimension");
      words_.number("an entity");
      const auto type = words_.index("the type of elements");
      const auto count = words_.index("the count of elements");
      for (std::uint64_t i = 0; i < count; ++i) {
        words_.index("an element's tag");
        read_corners(type);
      }
    }
    end_section("$EndElements");
  }

  struct Tag {
    std::uint64_t number;
    VertexId vertex;
  };

  const Source& source_;
  Words words_;
  MeshBuilder mesh_;
  bool new_format_ = true;
  std::vector<Tag> tags_;  // sorted once all nodes are read
  std::vector<std::uint64_t> corners_;
};

// ---- Writing. ----

void check_corners(const PolygonMesh& mesh) {
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const std::size_t corners = mesh.face(f).size();
    if (corners == 3 || corners == 4) continue;
    throw Error(
        ErrorCode::kBadOption,
        fmt::format("face {} has {} corners; .msh holds triangles and quads only", f, corners),
        {f});
  }
}

std::uint64_t type_of(const PolygonMesh& mesh, std::size_t f) {
  return mesh.face(f).size() == 3 ? kTriangle : kQuad;
}

void write_node(Output& out, const MeshFile& file, std::size_t v) {
  out << file.mesh.points[v].x << ' ' << file.mesh.points[v].y << ' ' << height(file, v) << '\n';
}

void write_corners(Output& out, const PolygonMesh& mesh, std::size_t f) {
  for (const VertexId v : mesh.face(f)) out << ' ' << std::uint64_t{v} + 1;
  out << '\n';
}

/// The one surface that all nodes and elements belong to, with its bounding box.
void write_entity(Output& out, const MeshFile& file) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::array<double, 3> low = {infinity, infinity, infinity},
                        high = {-infinity, -infinity, -infinity};
  for (std::size_t v = 0; v < file.mesh.points.size(); ++v) {
    const std::array<double, 3> p = {file.mesh.points[v].x, file.mesh.points[v].y, height(file, v)};
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], p[i]);
      high[i] = std::max(high[i], p[i]);
    }
  }
  if (file.mesh.points.empty()) low = high = {0, 0, 0};
  out << "$Entities\n0 0 1 0\n1";
  for (const double v : low) out << ' ' << v;
  for (const double v : high) out << ' ' << v;
  out << " 0 0\n$EndEntities\n";
}

/// Faces f to the end of their run of equal corner counts.
std::size_t end_of_run(const PolygonMesh& mesh, std::size_t f) {
  const auto type = type_of(mesh, f);
  while (f < mesh.face_count() && type_of(mesh, f) == type) ++f;
  return f;
}

std::size_t count_runs(const PolygonMesh& mesh) {
  std::size_t runs = 0;
  for (std::size_t f = 0; f < mesh.face_count(); f = end_of_run(mesh, f)) ++runs;
  return runs;
}

}  // namespace

MeshFile read_msh(const Source& source) { return MshReader(source).read(); }

void write_msh41(Output& out, const MeshFile& file) {
  const auto& mesh = file.mesh;
  check_corners(mesh);
  const std::size_t nodes = mesh.points.size(), faces = mesh.face_count();
  out << "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
  write_entity(out, file);
  out << "$Nodes\n1 " << nodes << " 1 " << nodes << "\n2 1 0 " << nodes << '\n';
  for (std::size_t v = 0; v < nodes; ++v) out << v + 1 << '\n';
  for (std::size_t v = 0; v < nodes; ++v) write_node(out, file, v);
  out << "$EndNodes\n$Elements\n" << count_runs(mesh) << ' ' << faces << " 1 " << faces << '\n';
  for (std::size_t f = 0; f < faces;) {
    const std::size_t end = end_of_run(mesh, f);
    out << "2 1 " << type_of(mesh, f) << ' ' << end - f << '\n';
    for (; f < end; ++f) {
      out << f + 1;
      write_corners(out, mesh, f);
    }
  }
  out << "$EndElements\n";
}

void write_msh22(Output& out, const MeshFile& file) {
  const auto& mesh = file.mesh;
  check_corners(mesh);
  out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" << mesh.points.size() << '\n';
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    out << v + 1 << ' ';
    write_node(out, file, v);
  }
  out << "$EndNodes\n$Elements\n" << mesh.face_count() << '\n';
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    out << f + 1 << ' ' << type_of(mesh, f) << " 2 0 1";
    write_corners(out, mesh, f);
  }
  out << "$EndElements\n";
}

}  // namespace quadloom::io
