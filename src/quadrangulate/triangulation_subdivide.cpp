// Any triangulation, mixed mesh or surface into strictly convex quads by splitting its faces.
//
// De Berg's conversion (Bose and Toussaint 1995, section 2), see subdivision.cpp: 3 quads a triangle, 4
// a given quad. Edges to keep and borders of regions are split in two and no quad reaches over them.
//
// Step: Subdivision::run with the boundary as in outline_places.hpp.
//
// What differs from the paper: any boundary, and meshes in space. Degenerate input: see subdivision.cpp.
// Cost: O(n), and O(b log b) for b boundary edges.
#include "quadrangulate/triangulation_subdivide.hpp"

#include "quadrangulate/mesh_parts.hpp"
#include "quadrangulate/outline_places.hpp"
#include "quadrangulate/subdivision.hpp"

namespace quadloom::quadrangulate {
TriangleResult subdivide_triangulation(const TriangleMesh& input, const TriangleOptions& options) {
  check_subdivision_size(input.mesh.points.size(), input.mesh.triangle_count());
  Subdivision subdivision({.mesh = input.mesh, .z = input.z, .given_pair = input.given_pair},
                          options.progress);
  OutlinePlaces boundary(input.mesh);
  subdivision.run(boundary);

  TriangleResult out;
  out.input_vertices = input.mesh.points.size();
  subdivision.write_to(out.mesh, out.z, out.steiner);
  out.quad_source = subdivision.quad_sources();
  out.statistics.triangles = input.mesh.triangle_count();
  out.statistics.boundary_edges = boundary.size();
  out.statistics.parts = parts_of(cut_along_kept_edges(input)).count();
  report_progress(options.progress, "subdividing", 1);
  return out;
}

}  // namespace quadloom::quadrangulate
