// Writes Gmsh's .msh as text, versions 4.1 and 2.2. Whole numbers named "physical" and "entity" among
// the face data become the groups and surfaces of the faces, other data $NodeData and $ElementData
// (without the entries that are NaN), the edges lines.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "io/mesh_formats.hpp"

namespace quadloom::io {
namespace {

constexpr int kLine = 1, kTriangle = 2, kQuad = 3;

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

// ---- Surfaces. ----

/// The face data of that name if they are whole numbers from `least` on that 32 bits hold.
const Attribute* find_labels(const MeshFile& file, std::string_view name, double least) {
  const auto at = std::ranges::find(file.face_data, name, &Attribute::name);
  if (at == file.face_data.end()) return nullptr;
  const bool whole = std::ranges::all_of(at->values, [&](double value) {
    return value >= least && value <= std::numeric_limits<std::int32_t>::max() &&
           value == std::floor(value);
  });
  return whole ? &*at : nullptr;
}

/// An entity of dimension 2 and its physical group (0: none).
struct Surface {
  int entity = 1;
  int physical = 0;
  friend auto operator<=>(const Surface&, const Surface&) = default;
};

class Surfaces {
 public:
  explicit Surfaces(const MeshFile& file)
      : physical_(find_labels(file, "physical", std::numeric_limits<std::int32_t>::min())),
        entity_(find_labels(file, "entity", 1)) {
    std::set<Surface> all;
    for (std::size_t f = 0; f < file.mesh.face_count(); ++f) all.insert(given(f));
    if (all.empty()) all.insert(Surface{});
    surfaces_.assign(all.begin(), all.end());
    const auto same = [](const Surface& a, const Surface& b) { return a.entity == b.entity; };
    renumber_ = std::ranges::adjacent_find(surfaces_, same) != surfaces_.end();
    if (!renumber_) return;
    for (const Surface& s : surfaces_) group_.push_back(s);
    for (std::size_t i = 0; i < surfaces_.size(); ++i)
      surfaces_[i].entity = static_cast<int>(i) + 1;
  }

  const std::vector<Surface>& all() const { return surfaces_; }

  /// One entity with several groups becomes several entities.
  Surface of(std::size_t f) const {
    const Surface wanted = given(f);
    if (!renumber_) return wanted;
    const auto at = std::ranges::lower_bound(group_, wanted);
    return surfaces_[static_cast<std::size_t>(at - group_.begin())];
  }

  /// Whether these face data are written as groups or entities.
  bool holds(const Attribute& data) const { return &data == physical_ || &data == entity_; }

 private:
  Surface given(std::size_t f) const {
    Surface out;
    if (physical_ != nullptr) out.physical = static_cast<int>(physical_->values[f]);
    if (entity_ != nullptr) out.entity = static_cast<int>(entity_->values[f]);
    return out;
  }

  const Attribute* physical_;
  const Attribute* entity_;
  bool renumber_ = false;
  std::vector<Surface> group_;  // as given, sorted, if they are renumbered
  std::vector<Surface> surfaces_;
};

// ---- Writing. ----

class MshWriter {
 public:
  MshWriter(Output& out, const MeshFile& file)
      : out_(out), file_(file), mesh_(file.mesh), surfaces_(file) {}

  void write41() {
    out_ << "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
    write_entities();
    const std::size_t nodes = mesh_.points.size();
    out_ << "$Nodes\n1 " << nodes << " 1 " << nodes << "\n2 " << surfaces_.all()[0].entity << " 0 "
         << nodes << '\n';
    out_.each(nodes, [](TextBuffer& to, std::size_t v) { to << v + 1 << '\n'; });
    out_.each(nodes, [&](TextBuffer& to, std::size_t v) { write_node(to, v); });
    out_ << "$EndNodes\n";
    write_elements41();
    write_data();
  }

  void write22() {
    out_ << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" << mesh_.points.size() << '\n';
    out_.each(mesh_.points.size(), [&](TextBuffer& to, std::size_t v) {
      to << v + 1 << ' ';
      write_node(to, v);
    });
    out_ << "$EndNodes\n$Elements\n" << mesh_.face_count() + file_.edges.size() << '\n';
    out_.each(mesh_.face_count(), [&](TextBuffer& to, std::size_t f) {
      const Surface surface = surfaces_.of(f);
      to << f + 1 << ' ' << type_of(f) << " 2 " << surface.physical << ' ' << surface.entity;
      write_corners(to, f);
    });
    for (std::size_t e = 0; e < file_.edges.size(); ++e) {
      out_ << mesh_.face_count() + e + 1 << ' ' << kLine << " 2 0 1";
      write_ends(file_.edges[e]);
    }
    out_ << "$EndElements\n";
    write_data();
  }

 private:
  int type_of(std::size_t f) const { return mesh_.face(f).size() == 3 ? kTriangle : kQuad; }

  void write_node(TextBuffer& to, std::size_t v) const {
    to << mesh_.points[v].x << ' ' << mesh_.points[v].y << ' ' << height(file_, v) << '\n';
  }

  void write_corners(TextBuffer& to, std::size_t f) const {
    for (const VertexId v : mesh_.face(f)) to << ' ' << std::uint64_t{v} + 1;
    to << '\n';
  }

  void write_ends(const Segment& edge) {
    out_ << ' ' << std::uint64_t{edge.from} + 1 << ' ' << std::uint64_t{edge.to} + 1 << '\n';
  }

  /// The bounding box of the whole mesh.
  void write_box() {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    std::array<double, 3> low = {infinity, infinity, infinity},
                          high = {-infinity, -infinity, -infinity};
    for (std::size_t v = 0; v < mesh_.points.size(); ++v) {
      const std::array<double, 3> p = {mesh_.points[v].x, mesh_.points[v].y, height(file_, v)};
      for (std::size_t i = 0; i < 3; ++i) {
        low[i] = std::min(low[i], p[i]);
        high[i] = std::max(high[i], p[i]);
      }
    }
    if (mesh_.points.empty()) low = high = {0, 0, 0};
    for (const double v : low) out_ << ' ' << v;
    for (const double v : high) out_ << ' ' << v;
  }

  /// The surfaces, and a curve for the edges.
  void write_entities() {
    const bool curve = !file_.edges.empty();
    out_ << "$Entities\n0 " << (curve ? 1 : 0) << ' ' << surfaces_.all().size() << " 0\n";
    if (curve) {
      out_ << '1';
      write_box();
      out_ << " 0 0\n";
    }
    for (const Surface& surface : surfaces_.all()) {
      out_ << surface.entity;
      write_box();
      if (surface.physical != 0) out_ << " 1 " << surface.physical << " 0\n";
      if (surface.physical == 0) out_ << " 0 0\n";
    }
    out_ << "$EndEntities\n";
  }

  /// Faces f to the end of their run of one type and surface.
  std::size_t end_of_run(std::size_t f) const {
    const int type = type_of(f);
    const Surface surface = surfaces_.of(f);
    while (f < mesh_.face_count() && type_of(f) == type && surfaces_.of(f) == surface) ++f;
    return f;
  }

  void write_elements41() {
    const std::size_t faces = mesh_.face_count(), edges = file_.edges.size();
    std::size_t blocks = edges == 0 ? 0 : 1;
    for (std::size_t f = 0; f < faces; f = end_of_run(f)) ++blocks;
    out_ << "$Elements\n" << blocks << ' ' << faces + edges << " 1 " << faces + edges << '\n';
    for (std::size_t f = 0; f < faces;) {
      const std::size_t end = end_of_run(f);
      out_ << "2 " << surfaces_.of(f).entity << ' ' << type_of(f) << ' ' << end - f << '\n';
      out_.each(end - f, [&](TextBuffer& to, std::size_t i) {
        to << f + i + 1;
        write_corners(to, f + i);
      });
      f = end;
    }
    if (edges > 0) out_ << "1 1 " << kLine << ' ' << edges << '\n';
    for (std::size_t e = 0; e < edges; ++e) {
      out_ << faces + e + 1;
      write_ends(file_.edges[e]);
    }
    out_ << "$EndElements\n";
  }

  void write_data() {
    for (const Attribute& data : file_.vertex_data) write_section("NodeData", data);
    for (const Attribute& data : file_.face_data) {
      if (!surfaces_.holds(data)) write_section("ElementData", data);
    }
  }

  void write_section(std::string_view section, const Attribute& data) {
    std::string name = data.name;
    for (char& c : name) {
      if (static_cast<unsigned char>(c) < 32) c = ' ';
      if (c == '"') c = '\'';
    }
    const auto is_number = [](double value) { return !std::isnan(value); };
    out_ << '$' << section << "\n1\n\"" << name << "\"\n1\n0\n3\n0\n1\n"
         << std::ranges::count_if(data.values, is_number) << '\n';
    out_.each(data.values.size(), [&](TextBuffer& to, std::size_t i) {
      if (is_number(data.values[i])) to << i + 1 << ' ' << data.values[i] << '\n';
    });
    out_ << "$End" << section << '\n';
  }

  Output& out_;
  const MeshFile& file_;
  const PolygonMesh& mesh_;
  Surfaces surfaces_;
};

}  // namespace

void write_msh41(Output& out, const MeshFile& file) {
  check_corners(file.mesh);
  MshWriter(out, file).write41();
}

void write_msh22(Output& out, const MeshFile& file) {
  check_corners(file.mesh);
  MshWriter(out, file).write22();
}

}  // namespace quadloom::io
