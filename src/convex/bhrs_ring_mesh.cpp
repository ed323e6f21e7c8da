// The mesh of the ring (Bremner, Hurtado, Ramaswami and Sacristan, theorem 2.4): n / 4 + 1 Steiner points,
// where n / 4 are needed. k = n / 2 hull corners a(i), one point b(i) inside each edge a(i) a(i + 1).
//
//   1. check_set     a(i) a(i+1) b(i) turns left, a(i+2) is left of a(i) -> b(i) and a(i-1) right of
//                    a(i+1) -> b(i)
//   2. place_centre  c, the mean of the hull's corners: left of a(i) -> b(i), right of a(i+1) -> b(i),
//                    left of b(i) -> b(i+1); and b(i) a(i+1) b(i+1) turns left (implied but for k = 3)
//   3. place_shared  for every other corner a(i+1) a Steiner point s, near to it: one quad for each of
//                    its two hull edges. k odd: the last edge and its b are the triangle
//   4. close_face    the face that is left has the corners a, b, s, b, a, b, s, b ... (k odd: one more
//                    a, b). Its b's are reflex, the others convex: c joined to all b's cuts it into
//                    strictly convex quads
//
//       a(i+2)                       The places of s: inside the hull; right of a(i) -> b(i) and left of
//        | `.                        a(i+2) -> b(i+1) (strict at the b's); on the inner side of the lines
//        |    b(i+1)                 from a(i+1) to both b's (strict at s, towards the hull); outside
//        |   /   `                   b(i) -> b(i+1) (strict at s, towards c); between c -> b(i) and
//        |  /      c                 c -> b(i+1) (strict at the b's, towards c). By the conditions of
//        | s     '                   steps 1 and 2 all of this holds near a(i+1) in the angle between the
//        |  `  b(i)                  lines from there to both b's.
//     a(i+1) - - - ` a(i)
//                                    The paper does not say that c is there for every set of its conditions.
// The mean is such a place if the ring is about regular, as the generator's; this is checked exactly.
//
// Degenerate input: places thinner than the doubles are reported. Cost: O(n log n), for the check.
#include <array>
#include <vector>

#include "convex/lower_bound_meshes.hpp"
#include "kernel/predicates_inline.hpp"
#include "quadloom/convex.hpp"
#include "quadloom/kernel.hpp"

namespace quadloom {
namespace convex {
namespace {

class RingMesh {
 public:
  explicit RingMesh(std::span<const Point> points)
      : k_(static_cast<std::uint32_t>(points.size() / 2)) {
    mesh_.points.assign(points.begin(), points.end());
  }

  void check_set() const {
    for (std::uint32_t i = 0; i < k_; ++i) {
      const bool convex = left(a(i), a(i + 1), a(i + 2));
      const bool near = left(a(i), a(i + 1), b(i)) && left(a(i), b(i), a(i + 2)) &&
                        left(b(i), a(i + 1), a(i + k_ - 1));
      if (!convex || !near) {
        throw Error(ErrorCode::kBadOption,
                    "not a ring with a point near to each edge: hull edge " + std::to_string(i),
                    {i});
      }
    }
    const auto hull = convex_hull(mesh_.points);
    bool in_order = hull.size() == k_;
    for (std::uint32_t i = 0; i < k_ && in_order; ++i) in_order = hull[i] == a(hull[0] + i);
    if (!in_order) {
      throw Error(ErrorCode::kBadOption, "the first half of the points must be the hull, in order");
    }
  }

  Quadrangulation build() && {
    place_centre();
    for (std::uint32_t i = 0; i + 1 < k_; i += 2) place_shared(i);
    if (k_ % 2 == 1) {
      mesh_.tri_vertex = {a(k_ - 1), a(0), b(k_ - 1)};
      face_.insert(face_.end(), {a(k_ - 1), b(k_ - 1)});
    }
    close_face();
    return std::move(mesh_);
  }

 private:
  VertexId a(std::uint32_t i) const { return i % k_; }
  VertexId b(std::uint32_t i) const { return k_ + i % k_; }
  Point at(VertexId v) const { return mesh_.points[v]; }
  bool left(VertexId p, VertexId q, VertexId r) const {
    return kernel::orient(at(p), at(q), at(r)) > 0;
  }

  VertexId add_point(Point p) {
    mesh_.points.push_back(p);
    return static_cast<VertexId>(mesh_.points.size() - 1);
  }

  void add_quad(std::array<VertexId, 4> quad) {
    mesh_.quad_vertex.insert(mesh_.quad_vertex.end(), quad.begin(), quad.end());
  }

  void place_centre() {
    Point mean;
    for (std::uint32_t i = 0; i < k_; ++i) {
      mean.x += at(a(i)).x / k_;
      mean.y += at(a(i)).y / k_;
    }
    centre_ = add_point(mean);
    for (std::uint32_t i = 0; i < k_; ++i) {
      const bool beyond = left(a(i), b(i), centre_) && left(b(i), a(i + 1), centre_);
      const bool around = left(b(i), b(i + 1), centre_) && left(b(i), a(i + 1), b(i + 1));
      if (!beyond || !around) {
        throw Error(
            ErrorCode::kGuarantee,
            "the mean of the hull's corners is not beyond inner point " + std::to_string(b(i)),
            {b(i)});
      }
    }
  }

  void place_shared(std::uint32_t i) {
    const Point a0 = at(a(i)), a1 = at(a(i + 1)), a2 = at(a(i + 2)), b0 = at(b(i)),
                b1 = at(b(i + 1));
    const Point c = at(centre_);
    const std::array<Point, 5> box = {a0, a1, a2, b0, b1};
    OpenRegion region(box);
    region.add(a0, a1);
    region.add(a1, a2);
    region.add(b0, a0);
    region.add(a2, b1);
    region.add(b0, a1);
    region.add(a1, b1);
    region.add(b1, b0);
    region.add(c, b0);
    region.add(b1, c);
    const VertexId s =
        add_point(place_or_throw(region, "beside hull corner " + std::to_string(a(i + 1))));
    add_quad({a(i), a(i + 1), s, b(i)});
    add_quad({a(i + 1), a(i + 2), b(i + 1), s});
    face_.insert(face_.end(), {a(i), b(i), s, b(i + 1)});
  }

  void close_face() {
    const std::size_t size = face_.size();
    for (std::size_t i = 1; i < size; i += 2) {
      add_quad({face_[i], face_[(i + 1) % size], face_[(i + 2) % size], centre_});
    }
  }

  std::uint32_t k_;
  VertexId centre_ = kNone;     // c
  std::vector<VertexId> face_;  // what is left in the middle; every other corner is a b
  Quadrangulation mesh_;
};

}  // namespace
}  // namespace convex

Quadrangulation mesh_of_bhrs_ring(std::span<const Point> points) {
  if (points.size() < 6 || points.size() % 2 == 1) {
    throw Error(ErrorCode::kBadOption, "a ring has an even number of points, six or more");
  }
  if (distinct_points(points).points.size() != points.size()) {
    throw Error(ErrorCode::kBadOption, "the points are not distinct");
  }
  convex::RingMesh ring(points);
  ring.check_set();
  return std::move(ring).build();
}

}  // namespace quadloom
