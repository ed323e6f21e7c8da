// Faces with fewer than k corners lack some. A face that lacks a corner takes a triangle from a
// neighbour, which then lacks one more and takes one from another: the lack walks from face to face
// and ends at a smaller face, which in the end vanishes.
//
//   1. concentrate   each face that lacks corners sends what it lacks to the nearest face that lacks as
//                    many or more (breadth-first, each step exact: FaceMesh::can_take)
//   2. move_to_hull  what inner faces lack goes to a face with a hull edge, for points outside
//   3. pair_up       with one face more than necessary the lack is spread over two neighbours: a point
//                    on their edge serves both, and d + k - 2 missing corners need at most k - 3
//                    points if d + 1 or more are shared
//   4. disturb       if the plan still needs too many, lacks move at random and all is repeated
//
// Faces are simple polygons all the time. Deterministic. Cost: near-linear in practice, bounded by the
// caller.
#include "quadrangulate/face_transfer.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/random.hpp"
#include "core/step_reports.hpp"
#include "quadrangulate/face_mesh.hpp"

namespace quadloom::quadrangulate {
namespace {

using End = FaceMesh::End;
using Take = FaceMesh::Take;

constexpr FaceId kNoFace = kNone;
constexpr std::size_t kNoLimit = static_cast<std::size_t>(-1);

class Transfer {
 public:
  Transfer(const LabelledTriangles& start, std::size_t k, std::size_t most_work,
           const Progress& progress)
      : report_(progress, "moving triangles", most_work, 64),
        points_(start.mesh.points),
        k_(k),
        most_work_(most_work),
        mesh_(start.mesh, start.label, start.labels),
        seen_(mesh_.face_slots(), 0),
        way_here_(mesh_.face_slots()) {}

  std::size_t work() const { return mesh_.work(); }
  bool is_tired() const { return work() > most_work_; }

  /// Corners, over all faces.
  std::size_t missing() const {
    std::size_t sum = 0;
    for (FaceId f = 1; f < mesh_.face_slots(); ++f) sum += lacks(f) ? k_ - mesh_.size(f) : 0;
    return sum;
  }

  /// Small searches first: near deficits meet.
  void concentrate() {
    for (const std::size_t limit : {std::size_t{4}, std::size_t{30}, std::size_t{300}, kNoLimit}) {
      constexpr int kMostRounds = 8;
      for (int i = 0; i < kMostRounds && concentrate_round(limit); ++i) {
      }
    }
  }

  /// What inner faces lack goes to a face at the hull.
  void move_to_hull() {
    for (const FaceId f : lacking_faces()) {
      FaceId sink = kNoFace;
      while (lacks(f) && !mesh_.on_hull(f)) {
        const FaceId now = receive(
            f, kNoLimit, [&](FaceId g) { return sink == kNoFace ? mesh_.on_hull(g) : g == sink; });
        if (now == kNoFace) break;
        sink = mesh_.size(now) == 0 ? kNoFace : now;
      }
    }
  }

  /// For one face too many: what is missing shall be missing at both sides of edges, around the
  /// face that lacks most, since a point there serves two faces; then evenly.
  void pair_up() {
    const std::vector<FaceId> lacking = lacking_faces();
    if (lacking.size() < 2) return;
    const FaceId centre = lacking.back();
    for (const FaceId f : lacking) {
      while (f != centre && lacks(f) && mesh_.size(centre) > 0 && !are_neighbours(f, centre)) {
        const auto wanted = [&](FaceId g) {
          return g != centre && mesh_.size(g) > 3 && are_neighbours(g, centre);
        };
        if (receive(f, kNoLimit, wanted) == kNoFace) break;
      }
    }
    FaceId other = kNoFace;
    for (const FaceId f : lacking_faces()) {
      if (f != centre && are_neighbours(f, centre)) other = f;
    }
    while (other != kNoFace && mesh_.size(centre) + 1 < mesh_.size(other)) {
      if (receive(centre, kNoLimit, [&](FaceId g) { return g == other; }) == kNoFace) break;
    }
  }

  /// One missing corner of each face moves to some other face near it.
  void disturb(Random& random) {
    for (const FaceId f : lacking_faces()) {
      if (!lacks(f)) continue;
      std::size_t countdown = random.below(12);
      turn_ = random.next();
      receive(f, kNoLimit, [&](FaceId g) { return countdown-- == 0 && mesh_.size(g) > 3; });
    }
    turn_ = random.next();
  }

  std::optional<FacePlan> plan() const;

 private:
  bool lacks(FaceId f) const {
    return f != FaceMesh::kOuterFace && mesh_.size(f) > 0 && mesh_.size(f) < k_;
  }

  bool are_neighbours(FaceId f, FaceId g) const {
    HalfedgeId a = mesh_.first(f), b = mesh_.first(g);
    do {
      if (mesh_.face(mesh_.twin(a)) == g || mesh_.face(mesh_.twin(b)) == f) return true;
      a = mesh_.next(a);
      b = mesh_.next(b);
    } while (a != mesh_.first(f) && b != mesh_.first(g));
    return false;
  }

  /// To a face that is wanted; kNone if there is none.
  template <typename Wanted>
  HalfedgeId longest_edge_to(FaceId f, const Wanted& wanted) const {
    HalfedgeId best = kNone, e = mesh_.first(f);
    double best_length = 0;
    do {
      const Point a = points_[mesh_.origin(e)], b = points_[mesh_.target(e)];
      const double length = std::hypot(b.x - a.x, b.y - a.y);
      const bool longer = best == kNone || length > best_length;
      if (longer && wanted(mesh_.face(mesh_.twin(e)))) {
        best = e;
        best_length = length;
      }
      e = mesh_.next(e);
    } while (e != mesh_.first(f));
    return best;
  }

  /// The largest first, ties by number.
  std::vector<FaceId> lacking_faces() const {
    std::vector<FaceId> out;
    for (FaceId f = 1; f < mesh_.face_slots(); ++f) {
      if (lacks(f)) out.push_back(f);
    }
    std::stable_sort(out.begin(), out.end(),
                     [&](FaceId a, FaceId b) { return mesh_.size(a) > mesh_.size(b); });
    return out;
  }

  bool concentrate_round(std::size_t limit) {
    bool moved = false;
    for (const FaceId f : lacking_faces()) {
      while (lacks(f)) {
        const std::size_t most = mesh_.size(f);
        const auto smaller = [&](FaceId g) { return g != f && lacks(g) && mesh_.size(g) <= most; };
        if (receive(f, limit, smaller) == kNoFace) break;
        moved = true;
      }
    }
    return moved;
  }

  /// f gets one triangle more, and a face that is wanted gets one less: the nearest one. That face,
  /// or kNoFace; then some other face may have one less.
  template <typename Wanted>
  FaceId receive(FaceId f, std::size_t limit, const Wanted& wanted) {
    constexpr int kMostTries = 40;
    FaceId lacking = f;
    for (int i = 0; i < kMostTries && !is_tired(); ++i) {
      const FaceId giver = find_way(lacking, limit, wanted);
      if (giver == kNoFace) return kNoFace;
      lacking = go(lacking, giver);
      if (lacking == giver) return giver;
    }
    return kNoFace;
  }

  /// Breadth-first; way_here_[g] is how the face before g takes from g.
  template <typename Wanted>
  FaceId find_way(FaceId f, std::size_t limit, const Wanted& wanted) {
    report_();
    ++stamp_;
    seen_[f] = stamp_;
    queue_.assign(1, f);
    for (std::size_t i = 0; i < queue_.size() && i < limit; ++i) {
      HalfedgeId start = mesh_.first(queue_[i]);
      for (std::size_t s = turn_ % mesh_.size(queue_[i]); s > 0; --s) start = mesh_.next(start);
      HalfedgeId e = start;
      do {
        const HalfedgeId beyond = mesh_.twin(e);
        const FaceId g = mesh_.face(beyond);
        e = mesh_.next(e);
        if (g == FaceMesh::kOuterFace || seen_[g] == stamp_) continue;
        for (const End end : {End::kTarget, End::kOrigin}) {
          const Take take{beyond, end};
          if (!mesh_.can_take(points_, take)) continue;
          seen_[g] = stamp_;
          way_here_[g] = take;
          if (wanted(g)) return g;
          if (mesh_.size(g) > 3) queue_.push_back(g);  // a triangle that gives is no more
          break;
        }
      } while (e != start);
    }
    return kNoFace;
  }

  /// From f on to the giver. Each step is checked again, since the one before changed the face that
  /// takes; the way may end early. The face that gave last.
  FaceId go(FaceId f, FaceId giver) {
    std::vector<FaceId> way;
    for (FaceId g = giver; g != f; g = mesh_.face(mesh_.twin(way_here_[g].edge))) way.push_back(g);
    FaceId taker = f;
    for (; !way.empty(); way.pop_back()) {
      const Take take = way_here_[way.back()];
      const bool same =
          mesh_.face(take.edge) == way.back() && mesh_.face(mesh_.twin(take.edge)) == taker;
      if (!same || !mesh_.can_take(points_, take)) break;
      mesh_.take(take);
      taker = way.back();
    }
    return taker;
  }

  StepReports report_;
  std::span<const Point> points_;
  std::size_t k_, most_work_;
  FaceMesh mesh_;
  std::uint32_t stamp_ = 0;
  std::vector<std::uint32_t> seen_;
  std::vector<Take> way_here_;
  std::vector<FaceId> queue_;
  std::uint64_t turn_ = 0;
};

/// Points on edges between two faces that both lack corners, first for those that have no hull
/// edge; the others get theirs at the hull.
std::optional<FacePlan> Transfer::plan() const {
  std::vector<std::size_t> missing(mesh_.face_slots(), 0);
  std::vector<FaceId> lacking = lacking_faces();
  std::reverse(lacking.begin(), lacking.end());
  std::stable_partition(lacking.begin(), lacking.end(),
                        [&](FaceId f) { return !mesh_.on_hull(f); });
  for (const FaceId f : lacking) missing[f] = k_ - mesh_.size(f);
  struct Shared {
    HalfedgeId edge;
    std::size_t count;
  };
  std::vector<Shared> shared;
  for (const FaceId f : lacking) {
    while (missing[f] > 0) {
      const HalfedgeId e = longest_edge_to(f, [&](FaceId g) { return missing[g] > 0; });
      if (e == kNone) break;
      const FaceId g = mesh_.face(mesh_.twin(e));
      const std::size_t count = std::min(missing[f], missing[g]);
      shared.push_back({e, count});
      missing[f] -= count;
      missing[g] -= count;
    }
    if (missing[f] > 0 && !mesh_.on_hull(f)) return std::nullopt;
  }
  FacePlan plan;
  std::vector<std::size_t> number(mesh_.face_slots(), 0);
  for (FaceId f = 1; f < mesh_.face_slots(); ++f) {
    if (mesh_.size(f) == 0) continue;
    number[f] = plan.faces.size();
    if (missing[f] > 0) plan.outer.push_back({number[f], missing[f]});
    plan.added += missing[f];
    plan.faces.push_back(mesh_.corners(f));
  }
  for (const Shared& s : shared) {
    plan.inner.push_back(
        {mesh_.origin(s.edge), mesh_.target(s.edge), number[mesh_.face(s.edge)], s.count});
    plan.added += s.count;
  }
  return plan;
}

}  // namespace

std::optional<FacePlan> transfer_triangles(const LabelledTriangles& start, std::size_t k,
                                           const TransferEffort& effort, std::size_t& work_left) {
  Transfer transfer(start, k, work_left, effort.progress);
  Random random(effort.seed);
  std::optional<FacePlan> best;
  const auto keep_better = [&] {
    auto now = transfer.plan();
    if (now && (!best || now->added < best->added)) best = std::move(now);
    return best && best->added <= enough_points(start.mesh.triangle_count(), k);
  };
  transfer.concentrate();
  for (int i = 0;; ++i) {
    const bool last = i == effort.disturbances || transfer.is_tired();
    // One face too many can do, see pair_up(), but not two.
    if (last || transfer.missing() < 2 * (k - 2)) {
      if (keep_better()) break;
      transfer.move_to_hull();
      if (keep_better()) break;
      transfer.pair_up();
      if (keep_better()) break;
    }
    if (last) break;
    transfer.disturb(random);
    transfer.concentrate();
  }
  work_left -= std::min(work_left, transfer.work());
  return best;
}

}  // namespace quadloom::quadrangulate
