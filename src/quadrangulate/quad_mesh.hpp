// A mesh of quads and the free triangles between them, one record a face: what the passes over a whole planar
// mesh and the searches in it work on.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "quadrangulate/face_range.hpp"
#include "quadrangulate/paired_mesh.hpp"

namespace quadloom::quadrangulate {

using FaceId = std::uint32_t;

/// The same mesh as a PairedMesh, planar and without sources, at half the memory and less than half the loads:
/// a quad has no diagonal. Halfedge 4f + i goes from corner i of face f to the next one.
struct QuadMesh {
  struct alignas(32) Face {
    std::array<VertexId, 4> corner;  // counter-clockwise; corner[3] = kNone: a free triangle
    std::array<HalfedgeId, 4> twin;  // of the sides; kNone on the boundary
  };
  /// A quad seen from one of its sides: the other three in order, and its number.
  struct Behind {
    std::array<HalfedgeId, 3> side;
    FaceId face;

    FaceId name() const { return face; }
    std::array<FaceId, 1> slots() const { return {face}; }
  };

  std::vector<Point> points;
  std::vector<Face> faces;

  static constexpr std::size_t kSlots = 1;
  std::size_t face_count() const { return faces.size(); }
  static FaceId face_of(HalfedgeId h) { return h / 4; }
  bool is_free(FaceId f) const { return faces[f].corner[3] == kNone; }
  /// Faces that became part of another one keep their numbers.
  bool is_gone(FaceId f) const { return faces[f].corner[0] == kNone; }
  bool is_quad(FaceId f) const { return !is_free(f) && !is_gone(f); }
  HalfedgeId next(HalfedgeId h) const {
    return h % 4 == (is_free(h / 4) ? 2U : 3U) ? h - h % 4 : h + 1;
  }

  Point point(VertexId v) const { return points[v]; }
  VertexId origin(HalfedgeId h) const { return faces[h / 4].corner[h % 4]; }
  HalfedgeId twin(HalfedgeId h) const { return faces[h / 4].twin[h % 4]; }
  /// Of a free triangle: the corner that is not on h; its sides.
  VertexId apex(HalfedgeId h) const { return faces[h / 4].corner[(h % 4 + 2) % 3]; }
  static std::array<HalfedgeId, 3> sides_of_free(FaceId f) { return {4 * f, 4 * f + 1, 4 * f + 2}; }
  static std::array<HalfedgeId, 4> sides_of_quad(FaceId f) {
    return {4 * f, 4 * f + 1, 4 * f + 2, 4 * f + 3};
  }
  static bool is_inside(HalfedgeId) { return false; }
  const std::array<VertexId, 4>& corners_of_quad(FaceId f) const { return faces[f].corner; }
  static std::array<FaceId, 1> slots_of_quad(FaceId f) { return {f}; }

  void link(HalfedgeId g, HalfedgeId h) {
    if (g != kNone) faces[g / 4].twin[g % 4] = h;
    if (h != kNone) faces[h / 4].twin[h % 4] = g;
  }
  /// Makes the two free triangles at h one quad, in the place of that of h.
  void pair(HalfedgeId h);

  /// Whether the face and its neighbours are in the range. To change a face writes to its neighbours; so passes that
  /// change such faces alone, and look at their neighbours at most, may go over several ranges at once.
  bool may_change(FaceId f, const FaceRange& range) const {
    if (range.is_all()) return true;
    bool inside = range.has(f);
    for (const HalfedgeId h : faces[f].twin) inside = inside && (h == kNone || range.has(h / 4));
    return inside;
  }
};

inline QuadMesh::Behind quad_behind(const QuadMesh&, HalfedgeId enter) {
  const HalfedgeId first = enter - enter % 4;
  return {{first + (enter + 1) % 4, first + (enter + 2) % 4, first + (enter + 3) % 4}, enter / 4};
}
/// As recut_pentagon of a PairedMesh, for ears of pentagons that are not wrapped. Touches the free triangle and the
/// quad, which are returned.
std::array<FaceId, 2> recut_pentagon(QuadMesh& mesh, HalfedgeId enter, int ear);

/// The faces follow the first triangles of each, so that the order of the triangles is kept.
QuadMesh to_quad_mesh(PairedMesh&& mesh);
/// Two triangles a quad one after the other, in the order of the faces. A quad is parted at a corner where both
/// triangles are counter-clockwise.
PairedMesh to_paired_mesh(QuadMesh&& mesh);

/// The quads and the free triangles, in the order of the faces.
Quadrangulation to_quadrangulation(QuadMesh&& mesh);

}  // namespace quadloom::quadrangulate
