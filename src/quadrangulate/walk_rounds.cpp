#include "quadrangulate/walk_rounds.hpp"

namespace quadloom::quadrangulate {

std::vector<TriangleId> free_triangles(const PairedMesh& mesh) {
  std::vector<TriangleId> free;
  for (TriangleId t = 0; t < mesh.mate.size(); ++t) {
    if (mesh.is_free(t)) free.push_back(t);
  }
  return free;
}

namespace {

constexpr std::size_t kNear = 1000;       // nodes; within them are nearly all strictly convex walks
constexpr std::size_t kAfterSlide = 200;  // and here most that a slide has opened
constexpr std::size_t kDeepNodes = 400'000;  // of thorough searches, all together

/// Sets of rows lock many triangles; small ones get all the search that helps.
constexpr WalkLimits kDeepRounds[] = {
    {WalkQuads::kStrictlyConvex, 4'000, 2},
    {WalkQuads::kAny, 1'000},
    {WalkQuads::kAny, 100'000},
};

template <typename Merge>
void sweep(const PairedMesh& mesh, Merge merge) {
  for (const TriangleId t : free_triangles(mesh)) {
    if (mesh.is_free(t)) merge(t);
  }
}

void walk_deeply(Walker& walker, const PairedMesh& mesh) {
  std::size_t nodes = 0;
  for (const WalkLimits& limits : kDeepRounds) {
    sweep(mesh, [&](TriangleId t) {
      if (nodes >= kDeepNodes) return;
      walker.merge(t, limits);
      nodes += walker.nodes();
    });
  }
}

}  // namespace

// Steps: walks over one quad, the best-shaped ones; walks that leave strictly convex quads, with the mesh
// as it is or with a diagonal slid; thorough searches, as long as they cost next to nothing; walks that
// leave any quads.
void walk_quickly(QuickWalker& quick, Walker& walker, const PairedMesh& mesh,
                  const Progress& progress) {
  report_progress(progress, "walking", 0);
  sweep(mesh, [&](TriangleId t) { quick.merge_over_quad(t); });
  report_progress(progress, "walking", 0.2);
  sweep(mesh, [&](TriangleId t) {
    if (quick.merge(t, WalkQuads::kStrictlyConvex, kNear)) return;
    if (quick.locked()) quick.merge_after_slide(t, kAfterSlide);
  });
  report_progress(progress, "walking", 0.8);
  walk_deeply(walker, mesh);
  sweep(mesh, [&](TriangleId t) { quick.merge(t, WalkQuads::kAny, kNear); });
  const std::vector<TriangleId> far = free_triangles(mesh);
  for (const TriangleId t : far) {
    if (mesh.is_free(t)) quick.merge_far(t, far);
  }
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
