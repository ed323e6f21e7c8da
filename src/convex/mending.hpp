// The mesh while its quads are mended: what all steps of mending share.
#pragma once

#include <span>
#include <vector>

#include "convex/cluster.hpp"
#include "core/random.hpp"
#include "quadloom/quadrangulate.hpp"

namespace quadloom::convex {

/// In meshes of more triangles each bad quad gets less effort.
inline constexpr std::size_t kThriftyMesh = 500'000;

class Mending {
 public:
  Mending(PairedMesh& mesh, std::uint64_t seed, std::vector<SteinerPoint>& steiner);

  TriangleId name_of_quad(TriangleId t) const {
    return std::min(t, triangle_of(mesh.tri.twin[mesh.mate[t]]));
  }
  bool is_bad(TriangleId t) const;
  /// Appends the names of the bad quads among the triangles.
  void note_bad(std::span<const TriangleId> triangles, std::vector<TriangleId>& list) const;
  std::size_t bad_in(const Cluster& cluster) const;
  std::vector<Point> points_of(std::span<const VertexId> vertices) const;
  void touch(std::span<const TriangleId> triangles) {
    touched.insert(touched.end(), triangles.begin(), triangles.end());
  }

  /// Few quads of a very large mesh are bad: less effort is spent on each, so that mending takes half of the time, for a
  /// fifth more points added.
  bool is_thrifty() const {
    constexpr std::size_t kFewBad = 100;  // of so many triangles, one
    return mesh.mate.size() > kThriftyMesh && bad.size() < mesh.mate.size() / kFewBad;
  }
  /// Small meshes have seen all there is to try soon.
  std::size_t tries_at_most() const { return mesh.mate.size() * mesh.mate.size() / 8; }

  /// The inner points that the mesh came with may be taken out from now on, as those that are added. O(n) if it has
  /// some.
  void adopt_inner_points();
  /// Whether a vertex is an added point that may be taken out.
  bool is_inner_point(VertexId v) const { return triangle_at(v) != kNone; }
  /// A triangle at an inner point; kNone for other vertices, and for points that were taken out.
  TriangleId triangle_at(VertexId v) const {
    return v < first_added_ || v - first_added_ >= triangle_at_.size()
               ? kNone
               : triangle_at_[v - first_added_];
  }
  /// All inner points that are in use.
  std::vector<VertexId> inner_points() const;

  /// Parts a cluster anew: the faces are numbers of its corners, then of `inside`, then of new points. Inner points that
  /// the cluster has inside and `inside` has not are taken out. Returns the triangles.
  std::vector<TriangleId> part(const Cluster& cluster, std::span<const ClusterQuad> quads,
                               std::span<const VertexId> inside, std::span<const Point> places);
  /// Vertices and triangles that are not in use any more go, and others take their numbers; the inner points are listed
  /// among the Steiner points, without parents yet.
  void compact();

  PairedMesh& mesh;
  Random random;
  ClusterGrower grower;
  std::vector<TriangleId> bad;  // by name_of_quad; some may have become good since
  std::vector<TriangleId> touched;

 private:
  VertexId add_point(Point place);
  void take_out(VertexId v);
  void list_inner_points();
  void rename_vertex(VertexId from, VertexId to);
  void rename_triangle(TriangleId from, TriangleId to);

  std::vector<SteinerPoint>& steiner_;
  VertexId first_added_;
  std::vector<TriangleId> triangle_at_;  // from the first added vertex on: of inner points
  std::vector<VertexId> spare_vertices_;
  std::vector<TriangleId> spare_triangles_;
};

}  // namespace quadloom::convex
