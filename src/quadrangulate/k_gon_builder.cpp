#include "quadrangulate/k_gon_builder.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "quadloom/kernel.hpp"
#include "quadrangulate/two_faces.hpp"

namespace quadloom::quadrangulate {
namespace {

using Edge = std::pair<VertexId, VertexId>;

/// The union of triangles first ... first + count - 1 of the path.
std::vector<VertexId> polygon(const Serpentine& path, std::size_t first, std::size_t count) {
  std::vector<VertexId> out = {path.outer(first), path.inner(first)};
  std::vector<VertexId> outer_side;
  for (std::size_t t = first; t < first + count; ++t) {
    const bool outer = t + 1 == path.size() || path.replaced(t) == Replaced::kOuter;
    (outer ? outer_side : out).push_back(path.apex(t));
  }
  out.insert(out.end(), outer_side.rbegin(), outer_side.rend());
  return out;
}

}  // namespace

KGonBuilder::KGonBuilder(std::span<const Point> points, std::span<const VertexId> hull,
                         const PointOptions& options)
    : hull_(hull.begin(), hull.end()), odd_boundary_(options.odd_boundary) {
  result_.mesh.points.assign(points.begin(), points.end());
  result_.input_vertices = points.size();
}

KAngulationResult KGonBuilder::from_groups(const Serpentine& path,
                                           const std::vector<PathGroup>& groups) {
  std::vector<std::vector<VertexId>> faces;
  std::size_t t = 0;
  for (const PathGroup& group : groups) {
    if (t > 0 && group.entering > 0) {
      add_inner(path.outer(t), path.inner(t), path.apex(t), group.entering, Room::kTriangle);
    }
    faces.push_back(polygon(path, t, group.triangles));
    t += group.triangles;
  }
  add_outer(faces[0], groups[0].entering);
  return finish(faces);
}

KAngulationResult KGonBuilder::from_cut(std::size_t from, std::size_t inner_points) {
  const std::size_t h = hull_.size();
  const std::size_t steps = h / 2;
  const CutPath cut = cut_through_all(result_.mesh.points, hull_, from, steps);
  const auto& path = cut.vertices;
  if (inner_points > 0) {
    add_inner(path[cut.wide_edge], path[cut.wide_edge + 1], cut.wide_apex, inner_points,
              Room::kTriangle);
  }
  std::vector<std::vector<VertexId>> faces(2);
  for (std::size_t i = 0; i < steps; ++i) faces[0].push_back(hull_[(from + i) % h]);
  faces[0].insert(faces[0].end(), path.rbegin(), path.rend() - 1);
  faces[1].assign(path.begin(), path.end() - 1);
  for (std::size_t i = steps; i < h; ++i) faces[1].push_back(hull_[(from + i) % h]);
  add_outer(faces[0], h % 2);
  return finish(faces);
}

KAngulationResult KGonBuilder::from_plan(const FacePlan& plan) {
  std::vector<VertexId> apices;
  std::map<std::array<VertexId, 3>, int> uses;  // of a triangle, by its edges
  const auto corners = [](const FacePlan::Inner& inner, VertexId apex) {
    std::array<VertexId, 3> out = {inner.from, inner.to, apex};
    std::sort(out.begin(), out.end());
    return out;
  };
  for (const FacePlan::Inner& inner : plan.inner) {
    apices.push_back(apex_in_face(plan.faces[inner.face], inner.from, inner.to));
    ++uses[corners(inner, apices.back())];
  }
  for (std::size_t i = 0; i < plan.inner.size(); ++i) {
    const FacePlan::Inner& inner = plan.inner[i];
    const Room room = uses[corners(inner, apices[i])] == 1 ? Room::kTriangle : Room::kThird;
    add_inner(inner.from, inner.to, apices[i], inner.count, room);
  }
  for (const FacePlan::Outer& outer : plan.outer) add_outer(plan.faces[outer.face], outer.count);
  return finish(plan.faces);
}

/// The third corner of the triangle at an edge of the face in a triangulation of the face.
VertexId KGonBuilder::apex_in_face(const std::vector<VertexId>& face, VertexId a,
                                   VertexId b) const {
  Polygon ring;
  ring.rings.resize(1);
  for (const VertexId v : face) ring.rings[0].push_back(result_.mesh.points[v]);
  const Triangulation mesh = constrained_delaunay(ring).mesh;
  HalfedgeId h = 0;
  while (face[mesh.origin(h)] != a || face[mesh.target(h)] != b) ++h;
  return face[mesh.apex(h)];
}

/// A third of a triangle is what its middle and the edge span, so that each edge has its own.
void KGonBuilder::add_inner(VertexId a, VertexId b, VertexId apex, std::size_t count, Room room) {
  auto& points = result_.mesh.points;
  const Point pa = points[a], pb = points[b], pc = points[apex];
  const Point middle{pa.x / 3 + pb.x / 3 + pc.x / 3, pa.y / 3 + pb.y / 3 + pc.y / 3};
  const int side = orient2d(pa, pb, pc);
  const bool inside = orient2d(pa, pb, middle) == side && orient2d(pb, pc, middle) == side &&
                      orient2d(pc, pa, middle) == side;
  const auto places = room == Room::kTriangle ? chain_in_triangle(pa, pb, pc, count)
                      : inside                ? chain_in_triangle(pa, pb, middle, count)
                                              : chain_on_segment(pa, pb, count);
  if (!places) {
    throw Error(ErrorCode::kGuarantee,
                "a triangle is too small to take a point with double-precision coordinates");
  }
  auto& chain = chains_[{a, b}];
  for (const Point& place : *places) {
    const auto s = static_cast<VertexId>(points.size());
    points.push_back(place);
    chain.push_back(s);
    result_.steiner.push_back({s, SteinerKind::kInner, {a, b, apex}});
  }
  chains_[{b, a}].assign(chain.rbegin(), chain.rend());
}

/// At the hull edges of one face.
void KGonBuilder::add_outer(const std::vector<VertexId>& face, std::size_t count) {
  if (count == 0) return;
  std::vector<VertexId> next(result_.mesh.points.size(), kNone);
  for (std::size_t i = 0; i < hull_.size(); ++i) next[hull_[i]] = hull_[(i + 1) % hull_.size()];
  std::vector<Edge> edges;
  for (std::size_t i = 0; i < face.size(); ++i) {
    const Edge edge{face[i], face[(i + 1) % face.size()]};
    if (next[edge.first] == edge.second) edges.push_back(edge);
  }
  add_hull_points(hull_, edges, count, odd_boundary_, result_.mesh.points, chains_,
                  result_.steiner);
  std::vector<VertexId> hull;
  for (std::size_t i = 0; i < hull_.size(); ++i) {
    hull.push_back(hull_[i]);
    const auto chain = chains_.find({hull_[i], hull_[(i + 1) % hull_.size()]});
    if (chain == chains_.end()) continue;
    hull.insert(hull.end(), chain->second.begin(), chain->second.end());
  }
  hull_ = std::move(hull);
}

KAngulationResult KGonBuilder::finish(const std::vector<std::vector<VertexId>>& faces) {
  std::vector<VertexId> corners;
  for (const auto& face : faces) {
    corners.clear();
    for (std::size_t i = 0; i < face.size(); ++i) {
      corners.push_back(face[i]);
      const auto chain = chains_.find({face[i], face[(i + 1) % face.size()]});
      if (chain == chains_.end()) continue;
      corners.insert(corners.end(), chain->second.begin(), chain->second.end());
    }
    result_.mesh.add_face(corners);
  }
  return std::move(result_);
}

}  // namespace quadloom::quadrangulate
