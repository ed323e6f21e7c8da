// Walks found by cheap searches: most left-over triangles of a matching are near each other.
//
// merge_over_quad: all walks of one step, by adjacency first (is there a free triangle at one of the
// pentagon's sides), geometry only where there is.
//
// merge:
//   1. search      Dijkstra over moves as in walk.cpp, with costs in buckets that are lists of nodes
//   2. try_ears    five rounded turns at the triangle's far corner tell, without branches, which ears may leave a
//                  strictly convex quad; these alone are judged exactly, the others only if any quad will do
//   3. try_goal    a node that is next to a free triangle ends the search when it is made, not when it is
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
constexpr std::uint32_t kSlack = 24;       // what a better walk may save without being looked for
constexpr double kHop = 12;                // what a quad on the way to the aim is thought to cost
constexpr std::size_t kLookAhead = 1'000;  // triangles among which the nearest is aimed at
constexpr double kNoWalk = 2;              // worse than any squared cosine

std::uint32_t convex_cost(double worst) {
  return kStep + (worst < 1 ? static_cast<std::uint32_t>(kShape * worst)
                            : static_cast<std::uint32_t>(kShape));
}

/// What there is at each corner of a pentagon, around it and nearly around once more, so that sums of indices need no
/// remainder.
template <typename T>
class Around {
 public:
  Around(T a, T b, T c, T d, T e) : at_{a, b, c, d, e, a, b, c, d} {}
  const T& operator[](std::size_t k) const { return at_[k]; }

 private:
  T at_[9];
};

/// The pentagon of a free triangle and the quad behind its side a->b, as in paired_mesh.hpp.
struct Pentagon {
  Around<VertexId> corner;
  Around<Point> place;

  template <class Mesh, class Quad>
  Pentagon(const Mesh& mesh, VertexId a, VertexId b, VertexId c, const Quad& quad)
      : corner{b, c, a, mesh.origin(quad.side[1]), mesh.origin(quad.side[2])},
        place{mesh.point(b), mesh.point(c), mesh.point(a), mesh.point(corner[3]),
              mesh.point(corner[4])} {}
  bool wrapped() const { return corner[1] == corner[3] || corner[1] == corner[4]; }
  kernel::QuadEdges without(std::size_t ear) const {
    return {place[ear + 1], place[ear + 2], place[ear + 3], place[ear + 4]};
  }
  bool convex_without(std::size_t ear) const {
    return classify_quad(place[ear + 1], place[ear + 2], place[ear + 3], place[ear + 4]) ==
           QuadKind::kStrictlyConvex;
  }
  PentagonTurns turns() const {
    return PentagonTurns({place[0], place[1], place[2], place[3], place[4]});
  }
  /// The ears that may leave a strictly convex quad if the quad is one, as bits, judged by rounded turns at c alone:
  /// where b, c, a turn, and on which sides of the diagonals of the quad c is.
  std::uint32_t likely_convex_cuts() const {
    const Point &b = place[0], &c = place[1], &a = place[2], &d = place[3], &e = place[4];
    const double ax = a.x - c.x, ay = a.y - c.y, bx = b.x - c.x, by = b.y - c.y;
    const double dx = d.x - c.x, dy = d.y - c.y, ex = e.x - c.x, ey = e.y - c.y;
    const auto left = [](double p, double q) { return p - q <= 0 ? 0U : 1U; };  // true if unknown
    const std::uint32_t at_b = left(ex * by, ey * bx), at_a = left(ax * dy, ay * dx);
    const std::uint32_t cde = left(dx * ey, dy * ex), bcd = left(dx * by, dy * bx);
    const std::uint32_t cae = left(ax * ey, ay * ex);
    const std::uint32_t both = at_a & at_b & cde;
    return (both & cae) | (both & bcd) << 2 | (at_b & cae) << 3 | (at_a & bcd) << 4;
  }
  /// Of the quad that is left without an ear.
  double worst_cosine_without(std::size_t ear) const { return without(ear).worst_squared_cosine(); }
};

template <class Mesh>
std::array<Point, 3> corners_of_free(const Mesh& mesh, std::uint32_t t) {
  std::array<Point, 3> p;
  for (std::size_t i = 0; i < 3; ++i) p[i] = mesh.point(mesh.origin(Mesh::sides_of_free(t)[i]));
  return p;
}

Point centre(const std::array<Point, 3>& p) {
  return {p[0].x / 3 + p[1].x / 3 + p[2].x / 3, p[0].y / 3 + p[1].y / 3 + p[2].y / 3};
}

bool meet_convexly(Point a, Point b, Point c, Point d) {
  return kernel::orient(c, a, d) > 0 && kernel::orient(d, b, c) > 0;
}

}  // namespace

template <class Mesh>
bool QuickWalker<Mesh>::may_change(std::uint32_t face) {
  const bool may = mesh_.may_change(face, range_);
  met_border_ = met_border_ || !may;
  return may;
}

template <class Mesh>
bool QuickWalker<Mesh>::merge_over_quad(TriangleId start) {
  if (!may_change(start)) return false;
  start_ = start;
  OverQuad best{kNoWalk};
  for (const HalfedgeId h : Mesh::sides_of_free(start)) try_over(h, best);
  if (best.met == kNone) return false;
  step(best.enter, static_cast<int>(best.ear));
  mesh_.pair(best.met);
  ++walks_;
  return true;
}

template <class Mesh>
void QuickWalker<Mesh>::try_over(HalfedgeId exit, OverQuad& best) {
  const HalfedgeId enter = mesh_.twin(exit);
  if (enter == kNone || mesh_.is_free(Mesh::face_of(enter))) return;
  const auto quad = quad_behind(mesh_, enter);
  if (!may_change(quad.name())) return;
  for (std::size_t side = 0; side < 3; ++side) {
    const HalfedgeId met = mesh_.twin(quad.side[side]);
    if (met == kNone || !mesh_.is_free(Mesh::face_of(met)) || Mesh::face_of(met) == start_)
      continue;
    if (!may_change(Mesh::face_of(met))) continue;
    const Pentagon pentagon(mesh_, mesh_.origin(exit), mesh_.origin(enter), mesh_.apex(exit), quad);
    if (pentagon.wrapped()) return;
    // The edge to the free triangle goes from corner k to the next; one of the two is the ear.
    const std::size_t k = side + 2;
    const Point a = pentagon.place[k], b = pentagon.place[k + 1], d = mesh_.point(mesh_.apex(met));
    const std::uint32_t cuts = pentagon.turns().convex_cuts();
    for (const std::size_t ear : {k, (k + 1) % 5}) {
      const Point c = pentagon.place[ear == k ? k + 4 : k + 2];
      if ((cuts >> ear & 1U) == 0 || !meet_convexly(a, b, c, d)) continue;
      const double worst =
          std::max(pentagon.worst_cosine_without(ear), kernel::worst_squared_cosine(a, d, b, c));
      if (worst < best.worst) best = {worst, enter, met, ear};
    }
  }
}

template <class Mesh>
bool QuickWalker<Mesh>::merge(TriangleId start, WalkQuads quads, std::size_t nodes) {
  start_ = start;
  quads_ = quads;
  if (!may_change(start) || !search(nodes)) return false;
  apply(goal_);
  mesh_.pair(met_);
  ++walks_;
  return true;
}

template <class Mesh>
void QuickWalker<Mesh>::merge_far(std::span<const std::uint32_t> triangles, std::size_t nodes) {
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    start_ = triangles[i];
    const std::size_t ahead = std::min(kLookAhead, triangles.size() - i - 1);
    if (!mesh_.is_free(start_) || !aim_at_nearest(triangles.subspan(i + 1, ahead))) continue;
    merge(start_, WalkQuads::kAny, nodes);
    cost_of_length_ = 0;
  }
}

/// The nearest in the plane; what the way costs is guessed from the size of the triangle.
template <class Mesh>
bool QuickWalker<Mesh>::aim_at_nearest(std::span<const TriangleId> others) {
  const Point from = centre(corners_of_free(mesh_, start_));
  double nearest = HUGE_VAL;
  for (const TriangleId t : others) {
    if (t == start_ || !mesh_.is_free(t)) continue;
    const Point to = centre(corners_of_free(mesh_, t));
    const double distance = std::hypot(to.x - from.x, to.y - from.y);
    if (!(distance < nearest)) continue;
    nearest = distance;
    aim_ = to;
  }
  const std::array<Point, 3> corner = corners_of_free(mesh_, start_);
  double size = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Point a = corner[i], b = corner[(i + 1) % 3];
    size = std::max(size, std::hypot(b.x - a.x, b.y - a.y));
  }
  cost_of_length_ = kHop / size;
  return nearest < HUGE_VAL;
}

template <class Mesh>
std::uint32_t QuickWalker<Mesh>::cost_to_aim(const Node& node) const {
  const Point a = mesh_.point(node.corner[0]), c = mesh_.point(node.corner[2]);
  const double x = a.x / 2 + c.x / 2 - aim_.x, y = a.y / 2 + c.y / 2 - aim_.y;
  const double cost = cost_of_length_ * std::sqrt(x * x + y * y);
  return cost < 1e6 ? static_cast<std::uint32_t>(cost) : 1'000'000;
}

template <class Mesh>
bool QuickWalker<Mesh>::merge_after_slide(TriangleId start, std::size_t nodes) {
  if (!may_change(start)) return false;
  for (const HalfedgeId h : Mesh::sides_of_free(start)) {
    if (mesh_.twin(h) == kNone || mesh_.is_free(Mesh::face_of(mesh_.twin(h)))) continue;
    start_ = start;
    for (std::size_t side = 0; side < 3; ++side) {
      if (try_slides(quad_behind(mesh_, mesh_.twin(h)).side[side], nodes)) return true;
    }
  }
  return false;
}

template <class Mesh>
bool QuickWalker<Mesh>::try_slides(HalfedgeId edge, std::size_t nodes) {
  const HalfedgeId beyond = mesh_.twin(edge);
  if (beyond == kNone || mesh_.is_free(Mesh::face_of(beyond))) return false;
  if (!may_change(Mesh::face_of(edge)) || !may_change(Mesh::face_of(beyond))) return false;
  auto pair = quad_pair_at(mesh_, edge);
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

template <class Mesh>
bool QuickWalker<Mesh>::search(std::size_t nodes) {
  search_of_.resize(range_.size(mesh_.face_count()));
  ++searches_;
  nodes_.clear();
  bucket_.fill(kNone);
  cost_ = 0;
  waiting_ = 0;
  most_nodes_ = nodes;
  goal_ = kNone;
  goal_cost_ = kNone;
  Node first;
  for (std::size_t i = 0; i < 3; ++i) {
    const HalfedgeId side = Mesh::sides_of_free(start_)[i];
    first.corner[i] = mesh_.origin(side);
    first.beyond[i] = mesh_.twin(side);
  }
  push(first);
  while (waiting_ > 0) {
    const std::uint32_t best = pop();
    if (goal_ != kNone && cost_ + kSlack >= goal_cost_) break;
    if (nodes_.size() < nodes) expand(best);
  }
  return goal_ != kNone;
}

template <class Mesh>
std::uint32_t QuickWalker<Mesh>::pop() {
  while (bucket_[cost_ % kRing] == kNone) ++cost_;
  std::uint32_t& bucket = bucket_[cost_ % kRing];
  const std::uint32_t node = bucket;
  bucket = nodes_[node].next;
  --waiting_;
  return node;
}

template <class Mesh>
void QuickWalker<Mesh>::expand(std::uint32_t from) {
  for (std::size_t i = 0; i < 3; ++i) {
    const HalfedgeId enter = nodes_[from].beyond[i];
    if (enter == kNone || mesh_.is_free(Mesh::face_of(enter))) continue;
    const std::uint32_t quad = quad_behind(mesh_, enter).name();
    std::uint32_t& search = search_of_[quad - range_.begin];
    if (search == searches_) continue;
    search = searches_;
    if (may_change(quad)) try_ears(from, i);
  }
}

template <class Mesh>
void QuickWalker<Mesh>::try_ears(std::uint32_t from, std::size_t i) {
  const Node node = nodes_[from];
  const HalfedgeId enter = node.beyond[i];
  const auto quad = quad_behind(mesh_, enter);
  const std::size_t j = i == 2 ? 0 : i + 1, k = i == 0 ? 2 : i - 1;
  const Pentagon pentagon(mesh_, node.corner[i], node.corner[j], node.corner[k], quad);
  if (pentagon.wrapped()) return;
  const Around<HalfedgeId> beyond = {node.beyond[j], node.beyond[k], mesh_.twin(quad.side[0]),
                                     mesh_.twin(quad.side[1]), mesh_.twin(quad.side[2])};
  const auto cut = [&](std::size_t ear, std::uint32_t cost) {
    const Node made = {from,
                       enter,
                       {pentagon.corner[ear + 4], pentagon.corner[ear], pentagon.corner[ear + 1]},
                       {beyond[ear + 4], beyond[ear], kNone},
                       node.cost + cost,
                       node.rank,
                       kNone,
                       static_cast<int>(ear)};
    push(made);
  };
  std::uint32_t tried = 1U << 1;  // that is where the triangle is
  // A quad that is not strictly convex, or a rounded turn, may mislead here: hence the exact tests.
  for (std::uint32_t ears = pentagon.likely_convex_cuts(); ears != 0; ears &= ears - 1) {
    const auto ear = static_cast<std::size_t>(std::countr_zero(ears));
    const kernel::QuadEdges left = pentagon.without(ear);
    if (!left.proven_convex() && !pentagon.convex_without(ear)) continue;
    const auto& place = pentagon.place;
    if (kernel::orient(place[ear + 4], place[ear], place[ear + 1]) <= 0) continue;
    tried |= 1U << ear;
    cut(ear, convex_cost(left.worst_squared_cosine()));
  }
  if (quads_ == WalkQuads::kStrictlyConvex) return;
  const PentagonTurns turns = pentagon.turns();
  for (const std::size_t ear : {0U, 2U, 3U, 4U}) {
    if ((tried >> ear & 1U) != 0 || turns.at(ear) <= 0) continue;
    const QuadKind kind = turns.without(ear);
    if (kind == QuadKind::kNotSimple) continue;
    cut(ear, kind == QuadKind::kFlatCorner ? kFlat
             : kind == QuadKind::kNonConvex
                 ? kReflex
                 : convex_cost(pentagon.without(ear).worst_squared_cosine()));
  }
}

/// A node of which both sides that are not cut lead nowhere new is left out.
template <class Mesh>
void QuickWalker<Mesh>::push(const Node& node) {
  std::array<bool, 3> meets{};
  bool leads_on = false;
  for (std::size_t i = 0; i < 3; ++i) {
    const HalfedgeId enter = node.beyond[i];
    if (enter == kNone) continue;
    meets[i] = mesh_.is_free(Mesh::face_of(enter));
    leads_on = leads_on || meets[i] ||
               search_of_[quad_behind(mesh_, enter).name() - range_.begin] != searches_;
  }
  if (!leads_on) return;
  const auto made = static_cast<std::uint32_t>(nodes_.size());
  nodes_.push_back(node);
  std::uint32_t& rank = nodes_[made].rank;
  rank = cost_of_length_ > 0 ? std::clamp(node.cost + cost_to_aim(node), rank, rank + kRing - 1)
                             : node.cost;
  std::uint32_t& bucket = bucket_[rank % kRing];
  nodes_[made].next = bucket;
  bucket = made;
  ++waiting_;
  for (std::size_t i = 0; i < 3; ++i) {
    if (meets[i]) try_goal(made, i);
  }
}

/// Whether the node's triangle and the free one beyond its side i make a quad.
template <class Mesh>
void QuickWalker<Mesh>::try_goal(std::uint32_t from, std::size_t i) {
  const Node& node = nodes_[from];
  const HalfedgeId enter = node.beyond[i];
  if (Mesh::face_of(enter) == start_ || !may_change(Mesh::face_of(enter))) return;
  const Point a = mesh_.point(node.corner[i]), b = mesh_.point(node.corner[(i + 1) % 3]);
  const Point c = mesh_.point(node.corner[(i + 2) % 3]), d = mesh_.point(mesh_.apex(enter));
  std::uint32_t cost = node.cost;
  if (meet_convexly(a, b, c, d)) {
    cost += convex_cost(kernel::worst_squared_cosine(a, d, b, c));
  } else if (quads_ == WalkQuads::kStrictlyConvex) {
    return;
  } else {
    cost += classify_quad(a, d, b, c) == QuadKind::kFlatCorner ? kFlat : kReflex;
  }
  if (cost >= goal_cost_) return;
  goal_cost_ = cost;
  goal_ = from;
  met_ = enter;
}

template <class Mesh>
void QuickWalker<Mesh>::step(HalfedgeId enter, int ear) {
  const auto touched = recut_pentagon(mesh_, enter, ear);
  ++steps_;
  if (on_recut) on_recut(touched);
}

template <class Mesh>
void QuickWalker<Mesh>::apply(std::uint32_t end) {
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

template class QuickWalker<PairedMesh>;
template class QuickWalker<QuadMesh>;

}  // namespace quadloom::quadrangulate
