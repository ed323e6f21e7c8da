// quadloom triangulate: points or polygons to the triangles that the other verbs begin with.
#include <fmt/format.h>

#include <cstdio>
#include <memory>

#include "convert_mesh.hpp"
#include "elevation.hpp"
#include "exit_codes.hpp"
#include "facts.hpp"
#include "mesh_facts.hpp"
#include "options.hpp"
#include "timer.hpp"
#include "verbs.hpp"

namespace quadloom::app {
namespace {

struct TriangulateOptions {
  InputOptions input;
  InputKind kind = InputKind::kAuto;
  std::string output, output_format, picture;
};

struct Triangles {
  io::MeshFile file;
  Certificate certificate;
  double seconds = 0;
  std::string verdict;
};

CertifyOptions three_corners() {
  CertifyOptions promise;
  promise.corners = 3;
  promise.steiner_at_most = 0;
  return promise;
}

Triangles from_points(const io::PointTable& table) {
  Triangles made;
  const Timer timer;
  const DelaunayResult result = delaunay(table.points);
  made.seconds = timer.seconds();
  made.file.mesh = to_polygon_mesh(result.mesh);
  if (!table.z.empty()) {
    made.file.z = carry_elevation(table.z, result.input_to_vertex, result.mesh.points, {}).z;
  }
  made.certificate = certify_points(made.file.mesh, table.points, three_corners());
  made.verdict = verdict_line(made.certificate, true);
  return made;
}

Triangles from_polygons(const TriangulateOptions& o, FoundInput found) {
  MeshReading reading;
  reading.path = o.input.path;
  reading.format = o.input.reading.format;
  SourceMesh source = read_source(reading, std::move(found));
  Triangles made;
  made.seconds = source.connect_seconds;
  made.file.mesh = to_polygon_mesh(source.triangles.mesh);
  made.file.z = source.z;
  made.file.vertex_data = source.vertex_data;
  made.file.face_data = source.face_data;
  made.file.edges = source.lines;
  made.certificate = certify_against(made.file, source, three_corners());
  made.verdict = source_verdict(made.certificate, source, false);
  return made;
}

io::PointTable take_points(io::PlanarFile file) {
  return {std::move(file.input.points), std::move(file.z), {}};
}

int triangulate(const TriangulateOptions& o) {
  require_mesh(o.output, o.output_format);
  require_picture(o.picture);
  FoundInput found = find_input(o.input.path, o.input.reading.format, o.kind);
  if (found.kind == InputKind::kMesh) {
    throw Error(ErrorCode::kBadOption,
                fmt::format("'{}' is a mesh already; points and polygons can be triangulated",
                            o.input.path));
  }
  const Triangles made = found.kind == InputKind::kPolygons ? from_polygons(o, std::move(found))
                         : found.planar
                             ? from_points(take_points(std::move(*found.planar)))
                             : from_points(io::read_points(o.input.path, o.input.reading));
  std::FILE* const to = o.output == "-" || !made.certificate.ok() ? stderr : stdout;
  if (made.certificate.ok()) {
    io::write_mesh(o.output, made.file, o.output_format);
    if (!o.picture.empty()) {
      io::DrawOptions draw;
      draw.colour = io::ColourBy::kNone;
      draw.title = fmt::format("{}: {}", short_name(o.input.path),
                               counted(made.file.mesh.face_count(), "triangle"));
      io::draw_mesh(o.picture, made.file, draw);
    }
  }
  fmt::print(to, "{}, {}, {:.2f} s\n{}\n", counted(made.file.mesh.points.size(), "point"),
             counted(made.file.mesh.face_count(), "triangle"), made.seconds, made.verdict);
  return made.certificate.ok() ? kDone : kCheckFailed;
}

}  // namespace

void add_triangulate(CLI::App& app, Run& run) {
  CLI::App* verb = app.add_subcommand(
      "triangulate", "Points or polygons to their (constrained) Delaunay triangles");
  verb->footer(
      "\nNo point is added. Triangles of polygons carry the number of their polygon (part) and "
      "its\n"
      "numbers; segments are written as lines.\n"
      "\n"
      "  quadloom triangulate towns.csv -o towns.off\n"
      "  quadloom triangulate lake.geojson -o lake.vtu --picture lake.svg");
  const auto o = std::make_shared<TriangulateOptions>();
  add_any_input(*verb, o->input);
  add_kind(*verb, o->kind);
  verb->add_option("-o,--output", o->output,
                   "Mesh: .obj, .off, .ply, .vtu, .msh, .geojson, or - for standard output")
      ->required();
  verb->add_option("--output-format", o->output_format, "Format of the mesh if not by the name");
  verb->add_option("--picture", o->picture, "Also draw the triangles: .svg, .png or .pdf");
  verb->callback([o, &run] { run = [o] { return triangulate(*o); }; });
}

}  // namespace quadloom::app
