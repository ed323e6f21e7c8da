// Walks found by cheap searches: most left-over triangles of a matching are near each other.
//
// merge_over_quad: all walks of one step, by adjacency first (is there a free triangle at one of the
// pentagon's sides), geometry only where there is.
//
// merge:
//   1. search      Dijkstra over moves as in walk.cpp, with costs in buckets that are lists of nodes
//   2. try_ears    the turns of the pentagon's corners are judged together, without branches
//   3. try_goals   a node that is next to a free triangle ends the search when it is made, not when it is
//                  its turn: the walks found cost little more, and half of the nodes are never made
//   4. apply       re-cuts the pentagons along the way
//
// If free triangles are taken in spatial order, what is ahead is still full of them, so that searches are
// short, but for those that have no strictly convex way out.
// Degenerate input: exact turns as everywhere; a quad that wraps around the free triangle is not passed.
// Cost: O(nodes).
#include "quadrangulate/quick_walk.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "kernel/squareness.hpp"
#include "quadrangulate/diagonal_slides.hpp"
#include "quadrangulate/pentagon.hpp"

namespace quadloom::quadrangulate {
namespace {

constexpr std::uint32_t kStep = 2;
constexpr double kShape = 12;  // times the greatest squared cosine of the quad left behind
constexpr std::uint32_t kFlat = 60, kReflex = 80;  // so much is a detour worth
constexpr std::uint32_t kSlack = 24;  // what a better walk may save without being looked for
constexpr double kHop = 12;           // what a quad on the way to the aim is thought to cost
constexpr double kNoWalk = 2;         // worse than any squared cosine

std::uint32_t convex_cost(double worst) {
  return kStep + (worst < 1 ? static_cast<std::uint32_t>(kShape * worst)
                            : static_cast<std::uint32_t>(kShape));
}

/// The pentagon of a free triangle and the quad behind its side a->b, as in paired_mesh.hpp.
struct Pentagon {
  std::array<VertexId, 5> corner;
  std::array<Point, 5> place;

  Pentagon(const PairedMesh& mesh, VertexId a, VertexId b, VertexId c, const QuadBehind& quad)
      : corner{b, c, a, mesh.tri.origin(quad.side[1]), mesh.tri.origin(quad.side[2])} {
    for (std::size_t k = 0; k < 5; ++k) place[k] = mesh.point(corner[k]);
  }
  bool wrapped() const { return corner[1] == corner[3] || corner[1] == corner[4]; }
  Point at(std::size_t k) const { return place[k % 5]; }
  /// Of the quad that is left without an ear.
  double worst_cosine_without(std::size_t ear) const {
    return kernel::worst_squared_cosine(at(ear + 1), at(ear + 2), at(ear + 3), at(ear + 4));
  }
};

Point centre(const PairedMesh& mesh, TriangleId t) {
  const auto at = [&](std::size_t i) { return mesh.point(mesh.tri.tri_vertex[3 * t + i]); };
  return {at(0).x / 3 + at(1).x / 3 + at(2).x / 3, at(0).y / 3 + at(1).y / 3 + at(2).y / 3};
}

bool meet_convexly(Point a, Point b, Point c, Point d) {
  return kernel::orient(c, a, d) > 0 && kernel::orient(d, b, c) > 0;
}

}  // namespace

bool QuickWalker::merge_over_quad(TriangleId start) {
  start_ = start;
  OverQuad best{kNoWalk};
  for (HalfedgeId h = 3 * start; h < 3 * start + 3; ++h) try_over(h, best);
  if (best.met == kNone) return false;
  step(best.enter, static_cast<int>(best.ear));
  mesh_.pair(best.met);
  ++walks_;
  return true;
}

void QuickWalker::try_over(HalfedgeId exit, OverQuad& best) const {
  const HalfedgeId enter = mesh_.tri.twin[exit];
  if (enter == kNone || mesh_.is_free(triangle_of(enter))) return;
  const QuadBehind quad = quad_behind(mesh_, enter);
  for (std::size_t side = 0; side < 3; ++side) {
    const HalfedgeId met = mesh_.tri.twin[quad.side[side]];
    if (met == kNone || !mesh_.is_free(triangle_of(met)) || triangle_of(met) == start_) continue;
    const Pentagon pentagon(mesh_, mesh_.tri.origin(exit), mesh_.tri.target(exit),
                            mesh_.tri.apex(exit), quad);
    if (pentagon.wrapped()) return;
    // The edge to the free triangle goes from corner k to the next; one of the two is the ear.
    const std::size_t k = side + 2;
    const Point a = pentagon.at(k), b = pentagon.at(k + 1), d = mesh_.point(mesh_.tri.apex(met));
    const std::uint32_t cuts = PentagonTurns(pentagon.place).convex_cuts();
    for (const std::size_t ear : {k, (k + 1) % 5}) {
      const Point c = pentagon.at(ear == k ? k + 4 : k + 2);
      if ((cuts >> ear & 1U) == 0 || !meet_convexly(a, b, c, d)) continue;
      const double worst =
          std::max(pentagon.worst_cosine_without(ear), kernel::worst_squared_cosine(a, d, b, c));
      if (worst < best.worst) best = {worst, enter, met, ear};
    }
  }
}

bool QuickWalker::merge(TriangleId start, WalkQuads quads, std::size_t nodes) {
  start_ = start;
  quads_ = quads;
  if (!search(nodes)) return false;
  apply(goal_);
  mesh_.pair(met_);
  ++walks_;
  return true;
}

bool QuickWalker::merge_far(TriangleId start, std::span<const TriangleId> others,
                            std::size_t nodes) {
  start_ = start;
  if (!aim_at_nearest(others)) return false;
  const bool merged = merge(start, WalkQuads::kAny, nodes);
  cost_of_length_ = 0;
  return merged;
}

/// The nearest in the plane; what the way costs is guessed from the size of the triangle.
bool QuickWalker::aim_at_nearest(std::span<const TriangleId> others) {
  const Point from = centre(mesh_, start_);
  double nearest = HUGE_VAL;
  for (const TriangleId t : others) {
    if (t == start_ || !mesh_.is_free(t)) continue;
    const Point to = centre(mesh_, t);
    const double distance = std::hypot(to.x - from.x, to.y - from.y);
    if (!(distance < nearest)) continue;
    nearest = distance;
    aim_ = to;
  }
  const auto corner = [&](std::size_t i) {
    return mesh_.point(mesh_.tri.tri_vertex[3 * start_ + i]);
  };
  double size = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Point a = corner(i), b = corner((i + 1) % 3);
    size = std::max(size, std::hypot(b.x - a.x, b.y - a.y));
  }
  cost_of_length_ = kHop / size;
  return nearest < HUGE_VAL;
}

std::uint32_t QuickWalker::cost_to_aim(const Node& node) const {
  const Point a = mesh_.point(node.corner[0]), c = mesh_.point(node.corner[2]);
  const double x = a.x / 2 + c.x / 2 - aim_.x, y = a.y / 2 + c.y / 2 - aim_.y;
  const double cost = cost_of_length_ * std::sqrt(x * x + y * y);
  return cost < 1e6 ? static_cast<std::uint32_t>(cost) : 1'000'000;
}

bool QuickWalker::merge_after_slide(TriangleId start, std::size_t nodes) {
  for (HalfedgeId h = 3 * start; h < 3 * start + 3; ++h) {
    if (mesh_.tri.twin[h] == kNone || mesh_.is_free(triangle_of(mesh_.tri.twin[h]))) continue;
    start_ = start;
    for (std::size_t side = 0; side < 3; ++side) {
      if (try_slides(quad_behind(mesh_, mesh_.tri.twin[h]).side[side], nodes)) return true;
    }
  }
  return false;
}

bool QuickWalker::try_slides(HalfedgeId edge, std::size_t nodes) {
  const HalfedgeId beyond = mesh_.tri.twin[edge];
  if (beyond == kNone || mesh_.is_free(triangle_of(beyond))) return false;
  QuadPair pair = quad_pair_at(mesh_, edge);
  if (!pair.simple) return false;
  const auto convex = [&](std::size_t first) {
    const auto at = [&](std::size_t k) { return mesh_.point(pair.corner[(first + k) % 6]); };
    return classify_quad(at(0), at(1), at(2), at(3)) == QuadKind::kStrictlyConvex &&
           classify_quad(at(3), at(4), at(5), at(0)) == QuadKind::kStrictlyConvex;
  };
  if (!convex(0)) return false;
  for (const std::size_t first : {1U, 2U}) {
    if (!convex(first)) continue;
    part_anew(mesh_, pair, first);
    if (merge(start_, WalkQuads::kStrictlyConvex, nodes)) {
      if (on_recut) on_recut(pair.slot);
      return true;
    }
  }
  part_anew(mesh_, pair, 0);
  return false;
}

bool QuickWalker::search(std::size_t nodes) {
  search_of_.resize(mesh_.mate.size());
  ++searches_;
  nodes_.clear();
  bucket_.fill(kNone);
  cost_ = 0;
  waiting_ = 0;
  most_nodes_ = nodes;
  goal_ = kNone;
  goal_cost_ = kNone;
  const TriangleId t = start_;
  const auto& v = mesh_.tri.tri_vertex;
  Node first;
  first.corner = {v[3 * t], v[3 * t + 1], v[3 * t + 2]};
  first.exit = {3 * t, 3 * t + 1, 3 * t + 2};
  push(first);
  while (waiting_ > 0) {
    const std::uint32_t best = pop();
    if (goal_ != kNone && cost_ + kSlack >= goal_cost_) break;
    if (nodes_.size() < nodes) expand(best);
  }
  return goal_ != kNone;
}

std::uint32_t QuickWalker::pop() {
  while (bucket_[cost_ % kRing] == kNone) ++cost_;
  std::uint32_t& bucket = bucket_[cost_ % kRing];
  const std::uint32_t node = bucket;
  bucket = nodes_[node].next;
  --waiting_;
  return node;
}

void QuickWalker::expand(std::uint32_t from) {
  for (std::size_t i = 0; i < 3; ++i) {
    const HalfedgeId exit = nodes_[from].exit[i];
    const HalfedgeId enter = exit == kNone ? kNone : mesh_.tri.twin[exit];
    if (enter != kNone && !mesh_.is_free(triangle_of(enter))) try_ears(from, i);
  }
}

void QuickWalker::try_ears(std::uint32_t from, std::size_t i) {
  const Node node = nodes_[from];
  const HalfedgeId enter = mesh_.tri.twin[node.exit[i]];
  const QuadBehind quad = quad_behind(mesh_, enter);
  std::uint32_t& search = search_of_[std::min(quad.near, quad.far)];
  if (search == searches_) return;
  search = searches_;
  const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
  const Pentagon pentagon(mesh_, node.corner[i], node.corner[j], node.corner[k], quad);
  if (pentagon.wrapped()) return;
  const std::array<HalfedgeId, 5> side = {node.exit[j], node.exit[k], quad.side[0], quad.side[1],
                                          quad.side[2]};
  const auto cut = [&](std::size_t ear, std::uint32_t cost) {
    const std::size_t before = (ear + 4) % 5, after = (ear + 1) % 5;
    push({from,
          enter,
          {pentagon.corner[before], pentagon.corner[ear], pentagon.corner[after]},
          {side[before], side[ear], kNone},
          node.cost + cost,
          node.rank,
          kNone,
          static_cast<int>(ear)});
  };
  const PentagonTurns turns(pentagon.place);
  const std::uint32_t own_ear = 1U << 1;  // that is where the triangle is
  const std::uint32_t convex = turns.convex_cuts() & ~own_ear;
  for (std::uint32_t cuts = convex; cuts != 0; cuts &= cuts - 1) {
    const auto ear = static_cast<std::size_t>(std::countr_zero(cuts));
    cut(ear, convex_cost(pentagon.worst_cosine_without(ear)));
  }
  if (quads_ == WalkQuads::kStrictlyConvex) return;
  for (const std::size_t ear : {0U, 2U, 3U, 4U}) {
    if ((convex >> ear & 1U) != 0 || turns.at(ear) <= 0) continue;
    const QuadKind kind = turns.without(ear);
    if (kind != QuadKind::kNotSimple) cut(ear, kind == QuadKind::kFlatCorner ? kFlat : kReflex);
  }
}

void QuickWalker::push(const Node& node) {
  const auto made = static_cast<std::uint32_t>(nodes_.size());
  nodes_.push_back(node);
  std::uint32_t& rank = nodes_[made].rank;
  rank = cost_of_length_ > 0 ? std::clamp(node.cost + cost_to_aim(node), rank, rank + kRing - 1)
                             : node.cost;
  std::uint32_t& bucket = bucket_[rank % kRing];
  nodes_[made].next = bucket;
  bucket = made;
  ++waiting_;
  try_goals(made);
}

/// Whether the node's triangle and a free one beside it make a quad.
void QuickWalker::try_goals(std::uint32_t from) {
  const Node& node = nodes_[from];
  for (std::size_t i = 0; i < 3; ++i) {
    const HalfedgeId enter = node.exit[i] == kNone ? kNone : mesh_.tri.twin[node.exit[i]];
    if (enter == kNone || !mesh_.is_free(triangle_of(enter)) || triangle_of(enter) == start_) {
      continue;
    }
    const Point a = mesh_.point(node.corner[i]), b = mesh_.point(node.corner[(i + 1) % 3]);
    const Point c = mesh_.point(node.corner[(i + 2) % 3]), d = mesh_.point(mesh_.tri.apex(enter));
    std::uint32_t cost = node.cost;
    if (meet_convexly(a, b, c, d)) {
      cost += convex_cost(kernel::worst_squared_cosine(a, d, b, c));
    } else if (quads_ == WalkQuads::kStrictlyConvex) {
      continue;
    } else {
      cost += classify_quad(a, d, b, c) == QuadKind::kFlatCorner ? kFlat : kReflex;
    }
    if (cost >= goal_cost_) continue;
    goal_cost_ = cost;
    goal_ = from;
    met_ = enter;
  }
}

void QuickWalker::step(HalfedgeId enter, int ear) {
  const auto touched = recut_pentagon(mesh_, enter, ear);
  ++steps_;
  if (on_recut) on_recut(touched);
}

void QuickWalker::apply(std::uint32_t end) {
  // Turned around, the parents lead from the start to the end.
  std::uint32_t after = kNone;
  while (end != kNone) {
    const std::uint32_t before = nodes_[end].parent;
    nodes_[end].parent = after;
    after = end;
    end = before;
  }
  for (std::uint32_t at = nodes_[after].parent; at != kNone; at = nodes_[at].parent) {
    step(nodes_[at].enter, nodes_[at].ear);
  }
}

}  // namespace quadloom::quadrangulate
