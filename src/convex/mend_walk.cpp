// Steps of a walk():
//   1. walk_convexly   cheap searches that leave strictly convex quads, with the quads around as they are, or one
//                      edge between two of them slid (quick_walk.hpp)
//   2. walk_deeply     thorough ones (walk.hpp), as long as their budget lasts
//   3. rejoin_halves   very large meshes: halves that are both left over are a quad again; a way to others, by quads that are
//                      bad as well, would be long
//   4. walk_anyhow     the others pair up by any quads, which are bad again but elsewhere; where walks are stuck
//                      (narrow corridors) the steps of crossings that need no point go on
#include "convex/mend_walk.hpp"

#include <algorithm>
#include <utility>

#include "convex/mending.hpp"
#include "quadrangulate/walk_rounds.hpp"

namespace quadloom::convex {

using quadrangulate::WalkLimits;
using quadrangulate::WalkQuads;

namespace {

/// Bad quads are rare in large meshes, and what locks a triangle is seldom far from it.
constexpr std::size_t kLarge = 100'000;  // triangles
constexpr std::size_t kNear = 1'000;     // nodes of a search
constexpr std::size_t kNearIfLarge = 300;
constexpr std::size_t kAfterSlide = 200;
/// Nodes of thorough searches, for each walk(); what is left over adds up.
constexpr std::size_t kDeepNodes = 150'000;
constexpr std::size_t kDeepNodesIfLarge = 10'000;
constexpr std::size_t kFar = 100'000;
constexpr WalkLimits kDeepRounds[] = {
    {WalkQuads::kStrictlyConvex, 4'000, 2},
    {WalkQuads::kStrictlyConvex, 20'000, 4},
};
constexpr WalkLimits kLastRounds[] = {
    {WalkQuads::kAny, 20'000, 4},
    {WalkQuads::kAny, 20'000, 255},
};

}  // namespace

MendWalker::MendWalker(quadrangulate::PairedMesh& mesh,
                       std::function<void(std::span<const TriangleId>)> touch)
    : mesh_(mesh), quick_(mesh), walker_(mesh), crossing_(mesh), touch_(std::move(touch)) {
  quick_.on_recut = walker_.on_recut = [this](std::span<const TriangleId> touched) {
    touch_(touched);
    changed_.insert(changed_.end(), touched.begin(), touched.end());
  };
}

bool MendWalker::is_large() const { return mesh_.mate.size() > kLarge; }

std::vector<TriangleId> MendWalker::walk(std::span<const TriangleId> apart) {
  free_.clear();
  taken_apart_.clear();
  for (const TriangleId t : apart) {
    if (mesh_.is_free(t)) continue;
    taken_apart_.push_back(mesh_.mate[t]);
    free_.insert(free_.end(), {t, triangle_of(mesh_.tri.twin[mesh_.mate[t]])});
    mesh_.unpair(t);
  }
  changed_ = free_;
  crossed_ = false;
  walk_convexly();
  walk_deeply();
  if (mesh_.mate.size() > kThriftyMesh) rejoin_halves();
  walk_anyhow();
  return std::move(changed_);
}

template <typename Merge>
void MendWalker::sweep(Merge merge) {
  for (const TriangleId t : free_) {
    if (mesh_.is_free(t)) merge(t);
  }
  forget_paired();
}

void MendWalker::forget_paired() {
  free_.erase(
      std::remove_if(free_.begin(), free_.end(), [&](TriangleId t) { return !mesh_.is_free(t); }),
      free_.end());
}

void MendWalker::walk_convexly() {
  const std::size_t near = is_large() ? kNearIfLarge : kNear;
  sweep([&](TriangleId t) {
    if (quick_.merge(t, WalkQuads::kStrictlyConvex, near)) return;
    // A slide moves no sources.
    if (mesh_.source.empty() && quick_.locked()) quick_.merge_after_slide(t, kAfterSlide);
  });
}

void MendWalker::walk_deeply() {
  deep_nodes_ += is_large() ? kDeepNodesIfLarge : kDeepNodes;
  for (const WalkLimits& limits : kDeepRounds) {
    sweep([&](TriangleId t) {
      if (deep_nodes_ == 0) return;
      walker_.merge(t, limits);
      deep_nodes_ -= std::min(deep_nodes_, walker_.nodes());
    });
  }
}

/// Halves of a bad quad that are both free have not moved.
void MendWalker::rejoin_halves() {
  for (const HalfedgeId h : taken_apart_) {
    if (mesh_.is_free(triangle_of(h)) && mesh_.is_free(triangle_of(mesh_.tri.twin[h])))
      mesh_.pair(h);
  }
}

void MendWalker::walk_anyhow() {
  // In large meshes the others are too far for a search without an aim.
  if (!is_large()) sweep([&](TriangleId t) { quick_.merge(t, WalkQuads::kAny, kNear); });
  quick_.merge_far(free_, kFar);
  forget_paired();
  // The odd one would look for another in all of the mesh, in vain.
  if (free_.size() <= 1 && quadrangulate::free_triangles(mesh_).size() <= 1) return;
  for (const WalkLimits& limits : kLastRounds) {
    sweep([&](TriangleId t) { walker_.merge(t, limits); });
  }
  sweep([&](TriangleId t) { crossed_ = crossing_.merge(t) || crossed_; });
}

}  // namespace quadloom::convex
