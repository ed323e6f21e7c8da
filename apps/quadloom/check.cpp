// quadloom check: judges any mesh file, exactly.
#include <fmt/format.h>

#include <cstdio>
#include <memory>

#include "exit_codes.hpp"
#include "facts.hpp"
#include "options.hpp"
#include "report.hpp"
#include "verbs.hpp"

namespace quadloom::app {
namespace {

struct CheckVerbOptions {
  std::string mesh, format, points, report;
  io::ReadPointsOptions reading;
  CertifyOptions certify;
};

void tell(const Certificate& c, bool with_points) {
  fmt::print(c.ok() ? stdout : stderr,
             "{}, {}, {} strictly convex, {} flat-cornered, {} not convex\n{}\n",
             counted(c.faces - c.triangles, "face"), counted(c.triangles, "triangle"),
             c.strictly_convex, c.flat_cornered, c.non_convex, verdict_line(c, with_points));
}

int check(const CheckVerbOptions& o) {
  require_writable(o.report);
  const io::MeshFile file = io::read_mesh(o.mesh, o.format);
  std::vector<Point> input;
  if (!o.points.empty()) input = io::read_points(o.points, o.reading).points;
  const Certificate certificate = certify_points(file.mesh, input, o.certify);
  if (!o.report.empty()) {
    Json json = report_head("check", o.mesh, input.size());
    json["certificate"] = certificate_json(certificate);
    io::write_text(o.report, json.dump(2) + "\n");
  }
  tell(certificate, !o.points.empty());
  return certificate.ok() ? kDone : kCheckFailed;
}

}  // namespace

void add_check(CLI::App& app, Run& run) {
  CLI::App* verb = app.add_subcommand(
      "check", "Prove from the faces alone that a mesh tiles its convex hull, or say why not");
  verb->footer(
      "\nExact: coordinates are taken as they stand in the file, no tolerance. Returns 0 if all "
      "is\n"
      "well, 1 if not.\n"
      "\n"
      "  quadloom check mesh.obj --points towns.csv --steiner-at-most 1\n"
      "  quadloom check mesh.vtu --strictly-convex\n"
      "  quadloom check triangles.off --k 3");
  const auto o = std::make_shared<CheckVerbOptions>();
  verb->add_option("MESH", o->mesh, "The mesh: .obj, .off, .ply, .vtu, .msh, .geojson, or -")
      ->required();
  verb->add_option("--mesh-format", o->format, "Format of the mesh if not by the name");
  verb->add_option("--points", o->points, "Points that must all be vertices of the mesh");
  verb->add_option("--format", o->reading.format, "Format of the points if not by the name");
  verb->add_option("--columns", o->reading.columns, "Columns of x, y and perhaps z of the points");
  add_whole(*verb, "--k", o->certify.corners, 3, 1 << 20, "Corners that each face must have");
  add_whole(*verb, "--triangles-allowed", o->certify.triangles_allowed, 0, kNoLimit,
            "So many triangles may be left");
  add_whole(*verb, "--steiner-at-most", o->certify.steiner_at_most, 0, kNoLimit,
            "At most so many vertices that are no given point")
      ->default_str("");
  verb->add_flag("--steiner-inside", o->certify.steiner_inside, "None of them on the boundary");
  verb->add_flag("--strictly-convex", o->certify.strictly_convex,
                 "Each face must turn left at each corner");
  verb->add_option("--report", o->report, "Also write the verdict as JSON");
  verb->callback([o, &run] { run = [o] { return check(*o); }; });
}

}  // namespace quadloom::app
