// Files: points in, meshes in and out, pictures. In the library quadloom::io.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "quadloom/core.hpp"

namespace quadloom::io {

/// Points as read: coordinates, z where the file has it (else empty), and the line (from 1) of each
/// point in a text file (GeoJSON: empty), for messages.
struct PointTable {
  std::vector<Point> points;
  std::vector<double> z;
  std::vector<std::size_t> line;
};

struct ReadPointsOptions {
  std::string
      format;  // "csv", "xyz" or "geojson"; empty: by the file's extension, xyz for standard input
  std::string columns;  // "x,y", "x,y,z" or any header names or 1-based numbers; empty: from the
                        // header or order
};

/// Reads .csv, .xyz, .txt, .geojson, .json; "-" is standard input. Throws Error kParse naming the
/// line (culprit), kNotFinite likewise, kFile. An empty file is kTooFewPoints.
PointTable read_points(const std::string& path, const ReadPointsOptions& options = {});

/// One number a vertex or a face, carried from readers to writers.
struct Attribute {
  std::string name;
  std::vector<double> values;
};

/// A mesh with what files carry beside it.
struct MeshFile {
  PolygonMesh mesh;
  std::vector<double> z;  ///< per vertex, or empty
  std::vector<Attribute> vertex_data;
  std::vector<Attribute> face_data;
};

/// Writes by extension: .obj .off .ply .vtu .msh (4.1; "msh22" for 2.2) .geojson, or `format`.
/// Coordinates read back bit for bit. Written to a temporary name beside the target, then renamed.
/// "-" is standard output (needs `format`). Throws Error kFile, kBadOption.
void write_mesh(const std::string& path, const MeshFile& mesh, const std::string& format = {});

/// Reads what write_mesh writes. Throws Error kParse, kIndexOutOfRange, kFile.
MeshFile read_mesh(const std::string& path, const std::string& format = {});

/// Writes a text file by temporary name and rename; "-" is standard output. For reports.
void write_text(const std::string& path, std::string_view text);

/// One point a line, x y [z], 17 digits; .csv with a header; .geojson as MultiPoint; by extension.
void write_points(const std::string& path, std::span<const Point> points,
                  std::span<const double> z = {});

/// Polylines or rings as GeoJSON (LineString or Polygon features), with one number each under
/// `name`.
struct Polyline {
  std::vector<Point> points;
  bool closed = false;
  double value = 0;
};
void write_polylines(const std::string& path, std::span<const Polyline> lines,
                     const std::string& name);

enum class ColourBy { kQuality, kConvexity, kNone };

struct DrawOptions {
  int width = 1600;  // pixels (points in SVG and PDF); the height follows from the aspect ratio
  ColourBy colour =
      ColourBy::kQuality;  // shape of each quad; convexity: strictly convex, flat, non-convex
  std::string title;       // one line above the picture
  std::vector<VertexId> steiner;  // marked with a ring
  std::vector<Polyline> overlay;  // drawn over the mesh, e.g. a spiral
};

/// A picture by extension: .svg .png .pdf. Line width and point marks adapt to the number of faces;
/// readable from 20 points to 200,000.
void draw_mesh(const std::string& path, const MeshFile& mesh, const DrawOptions& options = {});

/// Several pictures on one sheet, with their titles, `columns` a row.
struct Panel {
  const MeshFile* mesh = nullptr;
  DrawOptions options;
};
void draw_sheet(const std::string& path, std::span<const Panel> panels, int columns);

}  // namespace quadloom::io
