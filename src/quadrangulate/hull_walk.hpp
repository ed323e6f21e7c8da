// The odd point of a paired mesh: a free triangle walks to the hull and takes the Steiner point
// there.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "quadloom/quadrangulate.hpp"
#include "quadrangulate/walk.hpp"

namespace quadloom::quadrangulate {

/// The neighbours of each hull vertex along the boundary of a triangulation.
class HullOfMesh {
 public:
  explicit HullOfMesh(const Triangulation& mesh);
  std::size_t size() const { return size_; }
  bool has(VertexId v) const { return after_[v] != kNone; }
  VertexId before(VertexId v) const { return before_[v]; }
  VertexId after(VertexId v) const { return after_[v]; }

 private:
  std::vector<VertexId> before_, after_;
  std::size_t size_ = 0;
};

/// Walks one of the free triangles to the hull edge where the Steiner point of the first kind makes the
/// best quad, and attaches it; if no hull edge has such a place, one of the next kind.
/// Empty if no walk or no place was found.
std::optional<SteinerPoint> walk_to_hull(PairedMesh& mesh, Walker& walker, const HullOfMesh& hull,
                                         std::span<const TriangleId> free,
                                         std::span<const SteinerKind> kinds);

}  // namespace quadloom::quadrangulate
