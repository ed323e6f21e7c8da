// The readers and writers of meshes, one file each; mesh.cpp chooses. Readers take text in memory;
// writers may rely on check_writable.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "io/output.hpp"
#include "io/source.hpp"
#include "quadloom/io.hpp"

namespace quadloom::io {

MeshFile read_obj(const Source& source);
MeshFile read_off(const Source& source);
MeshFile read_ply(const Source& source);
MeshFile read_vtu(const Source& source);
MeshFile read_msh(const Source& source);
MeshFile read_stl(const Source& source);
MeshFile read_ele(const Source& source);
MeshFile read_fort14(const Source& source);
MeshFile read_geojson_mesh(const Source& source);

void write_obj(Output& out, const MeshFile& file);
void write_off(Output& out, const MeshFile& file);
void write_ply(Output& out, const MeshFile& file);
void write_vtu_base64(Output& out, const MeshFile& file);
void write_vtu_ascii(Output& out, const MeshFile& file);
void write_msh41(Output& out, const MeshFile& file);
void write_msh22(Output& out, const MeshFile& file);
void write_geojson_mesh(Output& out, const MeshFile& file);

/// A format by its name, which is also a file's extension but for vtu-ascii and msh22.
struct MeshFormat {
  std::string_view name;
  MeshFile (*read)(const Source& source);
  void (*write)(Output& out, const MeshFile& file);  // null: only read
};
std::span<const MeshFormat> mesh_formats();

/// Faces of three corners or more and edges that name vertices there are, finite coordinates, as
/// many numbers of each kind as there are vertices or faces. Throws Error kBadMesh, kIndexOutOfRange, kNotFinite.
void check_writable(const MeshFile& file);

/// The height of a vertex, 0 where there are none.
inline double height(const MeshFile& file, std::size_t v) { return file.z.empty() ? 0 : file.z[v]; }

}  // namespace quadloom::io
