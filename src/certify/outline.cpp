// The given boundary, and whether a mesh's boundary edges are those:
//
//   1. begin_at   the boundary edges by the vertex at which they begin
//   2. follow     for each given edge a -> b the boundary edges from a straight on to b, or with
//                 outer Steiner points the two edges a -> s -> b:
//
//                          s        s outside, added
//                         / \.
//       a --v--v-- b     a   b
//
//   3. nothing left over
#include "certify/outline.hpp"

#include <algorithm>

#include "certify/layout.hpp"
#include "certify/wording.hpp"
#include "kernel/ring_direction.hpp"

namespace quadloom::certify {
namespace {

bool edge_less(const OutlineEdge& a, const OutlineEdge& b) {
  if (a.from != b.from) return lex_less(a.from, b.from);
  return lex_less(a.to, b.to);
}

/// Drops each pair of an edge and its reverse.
void drop_shared(std::vector<OutlineEdge>& edges) {
  std::ranges::sort(edges, edge_less);
  std::vector<OutlineEdge> out;
  for (const OutlineEdge& e : edges) {
    if (!std::ranges::binary_search(edges, OutlineEdge{e.to, e.from}, edge_less)) out.push_back(e);
  }
  edges = std::move(out);
}

class Matching {
 public:
  Matching(const PolygonMesh& mesh, std::span<const DirectedEdge> boundary, const Places& places,
           std::span<const std::uint8_t> is_steiner, bool outer_steiner)
      : mesh_(mesh),
        boundary_(boundary),
        places_(places),
        is_steiner_(is_steiner),
        outer_steiner_(outer_steiner),
        used_(boundary.size(), 0) {}

  OutlineReport match(std::span<const OutlineEdge> outline) {
    begin_at();
    for (const OutlineEdge& edge : outline) {
      if (!follow(edge)) return fail_missing(edge);
    }
    const auto left_over = std::ranges::find(used_, 0);
    if (left_over == used_.end()) return {};
    const auto [from, to] = boundary_[static_cast<std::size_t>(left_over - used_.begin())];
    return {"the boundary edge from " + vertex_text(mesh_, from) + " to " + vertex_text(mesh_, to) +
                " is not on the given boundary",
            {from, to}};
  }

 private:
  void begin_at() {
    begin_.assign(mesh_.points.size() + 1, 0);
    for (const DirectedEdge& e : boundary_) ++begin_[e.from + 1];
    for (std::size_t v = 1; v < begin_.size(); ++v) begin_[v] += begin_[v - 1];
    order_.resize(boundary_.size());
    std::vector<std::uint32_t> next = begin_;
    for (std::uint32_t i = 0; i < boundary_.size(); ++i) order_[next[boundary_[i].from]++] = i;
  }

  std::span<const std::uint32_t> from(VertexId v) const {
    return std::span(order_).subspan(begin_[v], begin_[v + 1] - begin_[v]);
  }

  /// From v straight towards `to` (not beyond): the place of the edge in the list, or kNone.
  std::uint32_t straight(VertexId v, Point to) const {
    const Point p = mesh_.points[v];
    for (const std::uint32_t e : from(v)) {
      const Point q = mesh_.points[boundary_[e].to];
      if (used_[e] == 0 && orient2d(p, to, q) == 0 && dot_sign(p, to, p, q) > 0 &&
          (q == to || dot_sign(q, to, p, to) > 0)) {
        return e;
      }
    }
    return kNone;
  }

  bool follow(const OutlineEdge& edge) {
    VertexId v = places_.find(edge.from);
    if (v == kNone) return false;
    const std::uint32_t first = straight(v, edge.to);
    if (first == kNone) return outer_steiner_ && around(v, edge.to);
    while (mesh_.points[v] != edge.to) {
      const std::uint32_t e = straight(v, edge.to);
      if (e == kNone) return false;
      used_[e] = 1;
      v = boundary_[e].to;
    }
    return true;
  }

  bool around(VertexId v, Point to) {
    for (const std::uint32_t e : from(v)) {
      const VertexId s = boundary_[e].to;
      if (used_[e] != 0 || is_steiner_[s] == 0) continue;
      for (const std::uint32_t f : from(s)) {
        if (used_[f] != 0 || mesh_.points[boundary_[f].to] != to) continue;
        used_[e] = used_[f] = 1;
        return true;
      }
    }
    return false;
  }

  OutlineReport fail_missing(const OutlineEdge& edge) const {
    OutlineReport out;
    out.sentence = "the given boundary edge from " + point_text(edge.from) + " to " +
                   point_text(edge.to) + " is not on the mesh's boundary";
    for (const Point p : {edge.from, edge.to}) {
      if (const VertexId v = places_.find(p); v != kNone) out.culprits.push_back(v);
    }
    return out;
  }

  const PolygonMesh& mesh_;
  std::span<const DirectedEdge> boundary_;
  const Places& places_;
  std::span<const std::uint8_t> is_steiner_;
  bool outer_steiner_;
  std::vector<std::uint8_t> used_;
  std::vector<std::uint32_t> begin_;  // by vertex, into order_
  std::vector<std::uint32_t> order_;  // the boundary edges by their beginning
};

}  // namespace

std::vector<OutlineEdge> outline_of(std::span<const Polygon> polygons) {
  std::vector<OutlineEdge> out;
  for (const Polygon& polygon : polygons) {
    for (std::size_t r = 0; r < polygon.rings.size(); ++r) {
      const auto& ring = polygon.rings[r];
      if (ring.empty()) continue;
      const bool as_given = kernel::goes_counter_clockwise(ring) == (r == 0);
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point a = ring[i], b = ring[i + 1 == ring.size() ? 0 : i + 1];
        if (a != b) out.push_back(as_given ? OutlineEdge{a, b} : OutlineEdge{b, a});
      }
    }
  }
  drop_shared(out);
  return out;
}

EdgeReport check_source(const PolygonMesh& mesh) {
  if (!layout_fits(mesh)) {
    throw Error(ErrorCode::kBadMesh, "the faces' beginnings do not fit the list of corners");
  }
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    if (mesh.face(f).size() < 3) {
      throw Error(ErrorCode::kBadMesh, face_text(mesh, f) + " has fewer than three corners", {f});
    }
    for (const VertexId v : mesh.face(f)) {
      if (v < mesh.points.size()) continue;
      throw Error(ErrorCode::kIndexOutOfRange,
                  face_text(mesh, f) + " names a vertex that is not there", {f, v});
    }
  }
  EdgeReport report = match_edges(mesh);
  if (report.repeated.from != kNone) {
    const auto [from, to] = report.repeated;
    throw Error(ErrorCode::kBadMesh,
                "two faces of the source have the edge from " + vertex_text(mesh, from) + " to " +
                    vertex_text(mesh, to) + " on the same side",
                {from, to});
  }
  return report;
}

std::vector<OutlineEdge> outline_of(const PolygonMesh& mesh) {
  const EdgeReport report = check_source(mesh);
  std::vector<OutlineEdge> out;
  for (const auto [from, to] : report.alone) out.push_back({mesh.points[from], mesh.points[to]});
  return out;
}

OutlineReport match_outline(const PolygonMesh& mesh, std::span<const DirectedEdge> boundary,
                            std::span<const OutlineEdge> outline, const Places& places,
                            std::span<const std::uint8_t> is_steiner, bool outer_steiner) {
  return Matching(mesh, boundary, places, is_steiner, outer_steiner).match(outline);
}

}  // namespace quadloom::certify
