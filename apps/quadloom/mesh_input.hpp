// Meshes and polygons from files, made ready for a conversion: connected triangles, regions, edges
// that stay.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "input_kind.hpp"
#include "quadloom/io.hpp"
#include "quadloom/quadrangulate.hpp"

namespace quadloom::app {

struct MeshReading {
  std::string path, format;
  ConnectOptions connect;
  std::string regions = "auto";      // auto, none, or the name of face data
  std::string keep = "lines";        // lines, none, or a file of lines
  std::optional<double> keep_angle;  // degrees
};

/// The source of a conversion. Vertices are numbered as the file has them (merged ones as
/// connect_triangles leaves them; those of polygons as constrained_delaunay has them), faces too
/// (those of polygons are the triangles).
struct SourceMesh {
  TriangleMesh triangles;
  std::vector<std::uint32_t> source_face;  // per triangle
  std::vector<double> z;  // heights and depths over a planar mesh, or of a surface; or empty
  PolygonMesh faces;      // what is certified against; empty for polygons
  std::optional<PlanarInput> polygons;  // what they were given as
  std::vector<Point> inner;             // polygons: the points that must be vertices
  std::vector<io::Attribute> vertex_data, face_data;
  std::vector<Segment> lines;  // of the source, kept or not
  Space space = Space::kPlane;
  std::size_t kept_edges = 0;   // by lines, files and angles
  std::size_t face_count = 0;   // of the file, or the triangles of polygons
  std::size_t input_count = 0;  // vertices of the file, or corners and points
  std::vector<std::string> remarks;
  std::size_t components = 0, boundary_edges = 0, boundary_cycles = 0;
  double read_seconds = 0, connect_seconds = 0;
};

/// Reads and connects a mesh (kMesh) or reads and triangulates polygons (kPolygons). Throws the Errors of
/// the readers, connect_triangles and constrained_delaunay; kBadOption for names that are not there.
SourceMesh read_source(const MeshReading& reading, FoundInput input);

/// The values of a face or vertex attribute by name, null if there is none of that name.
const std::vector<double>* find_data(const std::vector<io::Attribute>& data,
                                     const std::string& name);

}  // namespace quadloom::app
