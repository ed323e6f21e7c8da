// A polygon whose triangles are a cycle, or a path, with added points: Arkin, Held, Mitchell and Skiena,
// theorem 2.3. For a cut into k > 1 convex parts: at most k - 1 points for a cycle, k - 2 for a path. With
// holes as well.
//
// Two neighbouring parts are the root. For a cycle a point on their common side sees all of both: its fan
// is a cycle. For a path each of the two has a path of triangles that starts at the common side
// (path_from_last_side), and the two meet there. Each other part comes in across a side u-v of a triangle
// that stands in the order already, with one more point s:
//
//        x ----- y             the triangle w, u, v becomes  w, u, s   and   w, s, v
//        |  \ /  |             and between the two stand the triangles that s has with the other
//        u   s   v             sides of the part, from u to v. One of the two shares the edge with the
//         \ / \ /              triangle before, the other with the triangle behind.
//           w
//
//   1. convex_decomposition  the parts; PartSides: which side of which part is whose
//   2. start_cycle, start_path  the root
//   3. take_in               the other parts, breadth first
//   4. finish                the list of triangles as a mesh
//   5. best_path             for a path
//
// What we do differently. A point that is rounded is not on the common side. It need not be: s must see
// the sides of its part and the edges v-w and w-u, each strictly from its left. That is an open region,
// which the theorem's places on u-v touch; so s is placed inside its part, about halfway to its middle,
// and checked exactly (place_in_star).
//
// And a part need not be convex: where a point can see more parts, it takes them in as well (grow_star).
// The theorem's numbers are the most, then; of random polygons it leaves 20 to 60% of them. A cycle cut open
// is a path, too; the one with fewer points is taken.
//
// Flat corners, which the theorem does not think of, cost a point more in two cases, and must:
//   - A cycle. Where one part goes straight on at one end of the common side and the other part at the
//     other end, no point sees both (two squares that share a part of their sides, shifted). If all
//     common sides are of that kind the root is one part with a point in it: k points.
//   - A path. Where one part goes straight on at both ends of the common side, it has no path that starts
//     there (a T). If all common sides are of that kind, they are none of the first kind: the path is a
//     cycle with k - 1 points that is cut open.
// A convex polygon (k = 1) has a path without points, and a cycle with one point.
//
// Cost: that of convex_decomposition, O(n log n) for the rest, but for the places: O(m^2) for each of the m
// sides, at most a few dozen, of what a point sees.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "core/point_text.hpp"
#include "quadloom/strips.hpp"
#include "strips/convex_path.hpp"
#include "strips/match_twins.hpp"
#include "strips/part_star.hpp"
#include "strips/star_place.hpp"

namespace quadloom {
namespace strips {
namespace {

Point middle(Point p, Point q) { return {p.x / 2 + q.x / 2, p.y / 2 + q.y / 2}; }

class Tour {
 public:
  explicit Tour(ConvexDecomposition decomposition)
      : decomposition_(std::move(decomposition)),
        points_(decomposition_.parts.points),
        sides_(decomposition_.parts),
        owner_(sides_.count(), kNone),
        taken_(decomposition_.parts.face_count(), 0) {}

  /// None if flat corners allow no path as a root.
  std::optional<PolygonOrder> from_path() {
    if (!start_path()) return std::nullopt;
    take_in_all();
    return finish(OrderKind::kPath);
  }

  PolygonOrder from_cycle(OrderKind order) {
    if (!start_cycle()) refuse(0);
    take_in_all();
    return finish(order);
  }

 private:
  /// A triangle of the list; side[i] is the side of a part, not yet crossed, that the edge from corner i
  /// is on.
  struct Item {
    std::array<VertexId, 3> corner = {kNone, kNone, kNone};
    std::array<SideId, 3> side = {kNone, kNone, kNone};
    TriangleId before = kNone;
    TriangleId behind = kNone;
  };

  Point at(VertexId v) const { return points_[v]; }
  std::vector<SideId> inner_sides() const;
  Point middle_of(std::span<const SideId> sides) const;

  bool start_cycle();
  bool start_star(PartStar star, Point from, Point towards);
  bool start_path();
  void start_half(SideId base, std::vector<TriangleId>& row);

  void take_in_all();
  void take_in(SideId side);
  void take(PartStar& star);
  VertexId add_point(const PartStar& star, std::array<VertexId, 3> parents);
  TriangleId add_item(const std::array<VertexId, 3>& corner, const std::array<SideId, 3>& side);
  void own(TriangleId t);
  std::vector<TriangleId> fan(VertexId centre, std::span<const SideId> sides);
  void link(TriangleId t, TriangleId u);
  void link_all(std::span<const TriangleId> row);
  bool has_edge(TriangleId t, VertexId from, VertexId to) const;
  void replace(TriangleId t, std::vector<TriangleId> row);

  [[noreturn]] void refuse(SideId side) const;
  PolygonOrder finish(OrderKind order);

  ConvexDecomposition decomposition_;
  std::vector<Point> points_;
  PartSides sides_;
  std::vector<SteinerPoint> steiner_;
  std::vector<Item> items_;  // those that were replaced stay, outside of the list
  std::vector<TriangleId>
      owner_;  // per side of a part taken in, if not crossed: the triangle at it
  std::vector<std::uint8_t> taken_;  // parts
  std::vector<SideId> waiting_;      // sides of parts taken in
  TriangleId first_ = kNone;
};

// ---- The root. ----

/// One of each two, the longer ones first (in floating point; any is as good).
std::vector<SideId> Tour::inner_sides() const {
  std::vector<SideId> inner;
  std::vector<double> length(sides_.count(), 0);
  for (SideId s = 0; s < sides_.count(); ++s) {
    if (sides_.twin(s) == kNone || sides_.twin(s) < s) continue;
    const Point p = at(sides_.origin(s)), q = at(sides_.target(s));
    length[s] = std::hypot(q.x / 2 - p.x / 2, q.y / 2 - p.y / 2);
    inner.push_back(s);
  }
  std::stable_sort(inner.begin(), inner.end(),
                   [&](SideId s, SideId t) { return length[s] > length[t]; });
  return inner;
}

Point Tour::middle_of(std::span<const SideId> sides) const {
  Point sum;
  const auto count = static_cast<double>(sides.size());
  for (const SideId s : sides) {
    sum = {sum.x + at(sides_.origin(s)).x / count, sum.y + at(sides_.origin(s)).y / count};
  }
  return sum;
}

bool Tour::start_cycle() {
  for (const SideId s : inner_sides()) {
    const SideId t = sides_.twin(s);
    const bool here = sides_.flat_at_origin(s) || sides_.flat_at_target(s);
    const bool there = sides_.flat_at_origin(t) || sides_.flat_at_target(t);
    if (here && there) continue;
    PartStar star{sides_.others(s), {}, {sides_.part(s), sides_.part(t)}, {}};
    const std::vector<SideId> beyond = sides_.others(t);
    const Point from = middle(at(sides_.origin(s)), at(sides_.target(s)));
    const Point towards = here || there ? middle_of(there ? beyond : star.sides) : from;
    star.sides.insert(star.sides.end(), beyond.begin(), beyond.end());
    if (start_star(std::move(star), from, towards)) return true;
  }
  for (PartId part = 0; part < taken_.size(); ++part) {
    const SideId first = decomposition_.parts.face_begin[part];
    PartStar star{sides_.others(first), {}, {part}, {}};
    star.sides.push_back(first);
    const Point centre = middle_of(star.sides);
    if (start_star(std::move(star), centre, centre)) return true;
  }
  return false;
}

bool Tour::start_star(PartStar star, Point from, Point towards) {
  star.place = place_in_star(corners_of(sides_, star), from, towards);
  if (!star.place) return false;
  take(star);
  const std::vector<TriangleId> row = fan(add_point(star, {kNone, kNone, kNone}), star.sides);
  link_all(row);
  link(row.back(), row.front());
  first_ = row.front();
  return true;
}

bool Tour::start_path() {
  const auto no_path = [&](SideId s) {
    return sides_.flat_at_origin(s) && sides_.flat_at_target(s);
  };
  std::vector<TriangleId> row;
  if (taken_.size() == 1) {
    SideId base = 0;
    while (sides_.flat_at_origin(base)) ++base;
    start_half(base, row);
  } else {
    const std::vector<SideId> inner = inner_sides();
    const auto base = std::find_if(inner.begin(), inner.end(), [&](SideId s) {
      return !no_path(s) && !no_path(sides_.twin(s));
    });
    if (base == inner.end()) return false;
    start_half(*base, row);
    std::reverse(row.begin(), row.end());
    start_half(sides_.twin(*base), row);
  }
  link_all(row);
  first_ = row.front();
  return true;
}

/// The path of a part, the triangle at the side first.
void Tour::start_half(SideId base, std::vector<TriangleId>& row) {
  const std::vector<SideId> chain = sides_.others(base);
  std::vector<VertexId> corners;
  for (const SideId s : chain) corners.push_back(sides_.origin(s));
  corners.push_back(sides_.origin(base));
  std::vector<Point> convex;
  for (const VertexId v : corners) convex.push_back(at(v));
  const auto path = path_from_last_side(convex);
  if (!path) return;  // not for a side that start_path takes
  for (std::size_t i = 0; i < path->size(); i += 3) {
    std::array<VertexId, 3> corner{};
    std::array<SideId, 3> side = {kNone, kNone, kNone};
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint32_t from = (*path)[i + c], to = (*path)[i + (c + 1) % 3];
      corner[c] = corners[from];
      if (from + 1 == to) side[c] = chain[from];
    }
    row.push_back(add_item(corner, side));
  }
  taken_[sides_.part(base)] = 1;
  waiting_.insert(waiting_.end(), chain.begin(), chain.end());
}

// ---- The other parts. ----

/// Marks the parts, takes in more of them, and lets the sides around them wait.
void Tour::take(PartStar& star) {
  for (const PartId part : star.parts) taken_[part] = 1;
  grow_star(sides_, taken_, star);
  waiting_.insert(waiting_.end(), star.sides.begin(), star.sides.end());
}

void Tour::take_in_all() {
  for (std::size_t i = 0; i < waiting_.size(); ++i) {
    const SideId beyond = sides_.twin(waiting_[i]);
    if (beyond != kNone && taken_[sides_.part(beyond)] == 0) take_in(waiting_[i]);
  }
  const auto apart = std::find(taken_.begin(), taken_.end(), 0);
  if (apart == taken_.end()) return;
  const auto part = static_cast<PartId>(apart - taken_.begin());
  const VertexId v = sides_.origin(decomposition_.parts.face_begin[part]);
  throw Error(ErrorCode::kBadPolygon,
              "the inside of the polygon is in parts that touch at corners only; the part at " +
                  point_text(at(v)) + " cannot be reached from the others",
              {v});
}

void Tour::take_in(SideId side) {
  const TriangleId t = owner_[side];
  const Item old = items_[t];
  const auto edge = static_cast<std::size_t>(std::find(old.side.begin(), old.side.end(), side) -
                                             old.side.begin());
  const VertexId u = old.corner[edge], v = old.corner[(edge + 1) % 3],
                 w = old.corner[(edge + 2) % 3];
  const SideId beyond = sides_.twin(side);
  PartStar star{sides_.others(beyond), {at(v), at(w)}, {sides_.part(beyond)}, {}};
  star.place = place_in_star(corners_of(sides_, star), middle(at(u), at(v)), middle_of(star.sides));
  if (!star.place) refuse(side);
  take(star);

  const VertexId s = add_point(star, {w, u, v});
  std::vector<TriangleId> row = {add_item({w, u, s}, {old.side[(edge + 2) % 3], kNone, kNone})};
  const std::vector<TriangleId> inside = fan(s, star.sides);
  row.insert(row.end(), inside.begin(), inside.end());
  row.push_back(add_item({v, w, s}, {old.side[(edge + 1) % 3], kNone, kNone}));

  const bool turned = (old.behind != kNone && has_edge(old.behind, u, w)) ||
                      (old.behind == kNone && old.before != kNone && has_edge(old.before, w, v));
  if (turned) std::reverse(row.begin(), row.end());
  replace(t, std::move(row));
}

/// Triangles of the centre with sides that follow each other.
std::vector<TriangleId> Tour::fan(VertexId centre, std::span<const SideId> sides) {
  std::vector<TriangleId> row;
  for (const SideId s : sides) {
    row.push_back(add_item({sides_.origin(s), sides_.target(s), centre}, {s, kNone, kNone}));
  }
  return row;
}

/// Its attributes come from the corners of a triangle that it is in: of a part of the star, else the one
/// that was there.
VertexId Tour::add_point(const PartStar& star, std::array<VertexId, 3> parents) {
  const Point p = *star.place;
  const auto holds = [&](VertexId a, VertexId b, VertexId c) {
    return orient2d(at(a), at(b), at(c)) > 0 && orient2d(at(a), at(b), p) >= 0 &&
           orient2d(at(b), at(c), p) >= 0 && orient2d(at(c), at(a), p) >= 0;
  };
  for (const PartId part : star.parts) {
    const auto corners = decomposition_.parts.face(part);
    for (std::size_t i = 2; i < corners.size(); ++i) {
      if (!holds(corners[0], corners[i - 1], corners[i])) continue;
      parents = {corners[0], corners[i - 1], corners[i]};
    }
  }
  const auto vertex = static_cast<VertexId>(points_.size());
  points_.push_back(p);
  steiner_.push_back({vertex, SteinerKind::kInner, parents});
  return vertex;
}

// ---- The list. ----

TriangleId Tour::add_item(const std::array<VertexId, 3>& corner,
                          const std::array<SideId, 3>& side) {
  const auto t = static_cast<TriangleId>(items_.size());
  items_.push_back({corner, side});
  for (const SideId s : side) {
    if (s != kNone) owner_[s] = t;
  }
  return t;
}

void Tour::link(TriangleId t, TriangleId u) {
  if (t != kNone) items_[t].behind = u;
  if (u != kNone) items_[u].before = t;
}

void Tour::link_all(std::span<const TriangleId> row) {
  for (std::size_t i = 1; i < row.size(); ++i) link(row[i - 1], row[i]);
}

bool Tour::has_edge(TriangleId t, VertexId from, VertexId to) const {
  const auto& corner = items_[t].corner;
  for (std::size_t i = 0; i < 3; ++i) {
    if (corner[i] == from && corner[(i + 1) % 3] == to) return true;
  }
  return false;
}

void Tour::replace(TriangleId t, std::vector<TriangleId> row) {
  link_all(row);
  link(items_[t].before, row.front());
  link(row.back(), items_[t].behind);
  if (first_ == t) first_ = row.front();
}

// ---- The result. ----

void Tour::refuse(SideId side) const {
  const VertexId u = sides_.origin(side), v = sides_.target(side);
  throw Error(ErrorCode::kGuarantee,
              "no double near the edge from " + point_text(at(u)) + " to " + point_text(at(v)) +
                  " sees all of the convex part beside it",
              {u, v});
}

PolygonOrder Tour::finish(OrderKind order) {
  PolygonOrder out;
  out.order = order;
  out.input_to_vertex = std::move(decomposition_.input_to_vertex);
  out.input_vertices = decomposition_.parts.points.size();
  out.steiner = std::move(steiner_);
  out.parts = decomposition_.parts.face_count();
  out.parts_at_least = decomposition_.at_least;
  TriangleId t = first_;
  do {
    const auto& corner = items_[t].corner;
    out.mesh.tri_vertex.insert(out.mesh.tri_vertex.end(), corner.begin(), corner.end());
    t = items_[t].behind;
  } while (t != kNone && t != first_);
  out.mesh.twin = match_twins(out.mesh.tri_vertex, points_.size());
  out.mesh.points = std::move(points_);
  return out;
}

/// The better of a path from the start and a cycle cut open.
PolygonOrder best_path(const ConvexDecomposition& decomposition) {
  std::optional<PolygonOrder> path = Tour(decomposition).from_path();
  if (path && path->steiner.empty()) return std::move(*path);
  try {
    PolygonOrder cycle = Tour(decomposition).from_cycle(OrderKind::kPath);
    if (!path || cycle.steiner.size() < path->steiner.size()) return cycle;
  } catch (const Error& e) {
    if (!path || e.code() != ErrorCode::kGuarantee) throw;
  }
  return std::move(*path);
}

}  // namespace
}  // namespace strips

PolygonOrder hamiltonian_triangulation_with_points(const Polygon& polygon, OrderKind order,
                                                   const DecompositionOptions& options) {
  if (order == OrderKind::kSequential) {
    throw Error(ErrorCode::kBadOption,
                "points are added for paths and cycles, not for sequential triangulations");
  }
  ConvexDecomposition parts = convex_decomposition(polygon, options);
  if (order == OrderKind::kPath) return strips::best_path(parts);
  return strips::Tour(std::move(parts)).from_cycle(order);
}

}  // namespace quadloom
