// quadloom polygonize: a simple polygon through all points.
#include <fmt/format.h>

#include <cstdio>
#include <memory>

#include "exit_codes.hpp"
#include "facts.hpp"
#include "options.hpp"
#include "quadloom/certify.hpp"
#include "quadloom/strips.hpp"
#include "timer.hpp"
#include "verbs.hpp"

namespace quadloom::app {
namespace {

struct PolygonizeOptions {
  InputOptions input;
  std::string output, triangles, picture;
};

struct MadePolygon {
  std::vector<Point> ring;
  io::MeshFile triangles;
  Certificate certificate;  // of the polygon; with --triangles, if that is good, of them
  std::size_t points = 0, reflex = 0, flat = 0;
  double seconds = 0;
};

/// Whether the triangles tile the polygon and stand in the order of a path.
Certificate certify_triangles(const MadePolygon& made) {
  CertifyOptions promise;
  promise.corners = 3;
  promise.steiner_at_most = 0;
  const Polygon polygon{{made.ring}};
  Certificate verdict = certify_polygons(made.triangles.mesh, std::span(&polygon, 1), {}, promise);
  return verdict.ok() ? certify_order(made.triangles.mesh, OrderKind::kPath) : verdict;
}

MadePolygon make(const PolygonizeOptions& o, const io::PointTable& table) {
  MadePolygon made;
  const Timer timer;
  const SpiralPolygon spiral = spiral_polygon(table.points);
  made.seconds = timer.seconds();
  for (const VertexId v : spiral.ring) made.ring.push_back(spiral.mesh.points[v]);
  made.certificate = certify_spiral_polygon(made.ring, table.points);
  made.points = spiral.ring.size();
  made.reflex = made.certificate.non_convex;
  made.flat = made.certificate.flat_cornered;
  if (o.triangles.empty()) {
    made.triangles.mesh.points = spiral.mesh.points;
    return made;
  }
  made.triangles.mesh = to_polygon_mesh(spiral.mesh);
  if (!table.z.empty()) {
    made.triangles.z = carry_values(table.z, spiral.input_to_vertex, spiral.mesh.points, {}).values;
  }
  io::Attribute order{"order", {}};
  for (std::size_t f = 0; f < made.triangles.mesh.face_count(); ++f) {
    order.values.push_back(static_cast<double>(f));
  }
  made.triangles.face_data.push_back(std::move(order));
  if (made.certificate.ok()) made.certificate = certify_triangles(made);
  return made;
}

void draw(const PolygonizeOptions& o, const MadePolygon& made) {
  if (o.picture.empty()) return;
  io::DrawOptions drawing;
  drawing.colour = io::ColourBy::kNone;
  drawing.title = fmt::format("{}: spiral polygon, {}", short_name(o.input.path),
                              counted(made.points, "point"));
  drawing.overlay = {{made.ring, true, 0}};
  io::draw_mesh(o.picture, made.triangles, drawing);
}

std::string verdict(const PolygonizeOptions& o, const MadePolygon& made) {
  if (!made.certificate.ok()) return verdict_line(made.certificate, false);
  std::string out =
      "certified: every point is a corner once, the polygon is simple and its reflex corners are "
      "one chain";
  if (!o.triangles.empty()) out += "; the triangles tile it, each beside the one before";
  return out;
}

int polygonize(const PolygonizeOptions& o) {
  require_different({o.output, o.triangles, o.picture});
  require_writable(o.output);
  if (!o.triangles.empty()) require_mesh(o.triangles, {});
  require_picture(o.picture);
  const io::PointTable table = io::read_points(o.input.path, o.input.reading);
  const MadePolygon made = make(o, table);
  const bool good = made.certificate.ok();
  if (good) {  // nothing is written that the check refuses
    const Polygon polygon{{made.ring}};
    io::write_polygons(o.output, std::span(&polygon, 1));
    if (!o.triangles.empty()) io::write_mesh(o.triangles, made.triangles, {});
    draw(o, made);
  }
  fmt::print(o.output == "-" || o.triangles == "-" || !good ? stderr : stdout,
             "{}, {}, {}, {:.2f} s\n{}\n", counted(made.points, "point"),
             counted(made.reflex, "reflex corner"), counted(made.flat, "flat corner"), made.seconds,
             verdict(o, made));
  return good ? kDone : kCheckFailed;
}

}  // namespace

void add_polygonize(CLI::App& app, Run& run) {
  CLI::App* verb =
      app.add_subcommand("polygonize", "A simple polygon through all points, a spiral");
  verb->footer(
      "\nEvery point is a corner of the polygon; its reflex corners are one chain. It has a\n"
      "triangulation, n - 2 triangles each beside the one before, which --triangles writes.\n"
      "Points that lie on a straight run of the polygon are flat corners of it.\n"
      "\n"
      "  quadloom polygonize towns.csv -o towns.geojson --picture towns.svg\n"
      "  quadloom polygonize towns.csv -o towns.geojson --triangles towns.obj");
  const auto o = std::make_shared<PolygonizeOptions>();
  add_input(*verb, o->input);
  verb->add_option("-o,--output", o->output, "The polygon as .geojson, or - for standard output")
      ->required();
  verb->add_option("--triangles", o->triangles,
                   "Also write its triangles in order: .obj, .off, .ply, .vtu, .msh, .geojson");
  verb->add_option("--picture", o->picture, "Also draw it: .svg, .png or .pdf");
  verb->callback([o, &run] { run = [o] { return polygonize(*o); }; });
}

}  // namespace quadloom::app
