// quadloom quadrangulate of points.
#include <fmt/format.h>

#include <cstdio>
#include <string_view>

#include "convex_facts.hpp"
#include "exit_codes.hpp"
#include "facts.hpp"
#include "progress_bar.hpp"
#include "quadrangulate.hpp"
#include "report.hpp"

namespace quadloom::app {
namespace {

MadeMesh make(const io::PointTable& table, const PointRun& run) {
  ProgressBar bar;
  PointRun making = run;
  making.making.progress = bar.callback();
  return make_mesh(table, making);
}

void write_picture(const MadeMesh& made, const std::string& path, const PointRun& run,
                   const std::string& picture) {
  if (picture.empty()) return;
  io::DrawOptions options;
  options.title = fmt::format("{}: {}, {}", short_name(path), counted(made.input_vertices, "point"),
                              run.k == 4 ? method_name(run) : fmt::format("{}-gons", run.k));
  if (run.convex && made.not_convex.empty()) options.title += ", strictly convex";
  options.steiner = steiner_vertices(made);
  io::draw_mesh(picture, made.file, options);
}

void write_report(const MadeMesh& made, const std::string& path, const PointRun& run,
                  double read_seconds, const OutputOptions& output) {
  if (output.report.empty()) return;
  Json json = report_head("quadrangulate", path, made.input_points);
  json["output"] = output.mesh;
  json["mesh"] = mesh_json(made, run);
  json["mesh"]["seconds"]["read"] = read_seconds;
  io::write_text(output.report, json.dump(2) + "\n");
}

// Shapes take a while, and two formats leave them out.
bool holds_data(const OutputOptions& output) {
  const auto is = [&](std::string_view format) {
    return output.mesh_format.empty() ? output.mesh.ends_with("." + std::string(format))
                                      : output.mesh_format == format;
  };
  return !is("obj") && !is("off");
}

void tell(const MadeMesh& made, const PointRun& run, const OutputOptions& output) {
  if (output.quiet && made.certificate.ok()) return;
  std::FILE* to =
      output.mesh == "-" || output.report == "-" || !made.certificate.ok() ? stderr : stdout;
  fmt::print(to, "{}\n{}{}\n", facts_line(made), remarks(made, run),
             verdict_line(made.certificate, true));
}

// The mesh is sound and written, but has more added points than the bound: said, and not a success.
int tell_bound(const MadeMesh& made, std::size_t k) {
  if (!beyond_bound(made, k)) return kDone;
  fmt::print(stderr, "quadloom: {} added, where the bound for {}-gons is {}\n",
             counted(made.steiner.size(), "point"), k, k - 3);
  return kGuaranteeMissed;
}

}  // namespace

int quadrangulate_point_file(const std::string& path, const io::PointTable& table,
                             double read_seconds, const PointRun& run,
                             const OutputOptions& output) {
  MadeMesh made = make(table, run);
  if (!made.certificate.ok()) {  // nothing is written that the check refuses
    tell(made, run, output);
    return kCheckFailed;
  }
  if (holds_data(output)) add_attributes(made);
  io::write_mesh(output.mesh, made.file, output.mesh_format);
  write_picture(made, path, run, output.picture);
  write_report(made, path, run, read_seconds, output);
  tell(made, run, output);
  return run.convex ? tell_not_convex(made.file.mesh, made.not_convex) : tell_bound(made, run.k);
}

}  // namespace quadloom::app
