// Directed edges sorted by their smaller ends, without a hash table: each is put into the bucket of its
// smaller end (a counting sort), written as one number: larger end * 2 + (1 if it points to the larger
// end). A bucket, sorted, then has the two directions of an edge side by side.
//
//   bucket of 3:   7 (to 3)  7 (from 3)   9 (from 3)         3-7 has both sides, 3->9 is alone
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "certify/edges.hpp"

namespace quadloom::certify {

class EdgeBuckets {
 public:
  using Packed = std::uint32_t;

  /// for_each(visit) calls visit(from, to) for each edge, in the same order each time.
  template <class ForEach>
  EdgeBuckets(std::size_t vertices, std::size_t edges, ForEach for_each)
      : begin_(vertices + 2, 0), edge_(edges) {
    for_each([&](VertexId a, VertexId b) { ++begin_[std::min(a, b) + 2]; });
    for (std::size_t v = 2; v < begin_.size(); ++v) begin_[v] += begin_[v - 1];
    for_each([&](VertexId a, VertexId b) {
      edge_[begin_[std::min(a, b) + 1]++] = std::max(a, b) * 2 + (a < b ? 1 : 0);
    });
  }

  std::size_t size() const { return begin_.size() - 2; }

  /// The edges whose smaller end is v, sorted.
  std::span<const Packed> sorted(VertexId v) {
    const auto bucket = std::span(edge_).subspan(begin_[v], begin_[v + 1] - begin_[v]);
    std::ranges::sort(bucket);
    return bucket;
  }

  static DirectedEdge unpack(VertexId smaller, Packed edge) {
    const VertexId larger = edge / 2;
    return edge % 2 == 1 ? DirectedEdge{smaller, larger} : DirectedEdge{larger, smaller};
  }

 private:
  std::vector<std::uint32_t> begin_;  // bucket v is edge_[begin_[v] .. begin_[v + 1])
  std::vector<Packed> edge_;
};

/// Calls visit(from, to) for each side of the faces first to last - 1.
template <class Visit>
void for_each_side(const PolygonMesh& mesh, std::size_t first, std::size_t last, Visit visit) {
  for (std::size_t f = first; f < last; ++f) {
    const auto corners = mesh.face(f);
    VertexId from = corners.back();
    for (const VertexId to : corners) {
      visit(from, to);
      from = to;
    }
  }
}

}  // namespace quadloom::certify
