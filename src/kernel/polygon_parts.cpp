// Which polygon each triangle is in, decided on indices but for the way around of each ring.
//
//   1. inner_sides   on which side of its edges a ring has the inside of its polygon: left if it
//                    goes counter-clockwise (its clockwise-most edge at its lexicographically
//                    smallest corner leaves that corner), a hole the other way
//   2. claim         what an edge says about the triangle on one of its sides: "in polygon p" if p
//                    has its inside there, else "in none"
//   3. spread        triangles that no ring's edge separates are one component; every claim in it,
//                    and "in none" where it meets the outside of the hull, must be the same
//
// If they agree, then polygon p's triangles are those with p's inside on the inner sides of p's
// edges, no more and no less: rings are nested as they should be and no two polygons overlap. A ring
// that touches itself or others at corners passes if each part is still claimed by one; one that
// crosses itself at a corner does not. Cost: linear.
#include <algorithm>
#include <string>

#include "kernel/planar_region.hpp"
#include "kernel/ring_direction.hpp"

namespace quadloom::kernel {
namespace {

class PolygonParts {
 public:
  PolygonParts(const Triangulation& mesh, std::span<const std::uint32_t> edge,
               const PlanarEdges& edges,
               const std::unordered_map<std::uint32_t, std::uint32_t>& also)
      : mesh_(mesh), edge_(edge), edges_(edges), also_(also) {}

  std::vector<std::uint32_t> find() {
    for (const RingRange& ring : edges_.rings()) inner_left_.push_back(inner_is_left(ring) ? 1 : 0);
    part_.assign(mesh_.triangle_count(), kNone);
    std::vector<std::uint8_t> seen(mesh_.triangle_count(), 0);
    for (TriangleId t = 0; t < mesh_.triangle_count(); ++t) {
      if (seen[t] == 0) spread(t, seen);
    }
    return std::move(part_);
  }

 private:
  /// A polygon or none, and the edge that says so (kNone: the outside of the hull).
  struct Claim {
    std::uint32_t polygon = kNone;
    std::uint32_t edge = kNone;
    bool made = false;
  };

  bool is_border(HalfedgeId h) const { return edge_[h] != kNone && edges_.is_ring_edge(edge_[h]); }

  bool inner_is_left(const RingRange& ring) const;
  bool inner_is_left_of(std::uint32_t edge, Point from, Point to) const;
  Claim claim(std::uint32_t edge, Point from, Point to) const;
  void spread(TriangleId start, std::vector<std::uint8_t>& seen);
  void agree(Claim& all, const Claim& claim) const;
  [[noreturn]] void fail(const Claim& a, const Claim& b) const;

  const Triangulation& mesh_;
  std::span<const std::uint32_t> edge_;
  const PlanarEdges& edges_;
  const std::unordered_map<std::uint32_t, std::uint32_t>& also_;
  std::vector<std::uint8_t> inner_left_;  // by ring
  std::vector<std::uint32_t> part_;
  std::vector<TriangleId> component_;
};

bool PolygonParts::inner_is_left(const RingRange& ring) const {
  const auto corners = edges_.points().subspan(ring.first, ring.size);
  return goes_counter_clockwise(corners) == (ring.ring == 0);
}

bool PolygonParts::inner_is_left_of(std::uint32_t edge, Point from, Point to) const {
  const EdgeEnds ends = edges_.ends(edge);
  const bool along =
      lex_less(from, to) == lex_less(edges_.points()[ends.from], edges_.points()[ends.to]);
  const auto ring = static_cast<std::size_t>(&edges_.ring_of(edge) - edges_.rings().data());
  return (inner_left_[ring] != 0) == along;
}

/// What the edge, followed from `from` to `to`, says about its left side.
PolygonParts::Claim PolygonParts::claim(std::uint32_t edge, Point from, Point to) const {
  Claim out{kNone, edge, true};
  if (inner_is_left_of(edge, from, to)) out.polygon = edges_.ring_of(edge).polygon;
  const auto second = also_.find(edge);
  if (second == also_.end() || !inner_is_left_of(second->second, from, to)) return out;
  const Claim other{edges_.ring_of(second->second).polygon, second->second, true};
  if (out.polygon != kNone) fail(out, other);
  return other;
}

void PolygonParts::spread(TriangleId start, std::vector<std::uint8_t>& seen) {
  Claim all;
  component_.assign(1, start);
  seen[start] = 1;
  for (std::size_t i = 0; i < component_.size(); ++i) {
    for (HalfedgeId h = 3 * component_[i]; h < 3 * component_[i] + 3; ++h) {
      const Point from = mesh_.points[mesh_.origin(h)], to = mesh_.points[mesh_.target(h)];
      const HalfedgeId twin = mesh_.twin[h];
      if (is_border(h)) {
        agree(all, claim(edge_[h], from, to));
        if (twin == kNone) {
          Claim outside{kNone, kNone, true};
          agree(outside, claim(edge_[h], to, from));
        }
      } else if (twin == kNone) {
        agree(all, {kNone, kNone, true});
      } else if (seen[triangle_of(twin)] == 0) {
        seen[triangle_of(twin)] = 1;
        component_.push_back(triangle_of(twin));
      }
    }
  }
  for (const TriangleId t : component_) part_[t] = all.polygon;
}

void PolygonParts::agree(Claim& all, const Claim& claim) const {
  if (!all.made) {
    all = claim;
  } else if (all.polygon != claim.polygon) {
    fail(all, claim);
  }
}

void PolygonParts::fail(const Claim& a, const Claim& b) const {
  if (a.edge == kNone || b.edge == kNone) {
    const std::uint32_t edge = a.edge == kNone ? b.edge : a.edge;
    throw Error(ErrorCode::kBadPolygon,
                edges_.text(edge) + (edges_.ring_of(edge).ring == 0
                                         ? " is of a ring that crosses itself at a corner"
                                         : " is of a hole that is not inside its polygon"),
                {edge});
  }
  const RingRange &ring_a = edges_.ring_of(a.edge), &ring_b = edges_.ring_of(b.edge);
  std::string why;
  if (ring_a.polygon != ring_b.polygon) {
    why = "polygons " + std::to_string(std::min(ring_a.polygon, ring_b.polygon)) + " and " +
          std::to_string(std::max(ring_a.polygon, ring_b.polygon)) + " overlap";
  } else if (ring_a.ring != ring_b.ring) {
    why = "the rings of polygon " + std::to_string(ring_a.polygon) +
          " are not an outer ring and holes in it that are apart";
  } else {
    why = "ring " + std::to_string(ring_a.ring) + " of polygon " + std::to_string(ring_a.polygon) +
          " crosses itself at a corner or goes around twice";
  }
  throw Error(ErrorCode::kBadPolygon,
              why + ": see " + edges_.text(std::min(a.edge, b.edge)) + " and " +
                  edges_.text(std::max(a.edge, b.edge)),
              {std::min(a.edge, b.edge), std::max(a.edge, b.edge)});
}

}  // namespace

std::vector<std::uint32_t> polygon_parts(
    const Triangulation& mesh, std::span<const std::uint32_t> edge, const PlanarEdges& edges,
    const std::unordered_map<std::uint32_t, std::uint32_t>& also) {
  return PolygonParts(mesh, edge, edges, also).find();
}

}  // namespace quadloom::kernel
