// The public door for triangulations and polygons: check the input, run the method.
#include <utility>

#include "quadloom/kernel.hpp"
#include "quadloom/quadrangulate.hpp"
#include "quadrangulate/triangulation_fans.hpp"
#include "quadrangulate/triangulation_input.hpp"
#include "quadrangulate/triangulation_pair.hpp"
#include "quadrangulate/triangulation_percolate.hpp"
#include "quadrangulate/triangulation_q_percolation.hpp"
#include "quadrangulate/triangulation_subdivide.hpp"

namespace quadloom {

using namespace quadrangulate;

TriangleResult quadrangulate_triangles(const TriangleMesh& input, const TriangleOptions& options) {
  report_progress(options.progress, "input", 0);
  check_triangle_mesh(input);
  switch (options.method) {
    case TriangleMethod::kPair:
      return pair_triangulation(input, options);
    case TriangleMethod::kPercolate:
      return percolate_triangulation(input, options);
    case TriangleMethod::kFans:
      return fan_triangulation(input, options);
    case TriangleMethod::kQPercolate:
    case TriangleMethod::kQuarter:
      return q_percolate_triangulation(input, options);
    case TriangleMethod::kSubdivide:
      return subdivide_triangulation(input, options);
  }
  throw Error(ErrorCode::kBadOption, "no such method");
}

PlanarResult quadrangulate_polygons(const PlanarInput& input, const TriangleOptions& options) {
  PlanarResult result;
  result.triangulation = constrained_delaunay(input, Extent::kInside, options.progress);
  TriangleMesh triangles{result.triangulation.mesh, {}, result.triangulation.part, {}, {}};
  for (const std::uint32_t edge : result.triangulation.edge)
    triangles.keep.push_back(edge != kNone);
  result.quads = quadrangulate_triangles(triangles, options);
  return result;
}

}  // namespace quadloom
