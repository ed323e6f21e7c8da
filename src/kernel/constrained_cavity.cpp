// Forcing an edge into a triangulation, second half: the triangles that the segment crosses are
// replaced by triangles on both sides of it, then flips make them Delaunay.
//
//   1. find_mates   edges of the rim whose two sides are both inside the cavity
//   2. fill_half    each half: triangles from its rim, with a stack, in linear time
//   3. legalize     Lawson's flips of the new edges
//
// Why fill_half works. Walk along the rim of a half. Each of its vertices is an end of crossed edges
// and sees along them a place on the segment, and these places come in the order of the rim. So, if
// the rim turns left at y between x and z, then the region between the sight lines of x and z has no
// vertex but x, y, z, and the triangle (x, y, z) is free. After cutting it off, x and z still have
// their sight lines. The vertex that is farthest from the segment always is such a y, so the stack
// ends with the segment alone. A vertex may be on the rim several times, and an edge on both its
// sides (when the cavity goes around it); its copies count as different vertices.
//
// Why flips of the new edges are enough. The triangles outside were constrained Delaunay before,
// and forcing an edge only takes vertices out of sight; of a set of points with ties decided there
// is only one constrained Delaunay triangulation, so those triangles are in it.
//
// Cost: linear in the crossed edges, and the flips: about as many in practice.
#include <algorithm>

#include "kernel/constrained_mesh.hpp"
#include "kernel/perturbed_incircle.hpp"

namespace quadloom::kernel {

void ConstrainedMesh::fill_cavity(std::uint32_t edge) {
  std::reverse(left_.begin(), left_.end());
  for (const TriangleId t : cavity_) in_cavity_[t] = 1;
  find_mates(right_);
  find_mates(left_);
  for (const TriangleId t : cavity_) in_cavity_[t] = 0;

  suspects_.clear();
  std::uint32_t next_triangle = 0;
  const HalfedgeId back = fill_half(right_, next_triangle);
  const HalfedgeId forth = fill_half(left_, next_triangle);
  mesh_.twin[back] = forth;
  mesh_.twin[forth] = back;
  edge_[back] = edge_[forth] = edge;
  legalize();
}

// The cavity's triangles are about to go, so the places of the rim's edges are noted in their twins.
void ConstrainedMesh::find_mates(Rim& rim) {
  for (std::uint32_t i = 0; i < rim.size(); ++i) mesh_.twin[rim[i].own] = i;
  for (RimEdge& e : rim) {
    if (e.outer != kNone && in_cavity_[triangle_of(e.outer)] != 0) e.mate = mesh_.twin[e.outer];
  }
}

// The half of the cavity on the left of its rim; gives the halfedge along the segment, from the end
// of the rim to its beginning:
//
//         ....<.....           stack: ..., x, y; then z. If x, y, z turns left, the triangle is
//     ...x        z            made, y goes, and x -> z is the new edge below z.
//         \      /
//          --y--
HalfedgeId ConstrainedMesh::fill_half(Rim& rim, std::uint32_t& next_triangle) {
  open_.assign(1, {rim.front().from, {}});
  for (std::uint32_t i = 0; i < rim.size(); ++i) {
    Open z{rim[i].to, {i, kNone}};
    while (open_.size() >= 2) {
      const VertexId x = open_[open_.size() - 2].vertex;
      const Open& y = open_.back();
      if (orient(at(x), at(y.vertex), at(z.vertex)) <= 0) break;
      const HalfedgeId h = 3 * cavity_[next_triangle++];
      mesh_.tri_vertex[h] = x;
      mesh_.tri_vertex[h + 1] = y.vertex;
      mesh_.tri_vertex[h + 2] = z.vertex;
      out_[x] = h;
      out_[y.vertex] = h + 1;
      out_[z.vertex] = h + 2;
      attach(h, y.link, rim);
      attach(h + 1, z.link, rim);
      z.link = {kNone, h + 2};
      open_.pop_back();
    }
    open_.push_back(z);
  }
  return open_.back().link.inner;
}

void ConstrainedMesh::attach(HalfedgeId h, const Link& link, Rim& rim) {
  if (link.inner != kNone) {
    mesh_.twin[h] = link.inner;
    mesh_.twin[link.inner] = h;
    edge_[h] = edge_[link.inner] = kNone;
    suspects_.push_back(h);
    return;
  }
  RimEdge& e = rim[link.rim];
  const HalfedgeId outer = e.mate == kNone ? e.outer : rim[e.mate].placed;
  e.placed = h;
  edge_[h] = e.edge;
  mesh_.twin[h] = outer;
  if (outer != kNone) mesh_.twin[outer] = h;
}

void ConstrainedMesh::legalize() {
  while (!suspects_.empty()) {
    const HalfedgeId h = suspects_.back();
    suspects_.pop_back();
    const HalfedgeId g = mesh_.twin[h];
    if (g == kNone || edge_[h] != kNone) continue;
    if (!inside_circle(at(mesh_.origin(h)), at(mesh_.target(h)), at(mesh_.apex(h)),
                       at(mesh_.apex(g)))) {
      continue;
    }
    flip(h);
    for (const HalfedgeId side : {h, next_halfedge(h), g, next_halfedge(g)}) {
      suspects_.push_back(side);
    }
  }
}

//        c                      c          h was a -> b and becomes d -> b,
//       / \                    /|\         g was b -> a and becomes c -> a;
//      a-h-b        ->        a | b        next of h and of g stay b -> c and a -> d,
//       \g/                    \|/         previous of h and of g become c -> d and d -> c
//        d                      d
void ConstrainedMesh::flip(HalfedgeId h) {
  const HalfedgeId g = mesh_.twin[h];
  const HalfedgeId h1 = next_halfedge(h), h2 = previous_halfedge(h);
  const HalfedgeId g1 = next_halfedge(g), g2 = previous_halfedge(g);
  const VertexId a = mesh_.origin(h), b = mesh_.origin(g), c = mesh_.origin(h2),
                 d = mesh_.origin(g2);
  const auto take_over = [&](HalfedgeId to, HalfedgeId from) {
    mesh_.twin[to] = mesh_.twin[from];
    if (mesh_.twin[to] != kNone) mesh_.twin[mesh_.twin[to]] = to;
    edge_[to] = edge_[from];
  };
  mesh_.tri_vertex[h] = d;
  mesh_.tri_vertex[g] = c;
  take_over(h, g2);
  take_over(g, h2);
  mesh_.twin[h2] = g2;
  mesh_.twin[g2] = h2;
  edge_[h2] = edge_[g2] = kNone;
  out_[a] = g1;
  out_[b] = h1;
}

}  // namespace quadloom::kernel
