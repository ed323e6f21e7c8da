// Directed edges are matched without a hash table: each is put into the bucket of its smaller end
// (a counting sort), written as one number: larger end * 2 + (1 if it points to the larger end).
// A bucket, sorted, then has the two directions of an edge side by side, and equal numbers are a
// directed edge that occurs twice.
//
//   bucket of 3:   7 (to 3)  7 (from 3)   9 (from 3)         3-7 has both sides, 3->9 is alone
//
// Cost: linear but for the sorting inside the buckets, which is O(m log m) in the worst case (a
// fan).

#include "certify/edges.hpp"

#include <algorithm>
#include <cstdint>
#include <span>

namespace quadloom::certify {
namespace {

using Packed = std::uint32_t;

struct Buckets {
  std::vector<Packed> edge;
  std::vector<std::uint32_t> begin;  // bucket v is edge[begin[v] .. begin[v + 1])
};

/// Calls visit(from, to) for each directed edge of each face.
template <class Visit>
void for_each_edge(const PolygonMesh& mesh, Visit visit) {
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto corners = mesh.face(f);
    VertexId from = corners.back();
    for (const VertexId to : corners) {
      visit(from, to);
      from = to;
    }
  }
}

Buckets fill_buckets(const PolygonMesh& mesh) {
  Buckets out;
  out.begin.assign(mesh.points.size() + 2, 0);
  for_each_edge(mesh, [&](VertexId a, VertexId b) { ++out.begin[std::min(a, b) + 2]; });
  for (std::size_t v = 2; v < out.begin.size(); ++v) out.begin[v] += out.begin[v - 1];
  out.edge.resize(mesh.face_vertex.size());
  for_each_edge(mesh, [&](VertexId a, VertexId b) {
    out.edge[out.begin[std::min(a, b) + 1]++] = std::max(a, b) * 2 + (a < b ? 1 : 0);
  });
  return out;
}

DirectedEdge unpack(VertexId smaller, Packed edge) {
  const VertexId larger = edge / 2;
  return edge % 2 == 1 ? DirectedEdge{smaller, larger} : DirectedEdge{larger, smaller};
}

}  // namespace

EdgeReport match_edges(const PolygonMesh& mesh) {
  EdgeReport report;
  Buckets buckets = fill_buckets(mesh);
  for (VertexId v = 0; v < mesh.points.size(); ++v) {
    const auto bucket =
        std::span(buckets.edge).subspan(buckets.begin[v], buckets.begin[v + 1] - buckets.begin[v]);
    std::ranges::sort(bucket);
    for (std::size_t i = 0; i < bucket.size(); ++i) {
      const bool more = i + 1 < bucket.size();
      if (more && bucket[i] == bucket[i + 1]) {
        report.repeated = unpack(v, bucket[i]);
        return report;
      }
      if (more && bucket[i] / 2 == bucket[i + 1] / 2) {
        if (i + 2 < bucket.size() && bucket[i + 1] == bucket[i + 2]) continue;
        ++i;
      } else {
        report.alone.push_back(unpack(v, bucket[i]));
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
  for_each_edge(mesh, [&](VertexId a, VertexId b) { ++begin[std::min(a, b) + 2]; });
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
