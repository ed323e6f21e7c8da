#include "make_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "convex_facts.hpp"
#include "facts.hpp"
#include "options.hpp"
#include "quadloom/kernel.hpp"
#include "timer.hpp"

namespace quadloom::app {
namespace {

// The mesh and where its vertices came from, whichever algorithm made it.
struct Source {
  PolygonMesh mesh;
  std::vector<VertexId> input_to_vertex;
};

constexpr std::size_t kMostExactPoints = 20;  // all that the search takes

bool by_subdivision(const PointRun& run) { return run.making.method == PointMethod::kSubdivide; }

ConvexOptions convex_options(const PointRun& run) {
  ConvexOptions convex;
  convex.method = run.convex_method;
  convex.odd_boundary = run.making.odd_boundary;
  convex.seed = run.making.seed;
  convex.progress = run.making.progress;
  return convex;
}

/// Says that there is no mesh of strictly convex quads alone, or that it is not known.
[[noreturn]] void no_exact_mesh(const ExactConvexResult& result) {
  const std::string quads = counted(result.quads, "quad");
  throw Error(
      ErrorCode::kGuarantee,
      result.convex == Answer::kNo
          ? fmt::format("no mesh without an added point has strictly convex quads alone; at "
                        "most {} of the {} can be",
                        *result.most_convex, quads)
          : fmt::format("not known after {} tried whether a mesh without an added point has "
                        "strictly convex quads alone",
                        counted(result.work, "face")));
}

Source run_exact(const io::PointTable& table, const PointRun& run, MadeMesh& made) {
  const Timer timer;
  ExactConvexOptions options;
  options.points_at_most = kMostExactPoints;
  options.progress = run.making.progress;
  ExactConvexResult result = exact_convex_quadrangulation(table.points, options);
  if (result.convex != Answer::kYes) no_exact_mesh(result);
  made.input_vertices = result.mesh.points.size();
  made.statistics.hull_points = result.hull_points;
  made.seconds = timer.seconds();
  return {to_polygon_mesh(result.mesh), std::move(result.input_to_vertex)};
}

Source run_algorithm(const io::PointTable& table, const PointRun& run, MadeMesh& made) {
  if (run.exact) return run_exact(table, run, made);
  const PointOptions& options = run.making;
  const Timer timer;
  Source source;
  if (run.convex && !by_subdivision(run)) {
    ConvexResult result = convex_quadrangulation(table.points, convex_options(run));
    made.input_vertices = result.input_vertices;
    made.steiner = std::move(result.steiner);
    made.statistics.hull_points = result.statistics.hull_points;
    made.convex = result.statistics;
    made.not_convex = std::move(result.not_convex);
    made.seconds = timer.seconds();
    source = {to_polygon_mesh(result.mesh), std::move(result.input_to_vertex)};
  } else if (run.k == 4) {
    PointResult result = quadrangulate_points(table.points, options);
    if (run.convex) made.not_convex = find_not_convex(result.mesh);
    made.input_vertices = result.input_vertices;
    made.steiner = std::move(result.steiner);
    made.statistics = result.statistics;
    made.seconds = timer.seconds();
    source = {to_polygon_mesh(result.mesh), std::move(result.input_to_vertex)};
  } else {
    KAngulationResult result = k_angulate_points(table.points, run.k, options);
    made.input_vertices = result.input_vertices;
    made.steiner = std::move(result.steiner);
    made.seconds = timer.seconds();
    source = {std::move(result.mesh), std::move(result.input_to_vertex)};
  }
  return source;
}

// What the theorems promise for this input and these options.
CertifyOptions promised(const MadeMesh& made, const PointRun& run) {
  CertifyOptions promise;
  promise.corners = run.k;
  if (run.k > 4) return promise;  // the number of added points is told apart: beyond_bound()
  const bool odd = made.statistics.hull_points % 2 == 1;
  const bool triangle = run.making.odd_boundary == OddBoundary::kTriangle;
  if (run.exact) {
    promise.strictly_convex = true;
    promise.triangles_allowed = odd ? 1 : 0;
    promise.steiner_at_most = 0;
  } else if (made.convex) {  // a triangle stays where no place is outside
    const bool outside =
        std::any_of(made.steiner.begin(), made.steiner.end(),
                    [](const SteinerPoint& s) { return s.kind == SteinerKind::kOutside; });
    promise.strictly_convex = made.not_convex.empty();
    promise.triangles_allowed = odd && !outside ? 1 : 0;
    promise.steiner_at_most = steiner_bound(made.input_vertices, *made.convex, convex_options(run));
  } else if (by_subdivision(run) && !made.statistics.fell_back_to_spiral) {
    promise.strictly_convex = true;
  } else {
    promise.triangles_allowed = odd && triangle ? 1 : 0;
    promise.steiner_at_most = steiner_bound(made.statistics, run.making);
  }
  return promise;
}

}  // namespace

MadeMesh make_mesh(const io::PointTable& table, const PointRun& run) {
  MadeMesh made;
  made.input_points = table.points.size();
  Source source = run_algorithm(table, run, made);
  made.file.mesh = std::move(source.mesh);

  const Timer timer;
  made.certificate = certify_points(made.file.mesh, table.points, promised(made, run));
  made.certify_seconds = timer.seconds();

  made.quality = measure_quality(made.file.mesh);
  made.total_edge_length = made.quality.mean_edge * static_cast<double>(made.quality.edges);
  if (!table.z.empty()) {
    CarriedValues elevation =
        carry_values(table.z, source.input_to_vertex, made.file.mesh.points, made.steiner);
    made.file.z = std::move(elevation.values);
    made.other_z = elevation.differing;
  }
  return made;
}

void add_attributes(MadeMesh& made) {
  const PolygonMesh& mesh = made.file.mesh;
  io::Attribute added{"added", std::vector<double>(mesh.points.size(), 0)};
  for (const SteinerPoint& s : made.steiner) added.values[s.vertex] = 1;
  made.file.vertex_data.push_back(std::move(added));

  io::Attribute shape{"shape", {}};
  shape.values.reserve(mesh.face_count());
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto v = mesh.face(f);
    const auto at = [&](std::size_t i) { return mesh.points[v[i]]; };
    shape.values.push_back(v.size() == 4 ? quad_shape(at(0), at(1), at(2), at(3)) : 0);
  }
  made.file.face_data.push_back(std::move(shape));
}

std::string method_name(const PointRun& run) {
  if (run.k > 4) return name_of(PointMethod::kSpiral);
  if (run.convex && !by_subdivision(run)) return name_of(run.convex_method);
  return name_of(run.making.method);
}

bool beyond_bound(const MadeMesh& made, std::size_t k) {
  return k > 4 && made.steiner.size() > k - 3;
}

std::vector<VertexId> steiner_vertices(const MadeMesh& made) {
  std::vector<VertexId> vertices;
  for (const SteinerPoint& s : made.steiner) vertices.push_back(s.vertex);
  return vertices;
}

}  // namespace quadloom::app
