// quadloom compare: every method on the same points, side by side (the experiment that Bose and
// Toussaint ask for at the end of their paper).
#include <fmt/format.h>

#include <cstdio>
#include <memory>

#include "exit_codes.hpp"
#include "facts.hpp"
#include "options.hpp"
#include "progress_bar.hpp"
#include "report.hpp"
#include "verbs.hpp"

namespace quadloom::app {
namespace {

struct CompareVerbOptions {
  InputOptions input;
  PointOptions making;
  std::string picture, report;
  io::ColourBy colour = io::ColourBy::kQuality;
};

constexpr PointMethod kAll[] = {PointMethod::kDelaunay, PointMethod::kInsertion,
                                PointMethod::kSpiral, PointMethod::kSubdivide};

struct Entry {
  PointRun run;
  MadeMesh made;
};

std::vector<Entry> run_all(const io::PointTable& table, const PointOptions& making) {
  ProgressBar bar;
  std::vector<Entry> entries;
  for (const PointMethod method : kAll) {
    PointRun run{making};
    run.making.method = method;
    run.making.progress = bar.callback();
    entries.push_back({run, make_mesh(table, run)});
    entries.back().run.making.progress = {};
  }
  return entries;
}

void print_table(const std::vector<Entry>& entries) {
  using Cell = std::string (*)(const MadeMesh&);
  const std::pair<const char*, Cell> rows[] = {
      {"quads", [](const MadeMesh& m) { return std::to_string(m.quality.quads); }},
      {"triangles", [](const MadeMesh& m) { return std::to_string(m.quality.triangles); }},
      {"added points", [](const MadeMesh& m) { return std::to_string(m.steiner.size()); }},
      {"strictly convex",
       [](const MadeMesh& m) { return percent(m.quality.strictly_convex, m.quality.quads); }},
      {"flat corner", [](const MadeMesh& m) { return std::to_string(m.quality.flat_cornered); }},
      {"not convex", [](const MadeMesh& m) { return std::to_string(m.quality.non_convex); }},
      {"least angle", [](const MadeMesh& m) { return fmt::format("{:.2f}", m.quality.min_angle); }},
      {"greatest angle",
       [](const MadeMesh& m) { return fmt::format("{:.2f}", m.quality.max_angle); }},
      {"mean shape", [](const MadeMesh& m) { return fmt::format("{:.3f}", m.quality.mean_shape); }},
      {"median aspect",
       [](const MadeMesh& m) { return fmt::format("{:.2f}", m.quality.median_aspect); }},
      {"total edge length",
       [](const MadeMesh& m) { return fmt::format("{:.5g}", m.total_edge_length); }},
      {"seconds", [](const MadeMesh& m) { return fmt::format("{:.3f}", m.seconds); }},
      {"certified",
       [](const MadeMesh& m) { return std::string(m.certificate.ok() ? "yes" : "NO"); }},
  };
  fmt::print("{:<18}", "");
  for (const Entry& e : entries) fmt::print("{:>12}", name_of(e.run.making.method));
  for (const auto& [name, cell] : rows) {
    fmt::print("\n{:<18}", name);
    for (const Entry& e : entries) fmt::print("{:>12}", cell(e.made));
  }
  fmt::print("\n");
}

void write_sheet(const CompareVerbOptions& o, const std::vector<Entry>& entries) {
  if (o.picture.empty()) return;
  std::vector<io::Panel> panels;
  for (const Entry& e : entries) {
    io::Panel panel{&e.made.file, {}};
    panel.options.width = 1200;
    panel.options.colour = o.colour;
    panel.options.title = fmt::format(
        "{}: {} strictly convex, mean shape {:.2f}", name_of(e.run.making.method),
        percent(e.made.quality.strictly_convex, e.made.quality.quads), e.made.quality.mean_shape);
    panel.options.steiner = steiner_vertices(e.made);
    panels.push_back(std::move(panel));
  }
  io::draw_sheet(o.picture, panels, 2);
}

void write_report(const CompareVerbOptions& o, const io::PointTable& table,
                  const std::vector<Entry>& entries) {
  if (o.report.empty()) return;
  Json json = report_head("compare", o.input.path, table.points.size());
  for (const Entry& e : entries) json["meshes"].push_back(mesh_json(e.made, e.run));
  io::write_text(o.report, json.dump(2) + "\n");
}

int compare(const CompareVerbOptions& o) {
  require_picture(o.picture);
  require_writable(o.report);
  const io::PointTable table = io::read_points(o.input.path, o.input.reading);
  const std::vector<Entry> entries = run_all(table, o.making);
  print_table(entries);
  bool all_certified = true;
  for (const Entry& e : entries) {
    if (const std::string lines = remarks(e.made, e.run); !lines.empty() && &e == &entries[0]) {
      fmt::print("{}", lines);
    }
    if (e.made.certificate.ok()) continue;
    fmt::print(stderr, "{}: {}\n", name_of(e.run.making.method),
               verdict_line(e.made.certificate, true));
    all_certified = false;
  }
  if (!all_certified) return kCheckFailed;
  write_sheet(o, entries);
  write_report(o, table, entries);
  return kDone;
}

}  // namespace

void add_compare(CLI::App& app, Run& run) {
  CLI::App* verb = app.add_subcommand("compare", "Every method on the same points, side by side");
  verb->footer(
      "\n  quadloom compare points.csv\n"
      "  quadloom compare points.csv --picture methods.png --report methods.json");
  const auto o = std::make_shared<CompareVerbOptions>();
  add_input(*verb, o->input);
  add_making(*verb, o->making);
  add_colour(*verb, o->colour);
  verb->add_option("--picture", o->picture, "One sheet with a picture of each: .svg, .png or .pdf");
  verb->add_option("--report", o->report, "All figures as JSON");
  verb->callback([o, &run] { run = [o] { return compare(*o); }; });
}

}  // namespace quadloom::app
