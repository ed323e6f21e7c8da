// Strictly convex quads with almost no added points.
//
// Steps:
//   1. find_bad      the quads that are not strictly convex
//   2. wander        a random cluster around each (2 to 8 quads) is parted as well as its corners allow,
//                    with random preferences among partings with as few bad quads: so bad quads wander
//                    until they meet, or come to a place where there is a way out
//   3. walk          bad quads are taken apart, and their triangles walk to each other through strictly
//                    convex quads alone (mend_walk.hpp); those that do not meet become bad quads again. Steps 2
//                    and 3 take turns: wandering opens ways that were locked.
//   4. add_stars     for each that is left the best of many clusters with one added point
//   5. add_cases     for what is left after that the union with a neighbour, as in the paper's cases: at most
//                    three points (Bremner, Hurtado, Ramaswami and Sacristan, theorem 3.8)
//   6. improve       shapes suffer from the wandering: diagonal slides (not on given meshes), clusters
//                    around poor quads parted better, and the added points moved, all without a quad that is
//                    not strictly convex
//
// The work of steps 2 and 3 is limited by the size of the mesh; on small meshes they run long. After find_bad
// all costs what there is to mend, not what the mesh has.
// Degenerate input: flat corners count as bad, decided exactly; rows of collinear points lock many quads. A
// quad for which no double is found stays and is counted.
#include "convex/mend.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "convex/best_parting.hpp"
#include "convex/hexagon.hpp"
#include "convex/mend_walk.hpp"
#include "convex/polish.hpp"
#include "convex/price.hpp"
#include "convex/quad.hpp"
#include "core/random.hpp"
#include "kernel/predicates_inline.hpp"
#include "quadrangulate/diagonal_slides.hpp"

namespace quadloom::convex {

using quadrangulate::classify_quad;
using quadrangulate::PairedMesh;
using quadrangulate::quad_behind;
using quadrangulate::QuadBehind;
using quadrangulate::QuadKind;

namespace {

constexpr int kMostCycles = 200;  // of wandering and walks
constexpr int kLeastCycles = 6;
constexpr std::size_t kCycleTriangles = 12'000'000;  // triangles times cycles, between the two
constexpr std::size_t kMostTries = 4;
constexpr std::size_t kTiny = 100;               // triangles; there one try sees it all
constexpr std::size_t kTriesTriangles = 16'000;  // triangles times tries, if there are several
constexpr double kUsualPrice = 0.8;              // of a quad
constexpr int kPatience = 40;                    // cycles without a bad quad less, at most
constexpr std::size_t kTrianglesPerCycle = 25;   // small meshes have seen it all sooner
constexpr int kRounds = 20;                      // of wandering in a cycle
constexpr std::size_t kLargest = 8;              // quads of a cluster
constexpr std::size_t kLargestStar = 5;
constexpr int kStarTries = 60;               // clusters looked at for each star
constexpr std::size_t kLeastWork = 300'000;  // clusters looked at, or a quarter of the triangles

class Mender {
 public:
  Mender(PairedMesh& mesh, std::uint64_t seed, std::vector<SteinerPoint>& steiner,
         const Progress& progress, Improve improve)
      : mesh_(mesh),
        random_(seed),
        grower_(mesh),
        walker_(mesh, [this](std::span<const TriangleId> changed) { touch(changed); }),
        steiner_(steiner),
        progress_(progress),
        improve_(improve) {}

  MendStatistics run() {
    find_bad();
    statistics_.bad = bad_.size();
    if (bad_.empty()) return statistics_;
    move();
    statistics_.bad_after_moves = bad_.size();
    slide();
    report_progress(progress_, "stars", 0);
    for (int round = 0; round < 6 && !bad_.empty(); ++round) add_stars();
    add_cases();
    statistics_.left = bad_.size();
    improve();
    return statistics_;
  }

 private:
  enum class Wish : std::uint8_t { kBestShape, kRandom };

  TriangleId name_of_quad(TriangleId t) const {
    return std::min(t, triangle_of(mesh_.tri.twin[mesh_.mate[t]]));
  }
  bool is_bad(TriangleId t) const;
  void find_bad();
  void find_bad(std::span<const TriangleId> changed);
  void note_bad(std::span<const TriangleId> triangles, std::vector<TriangleId>& list) const;
  bool grow(TriangleId t, std::size_t quads);
  std::vector<Point> polygon() const;
  std::size_t bad_in_cluster() const;
  void touch(std::span<const TriangleId> triangles) {
    touched_.insert(touched_.end(), triangles.begin(), triangles.end());
  }
  void move();
  void wander(Wish wish);
  void walk();
  void add_stars();
  void add_cases();
  void slide();
  void improve();
  bool add_case(TriangleId t);
  std::array<VertexId, 3> parents_of(Point s, std::span<const VertexId> corner) const;
  VertexId add_inner(Point place, std::span<const VertexId> corner);

  PairedMesh& mesh_;
  Random random_;
  ClusterGrower grower_;
  MendWalker walker_;
  std::vector<SteinerPoint>& steiner_;
  const Progress& progress_;
  const Improve improve_;
  std::vector<TriangleId> bad_;  // by name_of_quad; some may have become good since
  std::vector<TriangleId> touched_;
  std::size_t work_ = 0;
  MendStatistics statistics_;
};

bool Mender::is_bad(TriangleId t) const {
  const HalfedgeId h = mesh_.mate[t];
  if (h == kNone) return false;
  const auto& tri = mesh_.tri;
  return classify_quad(mesh_.point(tri.origin(h)), mesh_.point(tri.apex(tri.twin[h])),
                       mesh_.point(tri.target(h)),
                       mesh_.point(tri.apex(h))) != QuadKind::kStrictlyConvex;
}

void Mender::find_bad() {
  bad_.clear();
  for (TriangleId t = 0; t < mesh_.mate.size(); ++t) {
    if (!mesh_.is_free(t) && name_of_quad(t) == t && is_bad(t)) bad_.push_back(t);
  }
}

/// The same if only the quads of these triangles may be bad, or those that have been.
void Mender::find_bad(std::span<const TriangleId> changed) {
  std::vector<TriangleId> next;
  note_bad(bad_, next);
  for (const TriangleId t : changed) {
    if (!mesh_.is_free(t) && is_bad(t)) next.push_back(name_of_quad(t));
  }
  std::sort(next.begin(), next.end());
  next.erase(std::unique(next.begin(), next.end()), next.end());
  bad_ = std::move(next);
}

void Mender::note_bad(std::span<const TriangleId> triangles, std::vector<TriangleId>& list) const {
  for (const TriangleId t : triangles) {
    if (!mesh_.is_free(t) && name_of_quad(t) == t && is_bad(t)) list.push_back(t);
  }
}

bool Mender::grow(TriangleId t, std::size_t quads) {
  ++work_;
  grower_.start(t);
  while (grower_.cluster().quad_count() < quads) {
    if (!grower_.grow(random_)) return grower_.cluster().quad_count() > 1;
  }
  return true;
}

std::vector<Point> Mender::polygon() const {
  std::vector<Point> out;
  for (const VertexId v : grower_.cluster().corner) out.push_back(mesh_.point(v));
  return out;
}

std::size_t Mender::bad_in_cluster() const {
  std::vector<TriangleId> bad;
  note_bad(grower_.cluster().slot, bad);
  return bad.size();
}

/// Three of the corners that the point is between, far apart.
std::array<VertexId, 3> Mender::parents_of(Point s, std::span<const VertexId> corner) const {
  std::array<VertexId, 3> best = {corner[0], corner[1], corner[2]};
  double largest = -1;
  const auto consider = [&](VertexId a, VertexId b, VertexId c) {
    const Point p = mesh_.point(a), q = mesh_.point(b), r = mesh_.point(c);
    if (kernel::orient(p, q, s) < 0 || kernel::orient(q, r, s) < 0 || kernel::orient(r, p, s) < 0) {
      return;
    }
    const double area = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
    if (area <= largest || kernel::orient(p, q, r) <= 0) return;
    largest = area;
    best = {a, b, c};
  };
  for (std::size_t k = 2; k < corner.size(); ++k) {
    for (std::size_t j = 1; j < k; ++j) {
      for (std::size_t i = 0; i < j; ++i) {
        consider(corner[i], corner[j], corner[k]);
        consider(corner[i], corner[k], corner[j]);
      }
    }
  }
  return best;
}

VertexId Mender::add_inner(Point place, std::span<const VertexId> corner) {
  const VertexId s = quadrangulate::add_vertex(mesh_, {place.x, place.y});
  steiner_.push_back({s, SteinerKind::kInner, parents_of(place, corner)});
  return s;
}

void Mender::move() {
  const std::size_t most_work = std::max(kLeastWork, mesh_.mate.size() / 4);
  const int cycles =
      std::clamp(static_cast<int>(kCycleTriangles / mesh_.mate.size()), kLeastCycles, kMostCycles);
  const int patience =
      std::clamp(static_cast<int>(mesh_.mate.size() / kTrianglesPerCycle), 4, kPatience);
  std::size_t fewest = bad_.size();
  int since = 0;
  for (int cycle = 0; cycle < cycles && !bad_.empty() && work_ < most_work && since < patience;
       ++cycle, ++since) {
    report_progress(progress_, "mending", static_cast<double>(cycle) / cycles);
    for (int round = 0; round < kRounds && !bad_.empty(); ++round) {
      wander(cycle == 0 && round == 0 ? Wish::kBestShape : Wish::kRandom);
    }
    walk();
    if (bad_.size() < fewest) since = 0;
    fewest = std::min(fewest, bad_.size());
  }
}

void Mender::wander(Wish wish) {
  std::vector<TriangleId> next;
  for (const TriangleId t : bad_) {
    if (!is_bad(t)) continue;
    if (!grow(t, 2 + random_.below(kLargest - 1))) {
      next.push_back(t);
      continue;
    }
    const std::size_t before = bad_in_cluster();
    const auto price_of = [&](double squareness) {
      return wish == Wish::kRandom ? 1 - squareness + random_.uniform() : price(squareness);
    };
    const auto parting =
        best_parting(polygon(), kBadQuad * static_cast<double>(before + 1), Stars::kNone, price_of);
    if (parting && (wish == Wish::kRandom || parting->bad_quads() < before)) {
      part_cluster(mesh_, grower_.cluster(), parting->quads, {});
      touch(grower_.cluster().slot);
      ++statistics_.clusters;
    }
    note_bad(grower_.cluster().slot, next);
  }
  std::sort(next.begin(), next.end());
  next.erase(std::unique(next.begin(), next.end()), next.end());
  bad_ = std::move(next);
}

void Mender::walk() {
  std::vector<TriangleId> apart;
  note_bad(bad_, apart);
  const std::size_t crossings = walker_.points().size();
  find_bad(walker_.walk(apart));
  steiner_.insert(steiner_.end(), walker_.points().begin() + static_cast<std::ptrdiff_t>(crossings),
                  walker_.points().end());
  if (walker_.crossed()) find_bad();
}

void Mender::add_stars() {
  std::vector<TriangleId> next;
  for (const TriangleId t : bad_) {
    if (!is_bad(t)) continue;
    std::optional<Parting> best;
    double best_gain = 0;
    Cluster best_cluster;
    for (int i = 0; i < kStarTries && grow(t, 2 + random_.below(kLargestStar - 1)); ++i) {
      const auto before = static_cast<double>(bad_in_cluster());
      auto parting = best_parting(polygon(), kBadQuad * before, Stars::kAllowed, price);
      if (!parting) continue;
      // Bad quads gone, for few points, and shapes by the size of the cluster.
      const double gain = before * kBadQuad - parting->cost +
                          kUsualPrice * static_cast<double>(grower_.cluster().quad_count());
      if (gain <= best_gain) continue;
      best_gain = gain;
      best = std::move(parting);
      best_cluster = grower_.cluster();
    }
    if (!best) {
      next.push_back(t);
      continue;
    }
    std::vector<VertexId> added;
    for (const Point s : best->added) {
      added.push_back(add_inner(s, best_cluster.corner));
    }
    const auto first_new = static_cast<TriangleId>(mesh_.mate.size());
    part_cluster(mesh_, best_cluster, best->quads, added);
    ++statistics_.stars;
    for (TriangleId u = first_new; u < mesh_.mate.size(); ++u) best_cluster.slot.push_back(u);
    touch(best_cluster.slot);
    note_bad(best_cluster.slot, next);
  }
  bad_ = std::move(next);
}

void Mender::add_cases() {
  std::vector<TriangleId> left;
  for (const TriangleId t : bad_) {
    if (!is_bad(t)) continue;
    if (add_case(t)) {
      ++statistics_.cases;
    } else {
      left.push_back(t);
    }
  }
  bad_ = std::move(left);
}

/// The union of a bad quad with the neighbour that takes the fewest points; a quad without one alone.
bool Mender::add_case(TriangleId t) {
  Cluster best_cluster;
  std::optional<Patch> best;
  std::vector<VertexId> best_inner;
  const auto consider = [&](const Cluster& cluster, std::vector<VertexId> inner,
                            std::optional<Patch> patch) {
    if (!patch || (best && best->steiner.size() <= patch->steiner.size())) return;
    best = std::move(patch);
    best_cluster = cluster;
    best_inner = std::move(inner);
  };
  grower_.start(t);
  const Cluster alone = grower_.cluster();
  const auto place = [&](VertexId v) { return mesh_.point(v); };
  for (std::size_t k = 0; k < 4; ++k) {
    const HalfedgeId enter = mesh_.tri.twin[alone.inner[k]];
    if (enter == kNone || mesh_.is_free(triangle_of(enter))) continue;
    const QuadBehind quad = quad_behind(mesh_, enter);
    // The corners of the union from the end of side k on, and those of the neighbour between.
    Cluster both{{}, {}, {alone.slot[0], alone.slot[1], quad.near, quad.far}};
    for (std::size_t i = 1; i < 4; ++i) {
      both.corner.push_back(alone.corner[(k + i) % 4]);
      both.inner.push_back(alone.inner[(k + i) % 4]);
    }
    for (const HalfedgeId side : quad.side) {
      both.corner.push_back(mesh_.tri.origin(side));
      both.inner.push_back(side);
    }
    // If a second side is shared, its far corner is inside: it stands between two equal corners.
    std::optional<std::size_t> inside;
    for (std::size_t i = 0; i < 6; ++i) {
      if (mesh_.tri.twin[both.inner[i]] == both.inner[(i + 1) % 6]) inside = (i + 1) % 6;
    }
    if (!inside) {
      std::array<Point, 6> corner;
      std::transform(both.corner.begin(), both.corner.end(), corner.begin(), place);
      consider(both, {}, patch_hexagon(corner));
      continue;
    }
    Cluster four{{}, {}, both.slot};
    for (std::size_t i = 1; i < 5; ++i) {
      four.corner.push_back(both.corner[(*inside + i) % 6]);
      four.inner.push_back(both.inner[(*inside + i) % 6]);
    }
    std::array<Point, 4> corner;
    std::transform(four.corner.begin(), four.corner.end(), corner.begin(), place);
    const VertexId inner = both.corner[*inside];
    consider(four, {inner}, patch_quad_with_point(corner, mesh_.point(inner)));
  }
  if (!best) {
    std::array<Point, 4> corner;
    std::transform(alone.corner.begin(), alone.corner.end(), corner.begin(), place);
    consider(alone, {}, patch_quad(corner));
  }
  if (!best) return false;
  std::vector<VertexId> added = best_inner;
  for (const Point s : best->steiner) {
    added.push_back(add_inner(s, best_cluster.corner));
  }
  std::vector<ClusterQuad> quads;
  for (const LocalQuad& q : best->quads) {
    quads.push_back({static_cast<std::uint8_t>(q[0]), static_cast<std::uint8_t>(q[1]),
                     static_cast<std::uint8_t>(q[2]), static_cast<std::uint8_t>(q[3])});
  }
  part_cluster(mesh_, best_cluster, quads, added);
  touch(best_cluster.slot);
  return true;
}

void Mender::slide() {
  if (improve_ == Improve::kTouched) return;
  quadrangulate::slide_diagonals_at(mesh_, touched_);
  find_bad(touched_);  // a slide renames quads
}

void Mender::improve() {
  report_progress(progress_, "polishing", 0);
  slide();
  polish_quads(mesh_, std::move(touched_), random_);
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
