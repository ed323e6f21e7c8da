// The visibility graph of a simple polygon, corner by corner (theorem 2.1 of Arkin, Held, Mitchell and
// Skiena starts from it).
//
//   look_from      the triangles at the corner, counter-clockwise; through the far side of each:
//   look_through   the third corner c of the triangle beyond a window, in the cone of directions that
//                  is left. Strictly inside the cone it is seen, and the cone is cut in two there; on
//                  one of its sides it is seen past the corner that this side touches, which it
//                  replaces; outside nothing is seen of it
//
//         c             All directions of an open cone reach the window, so that a segment to a corner
//        / \            strictly inside it crosses the edges before it in their open parts: no corner
//   left ---  right     is on it. The two sides of a cone are never on one line with the eye.
//       \   /
//        eye
//
// The paper takes Hershberger's algorithm, O(E) in all. This is triangular expansion: the dual of the
// triangles is a tree, so that each triangle is looked into at most once a corner, and only if some of
// it is seen. O(n) a corner and O(n^2) in all at worst, even where E is smaller (along a row of
// collinear corners each is seen past the others); for random polygons about as many triangles are
// looked into as corners are seen. No recursion, O(n) space beside the chords. Collinear corners are
// decided by exact predicates; see Sight.
#include "strips/visibility.hpp"

#include "kernel/predicates_inline.hpp"

namespace quadloom::strips {

const std::vector<Seen>& Visibility::look_from(Position from) {
  const Triangulation& mesh = disc_.mesh;
  const Point eye = disc_.at(from);
  seen_.clear();
  for (HalfedgeId h = disc_.side[from]; h != kNone; h = mesh.twin[previous_halfedge(h)]) {
    open_.push_back({next_halfedge(h), mesh.target(h), mesh.apex(h), {}});
    while (!open_.empty()) {
      const Window window = open_.back();
      open_.pop_back();
      if (window.halfedge == kNone) {
        seen_.push_back(window.seen);
      } else if (mesh.twin[window.halfedge] != kNone) {
        ++work_;
        look_through(eye, window);
      }
    }
    const HalfedgeId last = previous_halfedge(h);
    if (mesh.twin[last] != kNone) seen_.push_back({disc_.position_of[last], Sight::kChord});
  }
  return seen_;
}

/// What comes first counter-clockwise goes onto the stack last.
void Visibility::look_through(Point eye, const Window& window) {
  const Triangulation& mesh = disc_.mesh;
  const HalfedgeId beyond = mesh.twin[window.halfedge];
  const HalfedgeId to_right = next_halfedge(beyond), to_left = previous_halfedge(beyond);
  const VertexId c = mesh.origin(to_left);
  const Position position = disc_.position_of[to_left];
  const int of_right = kernel::orient(eye, mesh.points[window.right], mesh.points[c]);
  const int of_left = kernel::orient(eye, mesh.points[c], mesh.points[window.left]);
  if (of_right <= 0) {
    open_.push_back({to_left, of_right == 0 ? c : window.right, window.left, {}});
    if (of_right == 0) open_.push_back({kNone, kNone, kNone, {position, Sight::kPastBefore}});
  } else if (of_left <= 0) {
    if (of_left == 0) open_.push_back({kNone, kNone, kNone, {position, Sight::kPastAfter}});
    open_.push_back({to_right, window.right, of_left == 0 ? c : window.left, {}});
  } else {
    open_.push_back({to_left, c, window.left, {}});
    open_.push_back({kNone, kNone, kNone, {position, Sight::kChord}});
    open_.push_back({to_right, window.right, c, {}});
  }
}

VisibilityGraph visibility_graph(const PolygonDisc& disc) {
  VisibilityGraph graph;
  graph.begin.reserve(std::size_t{disc.size()} + 1);
  Visibility visibility(disc);
  for (Position i = 0; i < disc.size(); ++i) {
    for (const Seen& seen : visibility.look_from(i)) {
      if (seen.sight == Sight::kChord) graph.other.push_back(seen.position);
    }
    graph.begin.push_back(graph.other.size());
  }
  return graph;
}

}  // namespace quadloom::strips
