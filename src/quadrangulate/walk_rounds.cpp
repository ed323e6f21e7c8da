#include "quadrangulate/walk_rounds.hpp"

#include <algorithm>

#include "core/parallel.hpp"
#include "core/step_reports.hpp"

namespace quadloom::quadrangulate {
namespace {

template <class Mesh>
std::vector<std::uint32_t> list_free(const Mesh& mesh, const FaceRange& range = {}) {
  std::vector<std::uint32_t> free;
  const auto end = range.begin + static_cast<std::uint32_t>(range.size(mesh.face_count()));
  for (std::uint32_t t = range.begin; t < end; ++t) {
    if (mesh.is_free(t)) free.push_back(t);
  }
  return free;
}

constexpr std::size_t kNear = 1000;       // nodes; within them are nearly all strictly convex walks
constexpr std::size_t kAfterSlide = 200;  // and here most that a slide has opened
constexpr std::size_t kRangesATime = 64;  // some tenths of a second's work
constexpr std::size_t kRangesToRest = 9;  // times the work in the ranges is that at their borders
constexpr std::size_t kDeepNodes = 400'000;  // of thorough searches, all together

/// Sets of rows lock many triangles; small ones get all the search that helps.
constexpr WalkLimits kDeepRounds[] = {
    {WalkQuads::kStrictlyConvex, 4'000, 2},
    {WalkQuads::kAny, 1'000},
    {WalkQuads::kAny, 100'000},
};

void add(const QuickWalker<QuadMesh>& quick, WalkCounts& counts) {
  counts.walks += quick.walks();
  counts.steps += quick.steps();
}

/// Returns those that are left over and would have looked beyond the border of the walker's range.
template <typename Report>
std::vector<FaceId> walk_convexly(QuickWalker<QuadMesh>& quick, const QuadMesh& mesh,
                                  std::span<const FaceId> free, Report report) {
  for (const FaceId t : free) {
    report();
    if (mesh.is_free(t)) quick.merge_over_quad(t);
  }
  std::vector<FaceId> left;
  for (const FaceId t : free) {
    report();
    if (!mesh.is_free(t)) continue;
    quick.take_met_border();
    if (quick.merge(t, WalkQuads::kStrictlyConvex, kNear)) continue;
    if (quick.locked() && quick.merge_after_slide(t, kAfterSlide)) continue;
    if (quick.take_met_border()) left.push_back(t);
  }
  return left;
}

/// Walks within the ranges, on several threads, some ranges between two reports. Returns who waits for walks anywhere.
std::vector<FaceId> walk_in_ranges(QuadMesh& mesh, std::span<const FaceRange> ranges,
                                   WalkCounts& counts, const Progress& progress) {
  constexpr double kShare = kRangesToRest / (kRangesToRest + 1.0);
  std::vector<std::vector<FaceId>> left(ranges.size());
  std::vector<WalkCounts> counts_of(ranges.size());
  for (std::size_t begin = 0; begin < ranges.size(); begin += kRangesATime) {
    report_progress(progress, "walking",
                    kShare * static_cast<double>(begin) / static_cast<double>(ranges.size()));
    parallel_tasks(std::min(kRangesATime, ranges.size() - begin), [&](std::size_t i) {
      QuickWalker quick(mesh, ranges[begin + i]);
      left[begin + i] = walk_convexly(quick, mesh, list_free(mesh, ranges[begin + i]), [] {});
      add(quick, counts_of[begin + i]);
    });
  }
  std::vector<FaceId> waiting;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    waiting.insert(waiting.end(), left[i].begin(), left[i].end());
    counts.walks += counts_of[i].walks;
    counts.steps += counts_of[i].steps;
  }
  return waiting;
}

}  // namespace

std::vector<TriangleId> free_triangles(const PairedMesh& mesh) { return list_free(mesh); }
std::vector<FaceId> free_triangles(const QuadMesh& mesh) { return list_free(mesh); }

WalkCounts walk_convexly(QuadMesh& mesh, const Progress& progress) {
  WalkCounts counts;
  const std::vector<FaceRange> ranges = face_ranges(mesh.face_count());
  const bool small = ranges.empty();
  const std::vector<FaceId> waiting =
      small ? list_free(mesh) : walk_in_ranges(mesh, ranges, counts, progress);
  const std::size_t steps = 2 * waiting.size(), before = small ? 0 : kRangesToRest * steps;
  QuickWalker quick(mesh);
  walk_convexly(quick, mesh, waiting,
                StepReports(progress, "walking", before + steps, StepReports::kEvery, before));
  add(quick, counts);
  return counts;
}

void walk_deeply(Walker& walker, const PairedMesh& mesh) {
  std::size_t nodes = 0;
  for (const WalkLimits& limits : kDeepRounds) {
    for (const TriangleId t : list_free(mesh)) {
      if (nodes >= kDeepNodes) return;
      if (!mesh.is_free(t)) continue;
      walker.merge(t, limits);
      nodes += walker.nodes();
    }
  }
}

WalkCounts walk_anyhow(QuadMesh& mesh) {
  QuickWalker quick(mesh);
  for (const std::size_t nodes : {kNear, std::size_t{kNone}}) {
    quick.merge_far(free_triangles(mesh), nodes);
  }
  WalkCounts counts;
  add(quick, counts);
  return counts;
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
