// A triangulation with some of its triangles paired into quads, and the local operations on it.
#pragma once

#include <array>
#include <vector>

#include "kernel/chart.hpp"
#include "kernel/squareness.hpp"
#include "quadloom/quadrangulate.hpp"
#include "quadrangulate/face_range.hpp"

namespace quadloom::quadrangulate {

/// mate[t] is the halfedge of t inside its quad, kNone for a free triangle. An edge that must stay
/// has no twin, so that nothing crosses it.
struct PairedMesh {
  /// What PairedMesh and QuadMesh have in common for those that work on either; here a face is a triangle, and a quad
  /// two of them.
  static constexpr std::size_t kSlots = 2;
  std::size_t face_count() const { return mate.size(); }
  bool is_quad(TriangleId t) const { return mate[t] != kNone; }
  static TriangleId face_of(HalfedgeId h) { return triangle_of(h); }
  HalfedgeId twin(HalfedgeId h) const { return tri.twin[h]; }
  VertexId origin(HalfedgeId h) const { return tri.origin(h); }
  VertexId apex(HalfedgeId h) const { return tri.apex(h); }
  static std::array<HalfedgeId, 3> sides_of_free(TriangleId t) {
    return {3 * t, 3 * t + 1, 3 * t + 2};
  }
  /// The sides of the quad of t that are t's.
  std::array<HalfedgeId, 2> sides_of_quad(TriangleId t) const {
    return {next_halfedge(mate[t]), previous_halfedge(mate[t])};
  }
  bool is_inside(HalfedgeId h) const { return mate[triangle_of(h)] == h; }
  /// Passes go over all of such a mesh.
  static bool may_change(TriangleId, const FaceRange&) { return true; }
  std::array<VertexId, 4> corners_of_quad(TriangleId t) const {
    const HalfedgeId h = mate[t];
    return {tri.origin(h), tri.apex(tri.twin[h]), tri.target(h), tri.apex(h)};
  }
  std::array<TriangleId, 2> slots_of_quad(TriangleId t) const {
    return {t, triangle_of(tri.twin[mate[t]])};
  }

  Triangulation tri;
  std::vector<HalfedgeId> mate;
  std::vector<double> z;           // of a surface in space, else empty
  std::vector<TriangleId> source;  // of each triangle, or empty; see TriangleResult::quad_source

  bool is_free(TriangleId t) const { return mate[t] == kNone; }
  Point point(VertexId v) const { return tri.points[v]; }
  bool planar() const { return z.empty(); }
  kernel::Places places() const { return {tri.points, z}; }
  /// Twice the area along the normal; the same bits whichever corner comes first.
  kernel::Vector3 area(VertexId a, VertexId b, VertexId c) const {
    if (b < a && b < c) return places().area(b, c, a);
    if (c < a && c < b) return places().area(c, a, b);
    return places().area(a, b, c);
  }
  kernel::Vector3 area(TriangleId t) const {
    return area(tri.tri_vertex[3 * t], tri.tri_vertex[3 * t + 1], tri.tri_vertex[3 * t + 2]);
  }

  /// Makes the two triangles at h one quad.
  void pair(HalfedgeId h) {
    mate[triangle_of(h)] = h;
    mate[triangle_of(tri.twin[h])] = tri.twin[h];
  }
  /// Frees both triangles of t's quad.
  void unpair(TriangleId t) {
    mate[triangle_of(tri.twin[mate[t]])] = kNone;
    mate[t] = kNone;
  }
  /// Makes two halfedges each other's twin; either may be kNone.
  void link(HalfedgeId g, HalfedgeId h) {
    if (g != kNone) tri.twin[g] = h;
    if (h != kNone) tri.twin[h] = g;
  }
  void set_triangle(TriangleId t, VertexId a, VertexId b, VertexId c) {
    tri.tri_vertex[3 * t] = a;
    tri.tri_vertex[3 * t + 1] = b;
    tri.tri_vertex[3 * t + 2] = c;
  }
};

/// Whether four corners in order are a simple counter-clockwise quad, and how its corners turn.
enum class QuadKind : std::uint8_t { kNotSimple, kNonConvex, kFlatCorner, kStrictlyConvex };
QuadKind classify_quad_exactly(Point a, Point b, Point c, Point d);
inline QuadKind classify_quad(Point a, Point b, Point c, Point d) {
  if (kernel::QuadEdges(a, b, c, d).proven_convex()) return QuadKind::kStrictlyConvex;
  return classify_quad_exactly(a, b, c, d);
}
/// The same from the turns at the corners in order (signs of orient2d).
inline QuadKind classify_quad(int at_a, int at_b, int at_c, int at_d) {
  // Split along one of the diagonals, both triangles must be counter-clockwise.
  if (!((at_b > 0 && at_d > 0) || (at_a > 0 && at_c > 0))) return QuadKind::kNotSimple;
  if (at_a < 0 || at_b < 0 || at_c < 0 || at_d < 0) return QuadKind::kNonConvex;
  if (at_a == 0 || at_b == 0 || at_c == 0 || at_d == 0) return QuadKind::kFlatCorner;
  return QuadKind::kStrictlyConvex;
}

/// Whether the diagonal a-c parts a simple quad into two counter-clockwise triangles; else b-d
/// does.
bool split_by_first_diagonal_exactly(Point a, Point b, Point c, Point d);
inline bool split_by_first_diagonal(Point a, Point b, Point c, Point d) {
  if (kernel::QuadEdges(a, b, c, d).proven_convex()) return true;  // as nearly all are
  return split_by_first_diagonal_exactly(a, b, c, d);
}

/// The quad behind one of its sides.
///
///     e ---- d        enter is b->a, a side of the quad b, a, d, e; the other sides are a->d,
///     d->e, e->b, |  Q   |        each given by its halfedge in the quad. b ---> a
struct QuadBehind {
  std::array<HalfedgeId, 3> side;
  TriangleId near = kNone;  // the triangle of `enter`
  TriangleId far = kNone;

  TriangleId name() const { return near < far ? near : far; }
  std::array<TriangleId, 2> slots() const { return {near, far}; }
};
inline QuadBehind quad_behind(const PairedMesh& mesh, HalfedgeId enter) {
  const TriangleId near = triangle_of(enter);
  const HalfedgeId inside = mesh.mate[near], beyond = mesh.tri.twin[inside];
  const HalfedgeId far_first = next_halfedge(beyond), far_second = previous_halfedge(beyond);
  if (inside == next_halfedge(enter)) {
    return {{far_first, far_second, previous_halfedge(enter)}, near, triangle_of(beyond)};
  }
  return {{next_halfedge(enter), far_first, far_second}, near, triangle_of(beyond)};
}

/// A free triangle a, b, c beside the quad b, a, d, e, seen as the pentagon b, c, a, d, e.
/// Re-cutting it moves the free triangle to another ear, or, where c is d or e (the quad wraps
/// around the triangle: they share two edges, and a or b is an inner corner of degree 2), to
/// another of the three triangles about that corner.
///
///         c
///       /   .
///     a ----- b          corner 0 = b, 1 = c, 2 = a, 3 = d, 4 = e; edge k goes from corner k to k
///     + 1 |   Q   | d ----- e
///
/// Ears are named by their corner, 0, 2, 3, 4; kWheel + k names the triangle at edge k of a wrapped
/// one.
inline constexpr int kWheel = 5;

/// Moves the free triangle at the twin of `enter` to `ear` of the pentagon. Touches three
/// triangles, which are returned, the free one first; their outer neighbours keep their halfedges.
std::array<TriangleId, 3> recut_pentagon(PairedMesh& mesh, HalfedgeId enter, int ear);

/// A new vertex, with z on a surface; returns it.
VertexId add_vertex(PairedMesh& mesh, kernel::Vector3 place);
/// A new free triangle without neighbours that has the source of `like`; returns it.
TriangleId add_triangle(PairedMesh& mesh, TriangleId like);

/// The vertex s, outside the boundary edge a->b of the free triangle (kOutside) or on it (kOnEdge),
/// turns that triangle into the quad a, s, b, c.
///
///        c                   c
///      /   .               / | .
///     a --- b     or      a--s--b
///      .   /
///        s
void attach_at_boundary(PairedMesh& mesh, HalfedgeId boundary, VertexId s, SteinerKind kind);

/// The quads and the free triangles, in the order of the triangles.
Quadrangulation to_quadrangulation(const PairedMesh& mesh);
Quadrangulation to_quadrangulation(PairedMesh&& mesh);

}  // namespace quadloom::quadrangulate
