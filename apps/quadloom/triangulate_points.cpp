// quadloom triangulate for points.
#include <fmt/format.h>

#include "facts.hpp"
#include "progress_bar.hpp"
#include "quadloom/quadrangulate.hpp"
#include "timer.hpp"
#include "triangulate.hpp"

namespace quadloom::app {
namespace {

struct Result {
  Triangulation mesh;
  std::vector<VertexId> input_to_vertex;
  std::optional<OrderKind> order;
};

/// A cycle; where there is none, or none was found, that is the answer.
Result make_cycle(const TriangulateOptions& o, std::span<const Point> points) {
  ProgressBar bar;
  HamiltonianOptions making;
  making.splitter = o.splitter.value_or(making.splitter);
  making.seed = o.seed;
  making.progress = bar.callback();
  HamiltonianResult made = hamiltonian_cycle_triangulation(points, making);
  if (made.order == OrderKind::kCycle) {
    return {std::move(made.mesh), std::move(made.input_to_vertex), OrderKind::kCycle};
  }
  const bool none_inside = made.statistics.hull_points == made.mesh.points.size();
  const std::string why =
      none_inside ? "none: without a point inside the hull no triangulation is a cycle"
      : made.cycle == Answer::kNo ? "none: no triangulation of these points is a cycle of triangles"
                                  : "no cycle of triangles was found: too many points are on lines";
  throw Error(ErrorCode::kGuarantee, why + "; --kind hamiltonian-path makes a path");
}

/// Where there is none, or none was found, that is the answer.
Result make_sequential(const TriangulateOptions& o, std::span<const Point> points) {
  ProgressBar bar;
  SequentialOptions making;
  if (o.limit) making.work_at_most = *o.limit;
  making.progress = bar.callback();
  SequentialResult made = sequential_triangulation(points, making);
  if (made.answer == Answer::kYes) {
    return {std::move(made.mesh), std::move(made.input_to_vertex), OrderKind::kSequential};
  }
  if (made.answer == Answer::kNo) {
    throw Error(ErrorCode::kGuarantee, "none: no triangulation of these points is sequential");
  }
  throw Error(ErrorCode::kGuarantee,
              made.work == 0
                  ? fmt::format("unknown: {} are inside the hull; with more than two a sequential "
                                "triangulation is searched for up to 32 points",
                                counted(made.inner_points, "point"))
                  : fmt::format("unknown: in {} steps no sequential triangulation was found, nor "
                                "that there is none; --limit allows more",
                                made.work));
}

Result make(const TriangulateOptions& o, std::span<const Point> points) {
  switch (o.kind) {
    case TriangulationKind::kDelaunay: {
      DelaunayResult made = delaunay(points);
      return {std::move(made.mesh), std::move(made.input_to_vertex), {}};
    }
    case TriangulationKind::kHamiltonianPath:
    case TriangulationKind::kSerpentine: {
      SerpentineResult made = serpentine_triangulation(points);
      return {std::move(made.mesh), std::move(made.input_to_vertex), OrderKind::kPath};
    }
    case TriangulationKind::kHamiltonianCycle:
      return make_cycle(o, points);
    case TriangulationKind::kSequential:
      break;
  }
  return make_sequential(o, points);
}

}  // namespace

MadeTriangles triangulate_points(const TriangulateOptions& options, const io::PointTable& table) {
  MadeTriangles made;
  const Timer timer;
  const Result result = make(options, table.points);
  made.seconds = timer.seconds();
  made.order = result.order;
  made.file.mesh = to_polygon_mesh(result.mesh);
  if (!table.z.empty()) {
    made.file.z = carry_values(table.z, result.input_to_vertex, result.mesh.points, {}).values;
  }
  made.certificate = certify_points(made.file.mesh, table.points, triangles_alone(0));
  made.verdict = verdict_line(made.certificate, true);
  return made;
}

}  // namespace quadloom::app
