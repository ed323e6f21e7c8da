// Added points for quads that no move has made strictly convex.
//
//   1. add_stars      the best parting of many random clusters around a bad quad, in which a hexagon may be
//                     three quads around an added point (best_parting.hpp)
//   2. add_cases      for what is left after that: the union with each neighbour is a hexagon, or a quad with a
//                     point inside; the one that takes the fewest points, at most three (Bremner, Hurtado,
//                     Ramaswami and Sacristan, theorem 3.8). A quad without a neighbour alone takes four.
//
// Degenerate input: as for the cases. Cost: constant for each bad quad.
#include "convex/mend_points.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "convex/best_parting.hpp"
#include "convex/hexagon.hpp"
#include "convex/price.hpp"
#include "convex/quad.hpp"

namespace quadloom::convex {
namespace {

using quadrangulate::quad_behind;
using quadrangulate::QuadBehind;

constexpr double kUsualPrice = 0.8;  // of a quad
constexpr std::size_t kLargestStar = 5;
/// Clusters looked at for each star; fewer where there is very much to mend.
constexpr std::size_t kStarTries = 60, kStarTriesIfThrifty = 12, kLeastStarTries = 8;
constexpr std::size_t kTriesOfARound = 400'000;

struct StarCluster {
  Cluster cluster;
  Parting parting;
  double gain = 0;
};

bool grow(Mending& state, TriangleId t, std::size_t quads) {
  state.grower.start(t);
  while (state.grower.cluster().quad_count() < quads) {
    if (!state.grower.grow(state.random)) return state.grower.cluster().quad_count() > 1;
  }
  return true;
}

std::optional<StarCluster> best_star(Mending& state, TriangleId t, std::size_t tries) {
  std::optional<StarCluster> best;
  for (std::size_t i = 0; i < tries && grow(state, t, 2 + state.random.below(kLargestStar - 1));
       ++i) {
    const Cluster& cluster = state.grower.cluster();
    const auto before = static_cast<double>(state.bad_in(cluster));
    auto parting =
        best_parting(state.points_of(cluster.corner), kBadQuad * before, Stars::kAllowed, price);
    if (!parting) continue;
    // Bad quads gone, for few points, and shapes by the size of the cluster.
    const double gain =
        before * kBadQuad - parting->cost + kUsualPrice * static_cast<double>(cluster.quad_count());
    if (gain <= (best ? best->gain : 0)) continue;
    best = StarCluster{cluster, std::move(*parting), gain};
  }
  return best;
}

/// The union of a quad with a neighbour, or the quad alone, as one of the paper's cases.
struct Case {
  Cluster cluster;
  Patch patch;
};

/// The quad and the one behind its side k: a hexagon, unless they share more sides.
Cluster union_at(const PairedMesh& mesh, const Cluster& alone, std::size_t k) {
  const QuadBehind quad = quad_behind(mesh, mesh.tri.twin[alone.inner[k]]);
  Cluster both{{}, {}, {alone.slot[0], alone.slot[1], quad.near, quad.far}, {}};
  for (std::size_t i = 1; i < 4; ++i) {  // from the end of side k on
    both.corner.push_back(alone.corner[(k + i) % 4]);
    both.inner.push_back(alone.inner[(k + i) % 4]);
  }
  for (const HalfedgeId side : quad.side) {
    both.corner.push_back(mesh.tri.origin(side));
    both.inner.push_back(side);
  }
  return both;
}

/// Where a second side is shared its far corner is inside: it stands between two equal corners, which become one.
void close_around_shared_corner(const PairedMesh& mesh, Cluster& both) {
  for (std::size_t i = 0; i < 6; ++i) {
    if (mesh.tri.twin[both.inner[i]] != both.inner[(i + 1) % 6]) continue;
    const auto first = static_cast<std::ptrdiff_t>((i + 2) % 6);
    std::rotate(both.corner.begin(), both.corner.begin() + first, both.corner.end());
    std::rotate(both.inner.begin(), both.inner.begin() + first, both.inner.end());
    both.inside = {both.corner[5]};
    both.corner.resize(4);
    both.inner.resize(4);
    return;
  }
}

template <std::size_t N>
std::array<Point, N> corners_of(const Mending& state, const Cluster& cluster) {
  std::array<Point, N> out;
  for (std::size_t i = 0; i < N; ++i) out[i] = state.mesh.point(cluster.corner[i]);
  return out;
}

std::optional<Patch> patch_of(const Mending& state, const Cluster& both) {
  if (both.inside.empty()) return patch_hexagon(corners_of<6>(state, both));
  return patch_quad_with_point(corners_of<4>(state, both), state.mesh.point(both.inside[0]));
}

std::optional<Case> best_case(Mending& state, TriangleId t) {
  state.grower.start(t);
  const Cluster alone = state.grower.cluster();
  std::optional<Case> best;
  for (std::size_t k = 0; k < 4; ++k) {
    const HalfedgeId enter = state.mesh.tri.twin[alone.inner[k]];
    if (enter == kNone || state.mesh.is_free(triangle_of(enter))) continue;
    Cluster both = union_at(state.mesh, alone, k);
    close_around_shared_corner(state.mesh, both);
    const auto patch = patch_of(state, both);
    if (!patch || (best && best->patch.steiner.size() <= patch->steiner.size())) continue;
    best = Case{std::move(both), *patch};
  }
  if (best) return best;
  if (const auto patch = patch_quad(corners_of<4>(state, alone))) return Case{alone, *patch};
  return std::nullopt;
}

void apply(Mending& state, const Case& found) {
  std::vector<ClusterQuad> quads;
  for (const LocalQuad& q : found.patch.quads) {
    quads.push_back({static_cast<std::uint8_t>(q[0]), static_cast<std::uint8_t>(q[1]),
                     static_cast<std::uint8_t>(q[2]), static_cast<std::uint8_t>(q[3])});
  }
  state.part(found.cluster, quads, found.cluster.inside,
             {found.patch.steiner.data(), found.patch.steiner.size()});
}

}  // namespace

void add_stars(Mending& state, MendStatistics& statistics) {
  std::vector<TriangleId> next;
  const std::size_t tries = std::clamp(kTriesOfARound / (state.bad.size() + 1), kLeastStarTries,
                                       state.is_thrifty() ? kStarTriesIfThrifty : kStarTries);
  for (const TriangleId t : state.bad) {
    if (!state.is_bad(t)) continue;
    const auto best = best_star(state, t, tries);
    if (!best) {
      next.push_back(t);
      continue;
    }
    state.note_bad(state.part(best->cluster, best->parting.quads, {}, best->parting.added), next);
    ++statistics.stars;
  }
  state.bad = std::move(next);
}

void add_cases(Mending& state, MendStatistics& statistics) {
  std::vector<TriangleId> left;
  for (const TriangleId t : state.bad) {
    if (!state.is_bad(t)) continue;
    const auto found = best_case(state, t);
    if (!found) {
      left.push_back(t);
      continue;
    }
    apply(state, *found);
    ++statistics.cases;
  }
  state.bad = std::move(left);
}

}  // namespace quadloom::convex
