// A triangulation made Hamiltonian: a point in each triangle, and flips along a spanning tree.
//
// Arkin, Held, Mitchell, Skiena, "Hamiltonian triangulations for fast rendering", theorem 2.4: k
// triangles become 3 k whose dual graph has a Hamiltonian cycle, by k added points; no angle is smaller
// than half the smallest one of the input. O(k), and sorting.
//
//   1. place_inner_points  the incentre of each triangle, which is joined to the corners
//   2. grow_trees          a spanning tree of the dual graph, of each component one
//   3. walk_around         the cycle goes around the tree: on the edges that the tree crosses a-b is
//                          flipped to c-d, and one triangle leads over to the other side
//
//             c                       c
//           /   \                   / | \            Before the flip the cycle around c has a b c in
//         a ----- b     ->        a   |   b          it, that around d has b a d. The flip joins them
//           \   /                   \ | /            to one cycle: ... a d c ... and ... b c d ...
//             d                       d
//
//             c                       c
//           /   \                   / | \            An edge that must stay (to keep, between regions)
//         a ===== b     ->        a ==m== b          gets a midpoint; the cycle leads over from a m c
//           \   /                   \ | /            to m a d and comes back from b m d to m b c.
//             d                       d
//
// Which tree: edges that must stay come last, so that there are as few midpoints as the mesh allows.
// Of the others those come first whose flip takes the sharpest angles away (a flip joins two of the
// halved angles at a, and at b). On a surface in space flat edges come first instead.
//
// What differs from the paper: that choice, and that it reasons in real numbers. Here each added point
// is rounded, then it is proved by exact predicates to be strictly inside its triangle, and each flip to
// be one in a strictly convex quad. If the incentre as rounded is not inside, another place in the
// triangle is taken; if a flip is not possible then, the tree avoids the edge or gives it a midpoint.
// The angle is a theorem in the plane and for incentres; elsewhere it is what it is. It is measured.
//
// Degenerate input: needles, see above. A triangle that has no double inside is an Error.
// Cost: O(k log k), by the sorting.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <string>

#include "quadloom/strips.hpp"
#include "quadrangulate/mesh_parts.hpp"
#include "quadrangulate/triangulation_input.hpp"
#include "strips/refinement_places.hpp"

namespace quadloom {
namespace strips {
namespace {

using kernel::Places;
using kernel::Vector3;

/// Union-find.
class Components {
 public:
  explicit Components(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0U);
  }
  std::uint32_t root(std::uint32_t t) {
    while (parent_[t] != t) t = parent_[t] = parent_[parent_[t]];
    return t;
  }
  bool join(std::uint32_t t, std::uint32_t u) {
    t = root(t);
    u = root(u);
    if (t == u) return false;
    parent_[std::max(t, u)] = std::min(t, u);
    return true;
  }

 private:
  std::vector<std::uint32_t> parent_;
};

enum class Crossing : std::uint8_t { kNo, kFlip, kMiddle };

struct Candidate {
  HalfedgeId h = kNone;
  double rank = 0;  // smaller first
};

class Refinement {
 public:
  Refinement(const TriangleMesh& input, const Progress& progress)
      : input_(input),
        mesh_(input.mesh),
        places_{input.mesh.points, input.z},
        progress_(progress),
        crossing_(mesh_.twin.size(), Crossing::kNo),
        middle_(mesh_.twin.size(), kNone),
        first_half_(mesh_.twin.size(), kNone),
        second_half_(mesh_.twin.size(), kNone) {}

  void place_inner_points() {
    report_progress(progress_, "placing points", 0);
    inner_.reserve(mesh_.triangle_count());
    for (TriangleId t = 0; t < mesh_.triangle_count(); ++t) {
      const InnerPlace found = inner_place(mesh_, places_, t);
      inner_.push_back(found.at);
      if (!found.incentre) ++out_.moved;
      const auto first = mesh_.tri_vertex.begin() + 3 * static_cast<std::ptrdiff_t>(t);
      out_.steiner.push_back(
          {inner_vertex(t), SteinerKind::kInner, {first[0], first[1], first[2]}});
    }
  }

  void grow_trees() {
    report_progress(progress_, "spanning tree", 0.4);
    std::vector<Candidate> flips;
    std::vector<HalfedgeId> others;
    for (HalfedgeId h = 0; h < mesh_.twin.size(); ++h) {
      const HalfedgeId g = mesh_.twin[h];
      if (g == kNone || g < h || triangle_of(g) == triangle_of(h)) continue;
      if (must_stay(h) || !can_flip(kite(mesh_, places_, h, inner(h), inner(g)))) {
        others.push_back(h);
      } else {
        flips.push_back({h, rank(h)});
      }
    }
    std::sort(flips.begin(), flips.end(), [](const Candidate& a, const Candidate& b) {
      return a.rank != b.rank ? a.rank < b.rank : a.h < b.h;
    });
    Components components(mesh_.triangle_count());
    for (const Candidate& c : flips) {
      if (!components.join(triangle_of(c.h), triangle_of(mesh_.twin[c.h]))) continue;
      set_crossing(c.h, Crossing::kFlip);
      ++out_.flips;
    }
    cross_by_midpoints(others, components);
  }

  void walk_around() {
    report_progress(progress_, "walking around", 0.7);
    std::vector<std::uint8_t> walked(mesh_.twin.size(), 0);
    for (HalfedgeId start = 0; start < mesh_.twin.size(); ++start) {
      if (walked[start] != 0) continue;
      HalfedgeId h = start;
      do {
        walked[h] = 1;
        pass(h);
        h = next_halfedge(crossing_[h] == Crossing::kNo ? h : mesh_.twin[h]);
      } while (h != start);
      out_.cycle_begin.push_back(static_cast<std::uint32_t>(out_.source.size()));
    }
  }

  HamiltonianRefinement finish() {
    write_points();
    connect();
    const Triangulation& mesh = out_.mesh.mesh;
    out_.input_vertices = mesh_.points.size();
    out_.min_angle_before = min_angle(mesh_, places_);
    out_.min_angle_after = min_angle(mesh, {mesh.points, out_.mesh.z});
    report_progress(progress_, "walking around", 1);
    return std::move(out_);
  }

 private:
  bool must_stay(HalfedgeId h) const { return quadrangulate::must_stay(input_, h); }
  const Vector3& inner(HalfedgeId h) const { return inner_[triangle_of(h)]; }
  VertexId inner_vertex(TriangleId t) const {
    return static_cast<VertexId>(mesh_.points.size()) + t;
  }

  /// The sharpest of the angles that the flip takes away, if it leaves none sharper; these come first.
  double rank(HalfedgeId h) const {
    const Vector3 a = places_.at(mesh_.origin(h)), b = places_.at(mesh_.target(h)), c = inner(h),
                  d = inner(mesh_.twin[h]);
    if (!places_.planar()) return -kernel::dot(normal(h), normal(mesh_.twin[h]));
    const double before = std::max(sharpness(a, b, c), sharpness(b, a, d));
    const double after = std::max(sharpness(a, d, c), sharpness(b, c, d));
    return after <= before ? -before : after;
  }

  Vector3 normal(HalfedgeId h) const {
    const Vector3 area = places_.area(mesh_.origin(h), mesh_.target(h), mesh_.apex(h));
    const double size = std::sqrt(kernel::dot(area, area));
    return size > 0 ? Vector3{area.x / size, area.y / size, area.z / size} : area;
  }

  void set_crossing(HalfedgeId h, Crossing crossing) {
    crossing_[h] = crossing_[mesh_.twin[h]] = crossing;
  }

  void cross_by_midpoints(const std::vector<HalfedgeId>& edges, Components& components) {
    HalfedgeId failed = kNone;
    for (const HalfedgeId h : edges) {
      const HalfedgeId g = mesh_.twin[h];
      if (components.root(triangle_of(h)) == components.root(triangle_of(g))) continue;
      const auto place = middle_place(mesh_, places_, h, inner(h), inner(g));
      if (!place) {
        failed = h;
        continue;
      }
      components.join(triangle_of(h), triangle_of(g));
      set_crossing(h, Crossing::kMiddle);
      middle_[h] = middle_[g] = inner_vertex(static_cast<TriangleId>(inner_.size()));
      out_.steiner.push_back(
          {middle_[h], SteinerKind::kOnEdge, {mesh_.origin(h), mesh_.target(h), kNone}});
      inner_.push_back(*place);
      ++out_.midpoints;
    }
    if (failed == kNone) return;
    const TriangleId t = triangle_of(failed), u = triangle_of(mesh_.twin[failed]);
    if (components.root(t) == components.root(u)) return;
    throw Error(ErrorCode::kGuarantee,
                "the edge between triangles " + std::to_string(t) + " and " + std::to_string(u) +
                    " can neither be flipped nor split",
                {t, u});
  }

  /// The piece or the two pieces that come at the halfedge h.
  void pass(HalfedgeId h) {
    const TriangleId t = triangle_of(h);
    const VertexId a = mesh_.origin(h), b = mesh_.target(h), c = inner_vertex(t);
    const bool kept =
        !input_.keep.empty() &&
        (input_.keep[h] != 0 || (mesh_.twin[h] != kNone && input_.keep[mesh_.twin[h]] != 0));
    first_half_[h] = static_cast<TriangleId>(out_.source.size());
    if (crossing_[h] == Crossing::kNo) {
      second_half_[h] = first_half_[h];
      add({a, b, c}, {t, kNone}, kept);
      return;
    }
    const HalfedgeId g = mesh_.twin[h];
    const TriangleId u = triangle_of(g);
    const VertexId d = inner_vertex(u);
    if (crossing_[h] == Crossing::kFlip) {
      second_half_[g] = first_half_[h];
      add({a, d, c}, {t, u}, false);
      return;
    }
    second_half_[g] = first_half_[h] + 1;
    add({a, middle_[h], c}, {t, kNone}, kept);
    add({middle_[h], a, d}, {u, kNone}, kept);
  }

  /// The twins. Of each piece halfedge 0 starts at its first corner (see pass).
  ///
  ///           c            The edge at the corner a of the triangle around c, where g ends and h begins:
  ///        g / \ h         from c to a in the first piece of h, from a to c in the last one of g.
  ///           a
  void connect() {
    Triangulation& mesh = out_.mesh.mesh;
    mesh.twin.assign(mesh.tri_vertex.size(), kNone);
    const auto join = [&](HalfedgeId a, HalfedgeId b) {
      mesh.twin[a] = b;
      mesh.twin[b] = a;
    };
    for (HalfedgeId h = 0; h < mesh_.twin.size(); ++h) {
      const HalfedgeId before = previous_halfedge(h), across = mesh_.twin[h];
      const HalfedgeId first = 3 * first_half_[h];
      join(first + 2, 3 * second_half_[before] + (crossing_[before] == Crossing::kFlip ? 0U : 1U));
      if (crossing_[h] == Crossing::kMiddle) {
        join(first, 3 * second_half_[across]);
        join(first + 1, 3 * second_half_[h] + 2);
      } else if (across != kNone) {
        const HalfedgeId side = crossing_[h] == Crossing::kFlip ? 1 : 0;
        join(first + side, 3 * first_half_[across] + side);
      }
    }
  }

  /// `kept`: the edge from the first corner to the second is one to keep.
  void add(const std::array<VertexId, 3>& corner, const std::array<TriangleId, 2>& source,
           bool kept) {
    TriangleMesh& out = out_.mesh;
    out.mesh.tri_vertex.insert(out.mesh.tri_vertex.end(), corner.begin(), corner.end());
    out_.source.push_back(source);
    if (!input_.region.empty()) out.region.push_back(input_.region[source[0]]);
    if (!input_.keep.empty())
      out.keep.insert(out.keep.end(), {kept ? std::uint8_t{1} : std::uint8_t{0}, 0, 0});
  }

  void write_points() {
    TriangleMesh& out = out_.mesh;
    out.mesh.points = mesh_.points;
    out.z = input_.z;
    for (const Vector3& p : inner_) {
      out.mesh.points.push_back({p.x, p.y});
      if (!places_.planar()) out.z.push_back(p.z);
    }
  }

  static double min_angle(const Triangulation& mesh, const Places& places) {
    double sharpest = -std::numeric_limits<double>::infinity();
    for (TriangleId t = 0; t < mesh.triangle_count(); ++t) {
      sharpest = std::max(sharpest, sharpness(places.at(mesh.tri_vertex[3 * t]),
                                              places.at(mesh.tri_vertex[3 * t + 1]),
                                              places.at(mesh.tri_vertex[3 * t + 2])));
    }
    return std::atan2(1.0, sharpest) * 180 / std::numbers::pi;
  }

  const TriangleMesh& input_;
  const Triangulation& mesh_;
  Places places_;
  const Progress& progress_;
  std::vector<Crossing> crossing_;  // by halfedge
  std::vector<VertexId> middle_;    // by halfedge
  std::vector<TriangleId> first_half_,
      second_half_;             // by halfedge: the pieces at its origin and target
  std::vector<Vector3> inner_;  // one a triangle, then the midpoints: added points in order
  HamiltonianRefinement out_;
};

void check_size(const Triangulation& mesh) {
  // five triangles for one at most: three and two more for a midpoint
  const std::size_t triangles = mesh.triangle_count();
  if (triangles < kNone / 15 - 1 && mesh.points.size() < kNone - 2 * triangles) return;
  throw Error(ErrorCode::kTooManyPoints, "too many triangles to refine with 32-bit indices");
}

}  // namespace
}  // namespace strips

HamiltonianRefinement hamiltonian_refinement(const TriangleMesh& input,
                                             const RefinementOptions& options) {
  quadrangulate::check_triangle_mesh(input);
  strips::check_size(input.mesh);
  strips::Refinement refinement(input, options.progress);
  refinement.place_inner_points();
  refinement.grow_trees();
  refinement.walk_around();
  return refinement.finish();
}

}  // namespace quadloom
