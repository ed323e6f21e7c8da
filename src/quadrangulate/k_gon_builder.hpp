// From groups of triangles, a cut or a plan of faces to the mesh of k-gons with its added points.
#pragma once

#include <span>
#include <vector>

#include "quadloom/quadrangulate.hpp"
#include "quadrangulate/face_transfer.hpp"
#include "quadrangulate/path_groups.hpp"
#include "quadrangulate/serpentine.hpp"
#include "quadrangulate/steiner_chains.hpp"

namespace quadloom::quadrangulate {

/// For one mesh. Each function throws Error kGuarantee if a point has no place among the doubles.
class KGonBuilder {
 public:
  KGonBuilder(std::span<const Point> points, std::span<const VertexId> hull,
              const PointOptions& options);

  /// Faces from groups of triangles of the path.
  KAngulationResult from_groups(const Serpentine& path, const std::vector<PathGroup>& groups);

  /// Two faces, left and right of a path through all inner points (two_faces.hpp).
  KAngulationResult from_cut(std::size_t from, std::size_t inner_points);

  /// Any faces.
  KAngulationResult from_plan(const FacePlan& plan);

 private:
  /// How much of a triangle the points of one of its edges may take.
  enum class Room { kTriangle, kThird };

  void add_inner(VertexId a, VertexId b, VertexId apex, std::size_t count, Room room);
  void add_outer(const std::vector<VertexId>& face, std::size_t count);
  VertexId apex_in_face(const std::vector<VertexId>& face, VertexId a, VertexId b) const;
  KAngulationResult finish(const std::vector<std::vector<VertexId>>& faces);

  std::vector<VertexId> hull_;  // with the points added there
  OddBoundary odd_boundary_;
  EdgeChains chains_;
  KAngulationResult result_;
};

}  // namespace quadloom::quadrangulate
