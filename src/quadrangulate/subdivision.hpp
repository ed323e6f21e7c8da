// The subdivision of a mesh of triangles and quads into strictly convex quads.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "kernel/chart.hpp"
#include "quadloom/quadrangulate.hpp"

namespace quadloom::quadrangulate {

/// Edges of the mesh, numbered in the order of their first halfedges; the diagonals of quads that are
/// split into four have none.
using EdgeId = std::uint32_t;

class Subdivision;

/// Where the points of boundary edges go.
class BoundaryPlaces {
 public:
  virtual ~BoundaryPlaces() = default;

  /// Gives each boundary edge its first place (Subdivision::set_place). Throws Error kGuarantee.
  virtual void place_all(Subdivision& s) = 0;

  /// Called for a boundary edge that has a needle behind it: may set places anew, to give it room;
  /// returns the edges whose places must not change any more.
  virtual std::vector<EdgeId> make_room(Subdivision& s, EdgeId e) = 0;

  /// Whether the point of a boundary edge may move to `place` for the sake of a needle behind it.
  virtual bool may_move(const Subdivision& s, EdgeId e, Point place) = 0;
  /// It has moved.
  virtual void moved(const Subdivision& s, EdgeId e) = 0;
};

/// What is subdivided; must outlive the Subdivision.
struct SubdivisionSource {
  const Triangulation& mesh;
  std::span<const double> z = {};               ///< one a vertex, or empty: in the plane
  std::span<const HalfedgeId> given_pair = {};  ///< as TriangleMesh::given_pair
};

/// Throws Error kTooManyPoints if points, edges and faces may not be numbered with 32 bits.
void check_subdivision_size(std::size_t points, std::size_t triangles);

class Subdivision {
 public:
  Subdivision(const SubdivisionSource& source, const Progress& progress);

  /// Places all points. Throws Error kGuarantee where doubles have no room.
  void run(BoundaryPlaces& boundary);

  const Triangulation& mesh() const { return mesh_; }
  bool planar() const { return places_.planar(); }
  std::size_t edge_count() const { return halfedge_.size(); }
  EdgeId edge_of(HalfedgeId h) const { return edge_of_[h]; }
  /// The first halfedge of an edge; on the boundary its only one.
  HalfedgeId halfedge(EdgeId e) const { return halfedge_[e]; }
  bool on_boundary(EdgeId e) const { return mesh_.twin[halfedge_[e]] == kNone; }
  Point origin(HalfedgeId h) const { return mesh_.points[mesh_.origin(h)]; }
  Point target(HalfedgeId h) const { return mesh_.points[mesh_.target(h)]; }

  Point place(EdgeId e) const { return edge_place_[e]; }
  void set_place(EdgeId e, Point place) { edge_place_[e] = place; }
  /// The middle of the edge as rounded, in space if the mesh is.
  void place_in_the_middle(EdgeId e);

  /// Fills in points (the source's, one an edge, one a face), quads and Steiner points.
  void write_to(Quadrangulation& mesh, std::vector<double>& z,
                std::vector<SteinerPoint>& steiner) const;
  /// For each quad of write_to its source triangles, the second kNone unless it is a given quad.
  std::vector<std::array<TriangleId, 2>> quad_sources() const;

 private:
  using Vector3 = kernel::Vector3;

  void keep_convex_quads(std::span<const HalfedgeId> given_pair);
  void number_edges();
  void place_on_inner_edges();
  void place_in_quads();
  void place_in_triangles();
  void straighten_needles();

  bool is_whole(TriangleId t) const { return !whole_.empty() && whole_[t] != kNone; }
  TriangleId partner(TriangleId t) const { return triangle_of(mesh_.twin[whole_[t]]); }
  /// The triangle under whose number a face has its inner point.
  TriangleId face_of(TriangleId t) const;
  std::array<HalfedgeId, 4> sides_of_quad(TriangleId t) const;
  static std::array<HalfedgeId, 3> sides_of_triangle(TriangleId t) {
    return {3 * t, 3 * t + 1, 3 * t + 2};
  }
  template <class Visit>
  void for_each_face(const Visit& visit) const;

  EdgeId new_edge(HalfedgeId h);
  void break_up(TriangleId t);
  Vector3 edge_at(EdgeId e) const {
    return {edge_place_[e].x, edge_place_[e].y, planar() ? 0 : edge_z_[e]};
  }
  void set_edge(EdgeId e, Vector3 place);
  Vector3 middle(HalfedgeId h) const;
  template <std::size_t N>
  std::optional<Vector3> find_inner(const std::array<HalfedgeId, N>& sides,
                                    const kernel::Chart& chart) const;
  std::optional<Vector3> find_inner(TriangleId t) const;
  kernel::Chart chart_of_triangle(TriangleId t) const;
  kernel::Chart chart_of_quad(TriangleId t) const;
  bool try_place(TriangleId t);

  double length(HalfedgeId h) const;
  HalfedgeId longest_edge(TriangleId t) const;
  bool is_thin(TriangleId t) const;
  Vector3 outwards(HalfedgeId h) const;
  bool neighbours_hold(TriangleId t) const;
  bool is_leaned_on(TriangleId t) const;
  void make_room(EdgeId e);
  bool move_edges(TriangleId t, HalfedgeId longest, int power);
  bool straighten(TriangleId t);
  [[noreturn]] void refuse(TriangleId t) const;

  SteinerPoint edge_point(EdgeId e, VertexId vertex) const;
  SteinerPoint inner_point(TriangleId t, VertexId vertex) const;

  const Triangulation& mesh_;
  kernel::Places places_;
  const Progress& progress_;
  BoundaryPlaces* boundary_ = nullptr;
  std::vector<HalfedgeId> whole_;     // by triangle: the diagonal if its quad is split into four
  std::vector<EdgeId> edge_of_;       // of each halfedge
  std::vector<HalfedgeId> halfedge_;  // of each edge, the first one
  std::vector<Point> edge_place_;
  std::vector<double> edge_z_;  // empty in the plane, as the next but one
  std::vector<Point> inner_place_;
  std::vector<double> inner_z_;
  std::vector<TriangleId> stuck_;  // no inner place found yet
  std::vector<char> is_stuck_;     // by triangle
  std::vector<char> settled_;      // by edge: moved for a needle, must not move again
};

}  // namespace quadloom::quadrangulate
