// Forcing an edge into a triangulation, first half: from vertex to vertex along the segment.
//
//   1. find_edge    is it an edge already? Around both ends in turn, so that the cost is that of
//                   the smaller degree
//   2. find_exit    the triangle, at either end, through which the segment leaves; or an edge along
//                   it that leads to a vertex on it
//   3. walk         the triangles that the segment crosses up to the next vertex on it
//   4. fill_cavity  (constrained_cavity.cpp) new triangles on both sides of the segment
//
// Every turn is judged against the ends of the segment that is left to do, which are vertices on the
// given one, so three points in line are seen as in line.
#include <algorithm>

#include "kernel/constrained_mesh.hpp"
#include "kernel/predicates_inline.hpp"
#include "quadloom/kernel.hpp"

namespace quadloom::kernel {
namespace {

/// The halfedges that start at a vertex, each once: counter-clockwise, and from the border on back
/// to the other border.
class Fan {
 public:
  Fan(const Triangulation& mesh, HalfedgeId start) : mesh_(mesh), start_(start), at_(start) {}

  bool at_end() const { return at_ == kNone; }
  HalfedgeId halfedge() const { return at_; }

  void step() {
    if (!clockwise_) {
      const HalfedgeId next = mesh_.twin[previous_halfedge(at_)];
      if (next != kNone) {
        at_ = next == start_ ? kNone : next;
        return;
      }
      clockwise_ = true;
      at_ = start_;
    }
    const HalfedgeId twin = mesh_.twin[at_];
    at_ = twin == kNone ? kNone : next_halfedge(twin);
  }

 private:
  const Triangulation& mesh_;
  HalfedgeId start_;
  HalfedgeId at_;
  bool clockwise_ = false;
};

/// Whether the straight line from a to b, which meets c, does so on b's side of a.
bool ahead(Point a, Point b, Point c) { return dot_sign(a, b, a, c) > 0; }

}  // namespace

ConstrainedMesh::ConstrainedMesh(Triangulation mesh)
    : mesh_(std::move(mesh)),
      edge_(mesh_.tri_vertex.size(), kNone),
      out_(mesh_.points.size(), kNone),
      in_cavity_(mesh_.triangle_count(), 0) {
  for (HalfedgeId h = 0; h < mesh_.tri_vertex.size(); ++h) out_[mesh_.origin(h)] = h;
}

std::optional<Obstacle> ConstrainedMesh::insert_existing(VertexId u, VertexId v,
                                                         std::uint32_t edge) {
  const Exit exit = find_edge(u, v);
  if (exit.halfedge == kNone) return std::nullopt;
  return follow_edge(exit, edge);
}

Obstacle ConstrainedMesh::insert(VertexId u, VertexId v, std::uint32_t edge) {
  while (u != v) {
    Exit exit = find_edge(u, v);
    if (exit.halfedge == kNone) exit = find_exit(u, v);
    Obstacle obstacle;
    VertexId end = exit.to;
    if (exit.to != kNone) {
      obstacle = follow_edge(exit, edge);
    } else {
      obstacle = walk(u, v, exit.halfedge, end);
      if (obstacle.kind == Obstacle::Kind::kNone) fill_cavity(edge);
    }
    if (obstacle.kind != Obstacle::Kind::kNone) return obstacle;
    u = end;
  }
  return {};
}

Obstacle ConstrainedMesh::follow_edge(const Exit& exit, std::uint32_t edge) {
  const HalfedgeId h = exit.halfedge, twin = mesh_.twin[h];
  if (edge_[h] != kNone) return {Obstacle::Kind::kCoincides, edge_[h]};
  edge_[h] = edge;
  if (twin != kNone) edge_[twin] = edge;
  return {};
}

ConstrainedMesh::Exit ConstrainedMesh::find_edge(VertexId u, VertexId v) const {
  Fan at_u(mesh_, out_[u]), at_v(mesh_, out_[v]);
  for (; !at_u.at_end() && !at_v.at_end(); at_u.step(), at_v.step()) {
    const HalfedgeId h = at_u.halfedge(), g = at_v.halfedge();
    if (mesh_.target(h) == v) return {h, v};
    if (mesh_.apex(h) == v) return {previous_halfedge(h), v};
    if (mesh_.target(g) == u) return {g, v};
    if (mesh_.apex(g) == u) return {previous_halfedge(g), v};
  }
  return {};
}

// Around both ends in turn; if the way is found at v first, then u and v change places.
ConstrainedMesh::Exit ConstrainedMesh::find_exit(VertexId& u, VertexId& v) const {
  Fan at_u(mesh_, out_[u]), at_v(mesh_, out_[v]);
  for (;;) {
    if (!at_u.at_end()) {
      const Exit exit = exit_through(at_u.halfedge(), v);
      if (exit.halfedge != kNone) return exit;
      at_u.step();
    }
    if (!at_v.at_end()) {
      const Exit exit = exit_through(at_v.halfedge(), u);
      if (exit.halfedge != kNone) {
        std::swap(u, v);
        return exit;
      }
      at_v.step();
    }
  }
}

//        q             h goes from u to p. The line to v leaves the triangle (u, p, q)
//       / \            - along u -> p or u -> q, if that corner is on it;
//      /   v  ....     - across p -> q, if p is on its right and q on its left.
//     u-----p
ConstrainedMesh::Exit ConstrainedMesh::exit_through(HalfedgeId h, VertexId v) const {
  const VertexId p = mesh_.target(h), q = mesh_.apex(h);
  const Point from = at(mesh_.origin(h)), to = at(v);
  const int side_of_p = orient(from, to, at(p));
  if (side_of_p > 0) return {};
  if (side_of_p == 0) return ahead(from, to, at(p)) ? Exit{h, p} : Exit{};
  const int side_of_q = orient(from, to, at(q));
  if (side_of_q < 0) return {};
  if (side_of_q == 0) {
    return ahead(from, to, at(q)) ? Exit{previous_halfedge(h), q} : Exit{};
  }
  return {next_halfedge(h), kNone};
}

// Through the triangles from u towards v up to the first vertex on the line, `end`:
//
//          q ___ r            the line enters the next triangle across p -> q and leaves it across
//         / \   /             p -> r if its third corner r is on the left, r -> q if on the right.
//     u ------------ v        The edge left behind joins the rim on r's side. The right rim goes
//         \ / \ /             from u to the end, the left one is collected from u too, each of
//          p                  its edges directed towards u.
//
Obstacle ConstrainedMesh::walk(VertexId u, VertexId v, HalfedgeId across, VertexId& end) {
  cavity_.assign(1, triangle_of(across));
  right_.clear();
  left_.clear();
  add_to_rim(right_, previous_halfedge(across));
  add_to_rim(left_, next_halfedge(across));
  for (HalfedgeId h = across;;) {
    if (edge_[h] != kNone) return {Obstacle::Kind::kCrosses, edge_[h]};
    const HalfedgeId entered = mesh_.twin[h];
    cavity_.push_back(triangle_of(entered));
    const VertexId r = mesh_.apex(entered);
    const HalfedgeId to_r = next_halfedge(entered), from_r = previous_halfedge(entered);
    const int side = r == v ? 0 : orient(at(u), at(v), at(r));
    if (side <= 0) add_to_rim(right_, to_r);
    if (side >= 0) add_to_rim(left_, from_r);
    if (side == 0) {
      end = r;
      return {};
    }
    h = side > 0 ? to_r : from_r;
  }
}

void ConstrainedMesh::add_to_rim(Rim& rim, HalfedgeId own) {
  rim.push_back(
      {mesh_.origin(own), mesh_.target(own), own, mesh_.twin[own], edge_[own], kNone, kNone});
}

}  // namespace quadloom::kernel
