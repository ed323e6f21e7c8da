// Every triangle of the Delaunay triangulation into three strictly convex quads.
//
// De Berg's conversion, as told by Bose and Toussaint (section 2): a point on each edge, one inside
// each triangle, and each corner of the triangle becomes a corner of a quad. For n points, e edges
// and t triangles: 3 t quads, e + t added points. O(n) after the triangulation.
//
// Steps:
//   1. number_edges           one added point an edge, in the order of the halfedges
//   2. place_on_boundary      hull edges: see subdivision_boundary.hpp
//   3. place_on_inner_edges   inner edges: the midpoint as rounded
//   4. place_in_triangles     the centroid of the three edge points, or a double near it
//   5. straighten_needles     for the triangles that step 4 could not do: their edges' points move
//
// What differs from the paper: it reasons in real numbers, where midpoint and centroid always do.
// Among doubles the midpoint of an edge is rarely on the edge. For an inner edge that does not
// matter, as long as the quads on both sides are strictly convex, which is checked exactly. For a
// hull edge it would dent the boundary.
//
// Degenerate input: a straight run of hull points whose edges have no double on them bulges
// outwards, with one more point and quad for each hull point inside the run. Where a triangle is so
// thin that no double is within reach of its quads, the answer is an Error that names it. This takes
// points that are a few units in the last place apart or from a common line.
#include "quadrangulate/points_subdivide.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "quadloom/kernel.hpp"
#include "quadrangulate/subdivision_boundary.hpp"
#include "quadrangulate/subdivision_places.hpp"

namespace quadloom::quadrangulate {
namespace {

// A needle's edge point moves by 2^-4 of the edge's length at most, and by 2^-62 at least.
constexpr int kWidest = 4;
constexpr int kThinnest = 62;
constexpr double kThin = 0x1p-24;  // height by longest edge of a triangle that may have to give way

class Subdivision {
 public:
  Subdivision(Triangulation&& mesh, const Progress& progress)
      : mesh_(std::move(mesh)), progress_(progress) {}

  PointResult run() {
    report_progress(progress_, "subdividing", 0);
    number_edges();
    place_on_boundary();
    place_on_inner_edges();
    report_progress(progress_, "subdividing", 0.2);
    place_in_triangles();
    straighten_needles();
    report_progress(progress_, "subdividing", 0.8);
    return assemble();
  }

 private:
  using EdgeId = std::uint32_t;

  Point origin(HalfedgeId h) const { return mesh_.points[mesh_.origin(h)]; }
  Point target(HalfedgeId h) const { return mesh_.points[mesh_.target(h)]; }
  bool on_boundary(EdgeId e) const { return mesh_.twin[halfedge_[e]] == kNone; }

  void number_edges();
  void place_on_boundary();
  void place_on_inner_edges();
  void place_in_triangles();
  void straighten_needles();

  HalfedgeId next_on_boundary(HalfedgeId h) const;
  SplitTriangle split(TriangleId t) const;
  bool try_place(TriangleId t);
  double length(HalfedgeId h) const;
  HalfedgeId longest_edge(TriangleId t) const;
  bool is_thin(TriangleId t) const;
  bool neighbours_hold(TriangleId t);
  bool straighten(TriangleId t);
  void bulge(EdgeId e);
  PointResult assemble() const;
  void append_caps(PointResult& out) const;
  SteinerPoint edge_point(EdgeId e, VertexId vertex) const;

  Triangulation mesh_;
  const Progress& progress_;
  std::vector<EdgeId> edge_of_;       // of each halfedge
  std::vector<HalfedgeId> halfedge_;  // of each edge, the first one
  std::vector<Point> edge_place_;
  std::vector<Point> inner_place_;
  std::vector<EdgeId> hull_;               // the boundary in order
  std::vector<std::uint32_t> hull_index_;  // of each edge, its place in hull_, or kNone
  std::optional<SubdivisionBoundary> boundary_;
  std::vector<TriangleId> stuck_;  // no inner place found yet
  std::vector<char> is_stuck_;     // by triangle
  std::vector<char> settled_;      // by edge: moved for a needle, must not move again
};

void Subdivision::number_edges() {
  edge_of_.assign(mesh_.twin.size(), kNone);
  for (HalfedgeId h = 0; h < edge_of_.size(); ++h) {
    if (edge_of_[h] != kNone) continue;
    edge_of_[h] = static_cast<EdgeId>(halfedge_.size());
    if (mesh_.twin[h] != kNone) edge_of_[mesh_.twin[h]] = edge_of_[h];
    halfedge_.push_back(h);
  }
  edge_place_.resize(halfedge_.size());
}

HalfedgeId Subdivision::next_on_boundary(HalfedgeId h) const {
  for (h = next_halfedge(h); mesh_.twin[h] != kNone;) h = next_halfedge(mesh_.twin[h]);
  return h;
}

void Subdivision::place_on_boundary() {
  EdgeId first = 0;
  while (!on_boundary(first)) ++first;
  hull_index_.assign(halfedge_.size(), kNone);
  std::vector<Point> polygon;
  for (HalfedgeId h = halfedge_[first]; hull_index_[edge_of_[h]] == kNone;
       h = next_on_boundary(h)) {
    hull_index_[edge_of_[h]] = static_cast<std::uint32_t>(hull_.size());
    hull_.push_back(edge_of_[h]);
    polygon.push_back(origin(h));
  }
  boundary_.emplace(std::move(polygon));
  if (const auto without = boundary_->place_all()) {
    const HalfedgeId h = halfedge_[hull_[*without]];
    throw Error(ErrorCode::kGuarantee,
                "no double lies on the hull edge from point " + std::to_string(mesh_.origin(h)) +
                    " to point " + std::to_string(mesh_.target(h)) + " or just outside it",
                {mesh_.origin(h), mesh_.target(h)});
  }
  for (std::size_t i = 0; i < hull_.size(); ++i) edge_place_[hull_[i]] = boundary_->edge_place(i);
}

void Subdivision::place_on_inner_edges() {
  for (EdgeId e = 0; e < halfedge_.size(); ++e) {
    if (!on_boundary(e)) edge_place_[e] = along_edge(origin(halfedge_[e]), target(halfedge_[e]), 4);
  }
}

SplitTriangle Subdivision::split(TriangleId t) const {
  SplitTriangle out;
  for (HalfedgeId i = 0; i < 3; ++i) {
    out.corner[i] = origin(3 * t + i);
    out.edge[i] = edge_place_[edge_of_[3 * t + i]];
  }
  return out;
}

bool Subdivision::try_place(TriangleId t) {
  const auto place = inner_place(split(t));
  if (place) inner_place_[t] = *place;
  return place.has_value();
}

void Subdivision::place_in_triangles() {
  inner_place_.resize(mesh_.triangle_count());
  is_stuck_.assign(mesh_.triangle_count(), 0);
  settled_.assign(halfedge_.size(), 0);
  for (TriangleId t = 0; t < mesh_.triangle_count(); ++t) {
    if (try_place(t)) continue;
    is_stuck_[t] = 1;
    stuck_.push_back(t);
  }
  for (std::size_t i = 0; i < stuck_.size(); ++i) {  // and the thin ones that it leans on
    const HalfedgeId back = mesh_.twin[longest_edge(stuck_[i])];
    if (back == kNone || is_stuck_[triangle_of(back)] || !is_thin(triangle_of(back))) continue;
    is_stuck_[triangle_of(back)] = 1;
    stuck_.push_back(triangle_of(back));
  }
}

double Subdivision::length(HalfedgeId h) const {
  return std::hypot(target(h).x - origin(h).x, target(h).y - origin(h).y);
}

bool Subdivision::is_thin(TriangleId t) const {
  const HalfedgeId h = longest_edge(t);
  const Point a = origin(h), b = target(h), c = target(next_halfedge(h));
  const double side = length(h);
  const double height = (b.x - a.x) / side * (c.y - a.y) - (b.y - a.y) / side * (c.x - a.x);
  return height < kThin * side;
}

HalfedgeId Subdivision::longest_edge(TriangleId t) const {
  const HalfedgeId h = 3 * t;
  const HalfedgeId longer = length(h) >= length(h + 1) ? h : h + 1;
  return length(longer) >= length(h + 2) ? longer : h + 2;
}

/// The boundary bulges at a hull edge; what is behind its chain is placed again.
void Subdivision::bulge(EdgeId e) {
  const auto chain = boundary_->bulge_around(hull_index_[e]);
  if (!chain) return;
  for (std::size_t k = 0; k < chain->count; ++k) {
    const std::size_t i = (chain->first + k) % hull_.size();
    edge_place_[hull_[i]] = boundary_->edge_place(i);
    settled_[hull_[i]] = 1;
    const TriangleId t = triangle_of(halfedge_[hull_[i]]);
    if (!try_place(t) && !std::exchange(is_stuck_[t], 1)) stuck_.push_back(t);
  }
}

/// The triangles across the edges of t that are not stuck themselves are still fine.
bool Subdivision::neighbours_hold(TriangleId t) {
  for (HalfedgeId h = 3 * t; h < 3 * t + 3; ++h) {
    const HalfedgeId back = mesh_.twin[h];
    if (back == kNone || is_stuck_[triangle_of(back)]) continue;
    if (!inner_place(split(triangle_of(back)))) return false;
  }
  return true;
}

/// A needle is flatter than the rounding of its edges' midpoints. The point of its longest edge ab
/// moves into the triangle behind or outside the hull, and the two others follow part of the way:
///
///                c                     c
///      a -.------'------.- b      a ---.----.--- b       what is behind ab has room, since only
///                                     .  g  .             triangles that are done are asked
///                                      ` m '
bool Subdivision::straighten(TriangleId t) {
  const HalfedgeId h = longest_edge(t);
  const EdgeId e = edge_of_[h];
  if (!on_boundary(e) && !settled_[e] && is_stuck_[triangle_of(mesh_.twin[h])]) return false;
  if (on_boundary(e) && !settled_[e]) bulge(e);
  if ((on_boundary(e) || settled_[e]) && try_place(t)) return true;

  const Point along = {target(h).x - origin(h).x, target(h).y - origin(h).y};
  const Point across = {along.y, -along.x};
  std::array<Point, 3> old;
  for (HalfedgeId i = 0; i < 3; ++i) old[i] = edge_place_[edge_of_[3 * t + i]];
  for (int power = kWidest; power < kThinnest; ++power) {
    for (HalfedgeId i = 0; i < 3; ++i) {
      const HalfedgeId side = 3 * t + i;
      if (settled_[edge_of_[side]] || on_boundary(edge_of_[side])) continue;
      const double f = std::ldexp(length(side) / length(h), side == h ? -power : -power - 2);
      const Point middle = along_edge(origin(side), target(side), 4);
      edge_place_[edge_of_[side]] = {middle.x + f * across.x, middle.y + f * across.y};
    }
    if (try_place(t) && neighbours_hold(t)) {
      for (HalfedgeId i = 0; i < 3; ++i) settled_[edge_of_[3 * t + i]] = 1;
      return true;
    }
  }
  for (HalfedgeId i = 0; i < 3; ++i) edge_place_[edge_of_[3 * t + i]] = old[i];
  return try_place(t);
}

/// From the triangles whose longest edge has room behind it to those behind them.
void Subdivision::straighten_needles() {
  for (std::size_t before = kNone; stuck_.size() < before;) {
    before = stuck_.size();
    for (const TriangleId t : std::exchange(stuck_, {})) {
      if (!straighten(t)) {
        stuck_.push_back(t);
        continue;
      }
      is_stuck_[t] = 0;
      for (HalfedgeId h = 3 * t; h < 3 * t + 3; ++h) {
        const HalfedgeId back = mesh_.twin[h];
        if (back != kNone && !is_stuck_[triangle_of(back)]) try_place(triangle_of(back));
      }
    }
  }
  if (stuck_.empty()) return;
  const VertexId* v = &mesh_.tri_vertex[std::size_t{3} * stuck_[0]];
  throw Error(ErrorCode::kGuarantee,
              "the triangle of points " + std::to_string(v[0]) + ", " + std::to_string(v[1]) +
                  " and " + std::to_string(v[2]) +
                  " is too thin to hold three strictly convex quads in double precision (" +
                  std::to_string(stuck_.size()) + " such triangles)",
              {v[0], v[1], v[2]});
}

SteinerPoint Subdivision::edge_point(EdgeId e, VertexId vertex) const {
  const Point a = origin(halfedge_[e]);
  const Point b = target(halfedge_[e]);
  SteinerKind kind = SteinerKind::kInner;
  if (on_boundary(e)) {
    kind = orient2d(a, b, edge_place_[e]) == 0 ? SteinerKind::kOnEdge : SteinerKind::kOutside;
  }
  return {vertex, kind, {mesh_.origin(halfedge_[e]), mesh_.target(halfedge_[e]), kNone}};
}

///          c
///         / \            the quads (a, ab, g, ca), (b, bc, g, ab), (c, ca, g, bc)
///       ca   bc
///      /   g   \         vertices: the points, then the edges' points, then the triangles'
///     a -- ab -- b        and caps of hull points, where the boundary bulges
PointResult Subdivision::assemble() const {
  const auto n = static_cast<VertexId>(mesh_.points.size());
  const auto edges = static_cast<EdgeId>(halfedge_.size());
  PointResult out;
  out.input_vertices = n;
  out.mesh.points = mesh_.points;
  out.mesh.points.insert(out.mesh.points.end(), edge_place_.begin(), edge_place_.end());
  out.mesh.points.insert(out.mesh.points.end(), inner_place_.begin(), inner_place_.end());

  out.steiner.reserve(std::size_t{edges} + mesh_.triangle_count());
  for (EdgeId e = 0; e < edges; ++e) {
    out.steiner.push_back(edge_point(e, n + e));
    if (on_boundary(e)) ++out.statistics.hull_points;
  }
  out.mesh.quad_vertex.reserve(12 * mesh_.triangle_count());
  for (TriangleId t = 0; t < mesh_.triangle_count(); ++t) {
    const HalfedgeId h = 3 * t;
    const VertexId g = n + edges + t;
    out.steiner.push_back(
        {g, SteinerKind::kInner, {mesh_.origin(h), mesh_.origin(h + 1), mesh_.origin(h + 2)}});
    for (HalfedgeId i = 0; i < 3; ++i) {
      const VertexId ahead = n + edge_of_[h + i];
      const VertexId behind = n + edge_of_[h + (i + 2) % 3];
      for (const VertexId v : {mesh_.origin(h + i), ahead, g, behind}) {
        out.mesh.quad_vertex.push_back(v);
      }
    }
  }
  append_caps(out);
  return out;
}

/// The quads of bulges, see subdivision_boundary.hpp.
void Subdivision::append_caps(PointResult& out) const {
  const auto n = static_cast<VertexId>(mesh_.points.size());
  for (std::size_t i = 0; i < hull_.size(); ++i) {
    const auto& place = boundary_->cap(i);
    if (!place) continue;
    const auto cap = static_cast<VertexId>(out.mesh.points.size());
    const EdgeId before = hull_[i == 0 ? hull_.size() - 1 : i - 1];
    const VertexId corner = mesh_.origin(halfedge_[hull_[i]]);
    const VertexId last = mesh_.origin(halfedge_[before]);
    const VertexId next = mesh_.target(halfedge_[hull_[i]]);
    out.mesh.points.push_back(*place);
    out.steiner.push_back({cap, SteinerKind::kOutside, {last, next, corner}});
    for (const VertexId v : {n + before, cap, n + hull_[i], corner}) {
      out.mesh.quad_vertex.push_back(v);
    }
  }
}

}  // namespace

PointResult subdivide_quadrangulation(Triangulation&& triangulation, const PointOptions& options) {
  const std::size_t added = 2 * triangulation.tri_vertex.size();  // at least edges + triangles
  if (triangulation.points.size() + added >= kNone) {
    throw Error(ErrorCode::kTooManyPoints, "too many points to subdivide with 32-bit indices");
  }
  return Subdivision(std::move(triangulation), options.progress).run();
}

}  // namespace quadloom::quadrangulate
