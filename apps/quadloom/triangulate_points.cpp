// quadloom triangulate for points.
#include "elevation.hpp"
#include "facts.hpp"
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

Result make(TriangulationKind kind, std::span<const Point> points) {
  switch (kind) {
    case TriangulationKind::kDelaunay: {
      DelaunayResult made = delaunay(points);
      return {std::move(made.mesh), std::move(made.input_to_vertex), {}};
    }
    case TriangulationKind::kHamiltonianPath:
    case TriangulationKind::kSerpentine: {
      SerpentineResult made = serpentine_triangulation(points);
      return {std::move(made.mesh), std::move(made.input_to_vertex), OrderKind::kPath};
    }
    default:
      no_such_kind(kind, "points", "delaunay, hamiltonian-path and serpentine");
  }
}

}  // namespace

MadeTriangles triangulate_points(const TriangulateOptions& options, const io::PointTable& table) {
  MadeTriangles made;
  const Timer timer;
  const Result result = make(options.kind, table.points);
  made.seconds = timer.seconds();
  made.order = result.order;
  made.file.mesh = to_polygon_mesh(result.mesh);
  if (!table.z.empty()) {
    made.file.z = carry_elevation(table.z, result.input_to_vertex, result.mesh.points, {}).z;
  }
  made.certificate = certify_points(made.file.mesh, table.points, triangles_alone(0));
  made.verdict = verdict_line(made.certificate, true);
  return made;
}

}  // namespace quadloom::app
