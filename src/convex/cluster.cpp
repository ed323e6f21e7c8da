#include "convex/cluster.hpp"

#include <algorithm>

namespace quadloom::convex {

using quadrangulate::quad_behind;
using quadrangulate::QuadBehind;
using quadrangulate::split_by_first_diagonal;

void ClusterGrower::start(TriangleId t) {
  seen_triangle_.resize(mesh_.mate.size());
  seen_vertex_.resize(mesh_.tri.points.size());
  ++round_;
  const HalfedgeId h = mesh_.mate[t], twin = mesh_.tri.twin[h];
  cluster_.inner = {next_halfedge(h), previous_halfedge(h), next_halfedge(twin),
                    previous_halfedge(twin)};
  cluster_.corner.clear();
  cluster_.slot.clear();
  for (const HalfedgeId side : cluster_.inner) {
    cluster_.corner.push_back(mesh_.tri.origin(side));
    seen_vertex_[mesh_.tri.origin(side)] = round_;
  }
  add(t, triangle_of(twin));
}

void ClusterGrower::add(TriangleId near, TriangleId far) {
  for (const TriangleId t : {near, far}) {
    cluster_.slot.push_back(t);
    seen_triangle_[t] = round_;
  }
}

//        e ---- d            The quad behind the side a->b takes it away and adds the sides a->d,
//        |      |            d->e, e->b; d and e must be new, or the cluster would close around
//     -- b <--- a --         something or touch itself.
//         cluster
bool ClusterGrower::grow(Random& random) {
  const std::size_t sides = cluster_.inner.size();
  const std::size_t first = random.below(sides);
  for (std::size_t i = 0; i < sides; ++i) {
    const std::size_t k = (first + i) % sides;
    const HalfedgeId enter = mesh_.tri.twin[cluster_.inner[k]];
    if (enter == kNone || mesh_.is_free(triangle_of(enter))) continue;
    if (seen_triangle_[triangle_of(enter)] == round_) continue;
    const QuadBehind quad = quad_behind(mesh_, enter);
    const VertexId d = mesh_.tri.origin(quad.side[1]), e = mesh_.tri.origin(quad.side[2]);
    if (seen_vertex_[d] == round_ || seen_vertex_[e] == round_) continue;
    seen_vertex_[d] = seen_vertex_[e] = round_;
    const auto at = static_cast<std::ptrdiff_t>(k);
    cluster_.inner[k] = quad.side[0];
    cluster_.inner.insert(cluster_.inner.begin() + at + 1, {quad.side[1], quad.side[2]});
    cluster_.corner.insert(cluster_.corner.begin() + at + 1, {d, e});
    add(quad.near, quad.far);
    return true;
  }
  return false;
}

namespace {

class Parting {
 public:
  Parting(PairedMesh& mesh, const Cluster& cluster, std::span<const VertexId> added)
      : mesh_(mesh), corners_(cluster.corner.size()), slot_(cluster.slot) {
    vertex_ = cluster.corner;
    vertex_.insert(vertex_.end(), added.begin(), added.end());
    known_.assign(vertex_.size() * vertex_.size(), kNone);
    for (const HalfedgeId h : cluster.inner) {
      beyond_.push_back(mesh.tri.twin[h]);
      if (!mesh.source.empty()) side_source_.push_back(mesh.source[triangle_of(h)]);
    }
    if (!mesh.source.empty()) {
      for (const TriangleId t : cluster.slot) left_.push_back(mesh.source[t]);
    }
  }

  void run(std::span<const ClusterQuad> quads) {
    while (slot_.size() < 2 * quads.size()) {
      slot_.push_back(quadrangulate::add_triangle(mesh_, slot_.front()));
    }
    for (std::size_t q = 0; q < quads.size(); ++q)
      add_quad(quads[q], slot_[2 * q], slot_[2 * q + 1]);
    move_sources();
  }

 private:
  Point at(std::uint8_t k) const { return mesh_.point(vertex_[k]); }

  void add_quad(const ClusterQuad& quad, TriangleId t, TriangleId u) {
    const auto [a, b, c, d] = quad;
    if (split_by_first_diagonal(at(a), at(b), at(c), at(d))) {
      add_triangles(a, b, c, d, t, u);
    } else {
      add_triangles(b, c, d, a, t, u);
    }
  }

  /// The triangles a, b, c and c, d, a of one quad.
  void add_triangles(std::uint8_t a, std::uint8_t b, std::uint8_t c, std::uint8_t d, TriangleId t,
                     TriangleId u) {
    mesh_.set_triangle(t, vertex_[a], vertex_[b], vertex_[c]);
    mesh_.set_triangle(u, vertex_[c], vertex_[d], vertex_[a]);
    add_side(a, b, 3 * t);
    add_side(b, c, 3 * t + 1);
    add_side(c, d, 3 * u);
    add_side(d, a, 3 * u + 1);
    mesh_.link(3 * t + 2, 3 * u + 2);
    mesh_.pair(3 * t + 2);
  }

  void add_side(std::uint8_t from, std::uint8_t to, HalfedgeId h) {
    if (from < corners_ && to == (from + 1U) % corners_) {
      mesh_.link(h, beyond_[from]);
      side_owner_.emplace_back(triangle_of(h), from);
      return;
    }
    const HalfedgeId other = known_[to * vertex_.size() + from];
    if (other != kNone) mesh_.link(h, other);
    known_[from * vertex_.size() + to] = h;
  }

  /// Each new triangle takes the source of a side of it that is still to be had, or any that is left.
  void move_sources() {
    if (mesh_.source.empty()) return;
    std::vector<TriangleId> without = slot_;
    for (const auto& [t, side] : side_owner_) {
      const auto here = std::find(without.begin(), without.end(), t);
      const auto source = std::find(left_.begin(), left_.end(), side_source_[side]);
      if (here == without.end() || source == left_.end()) continue;
      mesh_.source[t] = *source;
      without.erase(here);
      left_.erase(source);
    }
    for (const TriangleId t : without) {
      if (left_.empty()) break;  // an added triangle keeps the source that it was made with
      mesh_.source[t] = left_.back();
      left_.pop_back();
    }
  }

  PairedMesh& mesh_;
  const std::size_t corners_;
  std::vector<TriangleId> slot_;
  std::vector<VertexId> vertex_;
  std::vector<HalfedgeId> known_;   // by both ends: of inner sides
  std::vector<HalfedgeId> beyond_;  // of each side of the cluster
  std::vector<TriangleId> side_source_, left_;
  std::vector<std::pair<TriangleId, std::uint8_t>> side_owner_;
};

}  // namespace

void part_cluster(PairedMesh& mesh, const Cluster& cluster, std::span<const ClusterQuad> quads,
                  std::span<const VertexId> added) {
  Parting(mesh, cluster, added).run(quads);
}

}  // namespace quadloom::convex
