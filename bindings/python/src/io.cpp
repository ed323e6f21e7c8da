// include/quadloom/io.hpp: files and pictures.
#include "quadloom/io.hpp"

#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <algorithm>
#include <memory>

#include "bind.hpp"
#include "choice.hpp"
#include "conversions.hpp"
#include "fields.hpp"
#include "inputs.hpp"
#include "parts.hpp"
#include "progress.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace quadloom::python {
namespace {

using Path = std::filesystem::path;

// ---- Attributes: a dict of arrays. ----

nb::dict dict_of(const std::vector<io::Attribute>& attributes) {
  nb::dict out;
  for (const io::Attribute& a : attributes)
    out[nb::str(a.name.c_str())] = own(std::vector(a.values));
  return out;
}

std::vector<io::Attribute> attributes_from(const nb::dict& given) {
  std::vector<io::Attribute> out;
  for (const auto& [name, values] : given) {
    std::string word = nb::cast<std::string>(name);
    std::vector<double> numbers = doubles_from(nb::borrow<NumbersLike>(values), word.c_str());
    out.push_back({std::move(word), std::move(numbers)});
  }
  return out;
}

// ---- Points. ----

void bind_points(nb::module_& m) {
  m.def(
      "read_points",
      [](const Path& path, const std::string& format, const std::string& columns) {
        const io::PointTable table = without_gil([&] {
          return io::read_points(path.string(), {format, columns});
        });
        if (table.z.empty()) return nb::cast(own(std::vector(table.points)));
        return nb::cast(own<3>(interleaved(table.points, table.z)));
      },
      "path"_a, nb::kw_only(), "format"_a = "", "columns"_a = "",
      nb::sig("def read_points(path: str | os.PathLike, *, format: str = '', columns: str = '') -> "
              "numpy.typing.NDArray[numpy.float64]"),
      R"(Points of a file, float64 (n, 2), or (n, 3) where the file has heights: .csv .tsv, .xyz .xy .txt, .geojson .json;
"-" is standard input. `format`: "csv", "xyz" or "geojson"; empty: by the name. `columns`: two or three header names
(any case) or numbers from 1, such as "lon,lat" or "2,3,4"; empty: x,y[,z] or lon,lat[,elevation ...] of the header,
else the first two or three columns.

Raises Error: parse and not-finite naming the file, the line (culprit) and the text, file, bad-option; too-few-points
for a file without points. docs/formats.md has the details.)");
  m.def(
      "write_points",
      [](const Path& path, const PointsLike& points) {
        const Points given(points);
        without_gil([&] { io::write_points(path.string(), given.xy(), given.z()); });
      },
      "path"_a, "points"_a,
      "One point a line, the fewest digits that read back the same; .csv and .tsv with a header; "
      ".geojson as "
      "MultiPoint; by the name, \"-\" as .xyz to standard output. Raises Error: file.");
}

// ---- Meshes. ----

// A mesh to write or draw, with its data, or without.
io::MeshFile file_from(const MeshArgument& given) {
  if (const auto* file = dynamic_cast<const Made<io::MeshFile>*>(&given.mesh())) return *file;
  io::MeshFile out = given.mesh().file();
  const bool as_given = dynamic_cast<const Made<PolygonMesh>*>(&given.mesh()) != nullptr ||
                        dynamic_cast<const Made<Triangulation>*>(&given.mesh()) != nullptr;
  if (as_given) out.z_is_data = false;  // they may be a surface
  return out;
}

void bind_mesh_file(nb::module_& m) {
  using F = Made<io::MeshFile>;
  Fields<F, Mesh> fields(m, "MeshFile", "A mesh with what files carry beside it.");
  fields.def(
      "__init__",
      [](F* self, const MeshLike& mesh, const nb::object& faces, const nb::dict& vertex_data,
         const nb::dict& face_data, const NumbersLike& edges) {
        io::MeshFile file = file_from(MeshArgument(mesh, faces));
        for (auto& a : attributes_from(vertex_data)) file.vertex_data.push_back(std::move(a));
        for (auto& a : attributes_from(face_data)) file.face_data.push_back(std::move(a));
        const std::vector<Segment> lines = segments_from(edges, "edges");
        file.edges.insert(file.edges.end(), lines.begin(), lines.end());
        new (self) F(std::move(file));
      },
      "mesh"_a, "faces"_a = nb::none(), nb::kw_only(), "vertex_data"_a = nb::dict(),
      "face_data"_a = nb::dict(), "edges"_a = nb::none(),
      "A mesh, or points and faces; data as arrays by name, one number a vertex or a face; `edges` "
      "(e, 2): "
      "lines of the file.");
  fields
      .get(
          "vertex_data", [](const F& f) { return dict_of(f.vertex_data); },
          "Arrays by name, one number a vertex.")
      .get(
          "face_data", [](const F& f) { return dict_of(f.face_data); },
          "Arrays by name, one number a face.")
      .array("edges", &io::MeshFile::edges, "Lines of the file, uint32 (e, 2).")
      .value("z_is_data", &io::MeshFile::z_is_data, "Heights or depths over a planar mesh (.14).")
      .value("faces_left_out", &io::MeshFile::faces_left_out,
             ".stl: facets of which two corners are at the same place.");
  m.def(
      "read_mesh",
      [](const Path& path, const std::string& format) {
        return made(without_gil([&] { return io::read_mesh(path.string(), format); }));
      },
      "path"_a, "format"_a = "",
      R"(A mesh of a file: what write_mesh writes, .stl, .14, .gr3 and .ele with the .node beside it; "-" is standard input
(needs `format`). Heights that are all 0 count as none.

Raises Error: parse (culprit: the line where there is one), not-finite, index-out-of-range (culprits: face, index),
file, bad-option.)");
  m.def(
      "write_mesh",
      [](const Path& path, const MeshLike& mesh, const std::string& format) {
        const io::MeshFile file = file_from(MeshArgument(mesh));
        without_gil([&] { io::write_mesh(path.string(), file, format); });
      },
      "path"_a, "mesh"_a, "format"_a = "",
      R"(Writes a mesh by the name: .obj .off .ply .vtu .msh .geojson .json, or as `format` says: one of these without the
dot, "msh22" (.msh is 4.1) or "vtu-ascii" (.vtu has base64). Coordinates read back bit for bit (-0.0 as 0). Written to
a temporary name beside the target, then renamed; "-" is standard output (needs `format`). What a format cannot hold is
left out: vertex data in .obj, .off and .geojson, face data in .obj and .off, edges in .off, .ply and .geojson, unused
vertices in .geojson.

Raises Error: file; bad-option (unknown format, faces that .msh cannot hold); index-out-of-range, not-finite, bad-mesh
for a mesh that no file should hold.)");
  m.def(
      "require_mesh_format",
      [](const Path& path, const std::string& format) {
        io::require_mesh_format(path.string(), format);
      },
      "path"_a, "format"_a = "",
      "Raises the Error that write_mesh would raise for that name and format: to be asked before "
      "long work.");
}

// ---- Polygons, lines, strips, text. ----

using PolygonList = nb::typed<nb::list, Rings>;

PolygonList polygons_of(const io::PlanarFile& file) {
  nb::list out;
  for (const Polygon& polygon : file.input.polygons) out.append(rings_of(polygon));
  return nb::borrow<PolygonList>(out);
}

void bind_planar_file(nb::module_& m) {
  using F = io::PlanarFile;
  Fields<F>(m, "PlanarFile",
            "Polygons, segments and points of a file, with what it carries beside them. It may be "
            "given where "
            "polygons are expected; its points, segments, holes and regions then come along.")
      .get(
          "polygons", [](const F& f) { return polygons_of(f); },
          "Of each polygon its rings, float64 (k, 2), the outer one first.")
      .array(
          "points", [](const F& f) -> const auto& { return f.input.points; },
          "Inner points and ends of segments, float64 (n, 2).")
      .array(
          "segments", [](const F& f) -> const auto& { return f.input.segments; },
          "Numbers of points, uint32 (s, 2).")
      .array(
          "holes", [](const F& f) -> const auto& { return f.input.holes; },
          "A place in each enclosed part to leave out.")
      .array(
          "regions", [](const F& f) -> const auto& { return f.input.regions; },
          "A place in each part that has a name.")
      .array("z", &F::z, "Per input point, the corners first; or empty.")
      .get(
          "polygon_data", [](const F& f) { return dict_of(f.polygon_data); },
          "GeoJSON: the numbers of the polygon's feature, else NaN; arrays by name.")
      .get(
          "point_data", [](const F& f) { return dict_of(f.point_data); },
          ".poly: attributes and markers of `points`.")
      .get(
          "segment_data", [](const F& f) { return dict_of(f.segment_data); }, ".poly: markers.")
      .get(
          "region_data", [](const F& f) { return dict_of(f.region_data); },
          ".poly: attribute and area limit.")
      .done();
  m.def(
      "read_planar",
      [](const Path& path, const std::string& format) {
        return without_gil([&] { return io::read_planar(path.string(), format); });
      },
      "path"_a, "format"_a = "",
      R"(Polygons, segments and points of a file: .geojson .json (Polygon and MultiPolygon; LineString and MultiLineString
are segments, Point and MultiPoint inner points) and Triangle's .poly, which takes its points from the .node beside it
if it has none; "-" is standard input (needs `format`, the extension). The first corner again at the end of a ring is
dropped. Whether polygons are valid is for constrained_delaunay to say.

Raises Error: parse, not-finite, index-out-of-range (culprits: the line where there is one), file, bad-option;
too-few-points for a file without anything.)");
  m.def(
      "write_polygons",
      [](const Path& path, const PolygonsLike& polygons) {
        const std::vector<Polygon> given = polygons_from(polygons);
        without_gil([&] { io::write_polygons(path.string(), given); });
      },
      "path"_a, "polygons"_a,
      "Polygons with their holes as GeoJSON (a Polygon each), whatever the ending; \"-\" is "
      "standard output. Raises "
      "Error: file.");
}

std::vector<io::Polyline> lines_from(const std::vector<PointsLike>& given, bool closed) {
  std::vector<io::Polyline> out;
  for (const PointsLike& line : given) {
    const Points points(line);
    out.push_back({{points.xy().begin(), points.xy().end()}, closed, 0});
  }
  return out;
}

void bind_lines(nb::module_& m) {
  m.def(
      "write_polylines",
      [](const Path& path, const std::vector<PointsLike>& lines, const std::string& name,
         const NumbersLike& values, bool closed) {
        std::vector<io::Polyline> given = lines_from(lines, closed);
        const std::vector<double> numbers = doubles_from(values, "values");
        if (!values.is_none() && numbers.size() != given.size()) {
          throw Error(ErrorCode::kBadOption, "values needs one number a line");
        }
        for (std::size_t i = 0; i < numbers.size(); ++i) given[i].value = numbers[i];
        without_gil([&] { io::write_polylines(path.string(), given, name); });
      },
      "path"_a, "lines"_a, nb::kw_only(), "name"_a = "value", "values"_a = nb::none(),
      "closed"_a = false,
      "Polylines (k, 2), or rings if `closed`, as GeoJSON (LineString or Polygon features), with "
      "one number each "
      "under `name`. Raises Error: file, bad-option.");
  m.def(
      "write_text",
      [](const Path& path, const std::string& text) {
        without_gil([&] { io::write_text(path.string(), text); });
      },
      "path"_a, "text"_a,
      "Writes a text file by temporary name and rename; \"-\" is standard output. Raises Error: "
      "file.");
}

void bind_strip_file(nb::module_& m) {
  using F = io::StripFile;
  Fields<F>(m, "StripFile", "Triangles as strips of vertices, with the points.")
      .array("points", &F::points, "float64 (n, 2).")
      .array("z", &F::z, "Per point, or empty.")
      .value("code", &F::code, "The strips.")
      .done();
  m.def(
      "write_strips",
      [](const Path& path, const PointsLike& points, const StripCode& code) {
        const Points given(points);
        const F file{{given.xy().begin(), given.xy().end()}, given.z(), code};
        without_gil([&] { io::write_strips(path.string(), file); });
      },
      "path"_a, "points"_a, "code"_a,
      R"(Writes .strip, a text (docs/formats.md): the points bit for bit, the code as it is, one strip a line; "-" is
standard output. Raises Error: file; index-out-of-range, not-finite, bad-mesh for strips that no file should hold.)");
  m.def(
      "read_strips",
      [](const Path& path) { return without_gil([&] { return io::read_strips(path.string()); }); },
      "path"_a,
      "Reads what write_strips writes; \"-\" is standard input. Raises Error: parse, not-finite, "
      "index-out-of-range (culprits: the line), file.");
}

// ---- Pictures. ----

// A mesh and how it is drawn.
struct Drawing {
  io::MeshFile mesh;
  io::DrawOptions options;
};

std::vector<VertexId> marked_as_added(const io::MeshFile& file) {
  std::vector<VertexId> out;
  for (const io::Attribute& a : file.vertex_data) {
    if (a.name != "added") continue;
    for (VertexId v = 0; v < a.values.size(); ++v) {
      if (a.values[v] != 0) out.push_back(v);
    }
  }
  return out;
}

Drawing drawing_of(const MeshLike& mesh, int width, const Choice<io::ColourBy>& colour,
                   const NumbersLike& group, std::vector<std::string> group_names,
                   std::string title, const std::vector<PointsLike>& overlay) {
  Drawing out;
  out.mesh = file_from(MeshArgument(mesh));
  check_faces(out.mesh.mesh);
  out.options.width = width;
  out.options.colour = colour.get("colour");
  for (const std::uint32_t g : indices_from(group, "group")) {
    out.options.group.push_back(static_cast<std::uint8_t>(std::min(g, std::uint32_t{255})));
  }
  out.options.group_names = std::move(group_names);
  out.options.title = std::move(title);
  out.options.steiner = marked_as_added(out.mesh);
  out.options.overlay = lines_from(overlay, false);
  return out;
}

void draw(const Path& path, const std::vector<const Drawing*>& drawings, int columns) {
  std::vector<io::Panel> panels;
  for (const Drawing* d : drawings) panels.push_back({&d->mesh, d->options});
  without_gil([&] { io::draw_sheet(path.string(), panels, columns); });
}

void bind_pictures(nb::module_& m) {
  bind_words<io::ColourBy>(
      m, "ColourBy", "What the colours of a picture tell.",
      {{io::ColourBy::kQuality, "quality", "the shape of each quad"},
       {io::ColourBy::kConvexity, "convexity", "strictly convex, flat, non-convex"},
       {io::ColourBy::kNone, "none", "nothing"},
       {io::ColourBy::kGroup, "group", "`group` of each face"}});
  nb::class_<Drawing>(m, "Panel", "A mesh and how it is drawn, for draw_sheet.")
      .def(
          "__init__",
          [](Drawing* self, const MeshLike& mesh, int width, const Choice<io::ColourBy>& colour,
             const NumbersLike& group, std::vector<std::string> group_names, std::string title,
             const std::vector<PointsLike>& overlay) {
            Drawing made = drawing_of(mesh, width, colour, group, std::move(group_names),
                                      std::move(title), overlay);
            new (self) Drawing(std::move(made));
          },
          "mesh"_a, nb::kw_only(), "width"_a = io::DrawOptions().width, "colour"_a = "quality",
          "group"_a = nb::none(), "group_names"_a = nb::list(), "title"_a = "",
          "overlay"_a = nb::list(), "The options are those of draw_mesh.");
  m.def(
      "draw_mesh",
      [](const Path& path, const MeshLike& mesh, int width, const Choice<io::ColourBy>& colour,
         const NumbersLike& group, std::vector<std::string> group_names, std::string title,
         const std::vector<PointsLike>& overlay) {
        const Drawing made = drawing_of(mesh, width, colour, group, std::move(group_names),
                                        std::move(title), overlay);
        draw(path, {&made}, 1);
      },
      "path"_a, "mesh"_a, nb::kw_only(), "width"_a = io::DrawOptions().width,
      "colour"_a = "quality", "group"_a = nb::none(), "group_names"_a = nb::list(), "title"_a = "",
      "overlay"_a = nb::list(),
      R"(A picture by the name: .svg .png .pdf, `width` pixels (points in .svg and .pdf) wide. Added points are marked with
a ring, lines of `overlay` (each (k, 2)) drawn over the mesh. `group`, for colour "group": of each face 0 (plain),
1 (strong), 2 or 3; `group_names`: for the legend. Line width and point marks adapt to the number of faces; readable
from 20 points to 200,000.

Raises Error: file, bad-option; index-out-of-range, not-finite for a mesh that cannot be drawn.)");
  m.def(
      "draw_picture",
      [](const std::string& format, const MeshLike& mesh, int width,
         const Choice<io::ColourBy>& colour, const NumbersLike& group,
         std::vector<std::string> group_names, std::string title,
         const std::vector<PointsLike>& overlay) {
        const Drawing made = drawing_of(mesh, width, colour, group, std::move(group_names),
                                        std::move(title), overlay);
        const std::string bytes =
            without_gil([&] { return io::draw_picture(format, made.mesh, made.options); });
        return nb::bytes(bytes.data(), bytes.size());
      },
      "format"_a, "mesh"_a, nb::kw_only(), "width"_a = io::DrawOptions().width,
      "colour"_a = "quality", "group"_a = nb::none(), "group_names"_a = nb::list(), "title"_a = "",
      "overlay"_a = nb::list(),
      "The bytes of the file that draw_mesh would write; `format` is \"svg\", \"png\" or \"pdf\".");
  m.def("draw_sheet", &draw, "path"_a, "panels"_a, "columns"_a,
        "Several pictures on one sheet, with their titles, `columns` a row. Raises Error as "
        "draw_mesh.");
}

}  // namespace

void bind_io(nb::module_& m) {
  bind_points(m);
  bind_mesh_file(m);
  bind_planar_file(m);
  bind_lines(m);
  bind_strip_file(m);
  bind_pictures(m);
}

}  // namespace quadloom::python
