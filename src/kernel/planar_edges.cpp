#include "kernel/planar_edges.hpp"

#include <algorithm>

#include "core/point_text.hpp"

namespace quadloom::kernel {
namespace {

void check_count(const PlanarInput& input) {
  std::size_t corners = 0;
  for (const Polygon& polygon : input.polygons) {
    for (const auto& ring : polygon.rings) corners += ring.size();
  }
  const std::size_t points = corners + input.points.size();
  const std::size_t edges = corners + input.segments.size();
  if (points > kMaxPoints || edges >= kNone) {
    throw Error(ErrorCode::kTooManyPoints, std::to_string(points) + " points and " +
                                               std::to_string(edges) +
                                               " edges are more than 32-bit indices allow");
  }
}

void check_segments(const PlanarInput& input) {
  for (std::size_t i = 0; i < input.segments.size(); ++i) {
    for (const VertexId end : {input.segments[i].from, input.segments[i].to}) {
      if (end < input.points.size()) continue;
      throw Error(ErrorCode::kIndexOutOfRange,
                  "segment " + std::to_string(i) + " names point " + std::to_string(end) +
                      ", there are " + std::to_string(input.points.size()),
                  {i, end});
    }
  }
}

}  // namespace

PlanarEdges::PlanarEdges(const PlanarInput& input) : input_(input) {
  check_count(input);
  check_segments(input);
  for (std::uint32_t p = 0; p < input.polygons.size(); ++p) {
    const Polygon& polygon = input.polygons[p];
    for (std::uint32_t r = 0; r < polygon.rings.size(); ++r) {
      const auto& ring = polygon.rings[r];
      rings_.push_back({p, r, ring_edges_, static_cast<std::uint32_t>(ring.size())});
      points_.insert(points_.end(), ring.begin(), ring.end());
      ring_edges_ += static_cast<std::uint32_t>(ring.size());
    }
  }
  points_.insert(points_.end(), input.points.begin(), input.points.end());
}

std::uint32_t PlanarEdges::edge_count() const {
  return ring_edges_ + static_cast<std::uint32_t>(input_.segments.size());
}

const RingRange& PlanarEdges::ring_of(std::uint32_t edge) const {
  const auto after = std::upper_bound(
      rings_.begin(), rings_.end(), edge,
      [](std::uint32_t e, const RingRange& ring) { return e < ring.first + ring.size; });
  return *after;
}

EdgeEnds PlanarEdges::ends(std::uint32_t edge) const {
  if (!is_ring_edge(edge)) {
    const Segment s = input_.segments[edge - ring_edges_];
    return {ring_edges_ + s.from, ring_edges_ + s.to};
  }
  const RingRange& ring = ring_of(edge);
  return {edge, edge + 1 == ring.first + ring.size ? ring.first : edge + 1};
}

std::string PlanarEdges::text(std::uint32_t edge) const {
  const EdgeEnds e = ends(edge);
  const bool on_ring = is_ring_edge(edge);
  std::string out = on_ring ? "the edge from " : "the segment from ";
  out += point_text(points_[e.from]) + " to " + point_text(points_[e.to]);
  if (!on_ring) return out + " (segment " + std::to_string(edge - ring_edges_) + ")";
  const RingRange& ring = ring_of(edge);
  return out + " (polygon " + std::to_string(ring.polygon) + ", ring " + std::to_string(ring.ring) +
         ", edge " + std::to_string(edge - ring.first) + ")";
}

}  // namespace quadloom::kernel
