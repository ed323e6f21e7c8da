// Steps:
//   1. find_borders   which part is behind each border edge, or the outside
//   2. plan_splits    a set of borders that each get one point so that all parts become even: from an odd
//                     part breadth first over borders to the next odd part or the outside; two points
//                     on the same border cancel (the borders are a T-join of the graph of the parts)
//   3. split          a free triangle of the part walks to a border edge with a place for the point, and
//                     then one of the part behind it to the same edge
//
// Each point changes the parity of the parts on both sides of it, and nothing else does, so at least half
// as many points are needed as there are odd parts. Step 2 is that good where odd parts touch each other
// in pairs, and never adds more than one point for each border of its shortest ways.
// A boundary point is exactly on its edge or outside; one between two parts may lie beside the edge as far
// as rounding moves it.
#include "quadrangulate/odd_parts.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>

#include "kernel/point_on_segment.hpp"
#include "kernel/predicates_inline.hpp"
#include "quadrangulate/outer_places.hpp"

namespace quadloom::quadrangulate {
namespace {

using kernel::Vector3;
using PartId = std::uint32_t;
constexpr PartId kOutside = kNone;

/// Where the point of a border edge may lie.
enum class Wanted : std::uint8_t { kOutsideEdge, kExactlyOnEdge, kNearEdge };

double squared_cosine(Vector3 a, Vector3 b, Vector3 c) {
  const Vector3 u = a - b, v = c - b;
  const double uv = dot(u, v);
  return uv * uv / (dot(u, u) * dot(v, v));
}

class EvenParts {
 public:
  EvenParts(PairedMesh& mesh, const TriangleMesh& input, const MeshParts& parts, Walker& walker,
            SteinerCrossing& crossing, OddBoundary wish)
      : mesh_(mesh),
        input_(input),
        parts_(parts),
        walker_(walker),
        crossing_(crossing),
        wish_(wish),
        part_(parts.part) {}

  std::vector<SteinerPoint> run() {
    find_borders();
    for (const auto& [part, other] : plan_splits()) split(part, other);
    return std::move(points_);
  }

 private:
  struct Border {
    HalfedgeId halfedge;  // of the input
    PartId other;
  };

  static std::uint64_t key(VertexId a, VertexId b) { return std::uint64_t{a} << 32 | b; }

  void find_borders();
  std::set<std::pair<PartId, PartId>> plan_splits() const;
  std::vector<PartId> way_to_even(PartId from, const std::vector<std::uint8_t>& odd) const;
  void split(PartId part, PartId other);
  bool split_at(PartId part, PartId other, Wanted wanted);
  void split_other_side(PartId other, VertexId a, VertexId b, VertexId s);
  HalfedgeId bring(PartId part, const Walker::BoundaryGoal& goal);
  void free_one_at(PartId part, const Walker::BoundaryGoal& goal);
  const std::vector<TriangleId>& free_of(PartId part);
  void note_added(PartId part);
  template <class Visit>
  void for_each_triangle(PartId part, Visit visit) const;
  int cost_of(VertexId a, VertexId b, VertexId c) const;
  bool parts_face(VertexId a, Vector3 s, VertexId b, VertexId c) const;
  Vector3 middle(VertexId a, VertexId b) const;
  std::optional<Vector3> place(VertexId a, VertexId b, Wanted wanted);
  std::vector<Wanted> wishes(PartId other) const;

  PairedMesh& mesh_;
  const TriangleMesh& input_;
  const MeshParts& parts_;
  Walker& walker_;
  SteinerCrossing& crossing_;
  OddBoundary wish_;
  std::vector<SteinerPoint> points_;

  std::unordered_map<std::uint64_t, Border> border_;   // by the ends of the edge
  std::vector<std::pair<PartId, PartId>> neighbours_;  // ascending, each pair once both ways
  std::vector<TriangleId> by_part_;                    // the triangles of the parts, in order
  std::vector<std::uint32_t> begin_;                   // of each part in by_part_
  std::unordered_map<PartId, std::vector<TriangleId>> added_, free_;
  std::vector<PartId> part_;  // of each triangle
  std::optional<OuterPlaces> outer_;
};

void EvenParts::find_borders() {
  for (HalfedgeId h = 0; h < mesh_.tri.twin.size() && h < input_.mesh.twin.size(); ++h) {
    if (mesh_.tri.twin[h] != kNone) continue;
    const HalfedgeId twin = input_.mesh.twin[h];
    const PartId part = part_[triangle_of(h)];
    const PartId other = twin == kNone ? kOutside : part_[triangle_of(twin)];
    if (other == part) continue;  // a point there changes no parity
    border_[key(mesh_.tri.origin(h), mesh_.tri.target(h))] = {h, other};
    neighbours_.emplace_back(part, other);
  }
  std::sort(neighbours_.begin(), neighbours_.end());
  neighbours_.erase(std::unique(neighbours_.begin(), neighbours_.end()), neighbours_.end());

  for (TriangleId t = 0; t < mesh_.mate.size(); ++t) {
    if (mesh_.is_free(t)) free_[part_[t]].push_back(t);
  }
  begin_.assign(parts_.count() + 1, 0);
  for (std::size_t p = 0; p < parts_.count(); ++p) begin_[p + 1] = begin_[p] + parts_.triangles[p];
  by_part_.resize(part_.size());
  std::vector<std::uint32_t> next = begin_;
  for (TriangleId t = 0; t < part_.size(); ++t) by_part_[next[part_[t]]++] = t;
}

/// The parts from `from` to the next odd one or the outside, both ends included.
std::vector<PartId> EvenParts::way_to_even(PartId from,
                                           const std::vector<std::uint8_t>& odd) const {
  std::unordered_map<PartId, PartId> reached_from = {{from, from}};
  std::vector<PartId> level = {from}, next;
  const auto way = [&](PartId last, PartId end) {
    std::vector<PartId> parts = {end};
    for (PartId p = last;; p = reached_from[p]) {
      parts.push_back(p);
      if (p == from) break;
    }
    return parts;
  };
  for (; !level.empty(); level.swap(next), next.clear()) {
    PartId at_outside = kOutside;
    for (const PartId p : level) {
      auto n = std::lower_bound(neighbours_.begin(), neighbours_.end(), std::pair(p, PartId{0}));
      for (; n != neighbours_.end() && n->first == p; ++n) {
        if (n->second == kOutside) {
          if (at_outside == kOutside) at_outside = p;
        } else if (reached_from.emplace(n->second, p).second) {
          if (odd[n->second] != 0) return way(p, n->second);  // one way for two
          next.push_back(n->second);
        }
      }
    }
    if (at_outside != kOutside) return way(at_outside, kOutside);
  }
  return {};  // cannot be: the triangles of a closed component are even in number
}

std::set<std::pair<PartId, PartId>> EvenParts::plan_splits() const {
  std::vector<std::uint8_t> odd(parts_.count());
  for (PartId p = 0; p < odd.size(); ++p) odd[p] = parts_.is_odd(p) ? 1 : 0;
  std::set<std::pair<PartId, PartId>> splits;
  for (PartId p = 0; p < odd.size(); ++p) {
    if (odd[p] == 0) continue;
    const std::vector<PartId> way = way_to_even(p, odd);
    for (std::size_t i = 0; i + 1 < way.size(); ++i) {
      const auto border = std::minmax(way[i], way[i + 1]);  // the outside is the greatest
      if (const auto [at, fresh] = splits.insert(border); !fresh) splits.erase(at);
    }
    odd[p] = 0;
    if (!way.empty() && way.front() != kOutside) odd[way.front()] = 0;
  }
  return splits;
}

std::vector<Wanted> EvenParts::wishes(PartId other) const {
  if (!mesh_.planar()) return {Wanted::kNearEdge};
  if (other != kOutside) return {Wanted::kExactlyOnEdge, Wanted::kNearEdge};
  if (wish_ == OddBoundary::kOutside) return {Wanted::kOutsideEdge, Wanted::kExactlyOnEdge};
  return {Wanted::kExactlyOnEdge, Wanted::kOutsideEdge};
}

void EvenParts::split(PartId part, PartId other) {
  for (const Wanted wanted : wishes(other)) {
    if (split_at(part, other, wanted)) return;
  }
  throw Error(
      ErrorCode::kGuarantee,
      "a part of the mesh (that of triangle " + std::to_string(by_part_[begin_[part]]) +
          ") has an odd border, and no point that makes it even has a place among the doubles",
      {by_part_[begin_[part]]});
}

/// One point on the border between the two; false if there is no place of that kind.
bool EvenParts::split_at(PartId part, PartId other, Wanted wanted) {
  std::optional<Vector3> found;
  const Walker::BoundaryGoal goal = {
      .cost =
          [&](VertexId a, VertexId b, VertexId c) {
            const auto border = border_.find(key(a, b));
            if (border == border_.end() || border->second.other != other) return -1;
            if (wanted == Wanted::kNearEdge) {
              const Vector3 m = middle(a, b);
              if (!parts_face(a, m, b, c)) return -1;
              // A walk may bring another corner there later, but this one can be kept.
              const HalfedgeId back = input_.mesh.twin[border->second.halfedge];
              if (back != kNone && !parts_face(b, m, a, input_.mesh.apex(back))) return -1;
            }
            return cost_of(a, b, c);
          },
      .accept =
          [&](VertexId a, VertexId b) {
            found = place(a, b, wanted);
            return found.has_value();
          },
  };
  const HalfedgeId edge = bring(part, goal);
  if (edge == kNone) return false;
  const VertexId a = mesh_.tri.origin(edge), b = mesh_.tri.target(edge);
  const VertexId s = add_vertex(mesh_, *found);
  const auto kind = wanted == Wanted::kOutsideEdge ? SteinerKind::kOutside : SteinerKind::kOnEdge;
  attach_at_boundary(mesh_, edge, s, kind);
  note_added(part);
  points_.push_back({s, kind, {a, b, kNone}});
  border_.erase(key(a, b));
  if (other != kOutside) split_other_side(other, b, a, s);
  return true;
}

/// The part behind the border takes the point s of its edge a->b too.
void EvenParts::split_other_side(PartId other, VertexId a, VertexId b, VertexId s) {
  const Walker::BoundaryGoal goal = {
      .cost =
          [&](VertexId from, VertexId to, VertexId c) {
            return from == a && to == b && parts_face(a, mesh_.places().at(s), b, c) ? 0 : -1;
          },
      .accept = [](VertexId, VertexId) { return true; },
  };
  const HalfedgeId edge = bring(other, goal);
  if (edge == kNone) {
    throw Error(ErrorCode::kGuarantee,
                "no quad has room for a point on the edge from vertex " + std::to_string(a) +
                    " to vertex " + std::to_string(b) + " on both sides",
                {a, b});
  }
  attach_at_boundary(mesh_, edge, s, SteinerKind::kOnEdge);
  note_added(other);
  border_.erase(key(a, b));
}

/// A free triangle of the part goes to a border edge; its halfedge there, or kNone.
HalfedgeId EvenParts::bring(PartId part, const Walker::BoundaryGoal& goal) {
  if (free_of(part).empty()) free_one_at(part, goal);
  const std::vector<TriangleId>& starts = free_of(part);
  const double flat = mesh_.planar() ? -1 : 0.94;
  for (const WalkQuads quads : {WalkQuads::kStrictlyConvex, WalkQuads::kAny}) {
    const HalfedgeId edge = walker_.reach_boundary(starts, goal, {quads, kNone, 1, flat});
    if (edge != kNone) return edge;
  }
  const HalfedgeId edge = crossing_.reach_border(starts, [&](VertexId a, VertexId b) {
    const auto at = border_.find(key(a, b));
    const VertexId c = at == border_.end() ? a : input_.mesh.apex(at->second.halfedge);
    return c != a && goal.cost(a, b, c) >= 0 && goal.accept(a, b);
  });
  note_added(part);
  return edge;
}

/// Parts a quad at a border edge that will do.
void EvenParts::free_one_at(PartId part, const Walker::BoundaryGoal& goal) {
  TriangleId chosen = kNone;
  for_each_triangle(part, [&](TriangleId t) {
    for (HalfedgeId h = 3 * t; h < 3 * t + 3 && chosen == kNone; ++h) {
      if (mesh_.tri.twin[h] != kNone) continue;
      const VertexId a = mesh_.tri.origin(h), b = mesh_.tri.target(h);
      if (goal.cost(a, b, mesh_.tri.apex(h)) >= 0) chosen = t;
    }
  });
  if (chosen == kNone) return;
  free_[part] = {chosen, triangle_of(mesh_.tri.twin[mesh_.mate[chosen]])};
  mesh_.unpair(chosen);
}

template <class Visit>
void EvenParts::for_each_triangle(PartId part, Visit visit) const {
  for (std::uint32_t i = begin_[part]; i < begin_[part + 1]; ++i) visit(by_part_[i]);
  if (const auto more = added_.find(part); more != added_.end()) {
    for (const TriangleId t : more->second) visit(t);
  }
}

/// The free triangles of the part. A walk or a crossing that ends at a border leaves the others as they are.
const std::vector<TriangleId>& EvenParts::free_of(PartId part) {
  std::vector<TriangleId>& free = free_[part];
  std::erase_if(free, [this](TriangleId t) { return !mesh_.is_free(t); });
  return free;
}

void EvenParts::note_added(PartId part) {
  while (part_.size() < mesh_.mate.size()) {
    added_[part].push_back(static_cast<TriangleId>(part_.size()));
    part_.push_back(part);
  }
}

/// The worst corner of the quad a, s, b, c but the one at s; a good place is worth a walk of some steps.
int EvenParts::cost_of(VertexId a, VertexId b, VertexId c) const {
  const kernel::Places places = mesh_.places();
  const Vector3 pa = places.at(a), pb = places.at(b), pc = places.at(c);
  const double worst = std::max(
      {squared_cosine(pc, pa, pb), squared_cosine(pa, pb, pc), squared_cosine(pb, pc, pa)});
  return worst < 1 ? static_cast<int>(20 * worst) : 20;
}

/// Whether s parts the triangle a, b, c into two.
bool EvenParts::parts_face(VertexId a, Vector3 s, VertexId b, VertexId c) const {
  const kernel::Chart chart = mesh_.places().chart(a, b, c);
  const auto seen = [&](VertexId v) { return mesh_.places().seen(chart, v); };
  const Point at_s = mesh_.planar() ? Point{s.x, s.y} : chart(s);
  return kernel::orient(seen(a), at_s, seen(c)) > 0 && kernel::orient(at_s, seen(b), seen(c)) > 0;
}

Vector3 EvenParts::middle(VertexId a, VertexId b) const {
  const Vector3 p = mesh_.places().at(a), q = mesh_.places().at(b);
  return {p.x / 2 + q.x / 2, p.y / 2 + q.y / 2, p.z / 2 + q.z / 2};
}

std::optional<Vector3> EvenParts::place(VertexId a, VertexId b, Wanted wanted) {
  std::optional<Point> found;
  switch (wanted) {
    case Wanted::kNearEdge:
      return middle(a, b);
    case Wanted::kExactlyOnEdge:
      found = kernel::point_on_segment(mesh_.point(a), mesh_.point(b));
      break;
    case Wanted::kOutsideEdge:
      if (!outer_) outer_.emplace(input_.mesh);
      found = outer_->place(border_.at(key(a, b)).halfedge);
      break;
  }
  return found ? std::optional(Vector3{found->x, found->y, 0}) : std::nullopt;
}

}  // namespace

std::vector<SteinerPoint> make_parts_even(PairedMesh& mesh, const TriangleMesh& input,
                                          const MeshParts& parts, Walker& walker,
                                          SteinerCrossing& crossing, OddBoundary wish) {
  if (wish == OddBoundary::kTriangle || parts.odd_count() == 0) return {};
  return EvenParts(mesh, input, parts, walker, crossing, wish).run();
}

}  // namespace quadloom::quadrangulate
