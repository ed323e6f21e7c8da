// Every triangle of the Delaunay triangulation into three strictly convex quads: the subdivision of
// subdivision.cpp, with a boundary that stays convex.
//
// Bose and Toussaint (section 2), after de Berg. For n points, e edges and t triangles: 3 t quads,
// e + t added points. O(n) after the triangulation.
//
// Steps: Subdivision::run with hull edges as in subdivision_boundary.hpp; append_caps.
//
// Degenerate input: a straight run of hull points whose edges have no double on them bulges
// outwards, with one more point and quad for each hull point inside the run. So does the hull where a
// needle behind it needs room.
#include "quadrangulate/points_subdivide.hpp"

#include <optional>
#include <string>
#include <utility>

#include "quadrangulate/subdivision.hpp"
#include "quadrangulate/subdivision_boundary.hpp"

namespace quadloom::quadrangulate {
namespace {

/// The points of hull edges.
class HullPlaces final : public BoundaryPlaces {
 public:
  void place_all(Subdivision& s) override;
  std::vector<EdgeId> make_room(Subdivision& s, EdgeId e) override;
  bool may_move(const Subdivision&, EdgeId, Point) override { return false; }
  void moved(const Subdivision&, EdgeId) override {}

  std::size_t size() const { return hull_.size(); }
  /// The quads of bulges, see subdivision_boundary.hpp; their points come last.
  void append_caps(const Subdivision& s, PointResult& out) const;

 private:
  std::vector<EdgeId> hull_;               // the boundary in order
  std::vector<std::uint32_t> hull_index_;  // of each edge, its place in hull_, or kNone
  std::optional<SubdivisionBoundary> boundary_;
};

HalfedgeId next_on_boundary(const Triangulation& mesh, HalfedgeId h) {
  for (h = next_halfedge(h); mesh.twin[h] != kNone;) h = next_halfedge(mesh.twin[h]);
  return h;
}

void HullPlaces::place_all(Subdivision& s) {
  EdgeId first = 0;
  while (!s.on_boundary(first)) ++first;
  hull_index_.assign(s.edge_count(), kNone);
  std::vector<Point> polygon;
  for (HalfedgeId h = s.halfedge(first); hull_index_[s.edge_of(h)] == kNone;
       h = next_on_boundary(s.mesh(), h)) {
    hull_index_[s.edge_of(h)] = static_cast<std::uint32_t>(hull_.size());
    hull_.push_back(s.edge_of(h));
    polygon.push_back(s.origin(h));
  }
  boundary_.emplace(std::move(polygon));
  if (const auto without = boundary_->place_all()) {
    const HalfedgeId h = s.halfedge(hull_[*without]);
    const VertexId a = s.mesh().origin(h), b = s.mesh().target(h);
    throw Error(ErrorCode::kGuarantee,
                "no double lies on the hull edge from point " + std::to_string(a) + " to point " +
                    std::to_string(b) + " or just outside it",
                {a, b});
  }
  for (std::size_t i = 0; i < hull_.size(); ++i) s.set_place(hull_[i], boundary_->edge_place(i));
}

std::vector<EdgeId> HullPlaces::make_room(Subdivision& s, EdgeId e) {
  std::vector<EdgeId> out;
  const auto chain = boundary_->bulge_around(hull_index_[e]);
  for (std::size_t k = 0; chain && k < chain->count; ++k) {
    const std::size_t i = (chain->first + k) % hull_.size();
    s.set_place(hull_[i], boundary_->edge_place(i));
    out.push_back(hull_[i]);
  }
  return out;
}

void HullPlaces::append_caps(const Subdivision& s, PointResult& out) const {
  const Triangulation& mesh = s.mesh();
  const auto n = static_cast<VertexId>(mesh.points.size());
  for (std::size_t i = 0; i < hull_.size(); ++i) {
    const auto& place = boundary_->cap(i);
    if (!place) continue;
    const auto cap = static_cast<VertexId>(out.mesh.points.size());
    const EdgeId before = hull_[i == 0 ? hull_.size() - 1 : i - 1];
    const VertexId corner = mesh.origin(s.halfedge(hull_[i]));
    const VertexId last = mesh.origin(s.halfedge(before));
    const VertexId next = mesh.target(s.halfedge(hull_[i]));
    out.mesh.points.push_back(*place);
    out.steiner.push_back({cap, SteinerKind::kOutside, {last, next, corner}});
    for (const VertexId v : {n + before, cap, n + hull_[i], corner}) {
      out.mesh.quad_vertex.push_back(v);
    }
  }
}

}  // namespace

PointResult subdivide_quadrangulation(Triangulation&& triangulation, const PointOptions& options) {
  const Triangulation mesh = std::move(triangulation);
  check_subdivision_size(mesh.points.size(), mesh.triangle_count());
  Subdivision subdivision({.mesh = mesh}, options.progress);
  HullPlaces hull;
  subdivision.run(hull);
  PointResult out;
  out.input_vertices = mesh.points.size();
  out.statistics.hull_points = hull.size();
  std::vector<double> no_z;
  subdivision.write_to(out.mesh, no_z, out.steiner);
  hull.append_caps(subdivision, out);
  return out;
}

}  // namespace quadloom::quadrangulate
