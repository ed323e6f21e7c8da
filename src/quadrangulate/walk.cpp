#include "quadrangulate/walk.hpp"

#include <algorithm>
#include <cmath>

#include "kernel/predicates_inline.hpp"
#include "kernel/squareness.hpp"
#include "quadrangulate/pentagon.hpp"

namespace quadloom::quadrangulate {
namespace {

constexpr std::uint32_t kForbidden = 0xffffffffU;

// A quad left behind costs a step and its lack of shape; one that is not strictly convex as much as
// a detour of some ten good ones.
std::uint32_t quad_cost(QuadKind kind, Point a, Point b, Point c, Point d, WalkQuads allowed) {
  switch (kind) {
    case QuadKind::kStrictlyConvex:
      return 2 + static_cast<std::uint32_t>(8 * (1 - kernel::squareness(a, b, c, d)));
    case QuadKind::kFlatCorner:
      return allowed == WalkQuads::kAny ? 60 : kForbidden;
    case QuadKind::kNonConvex:
      return allowed == WalkQuads::kAny ? 80 : kForbidden;
    case QuadKind::kNotSimple:
      break;
  }
  return kForbidden;
}

constexpr std::uint32_t kWheelCost = 80;  // its quad has a reflex corner

}  // namespace

bool Walker::merge(TriangleId start, const WalkLimits& limits) {
  const std::uint32_t end = search({&start, 1}, nullptr, limits);
  if (end == kNone) return false;
  const HalfedgeId met = nodes_[end].enter;
  apply(end);
  mesh_.pair(met);
  return true;
}

HalfedgeId Walker::reach_boundary(std::span<const TriangleId> starts, const BoundaryGoal& goal,
                                  const WalkLimits& limits) {
  const std::uint32_t end = search(starts, &goal, limits);
  if (end == kNone) return kNone;
  const VertexId a = nodes_[end].corner[0], b = nodes_[end].corner[1];
  const TriangleId t = apply(end);
  for (HalfedgeId h = 3 * t; h < 3 * t + 3; ++h) {
    if (mesh_.tri.origin(h) == a && mesh_.tri.target(h) == b) return h;
  }
  return kNone;
}

std::uint32_t Walker::search(std::span<const TriangleId> starts, const BoundaryGoal* boundary,
                             const WalkLimits& limits) {
  nodes_.clear();
  queue_.clear();
  ++searches_;
  visits_.resize(mesh_.mate.size());
  for (const TriangleId t : starts) {
    visits_[t] = {searches_};
    const auto& v = mesh_.tri.tri_vertex;
    push(0, {kNone, kNone, {v[3 * t], v[3 * t + 1], v[3 * t + 2]}, {3 * t, 3 * t + 1, 3 * t + 2}});
  }
  for (std::uint32_t best; (best = queue_.pop()) != kNone;) {
    const Node& node = nodes_[best];
    if (node.goal && boundary && !boundary->accept(node.corner[0], node.corner[1])) continue;
    if (node.goal) return best;
    if (nodes_.size() < limits.nodes) expand(best, boundary, limits);
  }
  return kNone;
}

void Walker::expand(std::uint32_t from, const BoundaryGoal* boundary, const WalkLimits& limits) {
  for (std::size_t i = 0; i < 3; ++i) {
    const HalfedgeId exit = nodes_[from].exit[i];
    if (exit == kNone) continue;
    const HalfedgeId enter = mesh_.tri.twin[exit];
    if (enter == kNone) {
      if (boundary) try_boundary(from, i, *boundary);
    } else if (mesh_.is_free(triangle_of(enter))) {
      if (!boundary) try_goal(from, i, limits);
    } else {
      try_ears(from, i, limits);
    }
  }
}

void Walker::try_boundary(std::uint32_t from, std::size_t i, const BoundaryGoal& boundary) {
  const auto [a, b, c] = std::array{nodes_[from].corner[i], nodes_[from].corner[(i + 1) % 3],
                                    nodes_[from].corner[(i + 2) % 3]};
  const int cost = boundary.cost(a, b, c);
  if (cost < 0) return;
  Node goal{from, kNone, {a, b, c}, {kNone, kNone, kNone}};
  goal.goal = true;
  push(static_cast<std::uint32_t>(cost), goal);
}

void Walker::try_goal(std::uint32_t from, std::size_t i, const WalkLimits& limits) {
  const Node& node = nodes_[from];
  const HalfedgeId enter = mesh_.tri.twin[node.exit[i]];
  if (visits_[triangle_of(enter)].search == searches_) return;  // the start itself
  const VertexId apex = mesh_.tri.apex(enter);
  const TriangleId other = triangle_of(enter);
  kernel::Chart chart;
  if (!mesh_.planar()) {
    if (apex == node.corner[(i + 2) % 3]) return;  // both have the same three corners
    if (!flat_enough(node, {&other, 1}, limits.least_cosine, chart)) return;
  }
  const auto seen = [&](VertexId v) { return mesh_.places().seen(chart, v); };
  const Point a = seen(node.corner[i]), b = seen(node.corner[(i + 1) % 3]);
  const Point c = seen(node.corner[(i + 2) % 3]), d = seen(apex);
  const std::uint32_t cost = quad_cost(classify_quad(a, d, b, c), a, d, b, c, limits.quads);
  if (cost == kForbidden) return;
  Node goal{from, enter, node.corner, {kNone, kNone, kNone}};
  goal.goal = true;
  push(cost, goal);
}

void Walker::try_ears(std::uint32_t from, std::size_t i, const WalkLimits& limits) {
  const Node node = nodes_[from];
  const HalfedgeId enter = mesh_.tri.twin[node.exit[i]];
  const QuadBehind quad = quad_behind(mesh_, enter);
  if (!may_visit(from, std::min(quad.near, quad.far), limits.visits)) return;

  const VertexId a = node.corner[i], b = node.corner[(i + 1) % 3], c = node.corner[(i + 2) % 3];
  const std::array<VertexId, 5> corner = {b, c, a, mesh_.tri.origin(quad.side[1]),
                                          mesh_.tri.origin(quad.side[2])};
  if (c == corner[3] || c == corner[4]) {
    // Across an edge that must stay the three triangles do not hang together.
    const bool about_b = c == corner[4];
    const HalfedgeId spoke = node.exit[(i + (about_b ? 1U : 2U)) % 3];
    const bool whole = spoke != kNone && mesh_.tri.twin[spoke] == quad.side[about_b ? 2 : 0];
    if (whole && limits.quads == WalkQuads::kAny) try_wheel(from, enter, quad, about_b ? b : a);
    return;
  }
  const std::array<HalfedgeId, 5> side = {node.exit[(i + 1) % 3], node.exit[(i + 2) % 3],
                                          quad.side[0], quad.side[1], quad.side[2]};
  kernel::Chart chart;
  const std::array<TriangleId, 2> both = {quad.near, quad.far};
  if (!mesh_.planar() && !flat_enough(node, both, limits.least_cosine, chart)) return;
  std::array<Point, 5> p;
  for (std::size_t k = 0; k < 5; ++k) p[k] = mesh_.places().seen(chart, corner[k]);
  const PentagonTurns turns(p);
  for (const std::size_t ear : {0U, 2U, 3U, 4U}) {
    const std::size_t before = (ear + 4) % 5, after = (ear + 1) % 5;
    if (turns.at(ear) <= 0) continue;
    const std::uint32_t cost = quad_cost(turns.without(ear), p[after], p[(ear + 2) % 5],
                                         p[(ear + 3) % 5], p[before], limits.quads);
    if (cost == kForbidden) continue;
    push(cost, {from,
                enter,
                {corner[before], corner[ear], corner[after]},
                {side[before], side[ear], kNone},
                static_cast<std::int8_t>(ear)});
  }
}

/// Whether the node's triangle and the others are seen from their left sides in one chart, which is
/// then set, and their normals are near each other.
bool Walker::flat_enough(const Node& node, std::span<const TriangleId> others, double least_cosine,
                         kernel::Chart& chart) const {
  std::array<kernel::Vector3, 3> area = {
      mesh_.area(node.corner[0], node.corner[1], node.corner[2])};
  kernel::Vector3 sum = area[0];
  for (std::size_t i = 0; i < others.size(); ++i) {
    area[i + 1] = mesh_.area(others[i]);
    sum = sum + area[i + 1];
  }
  for (std::size_t i = 0; i <= others.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double lengths = std::sqrt(dot(area[i], area[i]) * dot(area[j], area[j]));
      if (!(dot(area[i], area[j]) >= least_cosine * lengths)) return false;
    }
  }
  chart = kernel::Chart(sum);
  const auto turns_left = [&](VertexId a, VertexId b, VertexId c) {
    const kernel::Places places = mesh_.places();
    return kernel::orient(places.seen(chart, a), places.seen(chart, b), places.seen(chart, c)) > 0;
  };
  if (!turns_left(node.corner[0], node.corner[1], node.corner[2])) return false;
  for (const TriangleId t : others) {
    const VertexId* v = &mesh_.tri.tri_vertex[std::size_t{3} * t];
    if (!turns_left(v[0], v[1], v[2])) return false;
  }
  return true;
}

//        r            The quad b, a, d, e has its corner e or d at the free triangle's third
//        corner: all three
//      / | .          triangles meet in b or a, the centre z, and each has one edge of the rim.
//     /  z  .
//    / .   . .
//   s ------- t
void Walker::try_wheel(std::uint32_t from, HalfedgeId enter, const QuadBehind& quad,
                       VertexId centre) {
  for (std::size_t k = 0; k < 3; ++k) {
    const HalfedgeId rim = quad.side[k];
    const VertexId s = mesh_.tri.origin(rim), t = mesh_.tri.target(rim);
    if (s == centre || t == centre) continue;
    push(kWheelCost, {from,
                      enter,
                      {s, t, centre},
                      {rim, kNone, kNone},
                      static_cast<std::int8_t>(kWheel + 2 + static_cast<int>(k))});
  }
}

bool Walker::may_visit(std::uint32_t node, TriangleId t, std::uint8_t most) {
  Visits& visits = visits_[t];
  if (visits.search != searches_) visits = {searches_};
  if (visits.count >= most) return false;
  const std::uint32_t depth = nodes_[node].depth + 1;  // of this visit
  // A second route may pass, but no route passes twice: its first pass has re-cut the quad. Before the first visit of
  // all there is nothing to look for; without that, long corridors would take quadratic time.
  for (; visits.count > 0 && nodes_[node].depth >= visits.least_depth; node = nodes_[node].parent) {
    const QuadBehind passed = quad_behind(mesh_, nodes_[node].enter);
    if (std::min(passed.near, passed.far) == t) return false;
  }
  visits.least_depth = std::min<std::uint32_t>(visits.least_depth, depth) & Visits::kDeepest;
  ++visits.count;
  return true;
}

void Walker::push(std::uint32_t move_cost, const Node& node) {
  queue_.push(queue_.cost() + move_cost, static_cast<std::uint32_t>(nodes_.size()));
  nodes_.push_back(node);
  if (node.parent != kNone) nodes_.back().depth = nodes_[node.parent].depth + 1;
}

void Walker::Queue::clear() {
  for (std::uint32_t c = cost_; size_ > 0; ++c) {
    size_ -= bucket_[c % kRing].size();
    bucket_[c % kRing].clear();
  }
  cost_ = 0;
}

void Walker::Queue::push(std::uint32_t cost, std::uint32_t node) {
  bucket_[cost % kRing].push_back(node);
  ++size_;
}

std::uint32_t Walker::Queue::pop() {
  if (size_ == 0) return kNone;
  while (bucket_[cost_ % kRing].empty()) ++cost_;
  const std::uint32_t node = bucket_[cost_ % kRing].back();
  bucket_[cost_ % kRing].pop_back();
  --size_;
  return node;
}

TriangleId Walker::apply(std::uint32_t end) {
  std::vector<std::uint32_t> way;
  std::uint32_t at = nodes_[end].goal ? nodes_[end].parent : end;
  for (; nodes_[at].enter != kNone; at = nodes_[at].parent) way.push_back(at);
  TriangleId free = triangle_of(nodes_[at].exit[0]);
  for (; !way.empty(); way.pop_back()) {
    const Node& step = nodes_[way.back()];
    const auto touched = recut_pentagon(mesh_, step.enter, step.ear);
    free = touched[0];
    ++steps_;
    if (on_recut) on_recut(touched);
  }
  ++walks_;
  return free;
}

}  // namespace quadloom::quadrangulate
