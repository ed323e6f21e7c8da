// Strictly convex quads with almost no added points.
//
// Steps:
//   1. find_bad      the quads that are not strictly convex
//   2. wander        a random cluster around each (2 to 8 quads) is parted as well as its corners allow,
//                    with random preferences among partings with as few bad quads: so bad quads wander
//                    until they meet, or come to a place where there is a way out
//   3. walk          bad quads are taken apart, and their triangles walk to each other through strictly
//                    convex quads alone (mend_walk.hpp); those that do not meet become bad quads again.
//                    Steps 2 to 4 take turns: wandering opens ways that were locked.
//   4. recut_bad     clusters that may close around vertices are cut anew by search (recut.hpp)
//   5. add_stars     for each that is left the best of many clusters with one added point
//   6. add_cases     for what is left after that the union with a neighbour, as in the paper's cases: at most
//                    three points (Bremner, Hurtado, Ramaswami and Sacristan, theorem 3.8); see
//                    mend_points.cpp
//   7. settle        added points wander and meet: clusters around them are cut anew with fewer (settle.cpp)
//   8. improve       shapes suffer from the wandering: diagonal slides (not on given meshes), clusters
//                    around poor quads parted better, and the added points moved, all without a quad that is
//                    not strictly convex
//
// The work of steps 2 to 4 is limited by the size of the mesh; on small meshes they run long. After find_bad
// all costs what there is to mend, not what the mesh has.
// Degenerate input: flat corners count as bad, decided exactly; rows of collinear points lock many quads. A
// quad for which no double is found stays and is counted.
#include "convex/mend.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "convex/best_parting.hpp"
#include "convex/mend_points.hpp"
#include "convex/mend_walk.hpp"
#include "convex/mending.hpp"
#include "convex/polish.hpp"
#include "convex/price.hpp"
#include "convex/recutter.hpp"
#include "convex/settle.hpp"
#include "core/parallel.hpp"
#include "core/random.hpp"
#include "kernel/predicates_inline.hpp"
#include "quadrangulate/diagonal_slides.hpp"

namespace quadloom::convex {

using quadrangulate::classify_quad;
using quadrangulate::PairedMesh;
using quadrangulate::QuadKind;

namespace {

constexpr int kMostCycles = 200;  // of wandering and walks
constexpr int kLeastCycles = 3;
constexpr std::size_t kCycleTriangles = 3'000'000;  // triangles times cycles, between the two
constexpr std::size_t kCycleBad = 100'000;          // and bad quads times cycles, at most
constexpr std::size_t kMostTries = 2;
constexpr std::size_t kTiny = 100;                 // triangles; there one try sees it all
constexpr std::size_t kTriesTriangles = 16'000;    // triangles times tries, if there are several
constexpr int kPatience = 15;                      // cycles without a bad quad less, at most
constexpr std::size_t kTrianglesPerCycle = 25;     // small meshes have seen it all sooner
constexpr int kRounds = 10, kRoundsIfThrifty = 5;  // of wandering in a cycle
constexpr int kStarRounds = 6;
constexpr std::size_t kLargest = 8;         // quads of a cluster
constexpr std::size_t kRecuts = 500;        // clusters in a cycle, about 20 us each
constexpr std::size_t kMostRecuts = 8'000;  // and in all
constexpr std::size_t kLeastRecutTries = 2;
constexpr std::size_t kMostRecutTries = 500;
constexpr std::size_t kMostRecutQuads = 16;
constexpr std::size_t kLeastWork = 300'000;  // clusters looked at, or a quarter of the triangles

class Mender {
 public:
  Mender(PairedMesh& mesh, std::uint64_t seed, std::vector<SteinerPoint>& steiner,
         const Progress& progress, Improve improve)
      : mesh_(mesh),
        state_(mesh, seed, steiner),
        walker_(mesh, [this](std::span<const TriangleId> changed) { state_.touch(changed); }),
        steiner_(steiner),
        progress_(progress),
        improve_(improve) {}

  MendStatistics run() {
    find_bad();
    statistics_.bad = state_.bad.size();
    if (state_.bad.empty()) return statistics_;
    move();
    statistics_.bad_after_moves = state_.bad.size();
    slide();
    state_.adopt_inner_points();
    report_progress(progress_, "stars", 0);
    for (int round = 0; round < kStarRounds && !state_.bad.empty(); ++round)
      add_stars(state_, statistics_);
    add_cases(state_, statistics_);
    settle(state_, statistics_);
    state_.compact();
    statistics_.left = state_.bad.size();
    improve();
    return statistics_;
  }

 private:
  enum class Wish : std::uint8_t { kBestShape, kRandom };

  void find_bad();
  void find_bad(std::span<const TriangleId> changed);
  bool grow(TriangleId t, std::size_t quads);
  void move();
  void wander(Wish wish);
  void walk();
  void recut_bad();
  void slide();
  void improve();

  PairedMesh& mesh_;
  Mending state_;
  MendWalker walker_;
  std::vector<SteinerPoint>& steiner_;
  const Progress& progress_;
  const Improve improve_;
  std::size_t work_ = 0;
  std::size_t recuts_ = 0;
  MendStatistics statistics_;
};

void Mender::find_bad() {
  state_.bad = parallel_find(mesh_.mate.size(), [&](TriangleId t) {
    return !mesh_.is_free(t) && state_.name_of_quad(t) == t && state_.is_bad(t);
  });
}

/// The same if only the quads of these triangles may be bad, or those that have been.
void Mender::find_bad(std::span<const TriangleId> changed) {
  std::vector<TriangleId> next;
  state_.note_bad(state_.bad, next);
  for (const TriangleId t : changed) {
    if (!mesh_.is_free(t) && state_.is_bad(t)) next.push_back(state_.name_of_quad(t));
  }
  std::sort(next.begin(), next.end());
  next.erase(std::unique(next.begin(), next.end()), next.end());
  state_.bad = std::move(next);
}

bool Mender::grow(TriangleId t, std::size_t quads) {
  ++work_;
  state_.grower.start(t);
  while (state_.grower.cluster().quad_count() < quads) {
    if (!state_.grower.grow(state_.random)) return state_.grower.cluster().quad_count() > 1;
  }
  return true;
}

void Mender::move() {
  const std::size_t most_work = std::max(kLeastWork, mesh_.mate.size() / 4);
  const int cycles = std::min(
      std::clamp(static_cast<int>(kCycleTriangles / mesh_.mate.size()), kLeastCycles, kMostCycles),
      static_cast<int>(1 + kCycleBad / state_.bad.size()));
  const int patience =
      std::clamp(static_cast<int>(mesh_.mate.size() / kTrianglesPerCycle), 4, kPatience);
  const int rounds = state_.is_thrifty() ? kRoundsIfThrifty : kRounds;
  std::size_t fewest = state_.bad.size();
  int since = 0;
  for (int cycle = 0;
       cycle < cycles && !state_.bad.empty() && work_ < most_work && since < patience;
       ++cycle, ++since) {
    report_progress(progress_, "mending", static_cast<double>(cycle) / cycles);
    for (int round = 0; round < rounds && !state_.bad.empty(); ++round) {
      wander(cycle == 0 && round == 0 ? Wish::kBestShape : Wish::kRandom);
    }
    walk();
    recut_bad();
    if (state_.bad.size() < fewest) since = 0;
    fewest = std::min(fewest, state_.bad.size());
  }
}

void Mender::wander(Wish wish) {
  std::vector<TriangleId> next;
  for (const TriangleId t : state_.bad) {
    if (!state_.is_bad(t)) continue;
    if (!grow(t, 2 + state_.random.below(kLargest - 1))) {
      next.push_back(t);
      continue;
    }
    const std::size_t before = state_.bad_in(state_.grower.cluster());
    const auto price_of = [&](double squareness) {
      return wish == Wish::kRandom ? 1 - squareness + state_.random.uniform() : price(squareness);
    };
    const auto parting =
        best_parting(state_.points_of(state_.grower.cluster().corner),
                     kBadQuad * static_cast<double>(before + 1), Stars::kNone, price_of);
    if (parting && (wish == Wish::kRandom || parting->bad_quads() < before)) {
      state_.part(state_.grower.cluster(), parting->quads, {}, {});
      ++statistics_.clusters;
    }
    state_.note_bad(state_.grower.cluster().slot, next);
  }
  std::sort(next.begin(), next.end());
  next.erase(std::unique(next.begin(), next.end()), next.end());
  state_.bad = std::move(next);
}

/// Clusters may close around vertices here, which gives them other partings.
void Mender::recut_bad() {
  const std::size_t most = std::min(kMostRecuts, state_.tries_at_most());
  if (state_.bad.empty() || recuts_ >= most) return;
  const std::size_t tries =
      std::clamp(kRecuts / state_.bad.size(), kLeastRecutTries, kMostRecutTries);
  std::vector<TriangleId> next;
  Recutter recutter(state_);
  for (const TriangleId t : state_.bad) {
    for (std::size_t i = 0; i < tries && state_.is_bad(t); ++i, ++recuts_) {
      recutter.grow(t, 2 + state_.random.below(kMostRecutQuads - 2), Recutter::Size::kLarge);
      if (recutter.look()) recutter.cut(recutter.points(), RecutOrder::kShape);
    }
    state_.note_bad({&t, 1}, next);
  }
  state_.bad = std::move(next);
}

void Mender::walk() {
  std::vector<TriangleId> apart;
  state_.note_bad(state_.bad, apart);
  const std::size_t crossings = walker_.points().size();
  find_bad(walker_.walk(apart));
  steiner_.insert(steiner_.end(), walker_.points().begin() + static_cast<std::ptrdiff_t>(crossings),
                  walker_.points().end());
  if (walker_.crossed()) find_bad();
}

void Mender::slide() {
  if (improve_ == Improve::kTouched) return;
  quadrangulate::slide_diagonals_at(mesh_, state_.touched);
  find_bad(state_.touched);  // a slide renames quads
}

void Mender::improve() {
  report_progress(progress_, "polishing", 0);
  slide();
  polish_quads(mesh_, std::move(state_.touched), state_.random);
  smooth_points(mesh_, steiner_);
}

}  // namespace

MendStatistics mend_quads(PairedMesh& mesh, std::uint64_t seed, std::vector<SteinerPoint>& steiner,
                          const Progress& progress, Improve improve) {
  const std::size_t tries =
      mesh.mate.size() < kTiny
          ? 1
          : std::clamp<std::size_t>(kTriesTriangles / mesh.mate.size(), 1, kMostTries);
  if (tries == 1) return Mender(mesh, seed, steiner, progress, improve).run();

  // Small meshes are mended several times; the fewest bad quads and then points win.
  const PairedMesh given = mesh;
  const std::vector<SteinerPoint> given_points = steiner;
  MendStatistics best;
  for (std::size_t i = 0; i < tries; ++i) {
    PairedMesh tried = given;
    std::vector<SteinerPoint> points = given_points;
    const MendStatistics now = Mender(tried, seed + i, points, progress, improve).run();
    if (i == 0 || std::pair(now.left, points.size()) < std::pair(best.left, steiner.size())) {
      best = now;
      mesh = std::move(tried);
      steiner = std::move(points);
    }
    if (best.left == 0 && steiner.size() == given_points.size()) break;
  }
  return best;
}

}  // namespace quadloom::convex
