// Any triangulation, mixed mesh or surface into strictly convex quads by splitting its faces.
//
// De Berg's conversion (Bose and Toussaint 1995, section 2), see subdivision.cpp: 3 quads a triangle, 4
// a given quad. Edges to keep and borders of regions are split in two and no quad reaches over them.
//
// Steps:
//   1. quads_to_split     the given quads without those that an edge to keep or a border divides
//   2. Subdivision::run   with the boundary as in outline_places.hpp
//   3. count_parts
//
// What differs from the paper: any boundary, and meshes in space. Degenerate input: see subdivision.cpp.
// Cost: O(n), and O(b log b) for b boundary edges.
#include "quadrangulate/triangulation_subdivide.hpp"

#include <vector>

#include "quadrangulate/outline_places.hpp"
#include "quadrangulate/subdivision.hpp"

namespace quadloom::quadrangulate {
namespace {

/// Whether faces may not reach over h, which has a twin.
bool divides(const TriangleMesh& input, HalfedgeId h) {
  const HalfedgeId back = input.mesh.twin[h];
  if (!input.keep.empty() && (input.keep[h] != 0 || input.keep[back] != 0)) return true;
  return !input.region.empty() && input.region[triangle_of(h)] != input.region[triangle_of(back)];
}

std::vector<HalfedgeId> quads_to_split(const TriangleMesh& input) {
  std::vector<HalfedgeId> out = input.given_pair;
  for (HalfedgeId& h : out) {
    if (h != kNone && divides(input, h)) h = kNone;
  }
  return out;
}

std::size_t count_parts(const TriangleMesh& input) {
  std::size_t parts = 0;
  std::vector<char> seen(input.mesh.triangle_count(), 0);
  std::vector<TriangleId> ahead;
  for (TriangleId first = 0; first < seen.size(); ++first) {
    if (seen[first] != 0) continue;
    ++parts;
    seen[first] = 1;
    ahead.push_back(first);
    while (!ahead.empty()) {
      const TriangleId t = ahead.back();
      ahead.pop_back();
      for (HalfedgeId h = 3 * t; h < 3 * t + 3; ++h) {
        const HalfedgeId back = input.mesh.twin[h];
        if (back == kNone || seen[triangle_of(back)] != 0 || divides(input, h)) continue;
        seen[triangle_of(back)] = 1;
        ahead.push_back(triangle_of(back));
      }
    }
  }
  return parts;
}

}  // namespace

TriangleResult subdivide_triangulation(const TriangleMesh& input, const TriangleOptions& options) {
  check_subdivision_size(input.mesh.points.size(), input.mesh.triangle_count());
  const std::vector<HalfedgeId> quads = quads_to_split(input);
  Subdivision subdivision({.mesh = input.mesh, .z = input.z, .given_pair = quads},
                          options.progress);
  OutlinePlaces boundary(input.mesh);
  subdivision.run(boundary);

  TriangleResult out;
  out.input_vertices = input.mesh.points.size();
  subdivision.write_to(out.mesh, out.z, out.steiner);
  out.quad_source = subdivision.quad_sources();
  out.statistics.triangles = input.mesh.triangle_count();
  out.statistics.boundary_edges = boundary.size();
  out.statistics.parts = count_parts(input);
  report_progress(options.progress, "subdividing", 1);
  return out;
}

}  // namespace quadloom::quadrangulate
