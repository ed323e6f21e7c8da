// Whether the boundary edges of a mesh bound a region once: they meet at common ends alone, and the
// winding number about any place is 0 or 1. As the winding number of its boundary is the number of
// faces over a place, the faces then tile the region once.
//
// A sweep as in polygon.cpp, over the vertices in lexicographic order:
//
//   1. end_edges     takes the edges that end at a vertex out of the ordered set of edges that the
//                    line meets, and tests the two that become neighbours
//   2. begin_edges   puts in those that begin, and tests the lowest and the highest with their
//                    neighbours; an edge through the vertex shows as a zero when the place is sought
//   3. wind          from the lowest of them to the highest, the winding number above each is that
//                    below it, one more if it goes to the right (the inside is on its left), one less
//                    if to the left
//
// Between its ends an edge meets no other, so the numbers on its sides stay. Cost O(k log k).
#include <algorithm>
#include <set>

#include "certify/outline.hpp"
#include "certify/wording.hpp"
#include "kernel/segments.hpp"

namespace quadloom::certify {
namespace {

class Winding {
 public:
  Winding(const PolygonMesh& mesh, std::span<const DirectedEdge> edges)
      : mesh_(mesh), edges_(edges), active_(Below{this}), place_(edges.size(), active_.end()) {}

  OutlineReport judge() {
    sort_ends();
    for (std::size_t i = 0; i < ends_.size() && report_.sentence.empty();) {
      std::size_t next = i;
      while (next < ends_.size() && ends_[next].vertex == ends_[i].vertex) ++next;
      const auto here = std::span(ends_).subspan(i, next - i);
      end_edges(here);
      begin_edges(here);
      if (report_.sentence.empty()) wind(here);
      i = next;
    }
    return std::move(report_);
  }

 private:
  using Edge = std::uint32_t;
  struct End {
    VertexId vertex;
    Edge edge;
    bool begins;
  };
  struct Below {
    Winding* sweep;
    bool operator()(Edge a, Edge b) const { return sweep->below(a, b); }
  };
  using Active = std::set<Edge, Below>;

  Point at(VertexId v) const { return mesh_.points[v]; }
  bool goes_right(Edge e) const { return lex_less(at(edges_[e].from), at(edges_[e].to)); }
  VertexId first(Edge e) const { return goes_right(e) ? edges_[e].from : edges_[e].to; }
  VertexId last(Edge e) const { return goes_right(e) ? edges_[e].to : edges_[e].from; }

  void sort_ends() {
    for (Edge e = 0; e < edges_.size(); ++e) {
      ends_.push_back({first(e), e, true});
      ends_.push_back({last(e), e, false});
    }
    std::ranges::sort(ends_, [&](const End& a, const End& b) {
      return a.vertex != b.vertex ? lex_less(at(a.vertex), at(b.vertex)) : a.edge < b.edge;
    });
    above_.assign(edges_.size(), 0);
  }

  void fail_meeting(Edge a, Edge b) {
    if (!report_.sentence.empty()) return;
    report_.sentence = "the boundary edges from " + vertex_text(mesh_, edges_[a].from) + " to " +
                       vertex_text(mesh_, edges_[a].to) + " and from " +
                       vertex_text(mesh_, edges_[b].from) + " to " +
                       vertex_text(mesh_, edges_[b].to) + " meet";
    report_.culprits = {edges_[a].from, edges_[a].to, edges_[b].from, edges_[b].to};
  }

  bool below(Edge a, Edge b) {
    if (a == b) return false;
    const Point as = at(first(a)), bs = at(first(b));
    const int side = first(a) == first(b) ? orient2d(as, at(last(a)), at(last(b)))
                     : lex_less(as, bs)   ? orient2d(as, at(last(a)), bs)
                                          : -orient2d(bs, at(last(b)), as);
    if (side == 0) fail_meeting(a, b);
    return side > 0;
  }

  void test(Edge a, Edge b) {
    if (first(a) == first(b) || last(a) == last(b) || first(a) == last(b) || last(a) == first(b)) {
      return;  // collinear ones are found by below()
    }
    if (kernel::segments_meet(at(first(a)), at(last(a)), at(first(b)), at(last(b))))
      fail_meeting(a, b);
  }

  void end_edges(std::span<const End> here) {
    for (const End& end : here) {
      if (end.begins || place_[end.edge] == active_.end()) continue;
      const auto above = active_.erase(place_[end.edge]);
      place_[end.edge] = active_.end();
      if (above != active_.end() && above != active_.begin()) test(*std::prev(above), *above);
    }
  }

  void begin_edges(std::span<const End> here) {
    for (const End& end : here) {
      if (!end.begins || !report_.sentence.empty()) continue;
      const auto [place, is_new] = active_.insert(end.edge);
      if (!is_new) fail_meeting(end.edge, *place);
      if (!report_.sentence.empty()) return;
      place_[end.edge] = place;
      if (place != active_.begin()) test(*std::prev(place), end.edge);
      if (std::next(place) != active_.end()) test(end.edge, *std::next(place));
    }
  }

  void wind(std::span<const End> here) {
    auto lowest = active_.end();
    for (const End& end : here) {
      if (end.begins && (lowest == active_.end() || below(end.edge, *lowest))) {
        lowest = place_[end.edge];
      }
    }
    if (lowest == active_.end()) return;
    int number = lowest == active_.begin() ? 0 : above_[*std::prev(lowest)];
    for (auto e = lowest; e != active_.end() && first(*e) == here.front().vertex; ++e) {
      number += goes_right(*e) ? 1 : -1;
      above_[*e] = number;
      if (number == 0 || number == 1) continue;
      report_.sentence = "the boundary goes around the side of its edge from " +
                         vertex_text(mesh_, edges_[*e].from) + " to " +
                         vertex_text(mesh_, edges_[*e].to) + ' ' + std::to_string(number) +
                         " times";
      report_.culprits = {edges_[*e].from, edges_[*e].to};
      return;
    }
  }

  const PolygonMesh& mesh_;
  std::span<const DirectedEdge> edges_;
  std::vector<End> ends_;
  std::vector<int> above_;
  OutlineReport report_;
  Active active_;
  std::vector<Active::iterator> place_;
};

}  // namespace

OutlineReport judge_winding(const PolygonMesh& mesh, std::span<const DirectedEdge> boundary) {
  return Winding(mesh, boundary).judge();
}

}  // namespace quadloom::certify
