// quadloom triangulate: points or polygons to triangles, Delaunay ones or in an order; meshes in an order.
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

const std::map<std::string, Splitter> kSplitters = {{"random", Splitter::kRandom},
                                                    {"balanced", Splitter::kBalanced}};
const std::map<std::string, Added> kAdded = {
    {"auto", Added::kAuto}, {"none", Added::kNone}, {"allow", Added::kAllowed}};

struct CommandOptions : TriangulateOptions {
  const CLI::App* verb = nullptr;
  double keep_angle = 0;

  bool has(const char* flag) const { return verb->count(flag) > 0; }
};

io::PointTable take_points(io::PlanarFile file) {
  return {std::move(file.input.points), std::move(file.z), {}};
}

// What the command line asks for, for that kind of input.
TriangulateOptions resolved(const CommandOptions& o, InputKind kind) {
  TriangulateOptions out = o;
  const bool mesh = kind == InputKind::kMesh;
  for (const char* flag :
       {"--regions", "--keep", "--keep-angle", "--space", "--faulty", "--merge-vertices"}) {
    if (mesh || !o.has(flag)) continue;
    throw Error(ErrorCode::kBadOption, fmt::format("{}: is for meshes", flag));
  }
  if (out.added == Added::kAuto) {
    out.added =
        mesh && o.kind == TriangulationKind::kHamiltonianCycle ? Added::kAllowed : Added::kNone;
  }
  out.reading.path = o.input.path;
  out.reading.format = o.input.reading.format;
  if (o.has("--keep-angle")) out.reading.keep_angle = o.keep_angle;
  return out;
}

MadeTriangles make(const CommandOptions& o, FoundInput found) {
  const TriangulateOptions options = resolved(o, found.kind);
  switch (found.kind) {
    case InputKind::kMesh:
      return triangulate_mesh(options, std::move(found));
    case InputKind::kPolygons:
      return triangulate_polygons(options, std::move(found));
    case InputKind::kAuto:
    case InputKind::kPoints:
      break;
  }
  return triangulate_points(options, found.planar ? take_points(std::move(*found.planar))
                                                  : io::read_points(o.input.path, o.input.reading));
}

// The triangles from one place in the order to another.
PolygonMesh part_of(const PolygonMesh& mesh, std::size_t from, std::size_t to) {
  PolygonMesh part;
  part.points = mesh.points;
  for (std::size_t f = from; f < to; ++f) part.add_face(mesh.face(f));
  return part;
}

std::vector<PolygonMesh> pieces_of(const MadeTriangles& made) {
  std::vector<PolygonMesh> pieces;
  for (std::size_t i = 0; i + 1 < made.piece_begin.size(); ++i) {
    pieces.push_back(part_of(made.file.mesh, made.piece_begin[i], made.piece_begin[i + 1]));
  }
  if (pieces.empty()) pieces.push_back(made.file.mesh);
  return pieces;
}

/// Judges the order, and writes it beside the triangles.
void tell_order(MadeTriangles& made) {
  if (!made.order || !made.certificate.ok()) return;
  const std::vector<PolygonMesh> pieces = pieces_of(made);
  for (const PolygonMesh& piece : pieces) {
    const Certificate verdict = certify_order(piece, *made.order);
    if (verdict.ok()) continue;
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
  if (pieces.size() > 1) made.verdict += fmt::format(", in each of {} components", pieces.size());
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
  if (made.order) {
    for (const PolygonMesh& piece : pieces_of(made)) {
      drawing.overlay.push_back(line_of(piece, *made.order));
    }
  }
  io::draw_mesh(o.picture, made.file, drawing);
}

int triangulate(const CommandOptions& o) {
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

namespace {

constexpr const char* kFooter =
    "\nNo point is added but by --steiner allow. Triangles of polygons carry the number of their\n"
    "polygon (part) and its numbers; segments are written as lines. But for delaunay the order of\n"
    "the triangles is the result: the order of the faces, the face data \"order\" of .vtu and\n"
    ".ply, a line in the picture. Of polygons it takes one alone. The triangles of a mesh stay "
    "and\n"
    "are put in order; but for a hamiltonian-cycle each takes a point, unless --steiner none.\n"
    "Exit status 4 says that there is no such order (\"none\"), or that the search ended before "
    "it\n"
    "was known (\"unknown\").\n"
    "\n"
    "  quadloom triangulate towns.csv -o towns.off\n"
    "  quadloom triangulate towns.csv --kind hamiltonian-path -o path.vtu --picture path.svg\n"
    "  quadloom triangulate towns.csv --kind hamiltonian-cycle -o tour.obj --splitter balanced\n"
    "  quadloom triangulate lake.geojson -o lake.vtu --picture lake.svg\n"
    "  quadloom triangulate lake.geojson --kind hamiltonian-cycle --steiner allow -o tour.vtu\n"
    "  quadloom triangulate coast.14 --kind hamiltonian-cycle -o cycle.vtu --picture cycle.png";

}  // namespace

void add_triangulate(CLI::App& app, Run& run) {
  CLI::App* verb = app.add_subcommand(
      "triangulate",
      "Points or polygons to triangles, Delaunay ones or one beside the other; meshes in order");
  verb->footer(kFooter);
  const auto o = std::make_shared<CommandOptions>();
  o->verb = verb;
  const auto splitter = std::make_shared<Splitter>(Splitter::kRandom);
  add_any_input(*verb, o->input);
  add_kind(*verb, o->input_kind);
  add_choice(*verb, "--kind", o->kind, kKinds,
             "Points: delaunay, or each triangle beside the one before: hamiltonian-path, "
             "serpentine, hamiltonian-cycle, where the last is beside the first, and sequential, "
             "where left and right turns alternate; polygons: delaunay, hamiltonian-path, "
             "hamiltonian-cycle, sequential; meshes: hamiltonian-path, hamiltonian-cycle, "
             "sequential");
  const auto* const splits =
      add_choice(*verb, "--splitter", *splitter, kSplitters,
                 "hamiltonian-cycle of points: which point splits a triangle, any of those in it, "
                 "or one with at most two thirds of them in each part");
  add_whole(*verb, "--seed", o->seed, 0, kNoLimit,
            "hamiltonian-cycle of points: the random choices");
  add_choice(*verb, "--steiner", o->added, kAdded,
             "Polygons, hamiltonian-path and -cycle: allow points to be added inside where there "
             "is no such triangulation without; meshes, hamiltonian-cycle: allow a point in each "
             "triangle; auto: allow for meshes, else none");
  add_whole_number(*verb, "--limit", 0, 1, kNoLimit,
                   "Where an order is searched for: the most steps, some seconds if not given",
                   [o = o.get()](std::uint64_t limit) { o->limit = limit; })
      ->default_str("");
  verb->add_option("-o,--output", o->output,
                   "Mesh: .obj, .off, .ply, .vtu, .msh, .geojson, or - for standard output")
      ->required();
  verb->add_option("--output-format", o->output_format, "Format of the mesh if not by the name");
  verb->add_option("--picture", o->picture, "Also draw the triangles: .svg, .png or .pdf");
  add_mesh_reading(*verb, o->reading, o->keep_angle);
  verb->callback([o, splitter, splits, &run] {
    if (splits->count() > 0) o->splitter = *splitter;
    run = [o] { return triangulate(*o); };
  });
}

}  // namespace quadloom::app
