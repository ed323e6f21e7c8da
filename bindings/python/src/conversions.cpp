#include "conversions.hpp"

namespace nb = nanobind;

namespace quadloom::python {

TriangleOptionsArgument::TriangleOptionsArgument(const Choice<TriangleMethod>& method,
                                                 const Choice<Leftover>& leftover,
                                                 const Choice<PairKind>& pairs,
                                                 const Choice<PairWeight>& weight,
                                                 const Choice<MatchingEffort>& effort,
                                                 double min_quality, const NumbersLike& weights,
                                                 const Choice<OddBoundary>& odd_boundary)
    : halfedge_weight(doubles_from(weights, "halfedge_weight")) {
  options.method = method.get("method");
  options.leftover = leftover.get("leftover");
  options.pairs = pairs.get("pairs");
  options.weight = weight.get("weight");
  options.effort = effort.get("effort");
  options.min_quality = min_quality;
  options.halfedge_weight = halfedge_weight;
  options.odd_boundary = odd_boundary.get("odd_boundary");
}

PlanarArgument::PlanarArgument(const PolygonsLike& polygons, const PointsLike& points,
                               const NumbersLike& segments, const PointsLike& holes,
                               const PointsLike& regions) {
  const io::PlanarFile* file = nullptr;
  if (nb::try_cast(polygons, file) && file != nullptr) {
    if (!points.is_none() || !segments.is_none() || !holes.is_none() || !regions.is_none()) {
      throw Error(ErrorCode::kBadOption,
                  "a PlanarFile has its points, segments, holes and regions already");
    }
    input = file->input;
    z = file->z;
    return;
  }
  const auto places = [](const PointsLike& given, std::vector<Point>& out,
                         std::vector<double>* heights) {
    if (given.is_none()) return;
    const Points read(given);
    out.assign(read.xy().begin(), read.xy().end());
    if (heights != nullptr) heights->insert(heights->end(), read.z().begin(), read.z().end());
  };
  input.polygons = polygons_from(polygons, &z);
  std::size_t count = 0;
  for (const Polygon& polygon : input.polygons) {
    for (const auto& ring : polygon.rings) count += ring.size();
  }
  places(points, input.points, &z);
  if (z.size() != count + input.points.size()) z.clear();
  places(holes, input.holes, nullptr);
  places(regions, input.regions, nullptr);
  input.segments = segments_from(segments, "segments");
}

void carry_heights(std::span<const double> z, std::span<const VertexId> input_to_vertex,
                   Mesh& out) {
  if (z.empty()) return;
  const Parts parts = out.parts();
  out.heights = carry_values(z, input_to_vertex, parts.points, parts.steiner).values;
}

void carry_heights(const TriangleMeshArgument& input, Mesh& out) {
  const std::span<const double> z = input.heights();
  if (z.empty() || !input.mesh().z.empty()) return;
  const Parts parts = out.parts();
  out.heights.assign(z.begin(), z.end());
  out.heights.resize(parts.points.size(), 0);
  interpolate(blends(parts.steiner, parts.points), out.heights);
}

void name_source_faces(std::span<const std::uint32_t> source_face,
                       std::span<TriangleId> triangles) {
  if (source_face.empty()) return;
  for (TriangleId& t : triangles) {
    if (t != kNone) t = source_face[t];
  }
}

void name_source_faces(std::span<const std::uint32_t> source_face,
                       std::span<std::array<TriangleId, 2>> pairs) {
  for (auto& pair : pairs) name_source_faces(source_face, std::span<TriangleId>(pair));
}

void name_source_faces(std::span<const std::uint32_t> source_face, TriangleResult& result) {
  name_source_faces(source_face, result.quad_source);
  name_source_faces(source_face, result.triangle_source);
  name_source_faces(source_face, result.barrier);
}

}  // namespace quadloom::python
