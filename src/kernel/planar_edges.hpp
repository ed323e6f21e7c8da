// The points and edges of a PlanarInput by number, and in words.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "quadloom/kernel.hpp"

namespace quadloom::kernel {

/// One ring: its corners are the input points (and its edges the input edges) first .. first + size.
struct RingRange {
  std::uint32_t polygon = 0;
  std::uint32_t ring = 0;
  std::uint32_t first = 0;
  std::uint32_t size = 0;
};

/// The two ends of an input edge, as input points.
struct EdgeEnds {
  std::uint32_t from = 0;
  std::uint32_t to = 0;
};

class PlanarEdges {
 public:
  /// Throws Error kIndexOutOfRange, kTooManyPoints.
  explicit PlanarEdges(const PlanarInput& input);

  std::span<const Point> points() const { return points_; }
  std::span<const RingRange> rings() const { return rings_; }
  std::uint32_t ring_edges() const { return ring_edges_; }
  std::uint32_t edge_count() const;
  EdgeEnds ends(std::uint32_t edge) const;
  const RingRange& ring_of(std::uint32_t edge) const;
  bool is_ring_edge(std::uint32_t edge) const { return edge < ring_edges_; }

  /// "the edge from (0, 0) to (1, 0) (polygon 0, ring 0, edge 3)" or "the segment from ... (segment
  /// 7)".
  std::string text(std::uint32_t edge) const;

 private:
  const PlanarInput& input_;
  std::vector<Point> points_;
  std::vector<RingRange> rings_;
  std::uint32_t ring_edges_ = 0;
};

}  // namespace quadloom::kernel
