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
  cluster_.inside.clear();
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
//
//        e ---- d --         Where vertices may be inside, the quad may share more sides in a row, here d->a
//        |      |            as well: then a goes inside, and only e must be new. `first` is the first side
//     -- b <--- a            of the run.
//         cluster
std::optional<ClusterGrower::Contact> ClusterGrower::contact_at(std::size_t side,
                                                                Inside inside) const {
  const auto& twin = mesh_.tri.twin;
  const std::size_t sides = cluster_.inner.size();
  const HalfedgeId enter = twin[cluster_.inner[side]];
  if (enter == kNone || mesh_.is_free(triangle_of(enter))) return std::nullopt;
  if (seen_triangle_[triangle_of(enter)] == round_) return std::nullopt;
  const QuadBehind quad = quad_behind(mesh_, enter);
  std::size_t back = 0, ahead = 0;
  if (inside == Inside::kAllowed) {
    const auto beyond = [&](std::size_t k) { return twin[cluster_.inner[k % sides]]; };
    while (back < 2 && beyond(side + sides - 1 - back) == quad.side[back]) ++back;
    while (back + ahead < 2 && beyond(side + 1 + ahead) == quad.side[2 - ahead]) ++ahead;
  }
  Contact contact{(side + sides - back) % sides, 1 + back + ahead, {}, quad.near, quad.far};
  std::copy(quad.side.begin() + static_cast<std::ptrdiff_t>(back),
            quad.side.end() - static_cast<std::ptrdiff_t>(ahead), contact.rest.begin());
  for (std::size_t i = 1; i < 4 - contact.count; ++i) {
    if (seen_vertex_[mesh_.tri.origin(contact.rest[i])] == round_) return std::nullopt;
  }
  return contact;
}

void ClusterGrower::take(const Contact& contact) {
  const auto first = static_cast<std::ptrdiff_t>(contact.first);
  const auto count = static_cast<std::ptrdiff_t>(contact.count);
  auto &inner = cluster_.inner, &corner = cluster_.corner;
  std::rotate(inner.begin(), inner.begin() + first, inner.end());
  std::rotate(corner.begin(), corner.begin() + first, corner.end());
  cluster_.inside.insert(cluster_.inside.end(), corner.begin() + 1, corner.begin() + count);
  inner.erase(inner.begin(), inner.begin() + count);
  corner.erase(corner.begin(), corner.begin() + count);
  const std::size_t rest = 4 - contact.count;
  inner.insert(inner.begin(), contact.rest.begin(), contact.rest.begin() + rest);
  for (std::size_t i = rest; i-- > 0;) {
    const VertexId v = mesh_.tri.origin(contact.rest[i]);
    corner.insert(corner.begin(), v);
    seen_vertex_[v] = round_;
  }
  add(contact.near, contact.far);
}

bool ClusterGrower::grow(Random& random, Inside inside) {
  const std::size_t sides = cluster_.inner.size();
  const std::size_t first = random.below(sides);
  // Round clusters have more partings than long ones: every other time, a quad with several sides.
  const bool round_first = inside == Inside::kAllowed && random.below(2) == 0;
  for (int pass = round_first ? 0 : 1; pass < 2; ++pass) {
    for (std::size_t i = 0; i < sides; ++i) {
      const auto contact = contact_at((first + i) % sides, inside);
      if (!contact || (pass == 0 && contact->count == 1)) continue;
      take(*contact);
      return true;
    }
  }
  return false;
}

bool ClusterGrower::surround(VertexId corner, std::size_t most_corners) {
  while (true) {
    const auto& all = cluster_.corner;
    const auto at = std::find(all.begin(), all.end(), corner);
    if (at == all.end()) return true;
    const auto contact = contact_at(static_cast<std::size_t>(at - all.begin()), Inside::kAllowed);
    if (!contact || cluster_.corner.size() > most_corners) return false;
    take(*contact);
  }
}

namespace {

class Parting {
 public:
  Parting(PairedMesh& mesh, const Cluster& cluster, std::span<const VertexId> added,
          std::vector<TriangleId>& spare)
      : mesh_(mesh), corners_(cluster.corner.size()), slot_(cluster.slot), spare_(spare) {
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

  std::vector<TriangleId> run(std::span<const ClusterQuad> quads) && {
    while (slot_.size() < 2 * quads.size()) slot_.push_back(new_triangle());
    while (slot_.size() > 2 * quads.size()) spare_last();
    for (std::size_t q = 0; q < quads.size(); ++q)
      add_quad(quads[q], slot_[2 * q], slot_[2 * q + 1]);
    move_sources();
    return std::move(slot_);
  }

 private:
  TriangleId new_triangle() {
    if (spare_.empty()) return quadrangulate::add_triangle(mesh_, slot_.front());
    const TriangleId t = spare_.back();
    spare_.pop_back();
    if (!mesh_.source.empty()) mesh_.source[t] = mesh_.source[slot_.front()];
    return t;
  }

  /// Its source stays among those to move, but for a repeated one that goes.
  void spare_last() {
    const TriangleId t = slot_.back();
    slot_.pop_back();
    spare_.push_back(t);
    mesh_.mate[t] = kNone;
    for (HalfedgeId h = 3 * t; h < 3 * t + 3; ++h) mesh_.tri.twin[h] = kNone;
    std::sort(left_.begin(), left_.end());
    const auto repeated = std::adjacent_find(left_.begin(), left_.end());
    if (!left_.empty()) left_.erase(repeated == left_.end() ? left_.end() - 1 : repeated);
  }

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
  std::vector<TriangleId>& spare_;
  std::vector<VertexId> vertex_;
  std::vector<HalfedgeId> known_;   // by both ends: of inner sides
  std::vector<HalfedgeId> beyond_;  // of each side of the cluster
  std::vector<TriangleId> side_source_, left_;
  std::vector<std::pair<TriangleId, std::uint8_t>> side_owner_;
};

}  // namespace

std::vector<TriangleId> part_cluster(PairedMesh& mesh, const Cluster& cluster,
                                     std::span<const ClusterQuad> quads,
                                     std::span<const VertexId> added,
                                     std::vector<TriangleId>& spare) {
  return Parting(mesh, cluster, added, spare).run(quads);
}

}  // namespace quadloom::convex
