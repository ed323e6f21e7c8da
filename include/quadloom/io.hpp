// Files: points in, meshes in and out, pictures. In the library quadloom::io.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "quadloom/core.hpp"
#include "quadloom/kernel.hpp"
#include "quadloom/strips.hpp"

namespace quadloom::io {

/// Points as read: coordinates, z where the file has it (else empty), and the line (from 1) of each
/// point in a text file (GeoJSON: empty), for messages.
struct PointTable {
  std::vector<Point> points;
  std::vector<double> z;
  std::vector<std::size_t> line;
};

struct ReadPointsOptions {
  /// "csv", "xyz" or "geojson"; empty: by the file's extension, xyz for standard input.
  std::string format;
  /// Two or three header names (any case) or numbers from 1, such as "lon,lat" or "2,3,4"; empty:
  /// x,y[,z] or lon,lat[,elevation ...] of the header, else the first two or three columns.
  std::string columns;
};

/// Reads .csv .tsv, .xyz .xy .txt, .geojson .json; "-" is standard input. Throws Error kParse and
/// kNotFinite naming the file, the line (culprit) and the text, kFile, kBadOption. A file without
/// points is kTooFewPoints. docs/formats.md has the details.
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
  std::vector<Segment> edges;  ///< lines of the file: .obj l, .msh and .vtu lines; segments of .ele
  bool z_is_data = false;      ///< z is a height or depth over a planar mesh (.14)
  std::size_t faces_left_out = 0;  ///< .stl: facets of which two corners are at the same place
};

/// Writes by extension: .obj .off .ply .vtu .msh .geojson .json, or as `format` says: one of these
/// without the dot, "msh22" (.msh is 4.1) or "vtu-ascii" (.vtu has base64). Coordinates read back
/// bit for bit (-0.0 as 0). Written to a temporary name beside the target, then renamed; "-" is
/// standard output (needs `format`). What a format cannot hold is left out: vertex data in .obj,
/// .off and .geojson, face data in .obj and .off, edges in .off, .ply and .geojson, unused vertices
/// in .geojson. Throws Error kFile; kBadOption (unknown format, faces that .msh cannot hold);
/// kIndexOutOfRange, kNotFinite, kBadMesh for a mesh that no file should hold.
void write_mesh(const std::string& path, const MeshFile& mesh, const std::string& format = {});

/// Throws the Error kBadOption that write_mesh would throw for that name and format (unknown, or only
/// read): to be asked before long work.
void require_mesh_format(const std::string& path, const std::string& format = {});

/// Reads what write_mesh writes, .stl, .14, .gr3 and .ele with the .node beside it (docs/formats.md); "-" is standard input (needs `format`).
/// Heights that are all 0 count as none. Throws Error kParse (culprit: the line where there is
/// one), kNotFinite, kIndexOutOfRange (culprits: face, index), kFile, kBadOption.
MeshFile read_mesh(const std::string& path, const std::string& format = {});

/// Polygons, segments and points for constrained_delaunay, with what files carry beside them.
struct PlanarFile {
  PlanarInput input;
  std::vector<double> z;                ///< per input point (the corners first), or empty
  std::vector<Attribute> polygon_data;  ///< GeoJSON: the numbers of the polygon's feature, else NaN
  std::vector<Attribute> point_data;    ///< .poly: attributes and markers of `input.points`
  std::vector<Attribute> segment_data;  ///< .poly: markers
  std::vector<Attribute> region_data;   ///< .poly: attribute and area limit
};

/// Reads .geojson .json (Polygon and MultiPolygon; LineString and MultiLineString are segments, Point
/// and MultiPoint inner points) and Triangle's .poly, which takes its points from the .node beside it
/// if it has none; "-" is standard input (needs `format`, the extension). The first corner again at
/// the end of a ring is dropped. Whether polygons are valid is for constrained_delaunay to say. Throws
/// Error kParse, kNotFinite, kIndexOutOfRange (culprits: the line where there is one), kFile,
/// kBadOption; kTooFewPoints for a file without anything.
PlanarFile read_planar(const std::string& path, const std::string& format = {});

/// Triangles as strips of vertices, with the points.
struct StripFile {
  std::vector<Point> points;
  std::vector<double> z;  ///< per point, or empty
  StripCode code;
};

/// Writes .strip, a text (docs/formats.md): the points bit for bit, the code as it is, one strip a
/// line. Written to a temporary name, then renamed; "-" is standard output. Throws Error kFile;
/// kIndexOutOfRange, kNotFinite, kBadMesh for strips that no file should hold.
void write_strips(const std::string& path, const StripFile& strips);

/// Reads what write_strips writes; "-" is standard input. Throws Error kParse, kNotFinite,
/// kIndexOutOfRange (culprits: the line), kFile.
StripFile read_strips(const std::string& path);

/// Writes a text file by temporary name and rename; "-" is standard output. For reports.
void write_text(const std::string& path, std::string_view text);

/// One point a line, x y [z], the fewest digits that read back the same; .csv and .tsv with a
/// header; .geojson as MultiPoint; by extension, "-" as .xyz to standard output.
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

/// Polygons with their holes as GeoJSON (a Polygon each), whatever the ending; "-" is standard output.
void write_polygons(const std::string& path, std::span<const Polygon> polygons);

enum class ColourBy { kQuality, kConvexity, kNone, kGroup };

struct DrawOptions {
  int width = 1600;  // pixels (points in SVG and PDF); the height follows from the aspect ratio
  ColourBy colour =
      ColourBy::kQuality;  // shape of each quad; convexity: strictly convex, flat, non-convex
  std::vector<std::uint8_t> group;       // kGroup: of each face, 0 (plain), 1 (strong), 2, 3
  std::vector<std::string> group_names;  // kGroup: for the legend
  std::string title;                     // one line above the picture
  std::vector<VertexId> steiner;         // marked with a ring
  std::vector<Polyline> overlay;         // drawn over the mesh, e.g. a spiral
};

/// A picture by extension: .svg .png .pdf. Line width and point marks adapt to the number of faces;
/// readable from 20 points to 200,000.
void draw_mesh(const std::string& path, const MeshFile& mesh, const DrawOptions& options = {});

/// The same as the bytes of a file; `format` is "svg", "png" or "pdf". Throws Error kBadOption for
/// others, kFile if the picture cannot be made.
std::string draw_picture(const std::string& format, const MeshFile& mesh,
                         const DrawOptions& options = {});

/// Several pictures on one sheet, with their titles, `columns` a row.
struct Panel {
  const MeshFile* mesh = nullptr;
  DrawOptions options;
};
void draw_sheet(const std::string& path, std::span<const Panel> panels, int columns);

}  // namespace quadloom::io
