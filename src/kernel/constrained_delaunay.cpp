// The constrained Delaunay triangulation (Lee and Lin 1986, Chew 1989) of polygons, segments and
// points.
//
// Steps:
//   1. delaunay        of all points (delaunay.cpp)
//   2. insert_edges    the rings' edges, then the segments. First those that are edges already, in
//                      order; then the others one by one: the triangles that an edge crosses are
//                      replaced (constrained_walk.cpp, constrained_cavity.cpp). They come in random
//                      rounds, each twice the one before and in order, which bounds the expected
//                      number of crossed triangles (Shewchuk and Brown 2015); along a spiral, one
//                      after the other, it would be quadratic. An edge that crosses another or runs
//                      along one shows here
//   3. find_parts      which polygon each triangle is in (polygon_parts.cpp), or what the segments
//                      enclose (enclosed_parts.cpp)
//   4. keep_inside     the triangles outside and the vertices that only they use are dropped
//
// Cost: O(n log n) expected for step 1, the crossed edges for step 2 (O(n log^2 n) expected, and
// their flips), linear for the rest.
// Degenerate input: points on edges split them, duplicates are merged, edges of length zero are
// nothing. Cocircular points: as in delaunay.cpp; with the ties decided there is one constrained
// Delaunay triangulation, so neither the order of the points nor that of the edges matters.
#include <algorithm>
#include <bit>
#include <cmath>
#include <string>
#include <unordered_map>
#include <utility>

#include "core/random.hpp"
#include "core/step_reports.hpp"
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

/// The edges by rounds; half of them are in the last round, half of the others in the one before.
std::vector<std::uint32_t> in_rounds(const std::vector<std::uint32_t>& edges) {
  constexpr int kRounds = 32;
  Random random(1);
  std::vector<std::uint8_t> round;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const int zeros = std::min(std::countr_zero(random.next()), kRounds - 1);
    round.push_back(static_cast<std::uint8_t>(kRounds - 1 - zeros));
  }
  std::vector<std::uint32_t> out;
  out.reserve(edges.size());
  for (int r = 0; r < kRounds; ++r) {
    for (std::size_t i = 0; i < edges.size(); ++i) {
      if (round[i] == r) out.push_back(edges[i]);
    }
  }
  return out;
}

class Constrained {
 public:
  Constrained(const PlanarInput& input, Extent extent, const Progress& progress)
      : input_(input), extent_(extent), progress_(progress), edges_(input) {}

  ConstrainedResult build() {
    check_input();
    report_progress(progress_, "triangulating", 0);
    DelaunayResult all = delaunay(edges_.points());
    out_.input_to_vertex = std::move(all.input_to_vertex);
    check_rings();
    insert_edges(std::move(all.mesh));
    report_progress(progress_, "finding parts", 0);
    find_parts();
    if (extent_ == Extent::kInside) keep_inside();
    return std::move(out_);
  }

 private:
  void check_input() const;
  void check_rings() const;
  void insert_edges(Triangulation mesh);
  void insert_range(ConstrainedMesh& mesh, std::uint32_t begin, std::uint32_t end);
  void meet(std::uint32_t edge, const Obstacle& obstacle);
  void rename(std::uint32_t inserted, std::uint32_t other);
  void rename_edges();
  void find_parts();
  void keep_inside();
  void drop_vertices();
  std::pair<VertexId, VertexId> vertices_of(std::uint32_t edge) const {
    const EdgeEnds ends = edges_.ends(edge);
    return {out_.input_to_vertex[ends.from], out_.input_to_vertex[ends.to]};
  }

  const PlanarInput& input_;
  Extent extent_;
  const Progress& progress_;
  PlanarEdges edges_;
  ConstrainedResult out_;
  std::unordered_map<std::uint32_t, std::uint32_t> also_;  // edges of two polygons: the second one
  std::unordered_map<std::uint32_t, std::uint32_t> name_;  // of inserted edges that get another
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
  insert_range(constrained, 0, edges_.ring_edges());
  insert_range(constrained, edges_.ring_edges(), edges_.edge_count());
  std::tie(out_.mesh, out_.edge) = std::move(constrained).take();
  rename_edges();
}

void Constrained::insert_range(ConstrainedMesh& mesh, std::uint32_t begin, std::uint32_t end) {
  std::vector<std::uint32_t> missing;
  StepReports report(progress_, "inserting edges", edges_.edge_count());
  for (std::uint32_t e = begin; e < end; ++e) {
    report();
    const auto [from, to] = vertices_of(e);
    if (from == to) continue;
    const auto obstacle = mesh.insert_existing(from, to, e);
    if (!obstacle) {
      missing.push_back(e);
    } else if (obstacle->kind != Obstacle::Kind::kNone) {
      meet(e, *obstacle);
    }
  }
  StepReports report_missing(progress_, "inserting missing edges", missing.size(), 256);
  for (const std::uint32_t e : in_rounds(missing)) {
    report_missing();
    const auto [from, to] = vertices_of(e);
    const Obstacle obstacle = mesh.insert(from, to, e);
    if (obstacle.kind != Obstacle::Kind::kNone) meet(e, obstacle);
  }
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
    if (same_ends && !edges_.is_ring_edge(edge)) {
      rename(other, edge);
      return;
    }
    if (same_ends && edges_.ring_of(edge).polygon != edges_.ring_of(other).polygon &&
        also_.try_emplace(other, edge).second) {
      rename(other, edge);
      return;
    }
  }
  const auto [first, second] = std::minmax(edge, other);
  throw Error(ErrorCode::kCrossing, edges_.text(second) + ' ' + how + ' ' + edges_.text(first),
              {first, second});
}

/// An edge of several numbers shall have the smallest.
void Constrained::rename(std::uint32_t inserted, std::uint32_t other) {
  if (other >= inserted) return;
  auto& name = name_.try_emplace(inserted, other).first->second;
  name = std::min(name, other);
}

void Constrained::rename_edges() {
  if (name_.empty()) return;
  for (std::uint32_t& e : out_.edge) {
    if (const auto name = name_.find(e); name != name_.end()) e = name->second;
  }
  for (const auto& [inserted, other] : name_) {
    if (also_.erase(inserted) != 0) also_.emplace(other, inserted);
  }
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

ConstrainedResult constrained_delaunay(const PlanarInput& input, Extent extent,
                                       const Progress& progress) {
  return Constrained(input, extent, progress).build();
}

ConstrainedResult constrained_delaunay(const Polygon& polygon, std::span<const Point> inner) {
  PlanarInput input;
  input.polygons.push_back(polygon);
  input.points.assign(inner.begin(), inner.end());
  return constrained_delaunay(input);
}

}  // namespace quadloom
