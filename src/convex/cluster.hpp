// Clusters: a few neighbouring quads whose union is a simple polygon with no vertex inside.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/random.hpp"
#include "quadrangulate/paired_mesh.hpp"

namespace quadloom::convex {

using quadrangulate::PairedMesh;

/// Corners counter-clockwise; side k goes from corner k to the next.
struct Cluster {
  std::vector<VertexId> corner;
  std::vector<HalfedgeId> inner;  ///< of each side, inside the cluster
  std::vector<TriangleId> slot;   ///< the triangles, two a quad

  std::size_t quad_count() const { return slot.size() / 2; }
};

/// A face of a new parting of a cluster: numbers of its corners; from the number of corners of the cluster on:
/// added points.
using ClusterQuad = std::array<std::uint8_t, 4>;

/// Grows clusters quad by quad.
class ClusterGrower {
 public:
  explicit ClusterGrower(const PairedMesh& mesh) : mesh_(mesh) {}

  /// The quad of t alone.
  void start(TriangleId t);
  /// One more quad, at a random side; false if no side has one that keeps the union a polygon without
  /// inner vertices.
  bool grow(Random& random);
  const Cluster& cluster() const { return cluster_; }

 private:
  void add(TriangleId near, TriangleId far);

  const PairedMesh& mesh_;
  Cluster cluster_;
  std::uint32_t round_ = 0;
  std::vector<std::uint32_t> seen_triangle_, seen_vertex_;  // the last round that took it
};

/// Parts the cluster anew; `added` are the vertices of the added points. Triangles that the cluster has lost
/// count are added at the end; the sources of triangles go with their sides as far as possible.
void part_cluster(PairedMesh& mesh, const Cluster& cluster, std::span<const ClusterQuad> quads,
                  std::span<const VertexId> added);

}  // namespace quadloom::convex
