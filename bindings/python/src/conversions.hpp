// What the conversions of points, triangles and polygons have in common: options, planar input, heights.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "choice.hpp"
#include "fields.hpp"
#include "inputs.hpp"
#include "parts.hpp"
#include "quadloom/convex.hpp"
#include "quadloom/quadrangulate.hpp"

namespace quadloom::python {

/// The quads of a planar input, and the triangulation that they were made from.
struct PlanarQuads : TriangleResult {
  std::shared_ptr<Made<ConstrainedResult>> source;
};

/// ConvexMeshResult, its mesh as the base.
struct ConvexQuads : TriangleResult {
  std::vector<QuadId> not_convex;
  MendStatistics mending;
};

/// TriangleOptions from the arguments; keeps the weights that they refer to.
struct TriangleOptionsArgument {
  TriangleOptionsArgument(const Choice<TriangleMethod>& method, const Choice<Leftover>& leftover,
                          const Choice<PairKind>& pairs, const Choice<PairWeight>& weight,
                          const Choice<MatchingEffort>& effort, double min_quality,
                          const NumbersLike& halfedge_weight,
                          const Choice<OddBoundary>& odd_boundary);
  TriangleOptionsArgument(const TriangleOptionsArgument&) = delete;
  TriangleOptionsArgument& operator=(const TriangleOptionsArgument&) = delete;

  std::vector<double> halfedge_weight;
  TriangleOptions options;
};

/// PlanarInput from the arguments, or a PlanarInput or PlanarFile as `polygons`; heights where all the
/// points have them.
struct PlanarArgument {
  PlanarArgument(const PolygonsLike& polygons, const PointsLike& points,
                 const NumbersLike& segments, const PointsLike& holes, const PointsLike& regions);

  PlanarInput input;
  std::vector<double> z;
};

/// Heights of input points become heights of the result's vertices.
void carry_heights(std::span<const double> z, std::span<const VertexId> input_to_vertex, Mesh& out);
template <typename Result>
void carry_heights(const Points& input, Made<Result>& out) {
  carry_heights(input.z(), out.input_to_vertex, out);
}
/// The same for a planar mesh with heights as data.
void carry_heights(const TriangleMeshArgument& input, Mesh& out);

/// Source triangles become the faces that they were cut from; without these, nothing changes.
void name_source_faces(std::span<const std::uint32_t> source_face, std::span<TriangleId> triangles);
void name_source_faces(std::span<const std::uint32_t> source_face,
                       std::span<std::array<TriangleId, 2>> pairs);
void name_source_faces(std::span<const std::uint32_t> source_face, TriangleResult& result);

/// What the results of all conversions of triangles have.
template <typename Result>
Fields<Result, Mesh> bind_triangle_fields(nanobind::module_& m, const char* name, const char* doc) {
  Fields<Result, Mesh> fields(m, name, doc);
  fields
      .array("source_triangles", &TriangleResult::quad_source,
             "Per quad, uint32 (m, 2): the source triangles that it is made of: both, or one and "
             "NONE. Where walks re-cut pentagons each source triangle goes to the face that took "
             "most of "
             "its sides over.")
      .array("triangle_source", &TriangleResult::triangle_source,
             "Per left-over triangle: its source triangle.")
      .array("barrier", &TriangleResult::barrier,
             "Why no more pairs are possible, see MaximumMatching; empty if none is missing.")
      .value("statistics", &TriangleResult::statistics, "What the conversion did.");
  return fields;
}

}  // namespace quadloom::python
