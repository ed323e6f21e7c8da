// Greedy matching of the dual graph by shape, without sorting.
//
// An edge that comes before all edges beside it in the order (shape, then number) belongs to the greedy
// matching; taking such edges as long as there are any gives the greedy matching itself (Preis 1999),
// here with one pointer a triangle (Manne and Bisseling 2007). It weighs at least half of the heaviest
// matching; on Delaunay triangulations 95% (bench/).
//
// Steps:
//   1. weigh_pairs   the shape of each pair, by halfedge; in passes that stream if the mesh is in order
//   2. choose        each triangle's best partner that is still free
//   3. take          two that have chosen each other; those who had chosen one of them choose again
//
// Cost: O(n), each triangle chooses at most three times.
#include <bit>
#include <cstdint>
#include <vector>

#include "dual/pair_shape.hpp"
#include "quadloom/dual.hpp"

namespace quadloom {
namespace {

constexpr float kNever = 2;  // worse than any squared cosine
constexpr std::uint64_t kNeverRank = std::uint64_t{std::bit_cast<std::uint32_t>(kNever)} << 32;

/// The greatest squared cosine of each pair, kNever if it is not strictly convex; by halfedge.
std::vector<float> weigh_pairs(const Triangulation& mesh) {
  std::vector<float> weight(mesh.twin.size(), kNever);
  for (HalfedgeId h = 0; h < mesh.twin.size(); ++h) {
    const HalfedgeId twin = mesh.twin[h];
    if (twin == kNone || twin < h) continue;
    const Point a = mesh.points[mesh.origin(h)], b = mesh.points[mesh.target(h)];
    const Point c = mesh.points[mesh.apex(h)], d = mesh.points[mesh.apex(twin)];
    if (!dual::strictly_convex_pair(a, d, b, c)) continue;
    const double worst = kernel::worst_squared_cosine(a, d, b, c);
    weight[h] = weight[twin] = worst < 1 ? static_cast<float>(worst) : 1;
  }
  return weight;
}

class GreedyMatching {
 public:
  explicit GreedyMatching(const Triangulation& mesh) : mesh_(mesh), weight_(weigh_pairs(mesh)) {
    matching_.mate.assign(mesh.triangle_count(), kNone);
    matching_.unmatched = mesh.triangle_count();
    choice_.resize(mesh.triangle_count());
  }

  DualMatching run() {
    for (TriangleId t = 0; t < choice_.size(); ++t) choose(t);
    for (TriangleId t = 0; t < choice_.size(); ++t) {
      take(t);
      while (!taken_.empty()) {
        const TriangleId gone = taken_.back();
        taken_.pop_back();
        choose_again_at(gone);
      }
    }
    return std::move(matching_);
  }

 private:
  bool is_free(TriangleId t) const { return matching_.mate[t] == kNone; }
  /// The triangle beyond the halfedge, or itself at the boundary, where no pair is.
  TriangleId across(HalfedgeId h) const {
    return triangle_of(mesh_.twin[h] == kNone ? h : mesh_.twin[h]);
  }

  /// Weight and number of the edge at h in one number that orders edges.
  std::uint64_t rank(HalfedgeId h) const {
    return std::uint64_t{std::bit_cast<std::uint32_t>(weight_[h])} << 32 |
           std::min(h, mesh_.twin[h]);
  }

  // Without branches, which would be a matter of luck.
  void choose(TriangleId t) {
    std::uint64_t best = kNeverRank;
    HalfedgeId choice = kNone;
    for (HalfedgeId h = 3 * t; h < 3 * t + 3; ++h) {
      const std::uint64_t here = is_free(across(h)) ? rank(h) : kNeverRank;
      choice = here < best ? h : choice;
      best = here < best ? here : best;
    }
    choice_[t] = choice;
  }

  void take(TriangleId t) {
    const HalfedgeId h = choice_[t];
    if (h == kNone || !is_free(t)) return;
    const HalfedgeId twin = mesh_.twin[h];
    if (choice_[triangle_of(twin)] != twin) return;
    matching_.mate[t] = h;
    matching_.mate[triangle_of(twin)] = twin;
    matching_.unmatched -= 2;
    taken_.push_back(t);
    taken_.push_back(triangle_of(twin));
  }

  void choose_again_at(TriangleId gone) {
    for (HalfedgeId h = 3 * gone; h < 3 * gone + 3; ++h) {
      const HalfedgeId twin = mesh_.twin[h];
      if (twin == kNone || choice_[triangle_of(twin)] != twin || !is_free(triangle_of(twin)))
        continue;
      choose(triangle_of(twin));
      take(triangle_of(twin));
    }
  }

  const Triangulation& mesh_;
  std::vector<float> weight_;
  std::vector<HalfedgeId> choice_;
  std::vector<TriangleId> taken_;  // lately; who had chosen them has to choose again
  DualMatching matching_;
};

}  // namespace

DualMatching greedy_shape_matching(const Triangulation& mesh) { return GreedyMatching(mesh).run(); }

}  // namespace quadloom
