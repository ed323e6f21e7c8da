#include "quadrangulate/mesh_parts.hpp"

#include <algorithm>

namespace quadloom::quadrangulate {

bool must_stay(const TriangleMesh& input, HalfedgeId h) {
  const HalfedgeId twin = input.mesh.twin[h];
  if (twin == kNone) return true;
  const TriangleId t = triangle_of(h);
  if (!input.given_pair.empty() && input.given_pair[t] == h) return false;
  if (!input.keep.empty() && (input.keep[h] != 0 || input.keep[twin] != 0)) return true;
  return !input.region.empty() && input.region[t] != input.region[triangle_of(twin)];
}

Triangulation cut_along_kept_edges(const TriangleMesh& input) {
  Triangulation cut = input.mesh;
  if (input.keep.empty() && input.region.empty()) return cut;
  for (HalfedgeId h = 0; h < cut.twin.size(); ++h) {
    if (must_stay(input, h)) cut.twin[h] = kNone;
  }
  return cut;
}

std::size_t MeshParts::odd_count() const {
  return static_cast<std::size_t>(std::count_if(triangles.begin(), triangles.end(),
                                                [](std::uint32_t n) { return n % 2 == 1; }));
}

MeshParts parts_of(const Triangulation& mesh) {
  MeshParts out;
  out.part.assign(mesh.triangle_count(), kNone);
  std::vector<TriangleId> todo;
  for (TriangleId first = 0; first < out.part.size(); ++first) {
    if (out.part[first] != kNone) continue;
    const auto p = static_cast<std::uint32_t>(out.triangles.size());
    out.triangles.push_back(0);
    out.part[first] = p;
    todo.push_back(first);
    while (!todo.empty()) {
      const TriangleId t = todo.back();
      todo.pop_back();
      ++out.triangles[p];
      for (HalfedgeId h = 3 * t; h < 3 * t + 3; ++h) {
        if (mesh.twin[h] == kNone || out.part[triangle_of(mesh.twin[h])] != kNone) continue;
        out.part[triangle_of(mesh.twin[h])] = p;
        todo.push_back(triangle_of(mesh.twin[h]));
      }
    }
  }
  return out;
}

std::size_t border_size(const Triangulation& mesh) {
  return static_cast<std::size_t>(std::count(mesh.twin.begin(), mesh.twin.end(), kNone));
}

}  // namespace quadloom::quadrangulate
