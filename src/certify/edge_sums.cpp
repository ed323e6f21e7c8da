// Faces that follow each other tend to be neighbours, so most sides find their opposite among a few
// faces: in a small table that stays in the cache, instead of all over the vertices.
//
//   1. sum_sides    of some faces: a table from edge to how often it is there forward less backward;
//                   sums that are not 0 are left
//   2. sum_the_rest of all those: match_edges' buckets, one a vertex
//
// Cost: linear but for sorting the buckets, whatever the order of the faces; where that is spatial, two
// million edges take 34 ms on one thread (match_edges: 52), and step 1 runs on several.

#include "certify/edge_sums.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <utility>

#include "certify/edge_buckets.hpp"
#include "core/parallel.hpp"

namespace quadloom::certify {
namespace {

constexpr std::size_t kFacesOfTask = std::size_t{1} << 15;
constexpr std::size_t kSidesOfTable = std::size_t{1} << 13;  // 16,384 entries: 200 kB

/// Sums of sides, an entry an edge; open addressing, at most half full.
class EdgeSums {
 public:
  /// Room for so many sides.
  void reserve(std::size_t sides) {
    if (2 * sides <= entries_.size()) return;
    entries_.assign(std::bit_ceil(2 * sides), Entry{});
    mask_ = entries_.size() - 1;
    shift_ = 64 - std::countr_zero(entries_.size());
    taken_.resize(entries_.size());
  }

  void add(VertexId from, VertexId to) {
    const std::uint64_t edge = std::uint64_t{std::min(from, to)} << 32 | std::max(from, to);
    std::size_t at = edge * 0x9e3779b97f4a7c15U >> shift_;
    // Whether the entry is free or the edge's own is anyone's guess: one branch for both.
    while (std::min(entries_[at].edge ^ edge, entries_[at].edge ^ kFree) != 0)
      at = (at + 1) & mask_;
    Entry& entry = entries_[at];
    taken_[count_] = static_cast<std::uint32_t>(at);
    count_ += entry.edge == kFree ? 1 : 0;
    entry.edge = edge;
    entry.sum += 2 * static_cast<int>(from < to) - 1;
  }

  /// Empties the table; what does not cancel goes to `left`.
  void take(std::vector<DirectedEdge>& left) {
    for (const std::uint32_t at : std::span(taken_).first(count_)) {
      const auto [edge, sum] = std::exchange(entries_[at], Entry{});
      const auto smaller = static_cast<VertexId>(edge >> 32), larger = static_cast<VertexId>(edge);
      for (int i = 0; i < sum; ++i) left.push_back({smaller, larger});
      for (int i = 0; i > sum; --i) left.push_back({larger, smaller});
    }
    count_ = 0;
  }

 private:
  static constexpr std::uint64_t kFree = ~std::uint64_t{0};
  struct Entry {
    std::uint64_t edge = kFree;  // smaller end, larger end
    std::int64_t sum = 0;
  };
  std::vector<Entry> entries_;
  std::size_t mask_ = 0;
  int shift_ = 64;
  std::vector<std::uint32_t> taken_;
  std::size_t count_ = 0;
};

/// Step 1.
void sum_sides(const PolygonMesh& mesh, std::size_t first, std::size_t last,
               std::vector<DirectedEdge>& left) {
  EdgeSums sums;
  while (first < last) {
    const std::size_t begin = mesh.face_begin[first];
    std::size_t end = first + 1;
    while (end < last && mesh.face_begin[end + 1] - begin <= kSidesOfTable) ++end;
    sums.reserve(mesh.face_begin[end] - begin);
    for_each_side(mesh, first, end, [&](VertexId a, VertexId b) { sums.add(a, b); });
    sums.take(left);
    first = end;
  }
}

/// Step 2.
std::vector<DirectedEdge> sum_the_rest(std::size_t vertices,
                                       std::span<const std::vector<DirectedEdge>> parts) {
  std::size_t count = 0;
  for (const auto& part : parts) count += part.size();
  EdgeBuckets buckets(vertices, count, [&](auto visit) {
    for (const auto& part : parts) {
      for (const auto [from, to] : part) visit(from, to);
    }
  });
  std::vector<DirectedEdge> out;
  for (VertexId v = 0; v < vertices; ++v) {
    const auto bucket = buckets.sorted(v);
    for (std::size_t i = 0; i < bucket.size();) {
      const std::size_t first = i;
      std::ptrdiff_t sum = 0;
      for (; i < bucket.size() && bucket[i] / 2 == bucket[first] / 2; ++i) {
        sum += bucket[i] % 2 == 1 ? 1 : -1;
      }
      const EdgeBuckets::Packed edge = bucket[first] / 2 * 2 + (sum > 0 ? 1 : 0);
      out.insert(out.end(), static_cast<std::size_t>(std::abs(sum)), EdgeBuckets::unpack(v, edge));
    }
  }
  return out;
}

}  // namespace

std::vector<DirectedEdge> boundary_chain(const PolygonMesh& mesh) {
  std::vector<std::vector<DirectedEdge>> left(mesh.face_count() / kFacesOfTask + 1);
  parallel_for_blocks(mesh.face_count(), kFacesOfTask, [&](std::size_t first, std::size_t last) {
    sum_sides(mesh, first, last, left[first / kFacesOfTask]);
  });
  return sum_the_rest(mesh.points.size(), left);
}

}  // namespace quadloom::certify
