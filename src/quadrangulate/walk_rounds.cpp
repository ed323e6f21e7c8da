#include "quadrangulate/walk_rounds.hpp"

#include "core/step_reports.hpp"

namespace quadloom::quadrangulate {
namespace {

template <class Mesh>
std::vector<std::uint32_t> list_free(const Mesh& mesh) {
  std::vector<std::uint32_t> free;
  for (std::uint32_t t = 0; t < mesh.face_count(); ++t) {
    if (mesh.is_free(t)) free.push_back(t);
  }
  return free;
}

constexpr std::size_t kNear = 1000;       // nodes; within them are nearly all strictly convex walks
constexpr std::size_t kAfterSlide = 200;  // and here most that a slide has opened
constexpr std::size_t kDeepNodes = 400'000;  // of thorough searches, all together

/// Sets of rows lock many triangles; small ones get all the search that helps.
constexpr WalkLimits kDeepRounds[] = {
    {WalkQuads::kStrictlyConvex, 4'000, 2},
    {WalkQuads::kAny, 1'000},
    {WalkQuads::kAny, 100'000},
};

template <class Mesh, typename Merge>
void sweep(const Mesh& mesh, Merge merge) {
  for (const std::uint32_t t : list_free(mesh)) {
    if (mesh.is_free(t)) merge(t);
  }
}

}  // namespace

std::vector<TriangleId> free_triangles(const PairedMesh& mesh) { return list_free(mesh); }
std::vector<FaceId> free_triangles(const QuadMesh& mesh) { return list_free(mesh); }

void walk_convexly(QuickWalker<QuadMesh>& quick, const QuadMesh& mesh, const Progress& progress) {
  StepReports report(progress, "walking", 2 * list_free(mesh).size());
  sweep(mesh, [&](FaceId t) {
    report();
    quick.merge_over_quad(t);
  });
  sweep(mesh, [&](FaceId t) {
    report();
    if (quick.merge(t, WalkQuads::kStrictlyConvex, kNear)) return;
    if (quick.locked()) quick.merge_after_slide(t, kAfterSlide);
  });
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

void walk_anyhow(QuickWalker<QuadMesh>& quick, const QuadMesh& mesh) {
  for (const std::size_t nodes : {kNear, std::size_t{kNone}}) {
    quick.merge_far(free_triangles(mesh), nodes);
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
