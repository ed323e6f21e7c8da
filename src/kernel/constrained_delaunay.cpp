// The constrained Delaunay triangulation (Lee and Lin 1986, Chew 1989) of polygons, segments and
// points.
//
// Steps:
//   1. delaunay        of all points (delaunay.cpp)
//   2. insert_edges    the rings' edges, then the segments, one by one: the triangles that an edge
//                      crosses are replaced (constrained_walk.cpp, constrained_cavity.cpp). An edge
//                      that crosses another or runs along one shows here
//   3. find_parts      which polygon each triangle is in (polygon_parts.cpp), or what the segments
//                      enclose (enclosed_parts.cpp)
//   4. keep_inside     the triangles outside and the vertices that only they use are dropped
//
// Cost: O(n log n) expected for step 1, the crossed edges for step 2, linear for the rest.
// Degenerate input: points on edges split them, duplicates are merged, edges of length zero are
// nothing. Cocircular points: as in delaunay.cpp; with the ties decided there is one constrained
// Delaunay triangulation, so neither the order of the points nor that of the edges matters.
#include <cmath>
#include <string>
#include <unordered_map>
#include <utility>

#include "core/point_text.hpp"
#include "kernel/constrained_mesh.hpp"
#include "kernel/planar_edges.hpp"
#include "kernel/planar_region.hpp"

namespace quadloom {
namespace {

using kernel::ConstrainedMesh;
using kernel::EdgeEnds;
using kernel::Obstacle;
using kernel::PlanarEdges;
using kernel::RingRange;

void check_places(std::span<const Point> places, const char* what) {
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (std::isfinite(places[i].x) && std::isfinite(places[i].y)) continue;
    throw Error(ErrorCode::kNotFinite,
                std::string("the place of ") + what + ' ' + std::to_string(i) + " is not finite",
                {i});
  }
}

class Constrained {
 public:
  Constrained(const PlanarInput& input, Extent extent)
      : input_(input), extent_(extent), edges_(input) {}

  ConstrainedResult build() {
    check_input();
    DelaunayResult all = delaunay(edges_.points());
    out_.input_to_vertex = std::move(all.input_to_vertex);
    check_rings();
    insert_edges(std::move(all.mesh));
    find_parts();
    if (extent_ == Extent::kInside) keep_inside();
    return std::move(out_);
  }

 private:
  void check_input() const;
  void check_rings() const;
  void insert_edges(Triangulation mesh);
  void meet(std::uint32_t edge, const Obstacle& obstacle);
  void find_parts();
  void keep_inside();
  void drop_vertices();
  std::pair<VertexId, VertexId> vertices_of(std::uint32_t edge) const {
    const EdgeEnds ends = edges_.ends(edge);
    return {out_.input_to_vertex[ends.from], out_.input_to_vertex[ends.to]};
  }

  const PlanarInput& input_;
  Extent extent_;
  PlanarEdges edges_;
  ConstrainedResult out_;
  std::unordered_map<std::uint32_t, std::uint32_t> also_;  // edges of two polygons: the second one
  std::vector<std::uint8_t> inside_;
};

void Constrained::check_input() const {
  if (!input_.polygons.empty() && !(input_.holes.empty() && input_.regions.empty())) {
    throw Error(ErrorCode::kBadOption,
                "places of holes and regions are for segments, polygons say themselves what is "
                "inside");
  }
  check_places(input_.holes, "hole");
  check_places(input_.regions, "region");
}

void Constrained::check_rings() const {
  for (const RingRange& ring : edges_.rings()) {
    const auto first = out_.input_to_vertex.begin() + ring.first;
    VertexId a = kNone, b = kNone;
    bool third = false;
    for (auto v = first; v != first + ring.size && !third; ++v) {
      if (a == kNone || a == *v) {
        a = *v;
      } else if (b == kNone || b == *v) {
        b = *v;
      } else {
        third = true;
      }
    }
    if (third) continue;
    throw Error(ErrorCode::kBadPolygon,
                "ring " + std::to_string(ring.ring) + " of polygon " +
                    std::to_string(ring.polygon) + " has fewer than three different corners",
                {ring.polygon, ring.ring});
  }
}

void Constrained::insert_edges(Triangulation mesh) {
  ConstrainedMesh constrained(std::move(mesh));
  for (std::uint32_t e = 0; e < edges_.edge_count(); ++e) {
    const auto [from, to] = vertices_of(e);
    if (from == to) continue;
    const Obstacle obstacle = constrained.insert(from, to, e);
    if (obstacle.kind != Obstacle::Kind::kNone) meet(e, obstacle);
  }
  std::tie(out_.mesh, out_.edge) = std::move(constrained).take();
}

/// Two edges with the same ends are one if they are of two polygons or one is a segment; everything
/// else is an error.
void Constrained::meet(std::uint32_t edge, const Obstacle& obstacle) {
  const std::uint32_t other = obstacle.edge;
  const char* how = "crosses";
  if (obstacle.kind == Obstacle::Kind::kCoincides) {
    how = "overlaps";
    auto a = vertices_of(edge), b = vertices_of(other);
    if (a.first > a.second) std::swap(a.first, a.second);
    if (b.first > b.second) std::swap(b.first, b.second);
    const bool same_ends = a == b;
    if (same_ends && !edges_.is_ring_edge(edge)) return;
    if (same_ends && edges_.ring_of(edge).polygon != edges_.ring_of(other).polygon &&
        also_.try_emplace(other, edge).second) {
      return;
    }
  }
  throw Error(ErrorCode::kCrossing, edges_.text(edge) + ' ' + how + ' ' + edges_.text(other),
              {other, edge});
}

void Constrained::find_parts() {
  if (!input_.polygons.empty()) {
    out_.part = kernel::polygon_parts(out_.mesh, out_.edge, edges_, also_);
    inside_.resize(out_.part.size());
    for (std::size_t t = 0; t < out_.part.size(); ++t) inside_[t] = out_.part[t] != kNone ? 1 : 0;
  } else {
    kernel::EnclosedParts parts = kernel::enclosed_parts(out_.mesh, out_.edge, input_);
    out_.part = std::move(parts.part);
    inside_ = std::move(parts.inside);
  }
}

void Constrained::keep_inside() {
  std::vector<TriangleId> number(inside_.size(), kNone);
  TriangleId kept = 0;
  for (TriangleId t = 0; t < inside_.size(); ++t) {
    if (inside_[t] != 0) number[t] = kept++;
  }
  if (kept == 0) throw Error(ErrorCode::kBadPolygon, "the segments enclose nothing");
  for (TriangleId t = 0; t < inside_.size(); ++t) {
    if (number[t] == kNone) continue;
    for (HalfedgeId i = 0; i < 3; ++i) {
      const HalfedgeId from = 3 * t + i, to = 3 * number[t] + i;
      const HalfedgeId twin = out_.mesh.twin[from];
      const TriangleId beyond = twin == kNone ? kNone : number[triangle_of(twin)];
      out_.mesh.tri_vertex[to] = out_.mesh.tri_vertex[from];
      out_.mesh.twin[to] = beyond == kNone ? kNone : 3 * beyond + twin % 3;
      out_.edge[to] = out_.edge[from];
    }
    out_.part[number[t]] = out_.part[t];
  }
  out_.mesh.tri_vertex.resize(3 * std::size_t{kept});
  out_.mesh.twin.resize(3 * std::size_t{kept});
  out_.edge.resize(3 * std::size_t{kept});
  out_.part.resize(kept);
  drop_vertices();
}

void Constrained::drop_vertices() {
  std::vector<VertexId> number(out_.mesh.points.size(), kNone);
  for (const VertexId v : out_.mesh.tri_vertex) number[v] = 0;
  VertexId kept = 0;
  for (VertexId v = 0; v < number.size(); ++v) {
    if (number[v] == kNone) continue;
    out_.mesh.points[kept] = out_.mesh.points[v];
    number[v] = kept++;
  }
  out_.mesh.points.resize(kept);
  for (VertexId& v : out_.mesh.tri_vertex) v = number[v];
  for (VertexId& v : out_.input_to_vertex) v = number[v];
}

}  // namespace

ConstrainedResult constrained_delaunay(const PlanarInput& input, Extent extent) {
  return Constrained(input, extent).build();
}

ConstrainedResult constrained_delaunay(const Polygon& polygon, std::span<const Point> inner) {
  PlanarInput input;
  input.polygons.push_back(polygon);
  input.points.assign(inner.begin(), inner.end());
  return constrained_delaunay(input);
}

}  // namespace quadloom
