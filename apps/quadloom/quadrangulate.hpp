// quadloom quadrangulate: what its two halves, points and meshes, share.
#pragma once

#include <string>

#include "convert_mesh.hpp"
#include "make_mesh.hpp"
#include "options.hpp"

namespace quadloom::app {

/// Where the results go.
struct OutputOptions {
  std::string mesh, mesh_format, picture, report;
  bool quiet = false;
};

/// Points to a mesh of quads (or of faces of k corners); gives the exit code.
int quadrangulate_point_file(const std::string& path, const io::PointTable& table,
                             double read_seconds, const PointRun& run, const OutputOptions& output);

/// A mesh or polygons to a mesh of quads; gives the exit code.
struct MeshRun {
  MeshReading reading;
  ConversionOptions conversion;
};
int quadrangulate_mesh_file(FoundInput input, MeshRun run, const OutputOptions& output);

}  // namespace quadloom::app
