// A mesh of simple polygons in which a face can take a triangle from its neighbour.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "quadloom/core.hpp"

namespace quadloom::quadrangulate {

using FaceId = std::uint32_t;

/// Faces of any number of corners over a triangulation's vertices, as halfedges: `next` goes
/// counter-clockwise around its face. The outside is a face too, kOuterFace.
class FaceMesh {
 public:
  static constexpr FaceId kOuterFace = 0;

  /// Which end of the edge moves, seen from the face that gives: see take().
  enum class End : std::uint8_t { kTarget, kOrigin };
  struct Take {
    HalfedgeId edge = kNone;  // of the face that gives; its twin is of the face that takes
    End end = End::kTarget;
  };

  /// The triangles of one label make one face; labels are 0, 1 ... `labels` - 1, each the label of
  /// a simple polygon. Face f + 1 is label f.
  FaceMesh(const Triangulation& mesh, std::span<const std::uint32_t> label, std::size_t labels);

  std::size_t face_slots() const { return size_.size(); }
  /// Corners; 0 for a face that is no more.
  std::size_t size(FaceId f) const { return size_[f]; }
  bool on_hull(FaceId f) const { return hull_edges_[f] > 0; }
  HalfedgeId first(FaceId f) const { return first_[f]; }
  HalfedgeId next(HalfedgeId e) const { return next_[e]; }
  HalfedgeId twin(HalfedgeId e) const { return e ^ 1U; }
  FaceId face(HalfedgeId e) const { return face_[e]; }
  VertexId origin(HalfedgeId e) const { return origin_[e]; }
  VertexId target(HalfedgeId e) const { return origin_[e ^ 1U]; }
  std::vector<VertexId> corners(FaceId f) const;

  /// Whether take() leaves two simple polygons (or one): the triangle is an ear of the face that
  /// gives, and its third corner is none of the face that takes. Exact.
  bool can_take(std::span<const Point> points, Take take) const;

  /// The face A beyond the edge e = x -> y takes the triangle at the moving end from e's face B:
  ///
  ///        B                     B
  ///      w     z               w ____ z       End::kTarget: y moves on to z, and the edge y -> z
  ///       .   /                  \   /        becomes one of A. End::kOrigin: x moves back to w.
  ///   ____ x-y ____  ->     ____ x\ y ____    If B is a triangle it vanishes.
  ///        A                     A
  void take(Take take);

  /// Corners looked at so far, a measure of the work done.
  std::size_t work() const { return work_; }

 private:
  void link(HalfedgeId a, HalfedgeId b) {
    next_[a] = b;
    previous_[b] = a;
  }
  bool has_corner(FaceId f, VertexId v) const;
  bool is_ear(std::span<const Point> points, HalfedgeId before) const;
  void swallow(HalfedgeId edge);
  void own(HalfedgeId e, FaceId from, FaceId to);

  std::vector<HalfedgeId> next_, previous_;
  std::vector<VertexId> origin_;
  std::vector<FaceId> face_;
  std::vector<HalfedgeId> first_;          // per face
  std::vector<std::uint32_t> size_;        // per face
  std::vector<std::uint32_t> hull_edges_;  // per face
  std::vector<HalfedgeId> vertex_first_;   // one that starts there
  mutable std::size_t work_ = 0;
};

}  // namespace quadloom::quadrangulate
