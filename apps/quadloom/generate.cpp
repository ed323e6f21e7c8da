// quadloom generate: named point sets and polygons.
#include "quadloom/generate.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
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
  std::size_t n = 1000, holes = 0;
  std::uint64_t seed = 1;
};

// Polygons have names of their own on the command line: there is a spiral of points, too.
std::string polygon_kind(const PolygonGenerator& generator) {
  return std::string(generator.name) + "-polygon";
}

std::vector<std::string> all_kinds() {
  std::vector<std::string> names;
  for (const Generator& g : generators()) names.emplace_back(g.name);
  for (const PolygonGenerator& g : polygon_generators()) names.push_back(polygon_kind(g));
  return names;
}

const PolygonGenerator* find_polygon_kind(const std::string& kind) {
  for (const PolygonGenerator& g : polygon_generators()) {
    if (polygon_kind(g) == kind) return &g;
  }
  return nullptr;
}

bool is_point_kind(const std::string& kind) {
  const auto kinds = generators();
  return std::any_of(kinds.begin(), kinds.end(), [&](const auto& g) { return g.name == kind; });
}

void tell_count(const GenerateVerbOptions& o, std::size_t n, const char* what) {
  if (n == o.n) return;
  fmt::print(stderr, "{} has {}, the nearest to {}\n", o.kind, counted(n, what), o.n);
}

int generate_a_polygon(const PolygonGenerator& kind, const GenerateVerbOptions& o) {
  if (o.output != "-" && !o.output.ends_with(".geojson") && !o.output.ends_with(".json")) {
    throw Error(ErrorCode::kBadOption,
                fmt::format("polygons are written as .geojson, not to '{}'", o.output));
  }
  Polygon polygon = generate_polygon(kind.name, o.n, o.seed);
  const std::size_t corners = polygon.rings[0].size();
  if (o.holes > 0) polygon = with_holes(polygon, o.holes, o.seed);
  io::write_polygons(o.output, {&polygon, 1});
  tell_count(o, corners, "corner");
  if (const std::size_t holes = polygon.rings.size() - 1; holes != o.holes) {
    fmt::print(stderr, "{} has room for {}\n", o.kind, counted(holes, "hole"));
  }
  return kDone;
}

int generate(const GenerateVerbOptions& o) {
  require_writable(o.output);
  if (const PolygonGenerator* kind = find_polygon_kind(o.kind)) {
    return generate_a_polygon(*kind, o);
  }
  if (!is_point_kind(o.kind)) {
    throw Error(ErrorCode::kBadOption, fmt::format("no kind is called '{}'; there are {}", o.kind,
                                                   fmt::join(all_kinds(), ", ")));
  }
  if (o.holes > 0) {
    throw Error(ErrorCode::kBadOption, "--holes: is for polygons, not for points");
  }
  const std::vector<Point> points = generate_points(o.kind, o.n, o.seed);
  io::write_points(o.output, points);
  tell_count(o, points.size(), "point");
  return kDone;
}

std::string list_of_kinds() {
  std::string list = "\nPoints:\n";
  for (const Generator& g : generators()) list += fmt::format("  {:<18} {}\n", g.name, g.what);
  list += "\nPolygons (-n corners of the outer ring, .geojson):\n";
  for (const PolygonGenerator& g : polygon_generators()) {
    list += fmt::format("  {:<18} {}\n", polygon_kind(g), g.what);
  }
  return list +
         "\nThe same kind, n and seed give the same coordinates on every platform.\n"
         "\n"
         "  quadloom generate uniform -n 100000 -o points.xyz\n"
         "  quadloom generate rotated-grid -n 400 --seed 7 -o grid.csv\n"
         "  quadloom generate two-opt-polygon -n 50 --holes 5 -o lake.geojson";
}

}  // namespace

void add_generate(CLI::App& app, Run& run) {
  CLI::App* verb =
      app.add_subcommand("generate", "A named set of points or a polygon, for tests and teaching");
  verb->footer(list_of_kinds());
  const auto o = std::make_shared<GenerateVerbOptions>();
  verb->add_option("KIND", o->kind, "One of the kinds below")->required();
  add_whole(*verb, "-n", o->n, 1, kMaxPoints, "How many points, or corners");
  add_whole(*verb, "--holes", o->holes, 0, kMaxPoints, "Polygons: at most so many holes");
  verb->add_option("-o,--output", o->output,
                   "The file: .xyz, .csv, .geojson, or -; polygons: .geojson or -")
      ->required();
  add_whole(*verb, "--seed", o->seed, 0, kNoLimit, "Seed of random choices");
  verb->callback([o, &run] { run = [o] { return generate(*o); }; });
}

}  // namespace quadloom::app
