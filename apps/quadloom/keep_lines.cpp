#include "keep_lines.hpp"

#include <algorithm>
#include <numeric>

#include "quadloom/kernel.hpp"

namespace quadloom::app {

// Each halfedge hangs at its origin; a boundary edge, which has no twin, at its target as well.
EdgePaths::EdgePaths(const Triangulation& mesh) : mesh_(mesh), begin_(mesh.points.size() + 1, 0) {
  const auto count = static_cast<HalfedgeId>(mesh.tri_vertex.size());
  for (HalfedgeId h = 0; h < count; ++h) {
    ++begin_[mesh.origin(h) + 1];
    if (mesh.twin[h] == kNone) ++begin_[mesh.target(h) + 1];
  }
  std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
  edge_.resize(begin_.back());
  std::vector<std::uint32_t> at(begin_.begin(), begin_.end() - 1);
  for (HalfedgeId h = 0; h < count; ++h) {
    edge_[at[mesh.origin(h)]++] = h;
    if (mesh.twin[h] == kNone) edge_[at[mesh.target(h)]++] = h;
  }
}

VertexId EdgePaths::other_end(HalfedgeId h, VertexId v) const {
  return mesh_.origin(h) == v ? mesh_.target(h) : mesh_.origin(h);
}

HalfedgeId EdgePaths::edge_to(VertexId a, VertexId b) const {
  for (std::uint32_t i = begin_[a]; i < begin_[a + 1]; ++i) {
    if (other_end(edge_[i], a) == b) return edge_[i];
  }
  return kNone;
}

//      v------w- - - - - b      the edge v-w lies on the line to b and ends before it or there
HalfedgeId EdgePaths::edge_towards(VertexId v, VertexId b) const {
  const auto& p = mesh_.points;
  for (std::uint32_t i = begin_[v]; i < begin_[v + 1]; ++i) {
    const VertexId w = other_end(edge_[i], v);
    if (w == b) return edge_[i];
    if (orient2d(p[v], p[w], p[b]) == 0 && dot_sign(p[v], p[w], p[v], p[b]) > 0 &&
        dot_sign(p[v], p[b], p[w], p[b]) > 0) {
      return edge_[i];
    }
  }
  return kNone;
}

bool EdgePaths::follow(VertexId a, VertexId b, bool straight, std::vector<HalfedgeId>& path) const {
  if (!straight) {
    const HalfedgeId h = edge_to(a, b);
    if (h != kNone) path.push_back(h);
    return h != kNone;
  }
  const std::size_t before = path.size();
  for (VertexId v = a; v != b;) {
    const HalfedgeId h = edge_towards(v, b);
    if (h == kNone) {
      path.resize(before);
      return false;
    }
    path.push_back(h);
    v = other_end(h, v);
  }
  return true;
}

std::vector<VertexId> vertices_at(std::span<const Point> vertices, std::span<const Point> places) {
  std::vector<VertexId> order(vertices.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](VertexId a, VertexId b) {
    if (lex_less(vertices[a], vertices[b])) return true;
    return vertices[a] == vertices[b] && a < b;
  });
  std::vector<VertexId> found;
  found.reserve(places.size());
  for (const Point place : places) {
    const auto at = std::lower_bound(order.begin(), order.end(), place,
                                     [&](VertexId v, Point p) { return lex_less(vertices[v], p); });
    found.push_back(at != order.end() && vertices[*at] == place ? *at : kNone);
  }
  return found;
}

}  // namespace quadloom::app
