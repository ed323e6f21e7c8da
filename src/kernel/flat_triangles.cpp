// Triangles without area: three corners on one line, exactly, in the plane or in space.
//
//        d                     d           The longest edge a-c of the flat triangle a b c, b between
//       / \.                  /|\.         a and c, is flipped: the two new triangles lie in the old
//      /   \.       ->       / | \.        one across the edge and have its direction. If a-c is on
//     a--b--c               a--b--c        the boundary, a b c is left out.
//
//   1. list_flat    the flat triangles; the rest is about each of them
//   2. resolve      across a-c there is nothing: drop. A triangle with an area: flip. A flat one that
//                   has a longer edge: that one first (a stack; edges grow on the way, so it ends). A
//                   flat one with the same longest edge: flip; both get shorter longest edges:
//
//     a--b-----c             a--b-----c    (drawn apart: all on one line, b and d between a and c)
//      \_____d/       ->      \__\_d_/
//
//   3. compact      left-out triangles leave the arrays
//   4. check        no edge has got a second pair of faces (thin closed surfaces)
//
// Each flip or drop of 2 leaves one flat triangle fewer, but for the last kind of flip; there the
// lengths go down, of which there are finitely many. So it ends: after one flip a flat triangle, as a
// rule; a zero-width strip of k of them with all vertices of one side left of all of the other takes
// O(k^2). A flat triangle with two corners at the same place, and one whose neighbour has the same
// three corners, cannot be repaired. A flip over the side of a given quad ends that quad: its side has
// a vertex on it.
#include <algorithm>
#include <tuple>

#include "kernel/connect_steps.hpp"
#include "kernel/predicates_inline.hpp"

namespace quadloom::kernel {
namespace {

class Flattened {
 public:
  explicit Flattened(Connecting& work)
      : work_(work), mesh_(work.mesh()), dropped_(mesh_.triangle_count(), 0) {}

  void run() {
    list_flat();
    if (flat_.empty()) return;
    if (!work_.repairs()) work_.refuse_face(face(flat_[0]), "has no area");
    work_.out.flat_faces += flat_.size();
    for (const TriangleId t : flat_) resolve(t);
    compact();
    check();
  }

 private:
  std::size_t face(TriangleId t) const { return work_.out.source_face[t]; }
  std::span<const VertexId, 3> corners(TriangleId t) const {
    return std::span<const VertexId, 3>(mesh_.tri_vertex.data() + std::size_t{3} * t, 3);
  }
  bool flat(TriangleId t) const { return is_flat(work_.places(), corners(t)); }

  void list_flat() {
    for (TriangleId t = 0; t < mesh_.triangle_count(); ++t) {
      if (flat(t)) flat_.push_back(t);
    }
  }

  /// The edge opposite the corner between the others.
  HalfedgeId longest_edge(TriangleId t) const {
    const int middle = middle_corner(work_.places(), corners(t));
    if (middle < 0) {
      work_.refuse_face(face(t),
                        "has no area and two corners at the same place; merging equal "
                        "vertices may help");
    }
    return next_halfedge(3 * t + static_cast<HalfedgeId>(middle));
  }

  void resolve(TriangleId first) {
    stack_.push_back(first);
    while (!stack_.empty()) {
      const TriangleId t = stack_.back();
      if (dropped_[t] != 0 || !flat(t)) {
        stack_.pop_back();
        continue;
      }
      const HalfedgeId h = longest_edge(t), twin = mesh_.twin[h];
      if (twin == kNone) {
        drop(t);
      } else if (flat(triangle_of(twin)) && longest_edge(triangle_of(twin)) != twin) {
        stack_.push_back(triangle_of(twin));
      } else {
        flip(h);
      }
    }
  }

  void end_quad(TriangleId t) {
    HalfedgeId& h = work_.out.triangles.given_pair[t];
    if (h == kNone) return;
    work_.out.triangles.given_pair[triangle_of(mesh_.twin[h])] = kNone;
    h = kNone;
  }

  void connect(HalfedgeId h, HalfedgeId twin) {
    mesh_.twin[h] = twin;
    if (twin != kNone) mesh_.twin[twin] = h;
  }

  void drop(TriangleId t) {
    dropped_[t] = 1;
    for (HalfedgeId h = 3 * t; h < 3 * t + 3; ++h) {
      if (mesh_.twin[h] != kNone) mesh_.twin[mesh_.twin[h]] = kNone;
      mesh_.twin[h] = kNone;
    }
  }

  /// h is c -> a in the flat triangle c a b, k is a -> c in its neighbour a c d. They become d a b
  /// and b c d: h is then d -> a, k is b -> c.
  void flip(HalfedgeId h) {
    const HalfedgeId k = mesh_.twin[h];
    const TriangleId t = triangle_of(h), u = triangle_of(k);
    const VertexId b = mesh_.apex(h), d = mesh_.apex(k);
    if (b == d) work_.refuse_face(face(t), "has no area and the corners of its neighbour");
    end_quad(u);
    if (!flat(u)) work_.out.source_face[t] = work_.out.source_face[u];
    const HalfedgeId bc = previous_halfedge(h), da = previous_halfedge(k);
    const HalfedgeId beyond_bc = mesh_.twin[bc], beyond_da = mesh_.twin[da];
    mesh_.tri_vertex[h] = d;
    mesh_.tri_vertex[k] = b;
    connect(h, beyond_da);
    connect(k, beyond_bc);
    connect(bc, da);  // now b -> d and d -> b
  }

  void compact() {
    std::vector<TriangleId> number(dropped_.size(), kNone);
    TriangleId count = 0;
    for (TriangleId t = 0; t < number.size(); ++t) {
      if (dropped_[t] == 0) number[t] = count++;
    }
    if (count == number.size()) return;
    if (count == 0) throw Error(ErrorCode::kTooFewPoints, "the mesh has no faces with an area");
    const auto moved = [&](HalfedgeId h) {
      return h == kNone ? kNone : 3 * number[triangle_of(h)] + h % 3;
    };
    auto& pair = work_.out.triangles.given_pair;
    auto& source = work_.out.source_face;
    for (TriangleId t = 0; t < number.size(); ++t) {
      if (number[t] == kNone) continue;
      for (HalfedgeId i = 0; i < 3; ++i) {
        mesh_.tri_vertex[3 * number[t] + i] = mesh_.tri_vertex[3 * t + i];
        mesh_.twin[3 * number[t] + i] = moved(mesh_.twin[3 * t + i]);
      }
      pair[number[t]] = moved(pair[t]);
      source[number[t]] = source[t];
    }
    mesh_.tri_vertex.resize(std::size_t{3} * count);
    mesh_.twin.resize(std::size_t{3} * count);
    pair.resize(count);
    source.resize(count);
  }

  void check() const {
    static_cast<void>(match_sides(work_,
                                  "would have more than two faces, were the triangles "
                                  "without area beside it repaired"));
  }

  Connecting& work_;
  Triangulation& mesh_;
  std::vector<std::uint8_t> dropped_;
  std::vector<TriangleId> flat_;
  std::vector<TriangleId> stack_;
};

std::tuple<double, double, double> place(const Places& places, VertexId v) {
  const Vector3 p = places.at(v);
  return {p.x, p.y, p.z};
}

}  // namespace

bool is_flat(const Places& places, std::span<const VertexId, 3> corners) {
  const Point a = places.points[corners[0]], b = places.points[corners[1]],
              c = places.points[corners[2]];
  if (orient(a, b, c) != 0) return false;
  if (places.planar()) return true;
  const double az = places.z[corners[0]], bz = places.z[corners[1]], cz = places.z[corners[2]];
  return orient({a.y, az}, {b.y, bz}, {c.y, cz}) == 0 &&
         orient({az, a.x}, {bz, b.x}, {cz, c.x}) == 0;
}

int middle_corner(const Places& places, std::span<const VertexId, 3> corners) {
  for (int i = 0; i < 3; ++i) {
    const auto at = place(places, corners[static_cast<std::size_t>(i)]);
    const auto u = place(places, corners[static_cast<std::size_t>((i + 1) % 3)]);
    const auto v = place(places, corners[static_cast<std::size_t>((i + 2) % 3)]);
    if ((u < at && at < v) || (v < at && at < u)) return i;
  }
  return -1;
}

void repair_flat_triangles(Connecting& work) { Flattened(work).run(); }

}  // namespace quadloom::kernel
