// quadloom quadrangulate: points, a mesh or polygons in, a certified mesh out. The verb, its options,
// and which half does the work.
#include "quadrangulate.hpp"

#include <fmt/format.h>

#include <memory>

#include "timer.hpp"
#include "verbs.hpp"

namespace quadloom::app {
namespace {

struct QuadrangulateOptions {
  InputOptions input;
  InputKind kind = InputKind::kAuto;
  std::string method;  // empty: the default of the kind of input
  OddBoundary odd_boundary = OddBoundary::kOutside;
  std::vector<std::string> given;  // the options on the command line
  double keep_angle = 0;
  std::uint64_t seed = 1;
  bool convex = false;
  bool exact = false;
  PointRun points;
  MeshRun mesh;
  OutputOptions output;

  bool has(const std::string& option) const {
    return std::find(given.begin(), given.end(), option) != given.end();
  }
};

// Options that the input or the method has no use for are refused: they would be ignored.
void refuse(const QuadrangulateOptions& o, std::initializer_list<const char*> options,
            const std::string& why) {
  for (const char* option : options) {
    if (o.has(option)) throw Error(ErrorCode::kBadOption, fmt::format("{}: {}", option, why));
  }
}

PointRun exact_run(const QuadrangulateOptions& o, PointRun run) {
  if (!o.convex) throw Error(ErrorCode::kBadOption, "--exact: is for --convex");
  refuse(o, {"--method", "--seed", "--k"}, "is not for --exact, which tries every mesh");
  if (o.has("--odd-boundary") && o.odd_boundary != OddBoundary::kTriangle) {
    throw Error(ErrorCode::kBadOption, "--odd-boundary: --exact adds no point, a triangle stays");
  }
  run.making.odd_boundary = OddBoundary::kTriangle;
  run.convex = run.exact = true;
  return run;
}

PointRun point_run(const QuadrangulateOptions& o) {
  refuse(o,
         {"--leftover", "--pairs", "--weight", "--matching", "--min-quality", "--regions",
          "--keep-angle", "--keep", "--space", "--faulty", "--merge-vertices"},
         "is for meshes and polygons, not for points");
  PointRun run = o.points;
  if (o.exact) return exact_run(o, run);
  if (o.convex && o.has("--method") && o.method != "subdivide") {
    run.convex_method = convex_method(o.method);
  } else if (o.has("--method")) {
    run.making.method = point_method(o.method);
  }
  if (o.has("--odd-boundary")) run.making.odd_boundary = o.odd_boundary;
  run.making.seed = o.seed;
  run.convex = o.convex;
  if (run.k == 4) return run;
  refuse(o, {"--convex"}, "is for faces of 4 corners");
  if (run.making.method != PointMethod::kDelaunay && run.making.method != PointMethod::kSpiral) {
    throw Error(ErrorCode::kBadOption,
                "--k: faces of more than 4 corners are made by delaunay and spiral only");
  }
  refuse(o, {"--odd-boundary"}, "is for faces of 4 corners");
  return run;
}

MeshRun mesh_run(const QuadrangulateOptions& o, InputKind kind) {
  refuse(o, {"--k", "--columns", "--exact"}, "is for points, not for meshes and polygons");
  if (!o.convex) refuse(o, {"--seed"}, "is for points, and for --convex");
  MeshRun run = o.mesh;
  if (o.has("--method")) run.conversion.triangles.method = triangle_method(o.method);
  if (o.has("--odd-boundary")) run.conversion.triangles.odd_boundary = o.odd_boundary;
  if (run.conversion.triangles.method != TriangleMethod::kPair) {
    refuse(o, {"--leftover", "--pairs", "--weight", "--matching", "--min-quality"},
           "is for --method pair");
  }
  if (kind == InputKind::kPolygons) {
    refuse(o, {"--space", "--faulty", "--merge-vertices"}, "is for meshes, not for polygons");
  }
  run.conversion.convex = o.convex;
  run.conversion.seed = o.seed;
  if (o.has("--keep-angle")) run.reading.keep_angle = o.keep_angle;
  run.reading.path = o.input.path;
  run.reading.format = o.input.reading.format;
  return run;
}

// GeoJSON that was read to find out what it holds is not read again.
io::PointTable read_point_table(const QuadrangulateOptions& o, FoundInput found) {
  if (!found.planar) return io::read_points(o.input.path, o.input.reading);
  io::PointTable table;
  table.points = std::move(found.planar->input.points);
  table.z = std::move(found.planar->z);
  return table;
}

int quadrangulate(const QuadrangulateOptions& o) {
  require_mesh(o.output.mesh, o.output.mesh_format);
  require_picture(o.output.picture);
  require_writable(o.output.report);
  require_different({o.output.mesh, o.output.picture, o.output.report});
  const Timer reading;
  FoundInput found = find_input(o.input.path, o.input.reading.format, o.kind);
  if (found.kind != InputKind::kPoints) {
    const InputKind kind = found.kind;
    return quadrangulate_mesh_file(std::move(found), mesh_run(o, kind), o.output);
  }
  const PointRun run = point_run(o);
  io::PointTable table = read_point_table(o, std::move(found));
  std::vector<std::size_t>().swap(table.line);  // a third of it, which nobody asks for
  return quadrangulate_point_file(o.input.path, table, reading.seconds(), run, o.output);
}

void add_mesh_options(CLI::App& verb, QuadrangulateOptions& o) {
  constexpr const char* kGroup = "Meshes and polygons";
  add_conversion(verb, o.mesh.conversion.triangles);
  const auto word = [&](const char* flag, std::string& value, const char* type, const char* help) {
    verb.add_option(flag, value, help)->type_name(type)->capture_default_str()->group(kGroup);
  };
  word("--weight", o.mesh.conversion.weight, "shape|convexity|NAME",
       "pair: what the pairs have most of; NAME: numbers of the vertices, an edge goes the sooner "
       "the "
       "greater their mean is at its ends");
  add_mesh_reading(verb, o.mesh.reading, o.keep_angle);
}

constexpr const char* kFooter =
    "\nThe given points are kept bit for bit and come first. Of points, the number of those on "
    "the\n"
    "hull decides: if it is even no point is added, if it is odd one point or one triangle.\n"
    "Triangles of a mesh or of polygons are paired, those left over walk together; a part with an\n"
    "odd number of border edges takes one point or keeps one triangle.\n"
    "With --convex a few points are added inside, for no corner to be flat or reflex.\n"
    "\n"
    "  quadloom quadrangulate towns.csv -o towns.vtu --picture towns.png\n"
    "  quadloom quadrangulate sites.csv --columns lon,lat,height -o sites.obj\n"
    "  quadloom quadrangulate points.xyz -o mesh.msh --odd-boundary triangle --report "
    "facts.json\n"
    "  quadloom quadrangulate coast.14 -o coast.vtu --report facts.json\n"
    "  quadloom quadrangulate lake.geojson -o lake.msh --method q-percolate\n"
    "  quadloom quadrangulate towns.csv --convex -o towns.vtu\n"
    "  quadloom quadrangulate few.xyz --convex --exact -o few.obj\n"
    "  cat points.xyz | quadloom quadrangulate - -o - --output-format off > mesh.off";

}  // namespace

void add_quadrangulate(CLI::App& app, Run& run) {
  CLI::App* verb = app.add_subcommand(
      "quadrangulate", "Points, a mesh of triangles or polygons to a mesh of quadrilaterals");
  verb->footer(kFooter);
  const auto o = std::make_shared<QuadrangulateOptions>();
  add_any_input(*verb, o->input);
  add_kind(*verb, o->kind);
  verb->add_option("-o,--output", o->output.mesh,
                   "Mesh: .obj, .off, .ply, .vtu, .msh, .geojson, or - for standard output")
      ->required();
  verb->add_option("--output-format", o->output.mesh_format,
                   "Format of the mesh if not by the name; msh22 is version 2.2 of msh");
  verb->add_option("--method", o->method,
                   "Points: delaunay (the best shapes), spiral, insertion (Bose and Toussaint's), "
                   "subdivide (all strictly convex), pentagons (with --convex); meshes and "
                   "polygons: pair, percolate, fans, "
                   "q-percolate, quarter, subdivide")
      ->type_name(method_words());
  add_odd_boundary(*verb, o->odd_boundary)->default_str("");
  verb->add_flag("--convex", o->convex,
                 "All quads strictly convex: points by delaunay (few points added), spiral or "
                 "pentagons (as in two papers), planar meshes and polygons by pair");
  verb->add_flag("--exact", o->exact,
                 "Points with --convex, 20 at most: no point is added; every mesh is tried, and if "
                 "none will do, that is said (exit code 4)");
  add_whole(*verb, "--seed", o->seed, 0, kNoLimit, "Points and --convex: seed of random choices");
  add_whole(*verb, "--k", o->points.k, 4, 1 << 20,
            "Points: corners of each face; above 4 the methods are delaunay and spiral");
  verb->add_option("--picture", o->output.picture, "Also draw the mesh: .svg, .png or .pdf");
  verb->add_option("--report", o->output.report,
                   "Also write all figures as JSON; - for standard output");
  verb->add_flag("--quiet", o->output.quiet, "Print nothing but errors");
  add_mesh_options(*verb, *o);
  verb->callback([o, verb, &run] {
    for (const CLI::Option* option : verb->get_options()) {
      if (option->count() > 0) o->given.push_back(option->get_name());
    }
    run = [o] { return quadrangulate(*o); };
  });
}

}  // namespace quadloom::app
