#include "quadrangulate/paired_mesh.hpp"

#include <algorithm>
#include <utility>

#include "core/large_array.hpp"
#include "kernel/predicates_inline.hpp"

namespace quadloom::quadrangulate {

QuadKind classify_quad_exactly(Point a, Point b, Point c, Point d) {
  return classify_quad(kernel::orient(d, a, b), kernel::orient(a, b, c), kernel::orient(b, c, d),
                       kernel::orient(c, d, a));
}

bool split_by_first_diagonal_exactly(Point a, Point b, Point c, Point d) {
  return kernel::orient(a, b, c) > 0 && kernel::orient(a, c, d) > 0;
}

namespace {

struct Pentagon {
  std::array<VertexId, 5> corner;
  std::array<HalfedgeId, 5> inner;  // of edge k, in the three triangles
};

Pentagon pentagon_at(const PairedMesh& mesh, HalfedgeId enter, const QuadBehind& quad) {
  const HalfedgeId shared = mesh.tri.twin[enter];
  Pentagon pentagon{
      {},
      {next_halfedge(shared), previous_halfedge(shared), quad.side[0], quad.side[1], quad.side[2]}};
  for (std::size_t k = 0; k < 5; ++k) pentagon.corner[k] = mesh.tri.origin(pentagon.inner[k]);
  return pentagon;
}

/// The sources go with the edges of the pentagon: each new triangle takes the source of the old one
/// that it has most edges of, as far as each goes to one.
class SourceMove {
 public:
  SourceMove(const PairedMesh& mesh, const std::array<TriangleId, 3>& slot,
             const std::array<HalfedgeId, 5>& inner)
      : slot_(slot) {
    if (mesh.source.empty()) return;
    for (std::size_t i = 0; i < 3; ++i) old_[i] = mesh.source[slot[i]];
    for (std::size_t k = 0; k < 5; ++k) owner_[k] = slot_of(triangle_of(inner[k]));
  }
  /// `inner` are the halfedges of the same edges after the cut.
  void apply(PairedMesh& mesh, const std::array<HalfedgeId, 5>& inner) const {
    if (mesh.source.empty()) return;
    std::array<std::size_t, 3> order = {0, 1, 2}, best = order;
    int most = -1;
    do {
      int kept = 0;
      for (std::size_t k = 0; k < 5; ++k) {
        kept += order[slot_of(triangle_of(inner[k]))] == owner_[k] ? 1 : 0;
      }
      if (kept > most) best = order;
      most = std::max(most, kept);
    } while (std::next_permutation(order.begin(), order.end()));
    for (std::size_t i = 0; i < 3; ++i) mesh.source[slot_[i]] = old_[best[i]];
  }

 private:
  std::size_t slot_of(TriangleId t) const {
    return static_cast<std::size_t>(std::find(slot_.begin(), slot_.end(), t) - slot_.begin());
  }
  std::array<TriangleId, 3> slot_;
  std::array<TriangleId, 3> old_ = {};
  std::array<std::size_t, 5> owner_ = {};
};

/// The quad wraps around the free triangle: all three triangles meet in an inner corner, only the
/// pairing changes.
std::array<TriangleId, 3> turn_wheel(PairedMesh& mesh, TriangleId old_free, TriangleId new_free,
                                     TriangleId other) {
  mesh.unpair(new_free);
  for (HalfedgeId h = 3 * other; h < 3 * other + 3; ++h) {
    if (mesh.tri.twin[h] != kNone && triangle_of(mesh.tri.twin[h]) == old_free) mesh.pair(h);
  }
  return {new_free, other, old_free};
}

}  // namespace

std::array<TriangleId, 3> recut_pentagon(PairedMesh& mesh, HalfedgeId enter, int ear) {
  const QuadBehind quad = quad_behind(mesh, enter);
  const TriangleId free = triangle_of(mesh.tri.twin[enter]), near = quad.near, far = quad.far;
  const Pentagon pentagon = pentagon_at(mesh, enter, quad);
  if (ear >= kWheel) {
    const bool to_near =
        triangle_of(pentagon.inner[static_cast<std::size_t>(ear - kWheel)]) == near;
    return turn_wheel(mesh, free, to_near ? near : far, to_near ? far : near);
  }

  const SourceMove sources(mesh, {free, near, far}, pentagon.inner);
  const kernel::Vector3 area =
      mesh.planar() ? kernel::Vector3{} : mesh.area(free) + mesh.area(near) + mesh.area(far);
  const kernel::Chart chart = mesh.planar() ? kernel::Chart() : kernel::Chart(area);

  // Turn the names so that the ear is at p[0] and the quad left is p[1], p[2], p[3], p[4].
  std::array<VertexId, 5> p;
  std::array<HalfedgeId, 5> outer;  // across the edge from p[k] to p[k + 1]
  for (std::size_t k = 0; k < 5; ++k) {
    const std::size_t from = (static_cast<std::size_t>(ear) + k) % 5;
    p[k] = pentagon.corner[from];
    outer[k] = mesh.tri.twin[pentagon.inner[from]];
  }
  mesh.set_triangle(free, p[4], p[0], p[1]);
  mesh.link(3 * free, outer[4]);
  mesh.link(3 * free + 1, outer[0]);
  const auto seen = [&](std::size_t k) { return mesh.places().seen(chart, p[k]); };
  std::array<HalfedgeId, 5> side = {3 * free + 1};
  side[4] = 3 * free;
  if (split_by_first_diagonal(seen(1), seen(2), seen(3), seen(4))) {
    mesh.set_triangle(near, p[1], p[2], p[3]);
    mesh.set_triangle(far, p[3], p[4], p[1]);
    mesh.link(3 * near, outer[1]);
    mesh.link(3 * near + 1, outer[2]);
    mesh.link(3 * far, outer[3]);
    mesh.link(3 * far + 1, 3 * free + 2);
    side[1] = 3 * near;
    side[2] = 3 * near + 1;
    side[3] = 3 * far;
  } else {
    mesh.set_triangle(near, p[2], p[3], p[4]);
    mesh.set_triangle(far, p[4], p[1], p[2]);
    mesh.link(3 * near, outer[2]);
    mesh.link(3 * near + 1, outer[3]);
    mesh.link(3 * far, 3 * free + 2);
    mesh.link(3 * far + 1, outer[1]);
    side[1] = 3 * far + 1;
    side[2] = 3 * near;
    side[3] = 3 * near + 1;
  }
  mesh.link(3 * near + 2, 3 * far + 2);
  mesh.mate[free] = kNone;
  mesh.pair(3 * near + 2);
  std::array<HalfedgeId, 5> inner;  // by the names of the pentagon again
  for (std::size_t k = 0; k < 5; ++k) inner[(static_cast<std::size_t>(ear) + k) % 5] = side[k];
  sources.apply(mesh, inner);
  return {free, near, far};
}

VertexId add_vertex(PairedMesh& mesh, kernel::Vector3 place) {
  mesh.tri.points.push_back({place.x, place.y});
  if (!mesh.planar()) mesh.z.push_back(place.z);
  return static_cast<VertexId>(mesh.tri.points.size() - 1);
}

TriangleId add_triangle(PairedMesh& mesh, TriangleId like) {
  const auto added = static_cast<TriangleId>(mesh.mate.size());
  mesh.tri.tri_vertex.resize(3 * added + 3);
  mesh.tri.twin.resize(3 * added + 3, kNone);
  mesh.mate.push_back(kNone);
  if (!mesh.source.empty()) mesh.source.push_back(mesh.source[like]);
  return added;
}

void attach_at_boundary(PairedMesh& mesh, HalfedgeId boundary, VertexId s, SteinerKind kind) {
  const VertexId a = mesh.tri.origin(boundary), b = mesh.tri.target(boundary);
  const VertexId c = mesh.tri.apex(boundary);
  const TriangleId t = triangle_of(boundary);
  if (kind == SteinerKind::kOutside) {
    const TriangleId added = add_triangle(mesh, t);
    mesh.set_triangle(added, b, a, s);
    mesh.link(boundary, 3 * added);
    mesh.pair(boundary);
  } else {
    const HalfedgeId beyond_bc = mesh.tri.twin[next_halfedge(boundary)];
    const HalfedgeId beyond_ca = mesh.tri.twin[previous_halfedge(boundary)];
    const TriangleId added = add_triangle(mesh, t);
    mesh.set_triangle(t, a, s, c);
    mesh.set_triangle(added, s, b, c);
    mesh.link(3 * t, kNone);
    mesh.link(3 * t + 2, beyond_ca);
    mesh.link(3 * added + 1, beyond_bc);
    mesh.link(3 * t + 1, 3 * added + 2);
    mesh.pair(3 * t + 1);
  }
}

namespace {

/// Without the points.
Quadrangulation faces_of(const PairedMesh& mesh) {
  Quadrangulation out;
  reserve_large(out.quad_vertex, 2 * mesh.mate.size());
  for (TriangleId t = 0; t < mesh.mate.size(); ++t) {
    const HalfedgeId h = mesh.mate[t];
    if (h == kNone) {
      for (HalfedgeId g = 3 * t; g < 3 * t + 3; ++g) out.tri_vertex.push_back(mesh.tri.origin(g));
    } else if (h < mesh.tri.twin[h]) {
      const std::array<VertexId, 4> quad = mesh.corners_of_quad(t);
      out.quad_vertex.insert(out.quad_vertex.end(), quad.begin(), quad.end());
    }
  }
  return out;
}

}  // namespace

Quadrangulation to_quadrangulation(const PairedMesh& mesh) {
  Quadrangulation out = faces_of(mesh);
  out.points = mesh.tri.points;
  return out;
}

Quadrangulation to_quadrangulation(PairedMesh&& mesh) {
  Quadrangulation out = faces_of(mesh);
  out.points = std::move(mesh.tri.points);
  return out;
}

}  // namespace quadloom::quadrangulate
