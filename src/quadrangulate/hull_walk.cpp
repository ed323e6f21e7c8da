#include "quadrangulate/hull_walk.hpp"

#include "kernel/squareness.hpp"
#include "quadrangulate/odd_boundary.hpp"

namespace quadloom::quadrangulate {

HullOfMesh::HullOfMesh(const Triangulation& mesh)
    : before_(mesh.points.size(), kNone), after_(mesh.points.size(), kNone) {
  for (HalfedgeId h = 0; h < mesh.twin.size(); ++h) {
    if (mesh.twin[h] != kNone) continue;
    after_[mesh.origin(h)] = mesh.target(h);
    before_[mesh.target(h)] = mesh.origin(h);
    ++size_;
  }
}

namespace {

// A good place is worth a walk of some steps.
int shape_cost(Point a, Point s, Point b, Point c) {
  return static_cast<int>(20 * (1 - kernel::squareness(a, s, b, c)));
}

std::optional<Point> middle(Point a, Point b) {
  return Point{a.x / 2 + b.x / 2, a.y / 2 + b.y / 2};
}

std::optional<Point> place_at(const PairedMesh& mesh, const HullOfMesh& hull, VertexId a,
                              VertexId b, SteinerKind kind) {
  const auto odd = place_of_kind(mesh.point(hull.before(a)), mesh.point(a), mesh.point(b),
                                 mesh.point(hull.after(b)), kind);
  return odd ? std::optional(odd->place) : std::nullopt;
}

/// The free triangles that have a hull vertex: most often one of them is next to a good hull edge
/// already.
std::vector<TriangleId> near_hull(const PairedMesh& mesh, const HullOfMesh& hull,
                                  std::span<const TriangleId> free) {
  std::vector<TriangleId> near;
  for (const TriangleId t : free) {
    const VertexId* v = &mesh.tri.tri_vertex[3 * t];
    if (hull.has(v[0]) || hull.has(v[1]) || hull.has(v[2])) near.push_back(t);
  }
  return near;
}

}  // namespace

std::optional<SteinerPoint> walk_to_hull(PairedMesh& mesh, Walker& walker, const HullOfMesh& hull,
                                         std::span<const TriangleId> free,
                                         std::span<const SteinerKind> kinds) {
  const std::vector<TriangleId> near = near_hull(mesh, hull, free);
  const std::pair<std::span<const TriangleId>, WalkQuads> tries[] = {
      {near, WalkQuads::kStrictlyConvex},
      {free, WalkQuads::kStrictlyConvex},
      {free, WalkQuads::kAny},
  };
  for (const SteinerKind kind : kinds) {
    std::optional<Point> place;
    const Walker::BoundaryGoal goal = {
        .cost =
            [&](VertexId a, VertexId b, VertexId c) {
              const auto s = kind == SteinerKind::kOnEdge ? middle(mesh.point(a), mesh.point(b))
                                                          : place_at(mesh, hull, a, b, kind);
              return s ? shape_cost(mesh.point(a), *s, mesh.point(b), mesh.point(c)) : -1;
            },
        // The exact point on an edge can be costly to find, so only where the walk would end.
        .accept =
            [&](VertexId a, VertexId b) {
              place = place_at(mesh, hull, a, b, kind);
              return place.has_value();
            },
    };
    for (const auto& [starts, quads] : tries) {
      const HalfedgeId edge = walker.reach_boundary(starts, goal, {quads});
      if (edge == kNone) continue;
      const VertexId a = mesh.tri.origin(edge), b = mesh.tri.target(edge);
      const VertexId s = add_vertex(mesh, {place->x, place->y});
      attach_at_boundary(mesh, edge, s, kind);
      return SteinerPoint{s, kind, {a, b, kNone}};
    }
  }
  return std::nullopt;
}

}  // namespace quadloom::quadrangulate
