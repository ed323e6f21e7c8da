// Clusters: a few neighbouring quads whose union is a simple polygon.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
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
  std::vector<VertexId>
      inside;  ///< vertices that are no corners, in the order in which they went inside

  std::size_t quad_count() const { return slot.size() / 2; }
};

/// A face of a new parting of a cluster: numbers of its corners; from the number of corners of the cluster on:
/// added points.
using ClusterQuad = std::array<std::uint8_t, 4>;

/// Whether a cluster may close around vertices.
enum class Inside : std::uint8_t { kNone, kAllowed };

/// Grows clusters quad by quad.
class ClusterGrower {
 public:
  explicit ClusterGrower(const PairedMesh& mesh) : mesh_(mesh) {}

  /// The quad of t alone.
  void start(TriangleId t);
  /// One more quad, at a random side; false if no side has one that keeps the union a simple polygon, without
  /// vertices inside if there may be none.
  bool grow(Random& random, Inside inside = Inside::kNone);
  /// Takes the quads around a corner until it is inside; false if that cannot be, or the cluster would have more
  /// corners.
  bool surround(VertexId corner, std::size_t most_corners);
  const Cluster& cluster() const { return cluster_; }

 private:
  /// A run of the cluster's sides that are one quad's, and the rest of its sides.
  struct Contact {
    std::size_t first = 0, count = 0;
    std::array<HalfedgeId, 3> rest;
    TriangleId near = kNone, far = kNone;
  };

  void add(TriangleId near, TriangleId far);
  std::optional<Contact> contact_at(std::size_t side, Inside inside) const;
  void take(const Contact& contact);

  const PairedMesh& mesh_;
  Cluster cluster_;
  std::uint32_t round_ = 0;
  std::vector<std::uint32_t> seen_triangle_, seen_vertex_;  // the last round that took it
};

/// Parts the cluster anew; `added` are the vertices numbered after the corners: those inside and added points. Triangles
/// that it then has more are taken from `spare` or added at the end; those that it has less go to
/// `spare`, without a pair or neighbours. Returns the triangles, two a quad. The sources of triangles go with their sides
/// as far as possible; none is lost if the cluster has no more of them than new triangles.
std::vector<TriangleId> part_cluster(PairedMesh& mesh, const Cluster& cluster,
                                     std::span<const ClusterQuad> quads,
                                     std::span<const VertexId> added,
                                     std::vector<TriangleId>& spare);

}  // namespace quadloom::convex
