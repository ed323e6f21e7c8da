// Hertel and Mehlhorn's merging of triangles into convex parts (1983, "Fast triangulation of simple
// polygons"): edges between two parts go, one after the other, where the union is convex. Of a simple
// polygon that leaves at most four times as many parts as there must be: at each reflex corner at
// most two edges stay that are needed there, and of the edges of any cut into convex parts at least one
// ends at each reflex corner.
//
//   1. edges_by_length  the longer ones first: short edges stay (in floating point; no guarantee rests
//                       on it)
//   2. link             each part is a ring of halfedges, next and before
//   3. can_go, remove   the angles at both ends of the edge, exact; the two rings become one
//   4. collect          the parts
//
//         \   /          The angle that both parts have at an end is at most half a turn if the edge
//          \ /           before and the one behind turn left or go straight on. It is less than a whole
//      .----o----.       turn, so that straight on is never straight back; a flat corner is welcome.
//     before    behind
//
// The mesh has no inner vertices; holes need no care. Cost: O(n log n) for the lengths, else linear: what
// cannot go once cannot go later, as angles only grow.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "kernel/predicates_inline.hpp"
#include "strips/convex_parts.hpp"

namespace quadloom::strips {
namespace {

class Merging {
 public:
  explicit Merging(const Triangulation& mesh) : mesh_(mesh), gone_(mesh.tri_vertex.size(), 0) {}

  std::vector<std::vector<VertexId>> merge() {
    link();
    for (const HalfedgeId h : edges_by_length()) {
      if (can_go(h) && can_go(mesh_.twin[h])) remove(h);
    }
    return collect();
  }

 private:
  Point at(VertexId v) const { return mesh_.points[v]; }

  std::vector<HalfedgeId> edges_by_length() const;
  void link();
  bool can_go(HalfedgeId h) const;
  void remove(HalfedgeId h);
  std::vector<std::vector<VertexId>> collect() const;

  const Triangulation& mesh_;
  std::vector<HalfedgeId> next_, before_;
  std::vector<std::uint8_t> gone_;
};

std::vector<HalfedgeId> Merging::edges_by_length() const {
  std::vector<HalfedgeId> edges;
  std::vector<double> length(mesh_.twin.size(), 0);
  for (HalfedgeId h = 0; h < mesh_.twin.size(); ++h) {
    if (mesh_.twin[h] == kNone || mesh_.twin[h] < h) continue;
    const Point p = at(mesh_.origin(h)), q = at(mesh_.target(h));
    length[h] = std::hypot(q.x / 2 - p.x / 2, q.y / 2 - p.y / 2);
    edges.push_back(h);
  }
  std::stable_sort(edges.begin(), edges.end(),
                   [&](HalfedgeId g, HalfedgeId h) { return length[g] > length[h]; });
  return edges;
}

void Merging::link() {
  for (HalfedgeId h = 0; h < mesh_.tri_vertex.size(); ++h) {
    next_.push_back(next_halfedge(h));
    before_.push_back(previous_halfedge(h));
  }
}

/// The angle at the edge's origin.
bool Merging::can_go(HalfedgeId h) const {
  const Point from = at(mesh_.origin(before_[h])), corner = at(mesh_.origin(h)),
              to = at(mesh_.target(next_[mesh_.twin[h]]));
  return kernel::orient(from, corner, to) >= 0;
}

void Merging::remove(HalfedgeId h) {
  const HalfedgeId g = mesh_.twin[h];
  const auto join = [&](HalfedgeId a, HalfedgeId b) {
    next_[a] = b;
    before_[b] = a;
  };
  join(before_[h], next_[g]);
  join(before_[g], next_[h]);
  gone_[h] = gone_[g] = 1;
}

std::vector<std::vector<VertexId>> Merging::collect() const {
  std::vector<std::uint8_t> seen = gone_;
  std::vector<std::vector<VertexId>> parts;
  for (HalfedgeId start = 0; start < seen.size(); ++start) {
    if (seen[start] != 0) continue;
    auto& part = parts.emplace_back();
    for (HalfedgeId h = start; seen[h] == 0; h = next_[h]) {
      seen[h] = 1;
      part.push_back(mesh_.origin(h));
    }
  }
  return parts;
}

}  // namespace

std::vector<std::vector<VertexId>> merge_to_convex(const Triangulation& mesh) {
  return Merging(mesh).merge();
}

}  // namespace quadloom::strips
