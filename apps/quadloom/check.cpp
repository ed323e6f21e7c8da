// quadloom check: judges any mesh file, exactly.
#include <fmt/format.h>

#include <cstdio>
#include <memory>

#include "exit_codes.hpp"
#include "facts.hpp"
#include "mesh_facts.hpp"
#include "options.hpp"
#include "report.hpp"
#include "verbs.hpp"

namespace quadloom::app {
namespace {

struct CheckVerbOptions {
  std::string mesh, format, points, source, report;
  io::ReadPointsOptions reading;
  Space space = Space::kAuto;
  CertifyOptions certify;
};

struct Judgement {
  Certificate certificate;
  std::string verdict;
  std::size_t points = 0;  // of what it was checked against
};

Judgement against_points(const io::MeshFile& file, std::span<const Point> points,
                         const CertifyOptions& options) {
  Judgement out;
  out.certificate = certify_points(file.mesh, points, options);
  out.verdict = verdict_line(out.certificate, !points.empty());
  out.points = points.size();
  return out;
}

// Equal faces and turned ones are the source's affair: it is taken as quadrangulate takes it.
Judgement against_source(const io::MeshFile& file, FoundInput found, const CheckVerbOptions& o) {
  MeshReading reading;
  reading.path = o.source;
  reading.format = o.reading.format;
  reading.connect.space = o.space;
  reading.regions = reading.keep = "none";
  const SourceMesh source = read_source(reading, std::move(found));
  Judgement out;
  out.certificate = certify_against(file, source, o.certify);
  out.verdict = source_verdict(out.certificate, source, o.certify.outer_steiner);
  out.points = source.input_count;
  return out;
}

Judgement judge(const io::MeshFile& file, const CheckVerbOptions& o) {
  if (!o.source.empty()) {
    FoundInput found = find_input(o.source, o.reading.format, InputKind::kAuto);
    if (found.kind != InputKind::kPoints) return against_source(file, std::move(found), o);
    if (found.planar) return against_points(file, found.planar->input.points, o.certify);
  }
  const std::string& path = o.source.empty() ? o.points : o.source;
  std::vector<Point> points;
  if (!path.empty()) points = io::read_points(path, o.reading).points;
  return against_points(file, points, o.certify);
}

void tell(const Judgement& judgement) {
  const Certificate& c = judgement.certificate;
  fmt::print(c.ok() ? stdout : stderr,
             "{}, {}, {} strictly convex, {} flat-cornered, {} not convex\n{}\n",
             counted(c.faces - c.triangles, "face"), counted(c.triangles, "triangle"),
             c.strictly_convex, c.flat_cornered, c.non_convex, judgement.verdict);
}

int check(const CheckVerbOptions& o) {
  require_writable(o.report);
  const io::MeshFile file = io::read_mesh(o.mesh, o.format);
  const Judgement judgement = judge(file, o);
  if (!o.report.empty()) {
    Json json = report_head("check", o.mesh, judgement.points);
    json["certificate"] = certificate_json(judgement.certificate);
    io::write_text(o.report, json.dump(2) + "\n");
  }
  tell(judgement);
  return judgement.certificate.ok() ? kDone : kCheckFailed;
}

}  // namespace

void add_check(CLI::App& app, Run& run) {
  CLI::App* verb = app.add_subcommand(
      "check", "Prove from the faces alone that a mesh tiles its convex hull, or its source");
  verb->footer(
      "\nExact: coordinates are taken as they stand in the file, no tolerance. Returns 0 if all "
      "is\n"
      "well, 1 if not.\n"
      "\n"
      "  quadloom check mesh.obj --points towns.csv --steiner-at-most 1\n"
      "  quadloom check mesh.vtu --strictly-convex\n"
      "  quadloom check triangles.off --k 3\n"
      "  quadloom check coast.vtu --source coast.14 --steiner-inside");
  const auto o = std::make_shared<CheckVerbOptions>();
  verb->add_option("MESH", o->mesh,
                   "The mesh: .obj, .off, .ply, .stl, .vtu, .msh, .14, .ele, .geojson, or -")
      ->required();
  verb->add_option("--mesh-format", o->format, "Format of the mesh if not by the name");
  CLI::Option* const points =
      verb->add_option("--points", o->points, "Points that must all be vertices of the mesh");
  verb->add_option(
          "--source", o->source,
          "The mesh or the polygons that it was made from: its boundary must be theirs and "
          "their vertices must be vertices")
      ->excludes(points);
  verb->add_option("--format", o->reading.format,
                   "Format of the points or the source if not by the name");
  add_space(*verb, o->space, "What z of the source is: data over the plane or a surface in space");
  verb->add_option("--columns", o->reading.columns, "Columns of x, y and perhaps z of the points");
  add_whole(*verb, "--k", o->certify.corners, 3, 1 << 20, "Corners that each face must have");
  add_whole(*verb, "--triangles-allowed", o->certify.triangles_allowed, 0, kNoLimit,
            "So many triangles may be left");
  add_whole(*verb, "--steiner-at-most", o->certify.steiner_at_most, 0, kNoLimit,
            "At most so many vertices that are no given point")
      ->default_str("");
  verb->add_flag("--steiner-inside", o->certify.steiner_inside, "None of them on the boundary");
  verb->add_flag("--outer-steiner", o->certify.outer_steiner,
                 "With --source: an edge of the boundary may be two that meet at an added point");
  verb->add_flag("--strictly-convex", o->certify.strictly_convex,
                 "Each face must turn left at each corner");
  verb->add_option("--report", o->report, "Also write the verdict as JSON");
  verb->callback([o, &run] { run = [o] { return check(*o); }; });
}

}  // namespace quadloom::app
