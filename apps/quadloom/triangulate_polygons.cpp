// quadloom triangulate for polygons.
#include <fmt/format.h>

#include "facts.hpp"
#include "mesh_facts.hpp"
#include "timer.hpp"
#include "triangulate.hpp"

namespace quadloom::app {
namespace {

MadeTriangles delaunay_triangles(const TriangulateOptions& options, FoundInput found) {
  MeshReading reading;
  reading.path = options.input.path;
  reading.format = options.input.reading.format;
  SourceMesh source = read_source(reading, std::move(found));
  MadeTriangles made;
  made.seconds = source.connect_seconds;
  made.file.mesh = to_polygon_mesh(source.triangles.mesh);
  made.file.z = source.z;
  made.file.vertex_data = source.vertex_data;
  made.file.face_data = source.face_data;
  made.file.edges = source.lines;
  made.certificate = certify_against(made.file, source, triangles_alone(0));
  made.verdict = source_verdict(made.certificate, source, false);
  return made;
}

// Orders of triangles are made of one polygon and nothing else.
io::PlanarFile read_one_polygon(const TriangulateOptions& options, FoundInput found) {
  io::PlanarFile file = found.planar
                            ? std::move(*found.planar)
                            : io::read_planar(options.input.path, options.input.reading.format);
  const PlanarInput& input = file.input;
  if (input.polygons.size() == 1 && input.points.empty() && input.segments.empty()) return file;
  throw Error(ErrorCode::kBadOption,
              fmt::format("--kind {} is for one polygon alone; '{}' has {}, {} and {}",
                          name_of(options.kind), options.input.path,
                          counted(input.polygons.size(), "polygon"),
                          counted(input.points.size(), "inner point"),
                          counted(input.segments.size(), "segment")));
}

// Holes make the question without added points one that is not answered.
std::optional<PolygonOrder> path_without_points(const Polygon& polygon, Added added) {
  try {
    return hamiltonian_triangulation(polygon);
  } catch (const Error& e) {
    if (added == Added::kNone || e.code() != ErrorCode::kBadPolygon) throw;
    return std::nullopt;
  }
}

PolygonOrder make(const Polygon& polygon, TriangulationKind kind, Added added) {
  std::optional<PolygonOrder> made;
  std::string missing;
  OrderKind order = OrderKind::kPath;
  switch (kind) {
    case TriangulationKind::kHamiltonianPath:
      made = path_without_points(polygon, added);
      missing = "no triangulation of this polygon is a path of triangles";
      break;
    case TriangulationKind::kHamiltonianCycle:
      order = OrderKind::kCycle;
      if (added == Added::kNone) sequential_triangulation(polygon);  // refuses holes, too
      missing = "no triangulation of a polygon without holes is a cycle of triangles";
      break;
    case TriangulationKind::kSequential:
      if (added == Added::kAllowed) {
        throw Error(ErrorCode::kBadOption,
                    "--steiner allow: points are added for hamiltonian-path and hamiltonian-cycle");
      }
      made = sequential_triangulation(polygon);
      if (made) return std::move(*made);
      throw Error(ErrorCode::kGuarantee, "none: no triangulation of this polygon is sequential");
    default:
      no_such_kind(kind, "polygons",
                   "delaunay, hamiltonian-path, hamiltonian-cycle and sequential");
  }
  if (made) return std::move(*made);
  if (added == Added::kAllowed) return hamiltonian_triangulation_with_points(polygon, order);
  throw Error(ErrorCode::kGuarantee,
              "none: " + missing + "; --steiner allow adds points until one is");
}

// "3 points added for 5 convex parts, the fewest"; nothing if no point may be added.
std::string in_words(const PolygonOrder& made) {
  if (made.parts == 0) return {};
  const std::string added = counted(made.steiner.size(), "point") + " added";
  if (made.parts == 1) return added + ", the polygon is convex\n";
  const std::string parts = counted(made.parts, "convex part");
  if (made.parts == made.parts_at_least)
    return fmt::format("{} for {}, the fewest\n", added, parts);
  return fmt::format("{} for {}; at least {} are needed\n", added, parts, made.parts_at_least);
}

MadeTriangles in_order(const TriangulateOptions& options, FoundInput found) {
  const io::PlanarFile file = read_one_polygon(options, std::move(found));
  const Polygon& polygon = file.input.polygons[0];
  MadeTriangles made;
  const Timer timer;
  const PolygonOrder result = make(polygon, options.kind, options.added);
  made.seconds = timer.seconds();
  made.order = result.order;
  made.remarks = in_words(result);
  made.file.mesh = to_polygon_mesh(result.mesh);
  if (!file.z.empty()) {
    made.file.z =
        carry_values(file.z, result.input_to_vertex, result.mesh.points, result.steiner).values;
  }
  for (const auto& [name, values] : file.polygon_data) {
    made.file.face_data.push_back(
        {name, std::vector<double>(made.file.mesh.face_count(), values[0])});
  }
  for (const SteinerPoint& s : result.steiner) made.steiner.push_back(s.vertex);
  CertifyOptions promise = triangles_alone(result.steiner.size());
  promise.steiner_inside = true;
  made.certificate = certify_polygons(made.file.mesh, std::span(&polygon, 1), {}, promise);
  made.verdict =
      made.certificate.ok()
          ? "certified: every corner is a vertex and the faces tile the polygon exactly once"
          : verdict_line(made.certificate, false);
  return made;
}

}  // namespace

MadeTriangles triangulate_polygons(const TriangulateOptions& options, FoundInput found) {
  return options.kind == TriangulationKind::kDelaunay
             ? delaunay_triangles(options, std::move(found))
             : in_order(options, std::move(found));
}

}  // namespace quadloom::app
