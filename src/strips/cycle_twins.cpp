// The twins of triangles in the order of a cycle, from the order alone: no edge is looked up by its ends
// (a tenth of the time of sorting the edges).
//
//              pivot           Two of a triangle's edges are those that the cycle crosses, from the triangle
//             /     \.         before and to the next one. The third, the base, is left or right of the
//        ->  /       \  ->     cycle. A cycle of triangles is a ring, and what is left (or right) of it
//           /  base   \.       inside is a tree of bases, around which the ring goes, or such trees on the
//                              hull's edges. So a base either comes for the first time, or it is the last
//   one of its side that did and has not come again: a stack a side. A hull's edge never comes again; with
//   the first triangle at one, all that is stacked on it comes again before the next.
#include "strips/cycle_twins.hpp"

#include <algorithm>
#include <array>

namespace quadloom::strips {
namespace {

struct Base {
  VertexId from = kNone, to = kNone;
  HalfedgeId halfedge = kNone;
};

/// The triangle with the halfedge from -> to as its base.
std::size_t triangle_at(std::span<const VertexId> tri_vertex, VertexId from, VertexId to) {
  std::size_t t = 0;
  while (tri_vertex[3 * t + 1] != from || tri_vertex[3 * t + 2] != to) ++t;
  return t;
}

}  // namespace

std::vector<HalfedgeId> cycle_twins(std::span<const VertexId> tri_vertex, VertexId from,
                                    VertexId to) {
  std::vector<HalfedgeId> twin(tri_vertex.size(), kNone);
  const auto link = [&](HalfedgeId a, HalfedgeId b) {
    twin[a] = b;
    twin[b] = a;
  };
  // Whether triangle t comes after triangle s by its first edge, pivot to second corner.
  const auto by_first_edge = [&](std::size_t s, std::size_t t) {
    const VertexId second = tri_vertex[3 * t + 1];
    const VertexId* const c = &tri_vertex[3 * s];
    return (c[0] == second) | (c[1] == second) | (c[2] == second);
  };
  std::array<std::vector<Base>, 2> open;
  const std::size_t count = tri_vertex.size() / 3;
  const std::size_t first = triangle_at(tri_vertex, from, to);
  std::size_t t = first;
  bool by_first = by_first_edge((first == 0 ? count : first) - 1, first);
  do {
    const auto base = static_cast<HalfedgeId>(3 * t + 1);
    const Base here = {tri_vertex[base], tri_vertex[base + 1], base};
    std::vector<Base>& side = open[by_first ? 1 : 0];
    if (!side.empty() && side.back().from == here.to && side.back().to == here.from) {
      link(base, side.back().halfedge);
      side.pop_back();
    } else {
      side.push_back(here);
    }
    const std::size_t next = t + 1 == count ? 0 : t + 1;
    const bool next_by_first = by_first_edge(t, next);
    link(static_cast<HalfedgeId>(3 * t + (by_first ? 2 : 0)),
         static_cast<HalfedgeId>(3 * next + (next_by_first ? 0 : 2)));
    t = next;
    by_first = next_by_first;
  } while (t != first);
  return twin;
}

}  // namespace quadloom::strips
