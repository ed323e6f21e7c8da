// quadloom generate: named point sets.
#include "quadloom/generate.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <memory>

#include "exit_codes.hpp"
#include "facts.hpp"
#include "options.hpp"
#include "verbs.hpp"

namespace quadloom::app {
namespace {

struct GenerateVerbOptions {
  std::string kind, output;
  std::size_t n = 1000;
  std::uint64_t seed = 1;
};

int generate(const GenerateVerbOptions& o) {
  require_writable(o.output);
  const std::vector<Point> points = generate_points(o.kind, o.n, o.seed);
  io::write_points(o.output, points);
  if (points.size() != o.n) {
    fmt::print(stderr, "{} has {}, the nearest to {}\n", o.kind, counted(points.size(), "point"),
               o.n);
  }
  return kDone;
}

std::string list_of_kinds() {
  std::string list = "\nKinds:\n";
  for (const Generator& g : generators()) list += fmt::format("  {:<18} {}\n", g.name, g.what);
  return list +
         "\nThe same kind, n and seed give the same points on every platform.\n"
         "\n"
         "  quadloom generate uniform -n 100000 -o points.xyz\n"
         "  quadloom generate rotated-grid -n 400 --seed 7 -o grid.csv";
}

}  // namespace

void add_generate(CLI::App& app, Run& run) {
  CLI::App* verb = app.add_subcommand("generate", "A named set of points, for tests and teaching");
  verb->footer(list_of_kinds());
  const auto o = std::make_shared<GenerateVerbOptions>();
  verb->add_option("KIND", o->kind, "One of the kinds below")->required();
  add_whole(*verb, "-n", o->n, 1, kMaxPoints, "How many points");
  verb->add_option("-o,--output", o->output, "The file: .xyz, .csv, .geojson, or -")->required();
  add_whole(*verb, "--seed", o->seed, 0, kNoLimit, "Seed of random choices");
  verb->callback([o, &run] { run = [o] { return generate(*o); }; });
}

}  // namespace quadloom::app
