// The search is breadth first by the number of points (steps over quads cost none), each quad is
// entered once, so a way never crosses its own trace. Cost of a search: O(quads that it sees).
#include "quadrangulate/steiner_crossing.hpp"

#include <algorithm>

#include "quadrangulate/inner_place.hpp"

namespace quadloom::quadrangulate {

bool SteinerCrossing::merge(TriangleId start) {
  const End end = search({&start, 1}, nullptr);
  if (end.node == kNone) return false;
  const HalfedgeId met = end.last;
  apply(end);
  mesh_.pair(met);
  return true;
}

HalfedgeId SteinerCrossing::reach_border(std::span<const TriangleId> starts, const EdgeGoal& goal) {
  const End end = search(starts, &goal);
  return end.node == kNone ? kNone : apply(end);
}

SteinerCrossing::End SteinerCrossing::search(std::span<const TriangleId> starts,
                                             const EdgeGoal* goal) {
  full_.resize(mesh_.mate.size());
  search_of_.resize(mesh_.mate.size());
  ++searches_;
  nodes_.clear();
  now_.clear();
  later_.clear();
  for (const TriangleId t : starts) {
    search_of_[t] = searches_;
    now_.push_back(static_cast<std::uint32_t>(nodes_.size()));
    nodes_.push_back({kNone, kNone, kNone, t, Step::kStart});
  }
  while (!now_.empty()) {
    for (std::size_t i = 0; i < now_.size(); ++i) {  // grows by steps that cost nothing
      const std::uint32_t at = now_[i];
      const Node node = nodes_[at];
      const HalfedgeId first = node.triangle == kNone ? node.exit : 3 * node.triangle;
      const HalfedgeId last = node.triangle == kNone ? node.exit : first + 2;
      for (HalfedgeId exit = first; exit <= last; ++exit) {
        const HalfedgeId enter = mesh_.tri.twin[exit];
        if (enter == kNone) {
          if (goal && (*goal)(mesh_.tri.origin(exit), mesh_.tri.target(exit)) && can_apply(at)) {
            return {at, exit};
          }
          continue;
        }
        const TriangleId t = triangle_of(enter);
        if (search_of_[t] == searches_) continue;
        if (!mesh_.is_free(t)) {
          pass(at, enter);
        } else if (!goal && can_apply(at) &&
                   (node.triangle == kNone || mesh_.tri.apex(enter) != mesh_.tri.apex(exit))) {
          return {at, enter};
        }
      }
    }
    now_.swap(later_);
    later_.clear();
  }
  return {};
}

/// All ways to pass a quad that is seen for the first time.
void SteinerCrossing::pass(std::uint32_t from, HalfedgeId enter) {
  const QuadBehind quad = quad_behind(mesh_, enter);
  search_of_[quad.near] = searches_;
  search_of_[quad.far] = searches_;
  const HalfedgeId exit = mesh_.tri.twin[enter];
  const bool same_corners =
      nodes_[from].triangle != kNone && mesh_.tri.apex(enter) == mesh_.tri.apex(exit);
  if (!same_corners) {
    now_.push_back(static_cast<std::uint32_t>(nodes_.size()));
    nodes_.push_back({from, enter, kNone, quad.far, Step::kOver});
  }
  for (const HalfedgeId side : quad.side) {
    Node node{from, enter, side, kNone, Step::kAcross};
    if (full_[split_by(node)] != 0) continue;
    later_.push_back(static_cast<std::uint32_t>(nodes_.size()));
    nodes_.push_back(node);
  }
}

TriangleId SteinerCrossing::split_by(const Node& node) const { return triangle_of(node.exit); }

/// Whether each triangle that the way splits has a double inside; one that has none is closed to
/// later searches.
bool SteinerCrossing::can_apply(std::uint32_t end) {
  bool all = true;
  for (std::uint32_t at = end; at != kNone; at = nodes_[at].parent) {
    if (nodes_[at].step != Step::kAcross) continue;
    const TriangleId t = split_by(nodes_[at]);
    const VertexId* v = &mesh_.tri.tri_vertex[std::size_t{3} * t];
    if (place_in_face(mesh_.places(), v[0], v[1], v[2])) continue;
    full_[t] = 1;
    all = false;
  }
  return all;
}

/// Takes the steps to the end; returns `end.last`, by its new name if the last step has renamed it.
HalfedgeId SteinerCrossing::apply(const End& end) {
  std::vector<Node> way;
  for (std::uint32_t at = end.node; at != kNone; at = nodes_[at].parent) way.push_back(nodes_[at]);
  HalfedgeId last = end.last;
  for (auto step = way.rbegin(); step != way.rend(); ++step) {
    if (step->step == Step::kOver) over(step->enter);
    if (step->step == Step::kAcross) {
      const HalfedgeId renamed = across(step->enter, step->exit);
      if (step->exit == end.last) last = renamed;
    }
  }
  return last;
}

void SteinerCrossing::over(HalfedgeId enter) {
  mesh_.unpair(triangle_of(enter));
  mesh_.pair(enter);
}

/// Leaves the triangle at the exit free; returns its halfedge there.
HalfedgeId SteinerCrossing::across(HalfedgeId enter, HalfedgeId exit) {
  const TriangleId near = triangle_of(enter), t = triangle_of(exit);
  const HalfedgeId diagonal = mesh_.mate[t];
  mesh_.unpair(near);
  const bool in_near = t == near;
  if (!in_near) mesh_.pair(enter);
  const std::array<TriangleId, 3> part = split(t);
  const auto outer = [&](HalfedgeId h) { return 3 * part[h % 3]; };
  if (in_near) {
    mesh_.pair(outer(enter));
    mesh_.pair(outer(diagonal));
  } else {
    // The third side and the diagonal have a corner in common, and so an edge from there to s.
    const bool exit_follows = exit == next_halfedge(diagonal);
    mesh_.pair(outer(diagonal) + (exit_follows ? 2 : 1));
  }
  return outer(exit);
}

/// A new vertex inside t makes three free triangles of it; part i has the edge i of t first.
///
///          c
///        / | .
///       /  s  .        (a, b, s), (b, c, s), (c, a, s)
///      / .   . .
///     a ------- b
std::array<TriangleId, 3> SteinerCrossing::split(TriangleId t) {
  std::array<VertexId, 3> v;
  std::array<HalfedgeId, 3> beyond;
  for (HalfedgeId i = 0; i < 3; ++i) {
    v[i] = mesh_.tri.tri_vertex[3 * t + i];
    beyond[i] = mesh_.tri.twin[3 * t + i];
  }
  const VertexId s = add_vertex(mesh_, *place_in_face(mesh_.places(), v[0], v[1], v[2]));
  points_.push_back({s, SteinerKind::kInner, v});
  const std::array<TriangleId, 3> part = {t, add_triangle(mesh_, t), add_triangle(mesh_, t)};
  for (std::size_t i = 0; i < 3; ++i) {
    mesh_.set_triangle(part[i], v[i], v[(i + 1) % 3], s);
    mesh_.link(3 * part[i], beyond[i]);
    mesh_.link(3 * part[i] + 1, 3 * part[(i + 1) % 3] + 2);
  }
  return part;
}

}  // namespace quadloom::quadrangulate
