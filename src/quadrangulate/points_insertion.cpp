// Sequential insertion (SI): Bose and Toussaint, lemma 3.2 and section 4.
//
// Guarantee: theorem 3.1 with 4.3, no Steiner point if the number of hull points is even, else one
// (or one triangle).
//
// Steps:
//   1. quadrangulate_hull   the hull polygon, collinear points included, by its serpentine
//   triangulation
//   2. walk_to_hull         for an odd hull, see hull_walk.hpp
//   3. insert               the inner points in random order, each into the quad that holds it
//
// What differs from the paper:
//   - Point location: each triangle keeps the list of the points that it holds and hands it on when
//   it is cut (as in
//     quicksort), so no search structure is needed; O(n log n) expected for any input in general
//     position.
//   - A point in a convex quad may be joined to either pair of opposite corners; we take the better
//   shapes.
//   - Collinear input, which the paper leaves open for random order: a point on the diagonal inside
//   a quad just cuts it.
//     A point on an edge between two quads makes pentagons of both; each gives a quad and a
//     triangle, and the two triangles are paired or walk together (walk.hpp). Should a walk find no
//     way, another order is tried.
#include "quadrangulate/points_insertion.hpp"

#include <array>
#include <utility>

#include "core/random.hpp"
#include "kernel/squareness.hpp"
#include "quadloom/kernel.hpp"
#include "quadrangulate/hull_walk.hpp"
#include "quadrangulate/odd_boundary.hpp"
#include "quadrangulate/walk.hpp"

namespace quadloom::quadrangulate {
namespace {

constexpr int kOrders = 8;  // insertion orders to try; one has always been enough

/// The halfedge of t whose twin belongs to u, kNone if they share no edge.
HalfedgeId shared_edge(const PairedMesh& mesh, TriangleId t, TriangleId u) {
  for (HalfedgeId h = 3 * t; h < 3 * t + 3; ++h) {
    if (mesh.tri.twin[h] != kNone && triangle_of(mesh.tri.twin[h]) == u) return h;
  }
  return kNone;
}

/// The hull's quads over all points, triangles in serpentine order, the free one of an odd hull
/// first.
PairedMesh quadrangulate_hull(const std::vector<Point>& points) {
  const std::vector<VertexId> hull = convex_hull(points);
  std::vector<Point> corners;
  for (const VertexId v : hull) corners.push_back(points[v]);
  PairedMesh mesh;
  mesh.tri = serpentine_triangulation(corners).mesh;
  for (VertexId& v : mesh.tri.tri_vertex) v = hull[v];
  mesh.tri.points = points;
  const auto count = static_cast<TriangleId>(mesh.tri.triangle_count());
  mesh.mate.assign(count, kNone);
  for (TriangleId t = count; t >= 2; t -= 2) {
    mesh.pair(shared_edge(mesh, t - 1, t - 2));
  }
  return mesh;
}

class Inserter {
 public:
  Inserter(PairedMesh& mesh, Walker& walker, std::span<const VertexId> inner)
      : mesh_(mesh), walker_(walker), next_(mesh.tri.points.size(), kNone), home_(next_) {
    walker_.on_recut = [this](std::span<const TriangleId> touched) { hand_on(touched); };
    locate_in_hull(inner);
  }

  /// To be called when a triangle was added by others: points of `t` may belong to it.
  void share_with_added(TriangleId t) {
    head_.resize(mesh_.mate.size(), kNone);
    hand_on(std::array{t, static_cast<TriangleId>(mesh_.mate.size() - 1)});
  }

  /// Makes q a vertex. False if the two triangles that a point on an edge leaves found no way
  /// together.
  bool insert(VertexId q) {
    const TriangleId t = home_[q];
    home_[q] = kNone;
    for (HalfedgeId h = 3 * t; h < 3 * t + 3; ++h) {
      if (orient(mesh_.tri.origin(h), mesh_.tri.target(h), q) != 0) continue;
      if (h != mesh_.mate[t]) return insert_on_edge(h, q);
    }
    mesh_.is_free(t) ? insert_in_free(t, q) : insert_in_quad(t, q);
    return true;
  }

 private:
  int orient(VertexId a, VertexId b, VertexId c) const {
    return orient2d(mesh_.point(a), mesh_.point(b), mesh_.point(c));
  }
  bool holds(TriangleId t, VertexId q) const {
    const VertexId* v = &mesh_.tri.tri_vertex[3 * t];
    return orient(v[0], v[1], q) >= 0 && orient(v[1], v[2], q) >= 0 && orient(v[2], v[0], q) >= 0;
  }

  void locate_in_hull(std::span<const VertexId> inner);

  /// The points of some triangles that were re-cut move to the ones among them that hold them now.
  void hand_on(std::span<const TriangleId> touched);

  TriangleId add_triangle() {
    mesh_.tri.tri_vertex.resize(mesh_.tri.tri_vertex.size() + 3);
    mesh_.tri.twin.resize(mesh_.tri.twin.size() + 3, kNone);
    mesh_.mate.push_back(kNone);
    head_.push_back(kNone);
    return static_cast<TriangleId>(mesh_.mate.size() - 1);
  }

  void insert_in_free(TriangleId t, VertexId q);
  void insert_in_quad(TriangleId t, VertexId q);
  bool insert_on_edge(HalfedgeId edge, VertexId q);

  bool other_diagonal_is_better(HalfedgeId diagonal, VertexId q) const;
  void flip_diagonal(HalfedgeId diagonal);
  std::array<TriangleId, 3> split_triangle(TriangleId t, VertexId q);
  std::array<TriangleId, 4> split_edge(HalfedgeId edge, VertexId q);

  PairedMesh& mesh_;
  Walker& walker_;
  std::vector<VertexId> head_;  // per triangle: the first point that it holds
  std::vector<VertexId> next_;  // per point: the next one in the same triangle
  std::vector<TriangleId> home_;
  std::vector<VertexId> moving_;
};

/// The diagonals of the serpentine order do not cross and part the hull in order: binary search for
/// each point.
void Inserter::locate_in_hull(std::span<const VertexId> inner) {
  const auto count = static_cast<TriangleId>(mesh_.mate.size());
  std::vector<HalfedgeId> diagonal;
  for (TriangleId t = 0; t + 1 < count; ++t) diagonal.push_back(shared_edge(mesh_, t, t + 1));
  head_.assign(count, kNone);
  for (const VertexId q : inner) {
    TriangleId low = 0, high = count - 1;
    while (low < high) {
      const TriangleId middle = (low + high) / 2;
      const HalfedgeId d = diagonal[middle];
      if (orient(mesh_.tri.origin(d), mesh_.tri.target(d), q) >= 0) {
        high = middle;
      } else {
        low = middle + 1;
      }
    }
    home_[q] = low;
    next_[q] = std::exchange(head_[low], q);
  }
}

/// The points of some triangles that were re-cut move to the ones among them that hold them now.
void Inserter::hand_on(std::span<const TriangleId> touched) {
  moving_.clear();
  for (const TriangleId t : touched) {
    for (VertexId q = std::exchange(head_[t], kNone); q != kNone; q = next_[q]) {
      if (home_[q] != kNone) moving_.push_back(q);
    }
  }
  for (const VertexId q : moving_) {
    std::size_t i = 0;
    while (i + 1 < touched.size() && !holds(touched[i], q)) ++i;
    home_[q] = touched[i];
    next_[q] = std::exchange(head_[touched[i]], q);
  }
}

void Inserter::insert_in_free(TriangleId t, VertexId q) {
  const auto parts = split_triangle(t, q);
  mesh_.pair(shared_edge(mesh_, parts[0], parts[1]));
  hand_on(parts);
}

//      c                    c
//     / .                 / | .           The path a-q-b or d-q-c parts the quad a, d, b, c in two.
//    /q  .               /  q  .
//   a --- b     ->      a . - . b
//    .   /               .     /
//      d                    d
void Inserter::insert_in_quad(TriangleId t, VertexId q) {
  HalfedgeId diagonal = mesh_.mate[t];
  const TriangleId other = triangle_of(mesh_.tri.twin[diagonal]);
  if (other_diagonal_is_better(diagonal, q)) {
    flip_diagonal(diagonal);
    if (!holds(t, q)) t = other;
    diagonal = mesh_.mate[t];
  }
  const TriangleId beyond = triangle_of(mesh_.tri.twin[diagonal]);
  if (orient(mesh_.tri.origin(diagonal), mesh_.tri.target(diagonal), q) == 0) {
    const auto parts = split_edge(diagonal, q);
    mesh_.pair(shared_edge(mesh_, parts[0], parts[2]));
    mesh_.pair(shared_edge(mesh_, parts[1], parts[3]));
    hand_on(parts);
    return;
  }
  const auto parts = split_triangle(t, q);  // parts[0] has the diagonal
  mesh_.pair(shared_edge(mesh_, parts[0], beyond));
  mesh_.pair(shared_edge(mesh_, parts[1], parts[2]));
  hand_on(std::array{parts[0], parts[1], parts[2], beyond});
}

//         c                     c
//       /   .                 / | .         The quads left and right of a->b lose a triangle each:
//       the half at a or at b that
//      / t   .               / 0|1 .        is not next to its old partner. Two such halves that
//      face each other are a
//     a-------b     ->      a---q---b       quad, else they walk together. If t or u was free
//     already, its half that
//      . u   /               . 2|3 /        faces the other's left-over pairs with it.
//       .   /                 . | /
//         e                     e
bool Inserter::insert_on_edge(HalfedgeId edge, VertexId q) {
  const HalfedgeId twin = mesh_.tri.twin[edge];
  // Which half of a triangle keeps its partner: the one at the end of the edge that the partner's
  // edge starts or ends at.
  const auto partner = [&](HalfedgeId side) {
    const HalfedgeId mate = mesh_.mate[triangle_of(side)];
    return mate == kNone ? kNone : triangle_of(mesh_.tri.twin[mate]);
  };
  const auto at_end = [&](HalfedgeId side) {
    return mesh_.mate[triangle_of(side)] == next_halfedge(side);
  };
  const TriangleId beside_t = partner(edge), beside_u = partner(twin);
  const bool keeps_b = at_end(edge), keeps_a_below = at_end(twin);

  const auto parts = split_edge(edge, q);
  if (beside_t != kNone) mesh_.pair(shared_edge(mesh_, parts[keeps_b ? 1 : 0], beside_t));
  if (beside_u != kNone) mesh_.pair(shared_edge(mesh_, parts[keeps_a_below ? 2 : 3], beside_u));
  hand_on(parts);
  for (const auto& [above, below] : {std::pair{0, 2}, std::pair{1, 3}}) {
    const TriangleId s = parts[static_cast<std::size_t>(above)];
    const TriangleId t = parts[static_cast<std::size_t>(below)];
    if (!mesh_.is_free(s) || !mesh_.is_free(t)) continue;
    mesh_.pair(shared_edge(mesh_, s, t));
    return true;
  }
  const TriangleId lost = parts[keeps_b ? 0 : 1];
  return walker_.merge(lost, {WalkQuads::kAny, 10'000}) ||
         walker_.merge(lost, {WalkQuads::kAny, 0xffffffffU, 16});
}

bool Inserter::other_diagonal_is_better(HalfedgeId diagonal, VertexId q) const {
  const Point a = mesh_.point(mesh_.tri.origin(diagonal)),
              b = mesh_.point(mesh_.tri.target(diagonal));
  const Point c = mesh_.point(mesh_.tri.apex(diagonal)), p = mesh_.point(q);
  const Point d = mesh_.point(mesh_.tri.apex(mesh_.tri.twin[diagonal]));
  if (classify_quad(a, d, b, c) != QuadKind::kStrictlyConvex) return false;
  // Of the two quads on either side of the path through q one may be convex: compare these.
  const auto shape = [](Point i, Point j, Point k, Point l) {
    return classify_quad(i, j, k, l) == QuadKind::kStrictlyConvex ? kernel::squareness(i, j, k, l)
                                                                  : -1.0;
  };
  const double along = std::max(shape(a, p, b, c), shape(a, d, b, p));
  const double across = std::max(shape(a, d, p, c), shape(d, b, c, p));
  return across > along;
}

/// The quad a, d, b, c gets the diagonal d-c; both triangles keep their places.
void Inserter::flip_diagonal(HalfedgeId diagonal) {
  Triangulation& tri = mesh_.tri;
  const HalfedgeId twin = tri.twin[diagonal];
  const TriangleId t = triangle_of(diagonal), u = triangle_of(twin);
  const VertexId a = tri.origin(diagonal), b = tri.target(diagonal);
  const VertexId c = tri.apex(diagonal), d = tri.apex(twin);
  const HalfedgeId beyond_bc = tri.twin[next_halfedge(diagonal)];
  const HalfedgeId beyond_ca = tri.twin[previous_halfedge(diagonal)];
  const HalfedgeId beyond_ad = tri.twin[next_halfedge(twin)];
  const HalfedgeId beyond_db = tri.twin[previous_halfedge(twin)];
  mesh_.set_triangle(t, d, c, a);
  mesh_.set_triangle(u, c, d, b);
  mesh_.link(3 * t + 1, beyond_ca);
  mesh_.link(3 * t + 2, beyond_ad);
  mesh_.link(3 * u + 1, beyond_db);
  mesh_.link(3 * u + 2, beyond_bc);
  mesh_.link(3 * t, 3 * u);
  mesh_.pair(3 * t);
}

/// Three triangles about q, the first at t's edge inside its quad (if it has one); all free.
std::array<TriangleId, 3> Inserter::split_triangle(TriangleId t, VertexId q) {
  Triangulation& tri = mesh_.tri;
  const HalfedgeId first = mesh_.is_free(t) ? 3 * t : mesh_.mate[t];
  const HalfedgeId second = next_halfedge(first), third = next_halfedge(second);
  const VertexId a = tri.origin(first), b = tri.origin(second), c = tri.origin(third);
  const HalfedgeId beyond_ab = tri.twin[first], beyond_bc = tri.twin[second];
  const HalfedgeId beyond_ca = tri.twin[third];
  const TriangleId u = add_triangle(), v = add_triangle();
  mesh_.set_triangle(t, a, b, q);
  mesh_.set_triangle(u, b, c, q);
  mesh_.set_triangle(v, c, a, q);
  mesh_.link(3 * t, beyond_ab);
  mesh_.link(3 * u, beyond_bc);
  mesh_.link(3 * v, beyond_ca);
  mesh_.link(3 * t + 1, 3 * u + 2);
  mesh_.link(3 * u + 1, 3 * v + 2);
  mesh_.link(3 * v + 1, 3 * t + 2);
  mesh_.mate[t] = kNone;
  return {t, u, v};
}

/// The four triangles about q on the edge a->b, as drawn at insert_on_edge; all free.
std::array<TriangleId, 4> Inserter::split_edge(HalfedgeId edge, VertexId q) {
  Triangulation& tri = mesh_.tri;
  const HalfedgeId twin = tri.twin[edge];
  const TriangleId t = triangle_of(edge), u = triangle_of(twin);
  const VertexId a = tri.origin(edge), b = tri.target(edge), c = tri.apex(edge), e = tri.apex(twin);
  const HalfedgeId beyond_bc = tri.twin[next_halfedge(edge)];
  const HalfedgeId beyond_ca = tri.twin[previous_halfedge(edge)];
  const HalfedgeId beyond_ae = tri.twin[next_halfedge(twin)];
  const HalfedgeId beyond_eb = tri.twin[previous_halfedge(twin)];
  const TriangleId v = add_triangle(), w = add_triangle();
  mesh_.set_triangle(t, a, q, c);
  mesh_.set_triangle(v, q, b, c);
  mesh_.set_triangle(u, q, a, e);
  mesh_.set_triangle(w, b, q, e);
  mesh_.link(3 * t + 2, beyond_ca);
  mesh_.link(3 * v + 1, beyond_bc);
  mesh_.link(3 * u + 1, beyond_ae);
  mesh_.link(3 * w + 2, beyond_eb);
  mesh_.link(3 * t, 3 * u);
  mesh_.link(3 * v, 3 * w);
  mesh_.link(3 * t + 1, 3 * v + 2);
  mesh_.link(3 * u + 2, 3 * w + 1);
  mesh_.mate[t] = mesh_.mate[u] = kNone;
  return {t, v, u, w};
}

std::vector<VertexId> inner_points_in_random_order(const PairedMesh& hull, std::uint64_t seed) {
  std::vector<bool> on_hull(hull.tri.points.size(), false);
  for (const VertexId v : hull.tri.tri_vertex) on_hull[v] = true;
  std::vector<VertexId> inner;
  for (VertexId v = 0; v < on_hull.size(); ++v) {
    if (!on_hull[v]) inner.push_back(v);
  }
  Random random(seed);
  for (std::size_t i = inner.size(); i > 1; --i) std::swap(inner[i - 1], inner[random.below(i)]);
  return inner;
}

std::optional<PointResult> insert_in_order(PairedMesh mesh, const PointOptions& options,
                                           std::uint64_t seed) {
  PointResult result;
  result.input_vertices = mesh.tri.points.size();
  const HullOfMesh hull(mesh.tri);
  result.statistics.hull_points = hull.size();
  const std::vector<VertexId> inner = inner_points_in_random_order(mesh, seed);

  Walker walker(mesh);
  Inserter inserter(mesh, walker, inner);
  if (hull.size() % 2 == 1 && options.odd_boundary != OddBoundary::kTriangle) {
    const TriangleId first = 0;
    const auto placed =
        walk_to_hull(mesh, walker, hull, {&first, 1}, kinds_by_wish(options.odd_boundary));
    if (!placed) return std::nullopt;
    result.steiner.push_back(*placed);
    const auto added = static_cast<TriangleId>(mesh.mate.size() - 1);
    inserter.share_with_added(triangle_of(mesh.tri.twin[mesh.mate[added]]));
  }
  constexpr std::size_t kReportEvery = 4096, kSlow = 256;  // the first ones look at all points
  for (std::size_t i = 0; i < inner.size(); ++i) {
    if (i < kSlow || i % kReportEvery == 0) {
      report_progress(options.progress, "inserting",
                      static_cast<double>(i) / static_cast<double>(inner.size()));
    }
    if (!inserter.insert(inner[i])) return std::nullopt;
  }
  result.statistics.walks = walker.walks();
  result.statistics.walk_steps = walker.steps();
  result.mesh = to_quadrangulation(std::move(mesh));
  return result;
}

}  // namespace

std::optional<PointResult> insertion_quadrangulation(const std::vector<Point>& points,
                                                     const PointOptions& options) {
  const PairedMesh hull = quadrangulate_hull(points);
  Random seeds(options.seed);
  for (int order = 0; order < kOrders; ++order) {
    if (auto result = insert_in_order(hull, options, seeds.next())) return result;
  }
  return std::nullopt;
}

}  // namespace quadloom::quadrangulate
