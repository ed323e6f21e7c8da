// quadloom quadrangulate: points in, a certified mesh out.
#include <fmt/format.h>

#include <cstdio>
#include <memory>

#include "exit_codes.hpp"
#include "facts.hpp"
#include "options.hpp"
#include "progress_bar.hpp"
#include "report.hpp"
#include "timer.hpp"
#include "verbs.hpp"

namespace quadloom::app {
namespace {

struct QuadrangulateOptions {
  InputOptions input;
  PointOptions making;
  std::size_t k = 4;
  std::string output, output_format, picture, report;
  bool quiet = false;
};

void check_outputs(const QuadrangulateOptions& o) {
  require_mesh(o.output, o.output_format);
  require_picture(o.picture);
  require_writable(o.report);
}

MadeMesh make(const io::PointTable& table, const QuadrangulateOptions& o) {
  ProgressBar bar;
  PointOptions options = o.making;
  options.progress = bar.callback();
  return make_mesh(table, options, o.k);
}

void write_picture(const MadeMesh& made, const QuadrangulateOptions& o) {
  if (o.picture.empty()) return;
  io::DrawOptions options;
  options.title =
      fmt::format("{}: {}, {}", short_name(o.input.path), counted(made.input_vertices, "point"),
                  o.k == 4 ? name_of(o.making.method) : fmt::format("{}-gons", o.k));
  options.steiner = steiner_vertices(made);
  io::draw_mesh(o.picture, made.file, options);
}

void write_report(const MadeMesh& made, const QuadrangulateOptions& o, double read_seconds) {
  if (o.report.empty()) return;
  Json json = report_head("quadrangulate", o.input.path, made.input_points);
  json["output"] = o.output;
  json["mesh"] = mesh_json(made, o.making, o.k);
  json["mesh"]["seconds"]["read"] = read_seconds;
  io::write_text(o.report, json.dump(2) + "\n");
}

void tell(const MadeMesh& made, const QuadrangulateOptions& o) {
  if (o.quiet && made.certificate.ok()) return;
  std::FILE* to = o.output == "-" || o.report == "-" || !made.certificate.ok() ? stderr : stdout;
  fmt::print(to, "{}\n{}{}\n", facts_line(made), remarks(made, o.making),
             verdict_line(made.certificate, true));
}

// The mesh is sound and written, but has more added points than the bound: said, and not a success.
int tell_bound(const MadeMesh& made, const QuadrangulateOptions& o) {
  if (!beyond_bound(made, o.k)) return kDone;
  fmt::print(stderr, "quadloom: {} added, where the bound for {}-gons is {}\n",
             counted(made.steiner.size(), "point"), o.k, o.k - 3);
  return kGuaranteeMissed;
}

int quadrangulate(const QuadrangulateOptions& o) {
  check_outputs(o);
  const Timer reading;
  const io::PointTable table = io::read_points(o.input.path, o.input.reading);
  const double read_seconds = reading.seconds();
  const MadeMesh made = make(table, o);
  if (!made.certificate.ok()) {  // nothing is written that the check refuses
    tell(made, o);
    return kCheckFailed;
  }
  io::write_mesh(o.output, made.file, o.output_format);
  write_picture(made, o);
  write_report(made, o, read_seconds);
  tell(made, o);
  return tell_bound(made, o);
}

}  // namespace

void add_quadrangulate(CLI::App& app, Run& run) {
  CLI::App* verb = app.add_subcommand(
      "quadrangulate", "Points to a mesh of quadrilaterals, with at most one point added");
  verb->footer(
      "\nThe given points are kept bit for bit and come first. The number of points on the hull\n"
      "decides: if it is even no point is added, if it is odd one point or one triangle.\n"
      "\n"
      "  quadloom quadrangulate towns.csv -o towns.vtu --picture towns.png\n"
      "  quadloom quadrangulate sites.csv --columns lon,lat,height -o sites.obj\n"
      "  quadloom quadrangulate points.xyz -o mesh.msh --odd-boundary triangle --report "
      "facts.json\n"
      "  cat points.xyz | quadloom quadrangulate - -o - --output-format off > mesh.off");
  const auto o = std::make_shared<QuadrangulateOptions>();
  add_input(*verb, o->input);
  verb->add_option("-o,--output", o->output,
                   "Mesh: .obj, .off, .ply, .vtu, .msh, .geojson, or - for standard output")
      ->required();
  verb->add_option("--output-format", o->output_format,
                   "Format of the mesh if not by the name; msh22 is version 2.2 of msh");
  add_method(*verb, o->making.method);
  add_making(*verb, o->making);
  add_whole(*verb, "--k", o->k, 4, 1 << 20,
            "Corners of each face; above 4 the method is the spiral");
  verb->add_option("--picture", o->picture, "Also draw the mesh: .svg, .png or .pdf");
  verb->add_option("--report", o->report, "Also write all figures as JSON; - for standard output");
  verb->add_flag("--quiet", o->quiet, "Print nothing but errors");
  verb->callback([o, verb, &run] {
    if (o->k > 4 && verb->count("--method") > 0 && o->making.method != PointMethod::kSpiral) {
      throw CLI::ValidationError("--k", "faces of more than 4 corners are made by the spiral only");
    }
    if (o->k > 4 && verb->count("--odd-boundary") > 0) {
      throw CLI::ValidationError("--odd-boundary", "is for faces of 4 corners");
    }
    run = [o] { return quadrangulate(*o); };
  });
}

}  // namespace quadloom::app
