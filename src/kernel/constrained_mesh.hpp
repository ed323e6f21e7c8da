// A triangulation into which edges are forced one by one; it stays constrained Delaunay.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "quadloom/core.hpp"

namespace quadloom::kernel {

/// Why an edge cannot be inserted, and which edge is in the way.
struct Obstacle {
  enum class Kind { kNone, kCrosses, kCoincides };
  Kind kind = Kind::kNone;
  std::uint32_t edge = kNone;
};

class ConstrainedMesh {
 public:
  /// Takes a Delaunay triangulation of all points.
  explicit ConstrainedMesh(Triangulation mesh);

  /// Makes the segment from u to v (different) an edge numbered `edge`, or a chain of such edges
  /// where vertices lie on it. Stops at the first obstacle; what was inserted until then stays.
  Obstacle insert(VertexId u, VertexId v, std::uint32_t edge);

  /// As insert, if the segment is a single edge already; else does nothing and gives none.
  std::optional<Obstacle> insert_existing(VertexId u, VertexId v, std::uint32_t edge);

  const Triangulation& mesh() const { return mesh_; }
  /// The number of the edge that a halfedge is on, kNone for an edge that is not forced.
  const std::vector<std::uint32_t>& edge() const { return edge_; }

  std::pair<Triangulation, std::vector<std::uint32_t>> take() && {
    return {std::move(mesh_), std::move(edge_)};
  }

 private:
  /// How a straight line leaves a vertex: along a halfedge (either way) to the vertex `to`, or
  /// across a halfedge that has the line's right on its origin.
  struct Exit {
    HalfedgeId halfedge = kNone;
    VertexId to = kNone;  // kNone: across
  };

  /// One edge of the rim of a cavity, and what was beyond it.
  struct RimEdge {
    VertexId from = kNone;
    VertexId to = kNone;
    HalfedgeId own = kNone;    // in the old triangle inside the cavity
    HalfedgeId outer = kNone;  // its twin
    std::uint32_t edge = kNone;
    std::uint32_t mate = kNone;  // the other side, if that is in the same rim: its place there
    HalfedgeId placed = kNone;   // in the new triangle
  };
  using Rim = std::vector<RimEdge>;

  /// An edge between two neighbours on the stack of fill_half: of the rim or of a new triangle.
  struct Link {
    std::uint32_t rim = kNone;
    HalfedgeId inner = kNone;
  };
  struct Open {
    VertexId vertex = kNone;
    Link link;  // to the vertex below it on the stack
  };

  Point at(VertexId v) const { return mesh_.points[v]; }

  Exit find_edge(VertexId u, VertexId v) const;
  Exit find_exit(VertexId& u, VertexId& v) const;
  Exit exit_through(HalfedgeId h, VertexId v) const;
  Obstacle follow_edge(const Exit& exit, std::uint32_t edge);

  Obstacle walk(VertexId u, VertexId v, HalfedgeId across, VertexId& end);
  void add_to_rim(Rim& rim, HalfedgeId own);
  void fill_cavity(std::uint32_t edge);
  void find_mates(Rim& rim);
  HalfedgeId fill_half(Rim& rim, std::uint32_t& next_triangle);
  void attach(HalfedgeId h, const Link& link, Rim& rim);
  void legalize();
  void flip(HalfedgeId h);

  Triangulation mesh_;
  std::vector<std::uint32_t> edge_;
  std::vector<HalfedgeId> out_;  // a halfedge that starts at each vertex

  std::vector<TriangleId> cavity_;
  std::vector<std::uint8_t> in_cavity_;
  Rim right_;
  Rim left_;
  std::vector<Open> open_;
  std::vector<HalfedgeId> suspects_;
};

}  // namespace quadloom::kernel
