#include "convert_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "convex_facts.hpp"
#include "timer.hpp"

namespace quadloom::app {
namespace {

// ---- Weights. ----

const std::vector<double>& vertex_weight(const SourceMesh& source, const std::string& name) {
  const std::vector<double>* values = find_data(source.vertex_data, name);
  if (values == nullptr && name == "z" && !source.z.empty()) values = &source.z;
  if (values != nullptr) return *values;
  std::string names = "shape, convexity";
  if (!source.z.empty()) names += ", z";
  for (const auto& data : source.vertex_data) names += ", " + data.name;
  throw Error(
      ErrorCode::kBadOption,
      fmt::format("--weight: the vertices have no numbers called '{}'; there is {}", name, names));
}

// An edge weighs half the mean over its ends (so that differences are finite), above the least of all.
std::vector<double> edge_weights(const SourceMesh& source, const std::string& name) {
  const std::vector<double>& value = vertex_weight(source, name);
  const Triangulation& mesh = source.triangles.mesh;
  std::vector<double> weight;
  weight.reserve(mesh.tri_vertex.size());
  for (HalfedgeId h = 0; h < mesh.tri_vertex.size(); ++h) {
    const VertexId a = mesh.origin(h), b = mesh.target(h);
    for (const VertexId v : {a, b}) {
      if (std::isfinite(value[v])) continue;
      throw Error(ErrorCode::kNotFinite,
                  fmt::format("--weight: '{}' of vertex {} is not finite", name, v), {v});
    }
    weight.push_back(value[a] / 4 + value[b] / 4);
  }
  const double least = *std::min_element(weight.begin(), weight.end());
  for (double& w : weight) w -= least;
  return weight;
}

TriangleResult convert(const SourceMesh& source, const ConversionOptions& options,
                       Conversion& made) {
  TriangleOptions making = options.triangles;
  std::vector<double> weight;
  if (options.weight == "convexity") {
    making.weight = PairWeight::kConvexity;
  } else if (options.weight != "shape") {
    weight = edge_weights(source, options.weight);
    making.weight = PairWeight::kGiven;
    making.halfedge_weight = weight;
  }
  if (!options.convex) return quadrangulate_triangles(source.triangles, making);
  if (source.space == Space::kSurface) {
    throw Error(ErrorCode::kBadMesh, "--convex: strictly convex quads are made of planar meshes");
  }
  if (making.method == TriangleMethod::kSubdivide) {  // all are, whatever is asked
    TriangleResult result = quadrangulate_triangles(source.triangles, making);
    made.not_convex = find_not_convex(result.mesh);
    return result;
  }
  ConvexMeshResult result = convex_quadrangulation(source.triangles, making, options.seed);
  made.mending = result.mending;
  made.not_convex = std::move(result.not_convex);
  return std::move(result.quads);
}

// ---- Promises. ----

// Whether points were added to edges of the boundary, or outside of them.
bool adds_to_boundary(const SourceMesh& source, const TriangleResult& result) {
  std::set<std::pair<VertexId, VertexId>> edges;
  for (const SteinerPoint& s : result.steiner) {
    if (s.kind == SteinerKind::kOutside) return true;
    if (s.parents[1] != kNone && s.parents[2] == kNone) {
      edges.insert(std::minmax(s.parents[0], s.parents[1]));
    }
  }
  const Triangulation& mesh = source.triangles.mesh;
  for (HalfedgeId h = 0; h < mesh.twin.size() && !edges.empty(); ++h) {
    if (mesh.twin[h] == kNone && edges.contains(std::minmax(mesh.origin(h), mesh.target(h)))) {
      return true;
    }
  }
  return false;
}

CertifyOptions promised(const SourceMesh& source, const Conversion& made,
                        const ConversionOptions& conversion) {
  const TriangleResult& result = made.result;
  const TriangleOptions& options = conversion.triangles;
  CertifyOptions promise;
  promise.strictly_convex = conversion.convex && made.not_convex.empty();
  promise.steiner_at_most = steiner_bound(result.statistics, options);
  promise.outer_steiner =
      std::any_of(result.steiner.begin(), result.steiner.end(),
                  [](const SteinerPoint& s) { return s.kind == SteinerKind::kOutside; });
  promise.steiner_inside = !adds_to_boundary(source, result);
  const bool pair = options.method == TriangleMethod::kPair;
  if (pair && options.leftover == Leftover::kTriangle) {
    promise.triangles_allowed = result.statistics.unmatched;
  } else if (options.odd_boundary == OddBoundary::kTriangle) {
    promise.triangles_allowed = result.statistics.odd_parts;
  }
  return promise;
}

}  // namespace

Certificate certify_against(const io::MeshFile& file, const SourceMesh& source,
                            const CertifyOptions& options) {
  if (source.space == Space::kSurface) {
    const std::vector<double> flat(file.z.empty() ? file.mesh.points.size() : 0, 0);
    return certify_surface(file.mesh, file.z.empty() ? flat : file.z, source.faces, source.z,
                           options);
  }
  if (source.polygons) {
    return certify_polygons(file.mesh, source.polygons->polygons, source.inner, options);
  }
  return certify_mesh(file.mesh, source.faces, options);
}

Conversion convert_mesh(const SourceMesh& source, const ConversionOptions& options) {
  Conversion made;
  const Timer converting;
  made.result = convert(source, options, made);
  made.convert_seconds = converting.seconds();
  made.file = carry_data(source, made.result);

  const Timer certifying;
  made.certificate = certify_against(made.file, source, promised(source, made, options));
  if (made.certificate.ok()) made.lost = lost_feature(source, made.result);
  made.certify_seconds = certifying.seconds();

  made.quality = source.space == Space::kSurface ? measure_quality(made.file.mesh, made.file.z)
                                                 : measure_quality(made.file.mesh);
  return made;
}

Witness explain_leftover(const SourceMesh& source, const ConversionOptions& options) {
  ConversionOptions leaving = options;
  leaving.triangles.leftover = Leftover::kTriangle;
  leaving.triangles.odd_boundary = OddBoundary::kTriangle;
  Conversion made;
  TriangleResult result = convert(source, leaving, made);
  return find_witness(source, std::move(result.barrier), result.mesh.triangle_count(),
                      options.triangles);
}

}  // namespace quadloom::app
