// quadloom triangulate: points or polygons to triangles, Delaunay ones or in an order.
#include "triangulate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <memory>

#include "choice.hpp"
#include "exit_codes.hpp"
#include "facts.hpp"
#include "verbs.hpp"

namespace quadloom::app {
namespace {

const std::map<std::string, TriangulationKind> kKinds = {
    {"delaunay", TriangulationKind::kDelaunay},
    {"hamiltonian-path", TriangulationKind::kHamiltonianPath},
    {"hamiltonian-cycle", TriangulationKind::kHamiltonianCycle},
    {"serpentine", TriangulationKind::kSerpentine},
    {"sequential", TriangulationKind::kSequential},
};

const std::map<std::string, Added> kAdded = {{"none", Added::kNone}, {"allow", Added::kAllowed}};
const std::map<std::string, Splitter> kSplitters = {{"random", Splitter::kRandom},
                                                    {"balanced", Splitter::kBalanced}};

io::PointTable take_points(io::PlanarFile file) {
  return {std::move(file.input.points), std::move(file.z), {}};
}

MadeTriangles make(const TriangulateOptions& o, FoundInput found) {
  switch (found.kind) {
    case InputKind::kMesh:
      throw Error(ErrorCode::kBadOption,
                  fmt::format("'{}' is a mesh already; points and polygons can be triangulated",
                              o.input.path));
    case InputKind::kPolygons:
      return triangulate_polygons(o, std::move(found));
    case InputKind::kAuto:
    case InputKind::kPoints:
      break;
  }
  return triangulate_points(o, found.planar ? take_points(std::move(*found.planar))
                                            : io::read_points(o.input.path, o.input.reading));
}

/// Judges the order, and writes it beside the triangles.
void tell_order(MadeTriangles& made) {
  if (!made.order || !made.certificate.ok()) return;
  const Certificate verdict = certify_order(made.file.mesh, *made.order);
  if (!verdict.ok()) {
    made.certificate = verdict;
    made.verdict = verdict_line(verdict, false);
    return;
  }
  switch (*made.order) {
    case OrderKind::kPath:
      made.verdict += ", each triangle beside the one before";
      break;
    case OrderKind::kCycle:
      made.verdict += ", each triangle beside the one before, the first beside the last";
      break;
    case OrderKind::kSequential:
      made.verdict += ", each triangle beside the one before, turning left and right by turns";
      break;
  }
  io::Attribute order{"order", {}};
  for (std::size_t f = 0; f < made.file.mesh.face_count(); ++f) {
    order.values.push_back(static_cast<double>(f));
  }
  made.file.face_data.push_back(std::move(order));
}

/// The order as a line: from the middle of each triangle through that of the edge to the next.
io::Polyline line_of(const PolygonMesh& mesh, OrderKind kind) {
  io::Polyline line;
  line.closed = kind == OrderKind::kCycle;
  const auto middle = [&](std::span<const VertexId> corners) {
    Point sum;
    for (const VertexId v : corners) {
      sum.x += mesh.points[v].x / static_cast<double>(corners.size());
      sum.y += mesh.points[v].y / static_cast<double>(corners.size());
    }
    return sum;
  };
  const std::size_t count = mesh.face_count();
  for (std::size_t f = 0; f < count; ++f) {
    line.points.push_back(middle(mesh.face(f)));
    if (f + 1 == count && !line.closed) break;
    const auto next = mesh.face((f + 1) % count);
    std::vector<VertexId> shared;
    for (const VertexId v : mesh.face(f)) {
      if (std::find(next.begin(), next.end(), v) != next.end()) shared.push_back(v);
    }
    line.points.push_back(middle(shared));
  }
  return line;
}

void draw(const TriangulateOptions& o, const MadeTriangles& made) {
  if (o.picture.empty()) return;
  io::DrawOptions drawing;
  drawing.colour = io::ColourBy::kNone;
  drawing.title = fmt::format("{}: {}", short_name(o.input.path),
                              counted(made.file.mesh.face_count(), "triangle"));
  drawing.steiner = made.steiner;
  if (made.order) drawing.overlay = {line_of(made.file.mesh, *made.order)};
  io::draw_mesh(o.picture, made.file, drawing);
}

int triangulate(const TriangulateOptions& o) {
  require_mesh(o.output, o.output_format);
  require_picture(o.picture);
  FoundInput found = find_input(o.input.path, o.input.reading.format, o.input_kind);
  const bool of_points = found.kind != InputKind::kMesh && found.kind != InputKind::kPolygons;
  if (o.splitter && !(of_points && o.kind == TriangulationKind::kHamiltonianCycle)) {
    throw Error(ErrorCode::kBadOption, "--splitter is for --kind hamiltonian-cycle of points");
  }
  MadeTriangles made = make(o, std::move(found));
  tell_order(made);
  std::FILE* const to = o.output == "-" || !made.certificate.ok() ? stderr : stdout;
  if (made.certificate.ok()) {
    io::write_mesh(o.output, made.file, o.output_format);
    draw(o, made);
  }
  fmt::print(to, "{}, {}, {:.2f} s\n{}{}\n", counted(made.file.mesh.points.size(), "point"),
             counted(made.file.mesh.face_count(), "triangle"), made.seconds, made.remarks,
             made.verdict);
  return made.certificate.ok() ? kDone : kCheckFailed;
}

}  // namespace

std::string name_of(TriangulationKind kind) { return find_name(kKinds, kind); }

CertifyOptions triangles_alone(std::size_t steiner_at_most) {
  CertifyOptions promise;
  promise.corners = 3;
  promise.steiner_at_most = steiner_at_most;
  return promise;
}

void no_such_kind(TriangulationKind kind, const std::string& input, const std::string& kinds) {
  throw Error(ErrorCode::kBadOption, fmt::format("there is no --kind {} for {}; there are {}",
                                                 name_of(kind), input, kinds));
}

void add_triangulate(CLI::App& app, Run& run) {
  CLI::App* verb = app.add_subcommand(
      "triangulate", "Points or polygons to triangles, Delaunay ones or one beside the other");
  verb->footer(
      "\nNo point is added but by --steiner allow. Triangles of polygons carry the number of "
      "their\n"
      "polygon (part) and its numbers; segments are written as lines. In the other kinds than\n"
      "delaunay the order of the triangles is the result: the order of the faces, the face data\n"
      "\"order\" of .vtu and .ply, a line in the picture. They take one polygon; exit status 4 "
      "and\n"
      "\"none\" say that it has no such triangulation.\n"
      "\n"
      "  quadloom triangulate towns.csv -o towns.off\n"
      "  quadloom triangulate towns.csv --kind hamiltonian-path -o path.vtu --picture path.svg\n"
      "  quadloom triangulate towns.csv --kind hamiltonian-cycle -o tour.obj --splitter balanced\n"
      "  quadloom triangulate lake.geojson -o lake.vtu --picture lake.svg\n"
      "  quadloom triangulate lake.geojson --kind hamiltonian-cycle --steiner allow -o tour.vtu");
  const auto o = std::make_shared<TriangulateOptions>();
  const auto splitter = std::make_shared<Splitter>(Splitter::kRandom);
  add_any_input(*verb, o->input);
  add_kind(*verb, o->input_kind);
  add_choice(*verb, "--kind", o->kind, kKinds,
             "Points: delaunay, or each triangle beside the one before: hamiltonian-path, "
             "serpentine, and hamiltonian-cycle, where the last is beside the first; polygons: "
             "delaunay, hamiltonian-path, hamiltonian-cycle, sequential");
  const auto* const splits =
      add_choice(*verb, "--splitter", *splitter, kSplitters,
                 "hamiltonian-cycle of points: which point splits a triangle, any of those in it, "
                 "or one with at most two thirds of them in each part");
  add_whole(*verb, "--seed", o->seed, 0, kNoLimit,
            "hamiltonian-cycle of points: the random choices");
  add_choice(*verb, "--steiner", o->added, kAdded,
             "Polygons, hamiltonian-path and -cycle: allow points to be added inside where there "
             "is no such triangulation without");
  verb->add_option("-o,--output", o->output,
                   "Mesh: .obj, .off, .ply, .vtu, .msh, .geojson, or - for standard output")
      ->required();
  verb->add_option("--output-format", o->output_format, "Format of the mesh if not by the name");
  verb->add_option("--picture", o->picture, "Also draw the triangles: .svg, .png or .pdf");
  verb->callback([o, splitter, splits, &run] {
    if (splits->count() > 0) o->splitter = *splitter;
    run = [o] { return triangulate(*o); };
  });
}

}  // namespace quadloom::app
