// Gmsh's .msh, versions 4.1 and 2.2, text and binary of both byte orders: sections $Name ... $EndName.
// Read are the nodes (any numbers as tags); the elements that are triangles, quadrilaterals or lines,
// those of second order by their corners; the first physical group and the entity of each face as the
// face data "physical" and "entity"; and the scalars of $NodeData and $ElementData. Points and other
// sections are skipped. In a binary file the numbers are as in the text, as 32-bit integers, doubles
// and (4.1) sizes; only version 2.2 orders its elements otherwise.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <unordered_map>

#include "io/mesh_builder.hpp"
#include "io/mesh_formats.hpp"
#include "io/msh_data.hpp"
#include "io/msh_tokens.hpp"
#include "io/numbers.hpp"

namespace quadloom::io {
namespace {

/// A type of elements: how many nodes it has, and how many corners, which come first.
struct ElementType {
  std::uint64_t number;
  std::size_t nodes;
  std::size_t corners;
};
constexpr std::array kTypes = {
    ElementType{1, 2, 2}, ElementType{2, 3, 3}, ElementType{3, 4, 4},  ElementType{15, 1, 1},
    ElementType{8, 3, 2}, ElementType{9, 6, 3}, ElementType{16, 8, 4}, ElementType{10, 9, 4},
};

class MshReader {
 public:
  explicit MshReader(const Source& source) : source_(source), tokens_(source), mesh_(source) {}

  MeshFile read() {
    if (tokens_.word() != "$MeshFormat") tokens_.fail("the file does not begin with $MeshFormat");
    read_format();
    for (auto word = tokens_.word(); !word.empty(); word = tokens_.word()) read_section(word);
    if (mesh_.vertex_count() == 0) fail_in(source_, "no nodes");
    MeshFile out = mesh_.finish();
    add_labels(out);
    add_msh_data(vertex_data_, out.mesh.points.size(), out.vertex_data);
    add_msh_data(face_data_, out.mesh.face_count(), out.face_data);
    return out;
  }

 private:
  void read_section(std::string_view word) {
    if (!word.starts_with('$')) {
      tokens_.fail(fmt::format("{} where a section should begin", in_quotes(word)));
    }
    if (word == "$Entities" && new_format_) {
      read_entities();
    } else if (word == "$Nodes") {
      new_format_ ? read_nodes41() : read_nodes22();
      tokens_.expect("$EndNodes");
      if (const auto twice = nodes_.sort()) {
        tokens_.fail(fmt::format("node {} is there twice", *twice));
      }
    } else if (word == "$Elements") {
      if (new_format_) {
        read_elements41();
      } else {
        tokens_.binary() ? read_binary_elements22() : read_elements22();
      }
      tokens_.expect("$EndElements");
      faces_.sort();
    } else if (word == "$NodeData") {
      read_msh_data(tokens_, nodes_, vertex_data_);
      tokens_.expect("$EndNodeData");
    } else if (word == "$ElementData") {
      read_msh_data(tokens_, faces_, face_data_);
      tokens_.expect("$EndElementData");
    } else {
      tokens_.skip_section(word);
    }
  }

  void read_format() {
    const auto version = tokens_.require("the version");
    if (version != "4.1" && version != "2.2") {
      tokens_.fail(
          fmt::format("version {} of .msh cannot be read, only 4.1 and 2.2", in_quotes(version)));
    }
    new_format_ = version == "4.1";
    const auto type = tokens_.text_count("the file type");
    if (type > 1) tokens_.fail(fmt::format("file type {}, there are 0 and 1", type));
    const auto size = tokens_.text_count("the size of numbers");
    if (type == 1) {
      if (size != 8 && (size != 4 || !new_format_)) {
        tokens_.fail(fmt::format("numbers of {} bytes cannot be read", size));
      }
      tokens_.set_binary(false, size);
      tokens_.end_text();
      tokens_.set_binary(tokens_.swapped_one(), size);
    }
    tokens_.expect("$EndMeshFormat");
  }

  // ---- Entities: the first physical group of each surface. ----

  void read_entities() {
    tokens_.end_text();
    std::array<std::uint64_t, 4> count{};
    for (auto& n : count) n = tokens_.size("a count of entities");
    for (std::size_t dimension = 0; dimension < 4; ++dimension) {
      for (std::uint64_t i = 0; i < count[dimension]; ++i) read_entity(dimension);
    }
    tokens_.expect("$EndEntities");
  }

  void read_entity(std::size_t dimension) {
    const auto tag = tokens_.integer("an entity's tag");
    for (int i = 0; i < (dimension == 0 ? 3 : 6); ++i) tokens_.number("a bound");
    const auto groups = tokens_.size("a count of physical groups");
    for (std::uint64_t i = 0; i < groups; ++i) {
      const auto group = tokens_.integer("a physical group");
      if (i == 0 && dimension == 2) physical_of_[tag] = static_cast<double>(group);
    }
    if (dimension == 0) return;
    const auto borders = tokens_.size("a count of bounding entities");
    for (std::uint64_t i = 0; i < borders; ++i) tokens_.integer("a bounding entity");
  }

  // ---- Nodes. ----

  void add_node(std::uint64_t tag) {
    const double x = tokens_.finite("x"), y = tokens_.finite("y"), z = tokens_.finite("z");
    nodes_.add(tag);
    mesh_.add_vertex(x, y, z);
  }

  void read_nodes22() {
    const auto count = tokens_.text_count("the count of nodes");
    tokens_.end_text();
    mesh_.reserve(count, 0);
    for (std::uint64_t i = 0; i < count; ++i) add_node(tokens_.index("a node's number"));
  }

  void read_nodes41() {
    tokens_.end_text();
    const auto blocks = tokens_.size("the count of blocks");
    mesh_.reserve(tokens_.size("the count of nodes"), 0);
    tokens_.size("the least tag");
    tokens_.size("the greatest tag");
    std::vector<std::uint64_t> tags;
    for (std::uint64_t b = 0; b < blocks; ++b) {
      const auto dimension = tokens_.index("a dimension");
      tokens_.integer("an entity");
      const bool parametric = tokens_.index("0 or 1 for parametric") != 0;
      const auto count = tokens_.size("the count of nodes");
      tags.clear();
      for (std::uint64_t i = 0; i < count; ++i) tags.push_back(tokens_.size("a node's tag"));
      for (const auto tag : tags) {
        add_node(tag);
        for (std::uint64_t i = 0; parametric && i < std::min<std::uint64_t>(dimension, 3); ++i) {
          tokens_.number("a parameter");
        }
      }
    }
  }

  std::uint64_t vertex_of(std::uint64_t tag) const {
    if (const auto vertex = nodes_.find(tag)) return *vertex;
    const std::string place = tokens_.line() == 0 ? "" : fmt::format(", line {}", tokens_.line());
    throw Error(
        ErrorCode::kIndexOutOfRange,
        fmt::format("{}{}: element names node {}, which is not there", source_.name, place, tag),
        {mesh_.face_count(), static_cast<std::size_t>(tag)});
  }

  // ---- Elements. ----

  const ElementType& element_type(std::uint64_t number) const {
    const auto at = std::ranges::find(kTypes, number, &ElementType::number);
    if (at != kTypes.end()) return *at;
    tokens_.fail(
        fmt::format("elements of type {} cannot be read, only points, lines, triangles and quads "
                    "(15, 1, 8, 2, 9, 3, 16 and 10)",
                    number));
  }

  template <class ReadNode>
  void read_element(const ElementType& type, std::uint64_t number, double physical, double entity,
                    ReadNode read_node) {
    corners_.clear();
    for (std::size_t i = 0; i < type.nodes; ++i) {
      const std::uint64_t tag = read_node();
      if (i < type.corners && type.corners > 1) corners_.push_back(vertex_of(tag));
    }
    if (type.corners == 2) mesh_.add_edge(corners_[0], corners_[1], tokens_.line());
    if (type.corners < 3) return;
    mesh_.add_face(corners_, tokens_.line());
    faces_.add(number);
    physical_.push_back(physical);
    entity_.push_back(entity);
  }

  /// An element's number, if that is not read yet, tags and nodes, as version 2.2 has them.
  void read_element22(const ElementType& type, std::uint64_t number, std::uint64_t tags) {
    std::array<double, 2> label = {0, 0};  // the physical group and the entity
    for (std::uint64_t t = 0; t < tags; ++t) {
      const auto tag = tokens_.integer("a tag");
      if (t < 2) label[t] = static_cast<double>(tag);
    }
    read_element(type, number, label[0], label[1], [&] { return tokens_.index("a node's tag"); });
  }

  //    1 2 2 7 1  5 6 8        number, type, count of tags, tags, nodes
  void read_elements22() {
    const auto count = tokens_.text_count("the count of elements");
    for (std::uint64_t i = 0; i < count; ++i) {
      const auto number = tokens_.index("an element's number");
      const auto& type = element_type(tokens_.index("an element's type"));
      read_element22(type, number, tokens_.index("the count of tags"));
    }
  }

  //    2 1000 2                type, elements in this block, count of tags; then for each
  //    1 7 1  5 6 8            number, tags, nodes
  void read_binary_elements22() {
    const auto count = tokens_.text_count("the count of elements");
    tokens_.end_text();
    for (std::uint64_t i = 0; i < count;) {
      const auto& type = element_type(tokens_.index("an element's type"));
      const auto block = tokens_.index("the count of elements");
      const auto tags = tokens_.index("the count of tags");
      if (block > count - i) tokens_.fail("more elements than their count says");
      for (std::uint64_t k = 0; k < block; ++k, ++i) {
        const auto number = tokens_.index("an element's number");
        read_element22(type, number, tags);
      }
    }
  }

  void read_elements41() {
    tokens_.end_text();
    const auto blocks = tokens_.size("the count of blocks");
    tokens_.size("the count of elements");
    tokens_.size("the least tag");
    tokens_.size("the greatest tag");
    for (std::uint64_t b = 0; b < blocks; ++b) {
      tokens_.index("a dimension");
      const auto entity = tokens_.integer("an entity");
      const auto& type = element_type(tokens_.index("the type of elements"));
      const auto count = tokens_.size("the count of elements");
      const auto at = physical_of_.find(entity);
      const double physical = at == physical_of_.end() ? 0 : at->second;
      for (std::uint64_t i = 0; i < count; ++i) {
        const auto number = tokens_.size("an element's tag");
        read_element(type, number, physical, static_cast<double>(entity),
                     [&] { return tokens_.size("a node's tag"); });
      }
    }
  }

  /// Groups if there is one, entities if there are two.
  void add_labels(MeshFile& out) {
    if (std::ranges::any_of(physical_, [](double label) { return label != 0; })) {
      out.face_data.push_back({"physical", std::move(physical_)});
    }
    if (std::ranges::any_of(entity_, [&](double label) { return label != entity_[0]; })) {
      out.face_data.push_back({"entity", std::move(entity_)});
    }
  }

  const Source& source_;
  MshTokens tokens_;
  MeshBuilder mesh_;
  bool new_format_ = true;
  NumberMap nodes_;
  NumberMap faces_;
  std::unordered_map<std::int64_t, double> physical_of_;  // of surfaces
  std::vector<double> physical_;                          // per face
  std::vector<double> entity_;
  std::vector<MshData> vertex_data_;
  std::vector<MshData> face_data_;
  std::vector<std::uint64_t> corners_;
};

}  // namespace

MeshFile read_msh(const Source& source) { return MshReader(source).read(); }

}  // namespace quadloom::io
