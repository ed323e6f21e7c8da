#include "quadrangulate/triangulation_input.hpp"

#include <string>

#include "quadloom/dual.hpp"

namespace quadloom::quadrangulate {
namespace {

void check_size(std::size_t size, std::size_t wanted, const char* what) {
  if (size == 0 || size == wanted) return;
  throw Error(ErrorCode::kBadMesh, std::string(what) + ": " + std::to_string(size) +
                                       " values for " + std::to_string(wanted));
}

void check_corners(const Triangulation& mesh) {
  for (HalfedgeId h = 0; h < mesh.tri_vertex.size(); ++h) {
    if (mesh.tri_vertex[h] < mesh.points.size()) continue;
    throw Error(ErrorCode::kIndexOutOfRange,
                "triangle " + std::to_string(triangle_of(h)) + " names vertex " +
                    std::to_string(mesh.tri_vertex[h]) + ", there are " +
                    std::to_string(mesh.points.size()),
                {triangle_of(h), mesh.tri_vertex[h]});
  }
}

void check_given_pairs(const TriangleMesh& input) {
  for (TriangleId t = 0; t < input.given_pair.size(); ++t) {
    const HalfedgeId h = input.given_pair[t];
    if (h == kNone) continue;
    const HalfedgeId twin = triangle_of(h) == t ? input.mesh.twin[h] : kNone;
    if (twin != kNone && input.given_pair[triangle_of(twin)] == twin) {
      if (input.region.empty() || input.region[t] == input.region[triangle_of(twin)]) continue;
      throw Error(ErrorCode::kBadMesh,
                  "the halves of a quad, triangles " + std::to_string(t) + " and " +
                      std::to_string(triangle_of(twin)) + ", are in two regions",
                  {t, triangle_of(twin)});
    }
    throw Error(ErrorCode::kBadMesh,
                "the quad of triangle " + std::to_string(t) + " has no other half", {t});
  }
}

}  // namespace

void check_triangle_mesh(const TriangleMesh& input) {
  const std::size_t triangles = input.mesh.triangle_count();
  if (triangles == 0) throw Error(ErrorCode::kTooFewPoints, "a mesh without triangles");
  check_corners(input.mesh);
  static_cast<void>(dual_graph(input.mesh));  // throws if the twins do not agree
  check_size(input.z.size(), input.mesh.points.size(), "z");
  check_size(input.region.size(), triangles, "regions");
  check_size(input.keep.size(), 3 * triangles, "edges to keep");
  check_size(input.given_pair.size(), triangles, "given quads");
  check_given_pairs(input);
}

}  // namespace quadloom::quadrangulate
