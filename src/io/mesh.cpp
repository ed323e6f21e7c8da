// Meshes in and out: which format, and what no file should hold.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <optional>
#include <system_error>

#include "io/mesh_formats.hpp"
#include "io/text.hpp"

namespace quadloom::io {
namespace {

constexpr std::array kFormats = {
    MeshFormat{"obj", read_obj, write_obj},
    MeshFormat{"off", read_off, write_off},
    MeshFormat{"ply", read_ply, write_ply},
    MeshFormat{"vtu", read_vtu, write_vtu_base64},
    MeshFormat{"msh", read_msh, write_msh41},
    MeshFormat{"geojson", read_geojson_mesh, write_geojson_mesh},
    MeshFormat{"json", read_geojson_mesh, write_geojson_mesh},
    MeshFormat{"vtu-ascii", read_vtu, write_vtu_ascii},
    MeshFormat{"msh22", read_msh, write_msh22},
    MeshFormat{"stl", read_stl, nullptr},
    MeshFormat{"ele", read_ele, nullptr},
    MeshFormat{"14", read_fort14, nullptr},
    MeshFormat{"gr3", read_fort14, nullptr},
};

enum class Use { kRead, kWrite };

const MeshFormat& find_format(const std::string& path, const std::string& format, Use use) {
  const std::string name = format.empty() ? extension_of(path) : format;
  bool only_read = false;
  std::string names;
  for (const auto& known : kFormats) {
    const bool usable = use == Use::kRead || known.write != nullptr;
    if (known.name == name && usable) return known;
    if (known.name == name) only_read = true;
    if (!usable) continue;
    names += names.empty() ? "" : ", ";
    names += known.name;
  }
  std::string what =
      !format.empty() ? fmt::format("no format of meshes is called {}", in_quotes(format))
      : path == "-"   ? fmt::format("the format of {} must be said",
                                  use == Use::kRead ? "standard input" : "standard output")
                      : fmt::format("cannot tell the format of {}", path);
  if (only_read) what = fmt::format("meshes are read from .{} but not written to it", name);
  throw Error(ErrorCode::kBadOption,
              fmt::format("{}; {} are {}", what, only_read ? "written" : "known", names));
}

void check_faces(const PolygonMesh& mesh) {
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto corners = mesh.face(f);
    if (corners.size() < 3) {
      throw Error(ErrorCode::kBadMesh,
                  fmt::format("face {} has {} corners, three are the least", f, corners.size()),
                  {f});
    }
    for (const VertexId v : corners) {
      if (v < mesh.points.size()) continue;
      throw Error(ErrorCode::kIndexOutOfRange,
                  fmt::format("face {} names vertex {}, there are {}", f, v, mesh.points.size()),
                  {f, v});
    }
  }
}

void check_vertices(const MeshFile& file) {
  for (std::size_t v = 0; v < file.mesh.points.size(); ++v) {
    const Point p = file.mesh.points[v];
    if (std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(height(file, v))) continue;
    throw Error(ErrorCode::kNotFinite, fmt::format("vertex {} is not finite", v), {v});
  }
}

void check_sizes(const std::vector<Attribute>& data, std::size_t size, std::string_view what) {
  for (const auto& [name, values] : data) {
    if (values.size() == size) continue;
    throw Error(ErrorCode::kBadMesh, fmt::format("{} has {} numbers for {} {}", in_quotes(name),
                                                 values.size(), size, what));
  }
}

void check_edges(const MeshFile& file) {
  const std::size_t vertices = file.mesh.points.size();
  for (std::size_t e = 0; e < file.edges.size(); ++e) {
    const auto [from, to] = file.edges[e];
    if (from < vertices && to < vertices) continue;
    const VertexId v = std::max(from, to);
    throw Error(ErrorCode::kIndexOutOfRange,
                fmt::format("edge {} names vertex {}, there are {}", e, v, vertices), {e, v});
  }
}

}  // namespace

std::span<const MeshFormat> mesh_formats() { return kFormats; }

void require_mesh_format(const std::string& path, const std::string& format) {
  find_format(path, format, Use::kWrite);
}

void check_writable(const MeshFile& file) {
  const std::size_t vertices = file.mesh.points.size();
  if (!file.z.empty() && file.z.size() != vertices) {
    throw Error(ErrorCode::kBadMesh,
                fmt::format("{} heights for {} vertices", file.z.size(), vertices));
  }
  check_faces(file.mesh);
  check_vertices(file);
  check_edges(file);
  check_sizes(file.vertex_data, vertices, "vertices");
  check_sizes(file.face_data, file.mesh.face_count(), "faces");
}

void write_mesh(const std::string& path, const MeshFile& mesh, const std::string& format) {
  const MeshFormat& chosen = find_format(path, format, Use::kWrite);
  check_writable(mesh);
  Output out(path);
  chosen.write(out, mesh);
  out.commit();
}

MeshFile read_mesh(const std::string& path, const std::string& format) {
  const MeshFormat& chosen = find_format(path, format, Use::kRead);
  const TextBuffer text = read_file(path);
  const auto beside = [&](std::string_view extension) -> std::optional<std::string> {
    auto other = std::filesystem::path(path).replace_extension(extension);
    std::error_code ignored;
    if (path == "-" || !std::filesystem::exists(other, ignored)) return {};
    return read_all(other.string());
  };
  return chosen.read({source_name(path), text.view(), beside});
}

}  // namespace quadloom::io
