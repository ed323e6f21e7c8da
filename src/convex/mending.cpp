#include "convex/mending.hpp"

#include <algorithm>
#include <unordered_map>

namespace quadloom::convex {

using quadrangulate::classify_quad;
using quadrangulate::QuadKind;

Mending::Mending(PairedMesh& given, std::uint64_t seed, std::vector<SteinerPoint>& steiner)
    : mesh(given),
      random(seed),
      grower(given),
      steiner_(steiner),
      first_added_(static_cast<VertexId>(given.tri.points.size() - steiner.size())) {}

bool Mending::is_bad(TriangleId t) const {
  const HalfedgeId h = mesh.mate[t];
  if (h == kNone) return false;
  const auto& tri = mesh.tri;
  return classify_quad(mesh.point(tri.origin(h)), mesh.point(tri.apex(tri.twin[h])),
                       mesh.point(tri.target(h)),
                       mesh.point(tri.apex(h))) != QuadKind::kStrictlyConvex;
}

void Mending::note_bad(std::span<const TriangleId> triangles, std::vector<TriangleId>& list) const {
  for (const TriangleId t : triangles) {
    if (!mesh.is_free(t) && name_of_quad(t) == t && is_bad(t)) list.push_back(t);
  }
}

std::size_t Mending::bad_in(const Cluster& cluster) const {
  std::vector<TriangleId> list;
  note_bad(cluster.slot, list);
  return list.size();
}

std::vector<Point> Mending::points_of(std::span<const VertexId> vertices) const {
  std::vector<Point> out;
  out.reserve(vertices.size());
  for (const VertexId v : vertices) out.push_back(mesh.point(v));
  return out;
}

void Mending::adopt_inner_points() {
  const auto inner = std::partition(steiner_.begin(), steiner_.end(), [](const SteinerPoint& s) {
    return s.kind != SteinerKind::kInner;
  });
  if (inner == steiner_.end()) return;
  triangle_at_.assign(mesh.tri.points.size() - first_added_, kNone);
  std::vector<bool> is_inner(triangle_at_.size());
  for (auto s = inner; s != steiner_.end(); ++s) is_inner[s->vertex - first_added_] = true;
  for (HalfedgeId h = 0; h < mesh.tri.tri_vertex.size(); ++h) {
    const VertexId v = mesh.tri.tri_vertex[h];
    if (v >= first_added_ && is_inner[v - first_added_]) {
      triangle_at_[v - first_added_] = triangle_of(h);
    }
  }
  steiner_.erase(inner, steiner_.end());
}

std::vector<VertexId> Mending::inner_points() const {
  std::vector<VertexId> out;
  for (std::size_t i = 0; i < triangle_at_.size(); ++i) {
    if (triangle_at_[i] != kNone) out.push_back(first_added_ + static_cast<VertexId>(i));
  }
  return out;
}

VertexId Mending::add_point(Point place) {
  if (spare_vertices_.empty()) return quadrangulate::add_vertex(mesh, {place.x, place.y});
  const VertexId v = spare_vertices_.back();
  spare_vertices_.pop_back();
  mesh.tri.points[v] = place;
  return v;
}

void Mending::take_out(VertexId v) {
  triangle_at_[v - first_added_] = kNone;
  spare_vertices_.push_back(v);
}

std::vector<TriangleId> Mending::part(const Cluster& cluster, std::span<const ClusterQuad> quads,
                                      std::span<const VertexId> inside,
                                      std::span<const Point> places) {
  for (const VertexId v : cluster.inside) {
    if (std::find(inside.begin(), inside.end(), v) == inside.end()) take_out(v);
  }
  std::vector<VertexId> numbered(inside.begin(), inside.end());
  for (const Point p : places) numbered.push_back(add_point(p));
  auto triangles = part_cluster(mesh, cluster, quads, numbered, spare_triangles_);
  triangle_at_.resize(mesh.tri.points.size() - first_added_, kNone);
  const auto is_new = [&](VertexId v) {
    return std::find(numbered.begin() + static_cast<std::ptrdiff_t>(inside.size()), numbered.end(),
                     v) != numbered.end();
  };
  for (const TriangleId t : triangles) {
    for (HalfedgeId h = 3 * t; h < 3 * t + 3; ++h) {
      const VertexId v = mesh.tri.tri_vertex[h];
      if (is_inner_point(v) || (v >= first_added_ && is_new(v))) triangle_at_[v - first_added_] = t;
    }
  }
  touch(triangles);
  return triangles;
}

void Mending::compact() {
  std::sort(spare_vertices_.rbegin(), spare_vertices_.rend());
  for (const VertexId v : spare_vertices_) {
    const auto last = static_cast<VertexId>(mesh.tri.points.size() - 1);
    if (v != last) rename_vertex(last, v);
    mesh.tri.points.pop_back();
    triangle_at_.pop_back();
  }
  spare_vertices_.clear();
  std::sort(spare_triangles_.rbegin(), spare_triangles_.rend());
  const auto gone = [&](TriangleId t) {
    return std::binary_search(spare_triangles_.rbegin(), spare_triangles_.rend(), t);
  };
  touched.erase(std::remove_if(touched.begin(), touched.end(), gone), touched.end());
  bad.erase(std::remove_if(bad.begin(), bad.end(), gone), bad.end());
  std::unordered_map<TriangleId, TriangleId> now;
  for (const TriangleId t : spare_triangles_) {
    const auto last = static_cast<TriangleId>(mesh.mate.size() - 1);
    if (t != last) {
      rename_triangle(last, t);
      now[last] = t;
    }
    mesh.mate.pop_back();
    mesh.tri.tri_vertex.resize(3 * mesh.mate.size());
    mesh.tri.twin.resize(3 * mesh.mate.size());
    if (!mesh.source.empty()) mesh.source.pop_back();
  }
  spare_triangles_.clear();
  for (std::vector<TriangleId>* list : {&touched, &bad, &triangle_at_}) {
    for (TriangleId& t : *list) {
      for (auto at = now.find(t); at != now.end(); at = now.find(t)) t = at->second;
    }
  }
  for (TriangleId& t : bad) t = name_of_quad(t);
  list_inner_points();
}

/// The last vertex, which is added, takes a number that is not in use.
void Mending::rename_vertex(VertexId from, VertexId to) {
  mesh.tri.points[to] = mesh.tri.points[from];
  const TriangleId t = triangle_at(from);
  if (t == kNone) {  // a point on or outside a border, after inner points of a given mesh
    std::replace(mesh.tri.tri_vertex.begin(), mesh.tri.tri_vertex.end(), from, to);
    for (SteinerPoint& s : steiner_) {
      if (s.vertex == from) s.vertex = to;
      std::replace(s.parents.begin(), s.parents.end(), from, to);
    }
    return;
  }
  triangle_at_[to - first_added_] = t;
  HalfedgeId h = 3 * t;
  while (mesh.tri.origin(h) != from) ++h;
  do {  // around the point, which is inside
    mesh.tri.tri_vertex[h] = to;
    h = mesh.tri.twin[previous_halfedge(h)];
  } while (mesh.tri.origin(h) == from);
}

/// The last triangle takes a number that is not in use.
void Mending::rename_triangle(TriangleId from, TriangleId to) {
  for (HalfedgeId i = 0; i < 3; ++i) {
    mesh.tri.tri_vertex[3 * to + i] = mesh.tri.tri_vertex[3 * from + i];
    mesh.tri.twin[3 * to + i] = kNone;
    mesh.link(3 * to + i, mesh.tri.twin[3 * from + i]);
  }
  mesh.mate[to] = mesh.mate[from] == kNone ? kNone : 3 * to + (mesh.mate[from] - 3 * from);
  if (!mesh.source.empty()) mesh.source[to] = mesh.source[from];
}

void Mending::list_inner_points() {
  for (const VertexId v : inner_points()) steiner_.push_back({v, SteinerKind::kInner, {}});
  std::sort(steiner_.begin(), steiner_.end(),
            [](const SteinerPoint& a, const SteinerPoint& b) { return a.vertex < b.vertex; });
}

}  // namespace quadloom::convex
