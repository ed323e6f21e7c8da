// Edges between triangles whose normals differ much: the features of a surface that people want to
// keep. Plain floating point, as good as the angle that was asked for.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "kernel/chart.hpp"
#include "quadloom/kernel.hpp"

namespace quadloom {
namespace {

using kernel::Places;
using kernel::Vector3;

/// The vector scaled to a largest component of 1, so that products stay in the range of doubles.
Vector3 tame(Vector3 v) {
  const double size = std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
  return size > 0 ? Vector3{v.x / size, v.y / size, v.z / size} : v;
}

/// b - a at a quarter of its size: no overflow.
Vector3 edge(const Places& places, VertexId a, VertexId b) {
  const Vector3 p = places.at(a), q = places.at(b);
  return tame({q.x / 4 - p.x / 4, q.y / 4 - p.y / 4, q.z / 4 - p.z / 4});
}

Vector3 normal(const Places& places, const Triangulation& mesh, TriangleId t) {
  const VertexId a = mesh.tri_vertex[3 * t], b = mesh.tri_vertex[3 * t + 1],
                 c = mesh.tri_vertex[3 * t + 2];
  return tame(kernel::cross(edge(places, a, b), edge(places, a, c)));
}

/// In degrees; 0 for a triangle that is flat in floating point.
double angle_between(Vector3 u, Vector3 v) {
  const Vector3 w = kernel::cross(u, v);
  return std::atan2(std::sqrt(kernel::dot(w, w)), kernel::dot(u, v)) * (180 / std::numbers::pi);
}

}  // namespace

std::size_t keep_sharp_edges(TriangleMesh& input, double degrees) {
  if (!(degrees >= 0 && degrees <= 180)) {
    throw Error(ErrorCode::kBadOption,
                "an angle of " + std::to_string(degrees) + " degrees is not between 0 and 180");
  }
  if (input.z.empty()) return 0;
  const Triangulation& mesh = input.mesh;
  const Places places{mesh.points, input.z};
  std::vector<Vector3> normals(mesh.triangle_count());
  for (TriangleId t = 0; t < normals.size(); ++t) normals[t] = normal(places, mesh, t);
  input.keep.resize(mesh.twin.size(), 0);
  std::size_t edges = 0;
  for (HalfedgeId h = 0; h < mesh.twin.size(); ++h) {
    const HalfedgeId twin = mesh.twin[h];
    if (twin == kNone || twin < h) continue;
    if (!input.given_pair.empty() && input.given_pair[triangle_of(h)] == h) continue;
    if (!(angle_between(normals[triangle_of(h)], normals[triangle_of(twin)]) > degrees)) continue;
    input.keep[h] = input.keep[twin] = 1;
    ++edges;
  }
  return edges;
}

}  // namespace quadloom
