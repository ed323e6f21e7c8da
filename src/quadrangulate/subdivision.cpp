// Every triangle into three strictly convex quads, and every convex quad into four.
//
// De Berg's conversion, as told by Bose and Toussaint (section 2): a point on each edge, one inside
// each triangle, and each corner of the triangle becomes a corner of a quad. For t triangles, q
// given quads and e edges: 3 t + 4 q quads, e + t + q added points. O(n).
//
// Steps:
//   1. keep_convex_quads      given quads that are not strictly convex count as their two triangles
//   2. number_edges           one added point an edge, in the order of the halfedges
//   3. BoundaryPlaces         boundary edges: see points_subdivide.cpp and outline_places.hpp
//   4. place_on_inner_edges   inner edges: the midpoint as rounded
//   5. place_in_quads         the centre, or a double near it; a quad without one is broken up into
//                             its two triangles, whose common edge comes last among the edges
//   6. place_in_triangles     the centroid of the three edge points, or a double near it
//   7. straighten_needles     for the triangles that step 6 could not do (subdivision_needles.cpp)
//
// What differs from the paper: it reasons in real numbers, where midpoint and centroid always do.
// Among doubles the midpoint of an edge is rarely on the edge. For an inner edge that does not
// matter, as long as the quads on both sides are strictly convex, which is checked exactly. For a
// boundary edge it would dent the boundary. The given quads are ours.
//
// Surfaces in space: each face is judged in its chart (kernel/chart.hpp); the points of a quad's
// edges are in one plane, so its inner point is too.
//
// Degenerate input: where a triangle is so thin that no double is within reach of its quads, the
// answer is an Error that names it. This takes points that are a few units in the last place apart or
// from a common line.
#include "quadrangulate/subdivision.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "quadloom/kernel.hpp"
#include "quadrangulate/subdivision_places.hpp"

namespace quadloom::quadrangulate {
namespace {

using kernel::Chart;
using kernel::Vector3;

double half_way(double a, double b) { return along_edge({a, 0}, {b, 0}, 4).x; }

/// The depth at g of the plane through three places; g is near them.
double depth_at(Point g, const std::array<Point, 3>& p, const std::array<double, 3>& depth) {
  const Point u{p[1].x - p[0].x, p[1].y - p[0].y};
  const Point v{p[2].x - p[0].x, p[2].y - p[0].y};
  const Point w{g.x - p[0].x, g.y - p[0].y};
  const double area = u.x * v.y - u.y * v.x;
  const double at_u = (w.x * v.y - w.y * v.x) / area;
  const double at_v = (u.x * w.y - u.y * w.x) / area;
  const double found = depth[0] + at_u * (depth[1] - depth[0]) + at_v * (depth[2] - depth[0]);
  return std::isfinite(found) ? found : depth[0] / 3 + depth[1] / 3 + depth[2] / 3;
}

}  // namespace

void check_subdivision_size(std::size_t points, std::size_t triangles) {
  // at most three edges and one inner point a triangle
  if (points < kNone && triangles < kNone / 4 && points + 4 * triangles < kNone) return;
  throw Error(ErrorCode::kTooManyPoints, "too many points to subdivide with 32-bit indices");
}

Subdivision::Subdivision(const SubdivisionSource& source, const Progress& progress)
    : mesh_(source.mesh), places_{source.mesh.points, source.z}, progress_(progress) {
  keep_convex_quads(source.given_pair);
  number_edges();
}

void Subdivision::run(BoundaryPlaces& boundary) {
  boundary_ = &boundary;
  report_progress(progress_, "subdividing", 0);
  boundary.place_all(*this);
  place_on_inner_edges();
  report_progress(progress_, "subdividing", 0.2);
  inner_place_.resize(mesh_.triangle_count());
  if (!planar()) inner_z_.resize(mesh_.triangle_count());
  place_in_quads();
  place_in_triangles();
  straighten_needles();
  report_progress(progress_, "subdividing", 0.8);
}

// ---- Quads and edges. ----

TriangleId Subdivision::face_of(TriangleId t) const {
  return is_whole(t) ? std::min(t, partner(t)) : t;
}

///       d --- c      the diagonal h goes from a to c in one triangle and back in the other:
///       |   / |      the sides from the end of h on, counter-clockwise
///       | h   |
///       a --- b
std::array<HalfedgeId, 4> Subdivision::sides_of_quad(TriangleId t) const {
  const HalfedgeId h = whole_[t], back = mesh_.twin[h];
  return {next_halfedge(h), previous_halfedge(h), next_halfedge(back), previous_halfedge(back)};
}

template <class Visit>
void Subdivision::for_each_face(const Visit& visit) const {
  for (TriangleId t = 0; t < mesh_.triangle_count(); ++t) {
    if (face_of(t) == t) visit(t);
  }
}

void Subdivision::keep_convex_quads(std::span<const HalfedgeId> given_pair) {
  whole_.assign(given_pair.begin(), given_pair.end());
  for (TriangleId t = 0; t < whole_.size(); ++t) {
    if (whole_[t] == kNone || partner(t) < t) continue;
    const auto sides = sides_of_quad(t);
    const Chart chart = chart_of_quad(t);
    std::array<Point, 4> corner;
    for (std::size_t i = 0; i < 4; ++i) corner[i] = places_.seen(chart, mesh_.origin(sides[i]));
    for (std::size_t i = 0; i < 4; ++i) {
      if (orient2d(corner[i], corner[(i + 1) % 4], corner[(i + 2) % 4]) > 0) continue;
      whole_[partner(t)] = kNone;
      whole_[t] = kNone;
      break;
    }
  }
}

EdgeId Subdivision::new_edge(HalfedgeId h) {
  const auto e = static_cast<EdgeId>(halfedge_.size());
  halfedge_.push_back(h);
  edge_of_[h] = e;
  if (mesh_.twin[h] != kNone) edge_of_[mesh_.twin[h]] = e;
  return e;
}

void Subdivision::number_edges() {
  edge_of_.assign(mesh_.twin.size(), kNone);
  for (HalfedgeId h = 0; h < edge_of_.size(); ++h) {
    if (edge_of_[h] != kNone || (is_whole(triangle_of(h)) && whole_[triangle_of(h)] == h)) continue;
    new_edge(h);
  }
  edge_place_.resize(halfedge_.size());
  if (!planar()) edge_z_.resize(halfedge_.size());
}

/// A quad counts as its two triangles; their common edge gets its number and place.
void Subdivision::break_up(TriangleId t) {
  const HalfedgeId h = std::min(whole_[t], mesh_.twin[whole_[t]]);
  whole_[partner(t)] = kNone;
  whole_[t] = kNone;
  const EdgeId e = new_edge(h);
  edge_place_.emplace_back();
  if (!planar()) edge_z_.push_back(0);
  place_in_the_middle(e);
}

// ---- First places. ----

Vector3 Subdivision::middle(HalfedgeId h) const {
  const Point p = along_edge(origin(h), target(h), 4);
  return {p.x, p.y,
          planar() ? 0 : half_way(places_.z[mesh_.origin(h)], places_.z[mesh_.target(h)])};
}

void Subdivision::set_edge(EdgeId e, Vector3 place) {
  edge_place_[e] = {place.x, place.y};
  if (!planar()) edge_z_[e] = place.z;
}

void Subdivision::place_in_the_middle(EdgeId e) { set_edge(e, middle(halfedge_[e])); }

void Subdivision::place_on_inner_edges() {
  for (EdgeId e = 0; e < halfedge_.size(); ++e) {
    if (!on_boundary(e)) place_in_the_middle(e);
  }
}

Chart Subdivision::chart_of_triangle(TriangleId t) const {
  return places_.chart(mesh_.tri_vertex[3 * t], mesh_.tri_vertex[3 * t + 1],
                       mesh_.tri_vertex[3 * t + 2]);
}

Chart Subdivision::chart_of_quad(TriangleId t) const {
  if (planar()) return {};
  const auto area = [&](TriangleId u) {
    return places_.area(mesh_.tri_vertex[3 * u], mesh_.tri_vertex[3 * u + 1],
                        mesh_.tri_vertex[3 * u + 2]);
  };
  return Chart(area(t) + area(partner(t)));
}

template <std::size_t N>
std::optional<Vector3> Subdivision::find_inner(const std::array<HalfedgeId, N>& sides,
                                               const Chart& chart) const {
  SplitFace<N> split;
  for (std::size_t i = 0; i < N; ++i) {
    split.corner[i] = places_.seen(chart, mesh_.origin(sides[i]));
    const Vector3 at = edge_at(edge_of_[sides[i]]);
    split.edge[i] = chart({at.x, at.y}, at.z);
  }
  const auto place = inner_place(split);
  if (!place) return std::nullopt;
  if (planar()) return Vector3{place->x, place->y, 0};
  std::array<double, 3> depth;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector3 at = edge_at(edge_of_[sides[i]]);
    depth[i] = chart.depth({at.x, at.y}, at.z);
  }
  return chart.lift(*place, depth_at(*place, {split.edge[0], split.edge[1], split.edge[2]}, depth));
}

std::optional<Vector3> Subdivision::find_inner(TriangleId t) const {
  return is_whole(t) ? find_inner(sides_of_quad(face_of(t)), chart_of_quad(t))
                     : find_inner(sides_of_triangle(t), chart_of_triangle(t));
}

bool Subdivision::try_place(TriangleId t) {
  const auto place = find_inner(t);
  if (!place) return false;
  inner_place_[face_of(t)] = {place->x, place->y};
  if (!planar()) inner_z_[face_of(t)] = place->z;
  return true;
}

void Subdivision::place_in_quads() {
  for (TriangleId t = 0; t < whole_.size(); ++t) {
    if (is_whole(t) && face_of(t) == t && !try_place(t)) break_up(t);
  }
}

// ---- The result. ----

SteinerPoint Subdivision::edge_point(EdgeId e, VertexId vertex) const {
  const HalfedgeId h = halfedge_[e];
  SteinerKind kind = SteinerKind::kInner;
  if (on_boundary(e)) {
    const Vector3 off = edge_at(e) - middle(h);
    const bool on_edge = planar() ? orient2d(origin(h), target(h), edge_place_[e]) == 0
                                  : off.x == 0 && off.y == 0 && off.z == 0;
    kind = on_edge ? SteinerKind::kOnEdge : SteinerKind::kOutside;
  }
  return {vertex, kind, {mesh_.origin(h), mesh_.target(h), kNone}};
}

/// Made from a triangle; in a quad from that of its triangles in which it lies.
SteinerPoint Subdivision::inner_point(TriangleId t, VertexId vertex) const {
  TriangleId on = t;
  if (is_whole(t)) {
    const HalfedgeId h = whole_[t];
    const Chart chart = chart_of_quad(t);
    const Point g = chart(inner_place_[t], planar() ? 0 : inner_z_[t]);
    const Point a = places_.seen(chart, mesh_.origin(h)), b = places_.seen(chart, mesh_.target(h));
    if (orient2d(a, b, g) < 0) on = partner(t);
  }
  return {vertex,
          SteinerKind::kInner,
          {mesh_.origin(3 * on), mesh_.origin(3 * on + 1), mesh_.origin(3 * on + 2)}};
}

///          c
///         / \            the quads (a, ab, g, ca), (b, bc, g, ab), (c, ca, g, bc)
///       ca   bc
///      /   g   \         vertices: the points, then the edges' points, then the faces'
///     a -- ab -- b
void Subdivision::write_to(Quadrangulation& mesh, std::vector<double>& z,
                           std::vector<SteinerPoint>& steiner) const {
  const auto n = static_cast<VertexId>(mesh_.points.size());
  const auto edges = static_cast<EdgeId>(halfedge_.size());
  mesh.points.reserve(n + edges + inner_place_.size());
  mesh.points.insert(mesh.points.end(), mesh_.points.begin(), mesh_.points.end());
  mesh.points.insert(mesh.points.end(), edge_place_.begin(), edge_place_.end());
  z.insert(z.end(), places_.z.begin(), places_.z.end());
  z.insert(z.end(), edge_z_.begin(), edge_z_.end());
  steiner.reserve(std::size_t{edges} + mesh_.triangle_count());
  for (EdgeId e = 0; e < edges; ++e) steiner.push_back(edge_point(e, n + e));

  const auto append_quads = [&](const auto& sides, VertexId g) {
    const std::size_t count = sides.size();
    for (std::size_t i = 0; i < count; ++i) {
      const VertexId ahead = n + edge_of_[sides[i]];
      const VertexId behind = n + edge_of_[sides[(i + count - 1) % count]];
      for (const VertexId v : {mesh_.origin(sides[i]), ahead, g, behind}) {
        mesh.quad_vertex.push_back(v);
      }
    }
  };
  mesh.quad_vertex.reserve(12 * mesh_.triangle_count());
  for_each_face([&](TriangleId t) {
    const auto g = static_cast<VertexId>(mesh.points.size());
    mesh.points.push_back(inner_place_[t]);
    if (!planar()) z.push_back(inner_z_[t]);
    steiner.push_back(inner_point(t, g));
    if (is_whole(t)) {
      append_quads(sides_of_quad(t), g);
    } else {
      append_quads(sides_of_triangle(t), g);
    }
  });
}

std::vector<std::array<TriangleId, 2>> Subdivision::quad_sources() const {
  std::vector<std::array<TriangleId, 2>> out;
  out.reserve(3 * mesh_.triangle_count());
  for_each_face([&](TriangleId t) {
    const std::array<TriangleId, 2> source = {t, is_whole(t) ? partner(t) : kNone};
    out.insert(out.end(), is_whole(t) ? 4 : 3, source);
  });
  return out;
}

}  // namespace quadloom::quadrangulate
