// The two sides of each edge, without a hash table: halfedges go into the bucket of their smaller
// end by a counting sort and are sorted by the larger one there.
#include <algorithm>

#include "kernel/connect_steps.hpp"

namespace quadloom::kernel {
namespace {

struct Side {
  VertexId larger;
  HalfedgeId halfedge;
};

struct Buckets {
  std::vector<Side> side;
  std::vector<std::uint32_t> begin;  // bucket v is side[begin[v] .. begin[v + 1])
};

bool is_diagonal(const Connecting& work, HalfedgeId h) {
  return work.out.triangles.given_pair[triangle_of(h)] == h;
}

Buckets fill_buckets(const Connecting& work) {
  const Triangulation& mesh = work.mesh();
  const auto count = static_cast<HalfedgeId>(mesh.tri_vertex.size());
  Buckets out;
  out.begin.assign(mesh.points.size() + 2, 0);
  const auto smaller = [&](HalfedgeId h) { return std::min(mesh.origin(h), mesh.target(h)); };
  for (HalfedgeId h = 0; h < count; ++h) {
    if (!is_diagonal(work, h)) ++out.begin[smaller(h) + 2];
  }
  for (std::size_t v = 2; v < out.begin.size(); ++v) out.begin[v] += out.begin[v - 1];
  out.side.resize(out.begin.back());
  for (HalfedgeId h = 0; h < count; ++h) {
    if (is_diagonal(work, h)) continue;
    out.side[out.begin[smaller(h) + 1]++] = {std::max(mesh.origin(h), mesh.target(h)), h};
  }
  return out;
}

/// The two halves of a quad are neighbours in the list.
void match_diagonals(const Connecting& work, std::vector<HalfedgeId>& other) {
  const auto& pair = work.out.triangles.given_pair;
  for (TriangleId t = 0; t < pair.size(); ++t) {
    if (pair[t] == kNone) continue;
    other[pair[t]] = pair[t + 1];
    other[pair[t + 1]] = pair[t];
    ++t;
  }
}

}  // namespace

std::vector<HalfedgeId> match_sides(const Connecting& work, const char* crowded) {
  std::vector<HalfedgeId> other(work.mesh().tri_vertex.size(), kNone);
  match_diagonals(work, other);
  Buckets buckets = fill_buckets(work);
  for (VertexId v = 0; v < work.mesh().points.size(); ++v) {
    const auto bucket =
        std::span(buckets.side).subspan(buckets.begin[v], buckets.begin[v + 1] - buckets.begin[v]);
    std::ranges::sort(bucket, [](const Side& a, const Side& b) {
      return a.larger != b.larger ? a.larger < b.larger : a.halfedge < b.halfedge;
    });
    for (std::size_t i = 1; i < bucket.size(); ++i) {
      if (bucket[i].larger != bucket[i - 1].larger) continue;
      if (other[bucket[i - 1].halfedge] != kNone) {
        work.refuse_edge(v, bucket[i].larger, crowded);
      }
      other[bucket[i].halfedge] = bucket[i - 1].halfedge;
      other[bucket[i - 1].halfedge] = bucket[i].halfedge;
    }
  }
  return other;
}

}  // namespace quadloom::kernel
