#include "quadrangulate/face_mesh.hpp"

#include "quadloom/kernel.hpp"

namespace quadloom::quadrangulate {

FaceMesh::FaceMesh(const Triangulation& mesh, std::span<const std::uint32_t> label,
                   std::size_t labels)
    : first_(labels + 1, kNone), size_(labels + 1, 0), hull_edges_(labels + 1, 0) {
  vertex_first_.assign(mesh.points.size(), kNone);
  std::vector<HalfedgeId> id(mesh.twin.size(), kNone);
  std::vector<HalfedgeId> source;  // kNone: outside
  for (HalfedgeId h = 0; h < mesh.twin.size(); ++h) {
    const HalfedgeId t = mesh.twin[h];
    if (t != kNone && (t < h || label[triangle_of(t)] == label[triangle_of(h)])) continue;
    id[h] = static_cast<HalfedgeId>(source.size());
    if (t != kNone) id[t] = id[h] + 1;
    source.push_back(h);
    source.push_back(t);
    for (const auto& [v, face] :
         {std::pair{mesh.origin(h), label[triangle_of(h)] + 1},
          std::pair{mesh.target(h), t == kNone ? kOuterFace : label[triangle_of(t)] + 1}}) {
      const auto e = static_cast<HalfedgeId>(origin_.size());
      origin_.push_back(v);
      face_.push_back(face);
      vertex_first_[v] = first_[face] = e;
      ++size_[face];
    }
    if (t == kNone) ++hull_edges_[face_[id[h]]];
  }
  next_.assign(origin_.size(), kNone);
  previous_.assign(origin_.size(), kNone);
  // The next edge of a face: around the target, through the triangles of the face.
  std::vector<HalfedgeId> outside_from(mesh.points.size(), kNone);
  for (HalfedgeId e = 0; e < source.size(); ++e) {
    if (source[e] == kNone) outside_from[origin_[e]] = e;
  }
  for (HalfedgeId e = 0; e < source.size(); ++e) {
    if (source[e] == kNone) {
      link(e, outside_from[target(e)]);
      continue;
    }
    HalfedgeId h = next_halfedge(source[e]);
    while (id[h] == kNone) h = next_halfedge(mesh.twin[h]);
    link(e, id[h]);
  }
}

std::vector<VertexId> FaceMesh::corners(FaceId f) const {
  std::vector<VertexId> out;
  HalfedgeId e = first_[f];
  do {
    out.push_back(origin_[e]);
    e = next_[e];
  } while (e != first_[f]);
  return out;
}

/// Around the face and around the vertex in step, as far as the shorter of the two.
bool FaceMesh::has_corner(FaceId f, VertexId v) const {
  const HalfedgeId face_start = first_[f], star_start = vertex_first_[v];
  HalfedgeId e = face_start, s = star_start;
  do {
    ++work_;
    if (origin_[e] == v || face_[s] == f) return true;
    e = next_[e];
    s = next_[twin(s)];
  } while (e != face_start && s != star_start);
  return false;
}

/// The corner after the edge `before` turns strictly left, and its triangle has no other corner of
/// the face in it.
bool FaceMesh::is_ear(std::span<const Point> points, HalfedgeId before) const {
  const HalfedgeId after = next_[before];
  const Point x = points[origin_[before]], y = points[origin_[after]], z = points[target(after)];
  if (orient2d(x, y, z) <= 0) return false;
  for (HalfedgeId e = next_[next_[after]]; e != before; e = next_[e]) {
    ++work_;
    const Point p = points[origin_[e]];
    if (orient2d(z, x, p) >= 0 && orient2d(x, y, p) >= 0 && orient2d(y, z, p) >= 0) return false;
  }
  return true;
}

bool FaceMesh::can_take(std::span<const Point> points, Take take) const {
  const HalfedgeId e = take.edge;
  const FaceId giver = face_[e], taker = face_[twin(e)];
  if (giver == kOuterFace || taker == kOuterFace || giver == taker) return false;
  const bool at_target = take.end == End::kTarget;
  const VertexId third = at_target ? target(next_[e]) : origin_[previous_[e]];
  if (has_corner(taker, third)) return false;
  return is_ear(points, at_target ? e : previous_[e]);
}

void FaceMesh::own(HalfedgeId e, FaceId from, FaceId to) {
  face_[e] = to;
  if (face_[twin(e)] == kOuterFace) {
    --hull_edges_[from];
    ++hull_edges_[to];
  }
}

/// All of the triangle on e's side goes to the face beyond e.
void FaceMesh::swallow(HalfedgeId e) {
  const HalfedgeId g = twin(e), m = next_[e], l = previous_[e];
  const FaceId giver = face_[e], taker = face_[g];
  vertex_first_[origin_[m]] = m;
  vertex_first_[origin_[e]] = next_[g];
  link(previous_[g], m);
  link(l, next_[g]);
  own(m, giver, taker);
  own(l, giver, taker);
  first_[taker] = m;
  first_[giver] = kNone;
  size_[giver] = 0;
  ++size_[taker];
}

void FaceMesh::take(Take take) {
  const HalfedgeId e = take.edge, g = twin(e);
  const FaceId giver = face_[e], taker = face_[g];
  if (size_[giver] == 3) return swallow(e);
  first_[giver] = e;
  first_[taker] = g;
  if (take.end == End::kTarget) {
    const HalfedgeId m = next_[e];
    link(e, next_[m]);
    link(previous_[g], m);
    link(m, g);
    vertex_first_[origin_[m]] = m;
    origin_[g] = origin_[next_[e]];
    own(m, giver, taker);
  } else {
    const HalfedgeId m = previous_[e];
    link(previous_[m], e);
    const HalfedgeId after = next_[g];
    link(g, m);
    link(m, after);
    vertex_first_[origin_[after]] = after;
    origin_[e] = origin_[m];
    own(m, giver, taker);
  }
  --size_[giver];
  ++size_[taker];
}

}  // namespace quadloom::quadrangulate
