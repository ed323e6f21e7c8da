// Equal numbers in a bucket are a directed edge that occurs twice.
//
// Cost: linear but for the sorting inside the buckets, which is O(m log m) in the worst case (a
// fan).

#include "certify/edges.hpp"

#include <algorithm>
#include <cstdint>
#include <span>

#include "certify/edge_buckets.hpp"

namespace quadloom::certify {

EdgeReport match_edges(const PolygonMesh& mesh) {
  EdgeReport report;
  EdgeBuckets buckets(mesh.points.size(), mesh.face_vertex.size(),
                      [&](auto visit) { for_each_side(mesh, 0, mesh.face_count(), visit); });
  for (VertexId v = 0; v < buckets.size(); ++v) {
    const auto bucket = buckets.sorted(v);
    for (std::size_t i = 0; i < bucket.size(); ++i) {
      const bool more = i + 1 < bucket.size();
      if (more && bucket[i] == bucket[i + 1]) {
        report.repeated = EdgeBuckets::unpack(v, bucket[i]);
        return report;
      }
      if (more && bucket[i] / 2 == bucket[i + 1] / 2) {
        if (i + 2 < bucket.size() && bucket[i + 1] == bucket[i + 2]) continue;
        ++i;
      } else {
        report.alone.push_back(EdgeBuckets::unpack(v, bucket[i]));
      }
    }
  }
  return report;
}

std::vector<std::uint32_t> reverse_edges(const PolygonMesh& mesh) {
  struct End {
    VertexId larger;
    std::uint32_t corner;
  };
  std::vector<std::uint32_t> begin(mesh.points.size() + 2, 0);
  for_each_side(mesh, 0, mesh.face_count(),
                [&](VertexId a, VertexId b) { ++begin[std::min(a, b) + 2]; });
  for (std::size_t v = 2; v < begin.size(); ++v) begin[v] += begin[v - 1];
  std::vector<End> ends(mesh.face_vertex.size());
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const std::uint32_t first = mesh.face_begin[f], last = mesh.face_begin[f + 1];
    for (std::uint32_t c = first; c < last; ++c) {
      const VertexId a = mesh.face_vertex[c], b = mesh.face_vertex[c + 1 == last ? first : c + 1];
      ends[begin[std::min(a, b) + 1]++] = {std::max(a, b), c};
    }
  }
  std::vector<std::uint32_t> reverse(ends.size(), kNone);
  for (VertexId v = 0; v < mesh.points.size(); ++v) {
    const auto bucket = std::span(ends).subspan(begin[v], begin[v + 1] - begin[v]);
    std::ranges::sort(bucket, {}, &End::larger);
    for (std::size_t i = 1; i < bucket.size(); ++i) {
      if (bucket[i].larger != bucket[i - 1].larger) continue;
      reverse[bucket[i].corner] = bucket[i - 1].corner;
      reverse[bucket[i - 1].corner] = bucket[i].corner;
    }
  }
  return reverse;
}

}  // namespace quadloom::certify
