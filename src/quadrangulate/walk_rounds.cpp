#include "quadrangulate/walk_rounds.hpp"

namespace quadloom::quadrangulate {

std::vector<TriangleId> free_triangles(const PairedMesh& mesh) {
  std::vector<TriangleId> free;
  for (TriangleId t = 0; t < mesh.mate.size(); ++t) {
    if (mesh.is_free(t)) free.push_back(t);
  }
  return free;
}

std::size_t walk_together(Walker& walker, const PairedMesh& mesh,
                          std::span<const WalkLimits> rounds, const Progress& progress) {
  double done = 0;
  std::vector<TriangleId> free = free_triangles(mesh);
  for (const WalkLimits& limits : rounds) {
    report_progress(progress, "walking", done++ / static_cast<double>(rounds.size()));
    if (free.size() <= 1) break;
    for (const TriangleId t : free) {
      if (mesh.is_free(t)) walker.merge(t, limits);
    }
    free = free_triangles(mesh);
  }
  return free.size();
}

}  // namespace quadloom::quadrangulate
