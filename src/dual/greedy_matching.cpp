// Greedy matching of the dual graph by shape, without sorting.
//
// Each triangle proposes to the best partner that has no better offer yet; who is turned down for it proposes again. With
// edges in a total order (shape, then number) that ends in the greedy matching itself, in whatever order triangles
// propose (the suitor algorithm: Manne and Halappanavar 2014). It weighs at least half of the heaviest matching; on
// Delaunay triangulations 95% (bench/).
//
// Steps:
//   1. weigh_pairs     the shape of each pair, by halfedge, in blocks of triangles on several threads; in passes
//                      that stream if the mesh is in order
//   2. put_scarce_first  if asked for: what triangles with few strictly convex pairs gain by
//   3. propose         for each triangle
//
// Cost: O(n) in practice.
#include "dual/greedy_matching.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "core/large_array.hpp"
#include "core/parallel.hpp"
#include "dual/pair_shape.hpp"
#include "quadloom/dual.hpp"

namespace quadloom {

using dual::GreedyOrder;

namespace {

constexpr float kNever = 8;  // that or more: worse than any pair
constexpr std::uint64_t kNoOffer = std::uint64_t{std::bit_cast<std::uint32_t>(kNever)} << 32;
constexpr float kScarcity = 0.5F;

/// The greatest squared cosine of the pair at h, kNever or more if it is not strictly convex.
float weigh_pair(const Triangulation& mesh, HalfedgeId h) {
  constexpr float kBeside[] = {kNever, 0};  // a choice that cannot be predicted
  const Point a = mesh.points[mesh.origin(h)], b = mesh.points[mesh.target(h)];
  const Point c = mesh.points[mesh.apex(h)], d = mesh.points[mesh.apex(mesh.twin[h])];
  const kernel::QuadEdges quad(a, d, b, c);
  const kernel::PairSigns turns = quad.turns_at_first_and_third();
  bool convex = turns.positive == 3;
  if ((turns.positive | turns.negative) != 3) convex = dual::strictly_convex_pair(a, d, b, c);
  const double worst = quad.worst_squared_cosine();
  return (worst < 1 ? static_cast<float>(worst) : 1) + kBeside[convex ? 1 : 0];
}

/// The weights of the pairs whose smaller halfedge is one of the triangles'. Two passes, since it is a matter of luck
/// which of the two halfedges comes first: what is costly is done without branches after this.
void weigh_pairs_of(const Triangulation& mesh, TriangleId begin, TriangleId end,
                    std::vector<float>& weight) {
  std::vector<HalfedgeId> edges(3 * (end - begin) + 1);
  std::size_t count = 0;
  for (HalfedgeId h = 3 * begin; h < 3 * end; ++h) {
    edges[count] = h;
    count += mesh.twin[h] + 1 > h + 1 ? 1 : 0;  // kNone + 1 is 0
  }
  edges.resize(count);
  for (const HalfedgeId h : edges) weight[h] = weight[mesh.twin[h]] = weigh_pair(mesh, h);
}

/// A triangle that has few pairs to choose from is left over unless it comes soon. Counted before anything is paired,
/// that is a third fewer triangles left over, and after the walks better shapes.
void put_scarce_first(const Triangulation& mesh, std::vector<float>& weight) {
  std::vector<std::uint8_t> partners(mesh.triangle_count());
  parallel_for(mesh.triangle_count(), [&](TriangleId t) {
    const auto has = [&](HalfedgeId i) { return weight[3 * t + i] < kNever ? 1 : 0; };
    partners[t] = static_cast<std::uint8_t>(has(0) + has(1) + has(2));
  });
  parallel_for(mesh.triangle_count(), [&](TriangleId t) {
    for (HalfedgeId h = 3 * t; h < 3 * t + 3; ++h) {
      const HalfedgeId twin = mesh.twin[h];
      const int others = partners[t] + partners[triangle_of(twin == kNone ? h : twin)];
      weight[h] += kScarcity * static_cast<float>(others);
    }
  });
}

/// By halfedge.
std::vector<float> weigh_pairs(const Triangulation& mesh, GreedyOrder order) {
  auto weight = large_vector<float>(mesh.twin.size(), kNever);
  parallel_for_blocks(mesh.triangle_count(), kPartOfPass, [&](std::size_t begin, std::size_t end) {
    weigh_pairs_of(mesh, static_cast<TriangleId>(begin), static_cast<TriangleId>(end), weight);
  });
  if (order == GreedyOrder::kShapeAndScarcity) put_scarce_first(mesh, weight);
  return weight;
}

class GreedyMatching {
 public:
  GreedyMatching(const Triangulation& mesh, GreedyOrder order)
      : mesh_(mesh),
        weight_(weigh_pairs(mesh, order)),
        offer_(large_vector<std::uint64_t>(mesh.triangle_count(), kNoOffer)) {}

  DualMatching run() {
    for (TriangleId t = 0; t < offer_.size(); ++t) propose(t);
    DualMatching matching;
    matching.mate = large_vector<HalfedgeId>(offer_.size(), kNone);
    parallel_for(mesh_.triangle_count(), [&](TriangleId t) {
      if (offer_[t] == kNoOffer) return;
      const HalfedgeId h = edge_of(offer_[t]);
      const HalfedgeId sides[] = {h, mesh_.twin[h]};  // either, by luck
      matching.mate[t] = sides[triangle_of(h) == t ? 0 : 1];
    });
    matching.unmatched =
        static_cast<std::size_t>(std::count(offer_.begin(), offer_.end(), kNoOffer));
    return matching;
  }

 private:
  /// Weight and smaller halfedge of an edge in one number, by which edges are ordered.
  std::uint64_t rank(HalfedgeId h, HalfedgeId twin) const {
    return std::uint64_t{std::bit_cast<std::uint32_t>(weight_[h])} << 32 | std::min(h, twin);
  }
  static HalfedgeId edge_of(std::uint64_t rank) { return static_cast<HalfedgeId>(rank); }

  /// Who is turned down for t proposes to another one, and so on.
  void propose(TriangleId t) {
    std::uint64_t best = best_for(t);
    while (best < kNoOffer) {
      const TriangleId other = other_end(best, t);
      const std::uint64_t before = offer_[other];
      offer_[other] = best;
      if (before == kNoOffer) return;
      t = other_end(before, other);
      best = best_for(t);
    }
  }
  TriangleId other_end(std::uint64_t rank, TriangleId t) const {
    const HalfedgeId h = edge_of(rank);
    return triangle_of(h) == t ? triangle_of(mesh_.twin[h]) : triangle_of(h);
  }

  /// The first of the edges of t whose other end has no better offer; without branches, which would be a matter of
  /// luck.
  std::uint64_t best_for(TriangleId t) const {
    std::uint64_t best = kNoOffer;
    for (HalfedgeId h = 3 * t; h < 3 * t + 3; ++h) {
      const HalfedgeId twin = mesh_.twin[h];
      const std::uint64_t here = rank(h, twin);
      const std::uint64_t there = offer_[triangle_of(twin == kNone ? h : twin)];
      best = here < there && here < best ? here : best;
    }
    return best;
  }

  const Triangulation& mesh_;
  const std::vector<float> weight_;
  std::vector<std::uint64_t> offer_;  // the best that each triangle has
};

}  // namespace

DualMatching greedy_shape_matching(const Triangulation& mesh) {
  return GreedyMatching(mesh, GreedyOrder::kShape).run();
}

DualMatching dual::greedy_matching(const Triangulation& mesh, GreedyOrder order) {
  return GreedyMatching(mesh, order).run();
}

}  // namespace quadloom
