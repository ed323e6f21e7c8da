// quadloom triangulate for meshes: their triangles in an order, with points added or as they are.
#include <fmt/format.h>

#include "facts.hpp"
#include "mesh_facts.hpp"
#include "progress_bar.hpp"
#include "timer.hpp"
#include "triangulate.hpp"

namespace quadloom::app {
namespace {

// What was made of the triangles of the source, in order.
struct Ordered {
  TriangleResult triangles;  // no quads
  std::vector<std::array<TriangleId, 2>> source;
  std::vector<std::uint32_t> piece_begin;
  OrderKind order = OrderKind::kPath;
  std::string remarks;
};

Ordered as_they_are(const TriangleMesh& input, const std::vector<TriangleId>& order,
                    OrderKind kind) {
  Ordered out;
  out.order = kind;
  Triangulation mesh = reorder_triangles(input.mesh, order);
  out.triangles.mesh.points = std::move(mesh.points);
  out.triangles.mesh.tri_vertex = std::move(mesh.tri_vertex);
  out.triangles.z = input.z;
  out.triangles.input_vertices = input.mesh.points.size();
  for (const TriangleId t : order) out.source.push_back({t, kNone});
  return out;
}

Ordered refined(const TriangleMesh& input, const SourceMesh& source, const Progress& progress) {
  RefinementOptions options;
  options.progress = progress;
  HamiltonianRefinement made = hamiltonian_refinement(input, options);
  Ordered out;
  out.order = OrderKind::kCycle;
  out.remarks = fmt::format("{} added, smallest angle {:.4g} degrees, {:.4g} before\n",
                            counted(made.steiner.size(), "point"), made.min_angle_after,
                            made.min_angle_before);
  if (source.kept_edges > 0) out.remarks += counted(source.kept_edges, "inner edge") + " kept\n";
  if (made.midpoints > 0) {
    out.remarks += fmt::format("{} on edges that stay, where a part hangs on them alone\n",
                               counted(made.midpoints, "point"));
  }
  if (made.moved > 0) {
    out.remarks += fmt::format("{} not at the centre of its triangle's inscribed circle\n",
                               counted(made.moved, "point"));
  }
  out.triangles.mesh.points = std::move(made.mesh.mesh.points);
  out.triangles.mesh.tri_vertex = std::move(made.mesh.mesh.tri_vertex);
  out.triangles.z = std::move(made.mesh.z);
  out.triangles.input_vertices = made.input_vertices;
  out.triangles.steiner = std::move(made.steiner);
  out.source = std::move(made.source);
  if (made.cycle_count() > 1) out.piece_begin = std::move(made.cycle_begin);
  return out;
}

[[noreturn]] void say_none(const HamiltonianOrder& found, const SourceMesh& source,
                           OrderKind kind) {
  const std::string what = kind == OrderKind::kCycle ? "cycle" : "path";
  const std::size_t culprits = found.culprits.size();
  std::string why;
  switch (found.reason) {
    case NoOrder::kTooFew:
      why = "a cycle takes three triangles";
      break;
    case NoOrder::kComponents:
      why = fmt::format("the triangles are in {} components", culprits);
      break;
    case NoOrder::kEars:
      why = fmt::format("{} with one neighbour, the first at face {}",
                        counted(culprits, "triangle"), source.source_face[found.culprits[0]]);
      break;
    case NoOrder::kBridges:
      why = kind == OrderKind::kCycle
                ? fmt::format(
                      "nothing but the edge between the faces {} and {} holds two parts "
                      "together",
                      source.source_face[found.culprits[0]], source.source_face[found.culprits[1]])
                : fmt::format("from the part around face {} three ways lead that do not come back",
                              source.source_face[found.culprits[0]]);
      break;
    case NoOrder::kPairing:
      why = "any way to pair neighbours leaves too many over";
      break;
    default:
      why = fmt::format("found by exhaustion, {} steps", found.work);
      break;
  }
  const char* const hint = kind == OrderKind::kCycle ? "; --steiner allow makes one" : "";
  throw Error(ErrorCode::kGuarantee,
              fmt::format("none: no order of the triangles is a {}: {}{}", what, why, hint));
}

Ordered searched(const TriangleMesh& input, const SourceMesh& source, OrderKind kind,
                 const TriangulateOptions& options, const Progress& progress) {
  OrderSearchOptions searching;
  searching.kind = kind;
  if (options.limit) searching.work_at_most = *options.limit;
  searching.progress = progress;
  const HamiltonianOrder found = hamiltonian_order(input.mesh, searching);
  if (found.answer == Answer::kNo) say_none(found, source, kind);
  if (found.answer == Answer::kUnknown) {
    throw Error(ErrorCode::kGuarantee,
                fmt::format("unknown: in {} steps no order of the triangles was found that is a "
                            "{}, nor that there is none; --limit allows more",
                            found.work, kind == OrderKind::kCycle ? "cycle" : "path"));
  }
  return as_they_are(input, found.order, kind);
}

Ordered sequential(const TriangleMesh& input) {
  const auto found = sequential_order(input.mesh);
  if (!found) {
    throw Error(ErrorCode::kGuarantee, "none: no order of the triangles is sequential");
  }
  Ordered out = as_they_are(input, found->order, OrderKind::kSequential);
  if (found->closure == Closure::kCycle) out.remarks = "the last triangle is beside the first\n";
  if (found->closure == Closure::kSequentialCycle) {
    out.remarks = "the last triangle is beside the first, and turns go on alternating there\n";
  }
  return out;
}

Ordered make(const TriangulateOptions& o, const SourceMesh& source) {
  ProgressBar bar;
  const TriangleMesh& input = source.triangles;
  const bool allowed = o.added == Added::kAllowed;
  switch (o.kind) {
    case TriangulationKind::kHamiltonianCycle:
      return allowed ? refined(input, source, bar.callback())
                     : searched(input, source, OrderKind::kCycle, o, bar.callback());
    case TriangulationKind::kHamiltonianPath:
    case TriangulationKind::kSequential:
      if (allowed) {
        throw Error(ErrorCode::kBadOption,
                    "--steiner allow: points are added to meshes for hamiltonian-cycle");
      }
      return o.kind == TriangulationKind::kSequential
                 ? sequential(input)
                 : searched(input, source, OrderKind::kPath, o, bar.callback());
    default:
      break;
  }
  throw Error(ErrorCode::kBadOption,
              fmt::format("'{}' is a mesh already; points and polygons can be triangulated, meshes "
                          "put in order: --kind hamiltonian-path, hamiltonian-cycle or sequential",
                          o.input.path));
}

}  // namespace

MadeTriangles triangulate_mesh(const TriangulateOptions& options, FoundInput found) {
  const SourceMesh source = read_source(options.reading, std::move(found));
  MadeTriangles made;
  const Timer timer;
  const Ordered ordered = make(options, source);
  made.seconds = timer.seconds();
  made.order = ordered.order;
  made.piece_begin = ordered.piece_begin;
  for (const SteinerPoint& s : ordered.triangles.steiner) made.steiner.push_back(s.vertex);
  made.file = carry_data(source, ordered.triangles, ordered.source);
  std::erase_if(made.file.face_data, [](const io::Attribute& a) { return a.name == "shape"; });

  CertifyOptions promise = triangles_alone(made.steiner.size());
  promise.steiner_inside = true;
  made.certificate = certify_against(made.file, source, promise);
  made.verdict = source_verdict(made.certificate, source, false);
  const std::string lost = lost_feature(source, ordered.triangles);
  if (made.certificate.ok() && !lost.empty()) {
    made.certificate.fault = Fault::kBoundary;
    made.verdict = "NOT CERTIFIED: " + lost;
  }
  for (const std::string& remark : source.remarks) made.remarks += remark + '\n';
  made.remarks += ordered.remarks;
  return made;
}

}  // namespace quadloom::app
