// The boundary cycle:
//
//   1. join_edges: the edges without a reverse form one closed cycle, each vertex once.
//   2. check_turns: at every vertex the cycle turns left, or goes straight on (no folding back).
//   3. check_once_around: it goes up in lexicographic order from its smallest vertex to its largest
//      and down again, nothing else.
//
// By 2 every turn is in [0, 180) degrees, so that their sum is a positive number k of full turns,
// and the cycle changes between up and down 2 k times; by 3, k = 1. A closed curve that only turns
// left, by one full turn in all, is the boundary of a convex region, counter-clockwise.

#include "certify/boundary.hpp"

#include <algorithm>

#include "certify/wording.hpp"
#include "quadloom/kernel.hpp"

namespace quadloom::certify {
namespace {

class Boundary {
 public:
  Boundary(const PolygonMesh& mesh, const std::vector<DirectedEdge>& edges)
      : mesh_(mesh), edges_(edges) {}

  BoundaryReport judge() {
    if (join_edges() && check_turns()) check_once_around();
    return std::move(report_);
  }

 private:
  bool fault(std::string sentence, std::vector<std::size_t> culprits) {
    report_.sentence = std::move(sentence);
    report_.culprits = std::move(culprits);
    return false;
  }

  bool join_edges() {
    if (edges_.empty()) return fault("the mesh has no boundary", {});
    std::vector<VertexId> next(mesh_.points.size(), kNone);
    VertexId start = edges_[0].from;
    for (const auto [from, to] : edges_) {
      if (next[from] != kNone) {
        return fault("the boundary passes twice through " + vertex_text(mesh_, from), {from});
      }
      next[from] = to;
      if (lex_less(mesh_.points[from], mesh_.points[start])) start = from;
    }
    VertexId at = start;
    do {
      report_.cycle.push_back(at);
      if (next[at] == kNone || report_.cycle.size() > edges_.size()) {
        return fault("the boundary is not a closed cycle at " + vertex_text(mesh_, at), {at});
      }
      at = next[at];
    } while (at != start);
    if (report_.cycle.size() == edges_.size()) return true;
    for (const VertexId v : report_.cycle) next[v] = kNone;
    const auto other = std::ranges::find_if(edges_, [&](auto e) { return next[e.from] != kNone; });
    return fault("the boundary falls into several cycles: one through " +
                     vertex_text(mesh_, start) + ", another through " +
                     vertex_text(mesh_, other->from),
                 {start, other->from});
  }

  bool check_turns() {
    const auto& cycle = report_.cycle;
    for (std::size_t i = 0; i < cycle.size(); ++i) {
      const VertexId v = cycle[i];
      const Point before = mesh_.points[i == 0 ? cycle.back() : cycle[i - 1]], at = mesh_.points[v],
                  after = mesh_.points[i + 1 == cycle.size() ? cycle[0] : cycle[i + 1]];
      const int turn = orient2d(before, at, after);
      if (turn < 0) return fault("the boundary turns right at " + vertex_text(mesh_, v), {v});
      if (turn == 0 && dot_sign(before, at, at, after) <= 0) {
        return fault("the boundary folds back at " + vertex_text(mesh_, v), {v});
      }
    }
    return true;
  }

  bool check_once_around() {
    const auto& cycle = report_.cycle;
    const auto up = [&](VertexId a, VertexId b) {
      return lex_less(mesh_.points[a], mesh_.points[b]);
    };
    const auto top = std::ranges::adjacent_find(cycle, [&](auto a, auto b) { return !up(a, b); });
    const auto again = std::adjacent_find(top, cycle.end(), up);
    if (again == cycle.end()) return true;
    return fault(
        "the boundary goes around more than once, it rises again at " + vertex_text(mesh_, *again),
        {*again});
  }

  const PolygonMesh& mesh_;
  const std::vector<DirectedEdge>& edges_;
  BoundaryReport report_;
};

}  // namespace

BoundaryReport judge_boundary(const PolygonMesh& mesh, const std::vector<DirectedEdge>& edges) {
  return Boundary(mesh, edges).judge();
}

}  // namespace quadloom::certify
