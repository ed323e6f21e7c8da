// Fans of a three-coloured polygon.
//
// Ramaswami, Ramos and Toussaint, Converting Triangulations to Quadrangulations, theorem 2.1, after Fisk's
// proof of the art gallery theorem: the corners of a triangulated simple polygon have three colours such
// that each triangle has all three, so the corners of any one colour part the triangles into fans, which
// start and end at edges of the polygon. Along a fan triangles are paired; a fan of an odd number of
// triangles takes one outer Steiner point. One colour has at most n / 3 corners: at most n / 3 points.
//
// Steps, for each part (triangles connected without crossing an edge that stays):
//   1. open_up          holes and inner vertices: the dual is cut down to a spanning tree, so that the
//                       triangles hang together as those of a simple polygon do
//   2. colour_corners   the first triangle's corners at will, then over each edge of the tree
//   3. choose_colour    the one with the fewest odd fans
//   4. pair_fan         for each of its corners
//   5. find_way_out     for the triangle that stays over in a fan without a boundary edge, which only step
//                       1 makes: along an alternating path to a triangle that has one
//   6. add_points       one outside each triangle that is still over
//
//        r2---r1           The fan of v: triangles 0, 1, 2, from arm to arm. One of those with an even
//       / .   | .          number stays over, and takes its point outside an arm (here v r0) or outside a
//      / 2 . 1|0 .         boundary edge opposite of v.
//    r3 ----- v---r0
//
// What differs from the paper: it takes the smallest colour, we take the one with the fewest odd
// fans, which are no more; the left-over triangle may be any of those with an even number, the one with the
// longest boundary edge that has a place. Colours belong to corners of triangles, not to vertices, so that a
// vertex at which the boundary touches itself counts once for each time that the boundary passes it; n is
// the number of boundary edges. Step 1 goes past the paper: t triangles, opened up, are a polygon of
// t + 2 corners, so at most (t + 2) / 3 points; for n corners and k holes that is (n + 2 k) / 3.
//
// Degenerate input: parts of one triangle, collinear corners. A triangle that cannot reach a
// boundary edge is an Error that names it. Cost: O(n), O(n log n) for the places, and the search of step 5.
#include "quadrangulate/triangulation_fans.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "core/step_reports.hpp"
#include "quadloom/dual.hpp"
#include "quadrangulate/border_edges.hpp"
#include "quadrangulate/mesh_parts.hpp"
#include "quadrangulate/quad_collector.hpp"

namespace quadloom::quadrangulate {
namespace {

using Colour = std::uint8_t;

class Fans {
 public:
  Fans(const TriangleMesh& input, const TriangleOptions& options)
      : input_(input),
        options_(options),
        cut_(cut_along_kept_edges(input)),
        parts_(parts_of(cut_)),
        out_(input) {}

  TriangleResult run() {
    out_.statistics().parts = parts_.count();
    out_.statistics().odd_parts = parts_.odd_count();
    report_progress(options_.progress, "three colours", 0);
    open_up();
    colour_corners();
    const std::vector<Colour> chosen = choose_colours();
    report_progress(options_.progress, "pairing", 0);
    for (const HalfedgeId h : boundary_edges(open_)) {
      if (colour_[h] == chosen[parts_.part[triangle_of(h)]]) pair_fan(h);
    }
    StepReports report(options_.progress, "ways out", over_.size(), 16);
    for (const Over& over : over_) {
      report();
      if (mate_[over.triangle] == kNone && over.may_stay.empty()) find_way_out(over.triangle);
    }
    add_points();
    out_.statistics().unmatched = out_.result().steiner.size();
    return out_.take();
  }

 private:
  /// A triangle that stayed over in its fan, and those that may stay in its place; none if no
  /// triangle of the fan has a boundary edge.
  struct Over {
    TriangleId triangle;
    std::vector<TriangleId> may_stay;
    std::vector<HalfedgeId> fan;
  };

  bool at_boundary(TriangleId t) const;
  void open_up();
  void colour_corners();
  std::vector<Colour> choose_colours() const;
  std::vector<HalfedgeId> fan_of(HalfedgeId first) const;
  void pair_fan(HalfedgeId first);
  void pair_along(const std::vector<HalfedgeId>& fan, TriangleId alone);
  void pair(HalfedgeId h);
  void find_way_out(TriangleId start);
  void add_points();

  const TriangleMesh& input_;
  const TriangleOptions& options_;
  const Triangulation cut_;
  const MeshParts parts_;
  QuadCollector out_;
  Triangulation open_;          // the twins of spanning trees alone
  std::vector<Colour> colour_;  // of the corner that a halfedge starts at
  std::vector<HalfedgeId> mate_;
  std::vector<Over> over_;
  std::vector<TriangleId> ways_end_;  // where ways out ended: the triangle there is over now
};

bool Fans::at_boundary(TriangleId t) const {
  const auto& twin = input_.mesh.twin;
  return twin[3 * t] == kNone || twin[3 * t + 1] == kNone || twin[3 * t + 2] == kNone;
}

void Fans::open_up() {
  open_ = cut_;
  open_.twin = spanning_forest(dual_graph(cut_)).twin;
  mate_.assign(cut_.triangle_count(), kNone);
}

void Fans::colour_corners() {
  constexpr Colour kWithout = 3;
  colour_.assign(cut_.twin.size(), kWithout);
  std::vector<TriangleId> todo;
  for (TriangleId first = 0; first < cut_.triangle_count(); ++first) {
    if (colour_[3 * first] != kWithout) continue;
    for (Colour i = 0; i < 3; ++i) colour_[3 * first + i] = i;
    todo.push_back(first);
    while (!todo.empty()) {
      const TriangleId t = todo.back();
      todo.pop_back();
      for (HalfedgeId h = 3 * t; h < 3 * t + 3; ++h) {
        const HalfedgeId twin = open_.twin[h];
        if (twin == kNone || colour_[twin] != kWithout) continue;
        colour_[twin] = colour_[next_halfedge(h)];
        colour_[next_halfedge(twin)] = colour_[h];
        colour_[previous_halfedge(twin)] = colour_[previous_halfedge(h)];
        todo.push_back(triangle_of(twin));
      }
    }
  }
}

/// The halfedges from the fan's middle, one a triangle, counter-clockwise from the arm `first`.
std::vector<HalfedgeId> Fans::fan_of(HalfedgeId first) const {
  std::vector<HalfedgeId> out;
  for (HalfedgeId h = first; h != kNone; h = open_.twin[previous_halfedge(h)]) out.push_back(h);
  return out;
}

std::vector<Colour> Fans::choose_colours() const {
  std::vector<std::array<std::size_t, 3>> odd_fans(parts_.count());
  for (const HalfedgeId h : boundary_edges(open_)) {
    odd_fans[parts_.part[triangle_of(h)]][colour_[h]] += fan_of(h).size() % 2;
  }
  std::vector<Colour> out;
  for (const auto& count : odd_fans) {
    out.push_back(
        static_cast<Colour>(std::min_element(count.begin(), count.end()) - count.begin()));
  }
  return out;
}

void Fans::pair_fan(HalfedgeId first) {
  std::vector<HalfedgeId> fan = fan_of(first);
  if (fan.size() % 2 == 0) {
    pair_along(fan, kNone);
    return;
  }
  Over over{triangle_of(fan[0]), {}, {}};
  for (std::size_t i = 0; i < fan.size(); i += 2) {
    if (at_boundary(triangle_of(fan[i]))) over.may_stay.push_back(triangle_of(fan[i]));
  }
  if (!over.may_stay.empty()) over.triangle = over.may_stay[0];
  pair_along(fan, over.triangle);
  over.fan = std::move(fan);
  over_.push_back(std::move(over));
}

void Fans::pair_along(const std::vector<HalfedgeId>& fan, TriangleId alone) {
  for (std::size_t i = 0; i < fan.size(); i += 2) {
    if (triangle_of(fan[i]) == alone)
      --i;
    else
      pair(previous_halfedge(fan[i]));
  }
}

void Fans::pair(HalfedgeId h) {
  mate_[triangle_of(h)] = h;
  mate_[triangle_of(cut_.twin[h])] = cut_.twin[h];
}

/// Breadth first: from a triangle over the pair beside it to its far half, until that has a boundary edge
/// or another triangle is over beside it.
void Fans::find_way_out(TriangleId start) {
  std::vector<HalfedgeId> came_over = std::vector<HalfedgeId>(mate_.size(), kNone);
  std::vector<std::uint8_t> seen(mate_.size());
  std::vector<TriangleId> todo = {start};
  seen[start] = 1;
  const auto take_way = [&](TriangleId t) {
    std::vector<HalfedgeId> way;
    for (; t != start; t = triangle_of(way.back())) way.push_back(came_over[t]);
    for (; !way.empty(); way.pop_back()) pair(way.back());
  };
  for (std::size_t i = 0; i < todo.size(); ++i) {
    const TriangleId t = todo[i];
    for (HalfedgeId h = 3 * t; h < 3 * t + 3; ++h) {
      const HalfedgeId twin = cut_.twin[h];
      if (twin == kNone || seen[triangle_of(twin)] != 0) continue;
      const TriangleId near = triangle_of(twin);
      seen[near] = 1;
      if (mate_[near] == kNone) {
        take_way(t);
        pair(h);
        return;
      }
      const TriangleId far = triangle_of(cut_.twin[mate_[near]]);
      seen[far] = 1;
      came_over[far] = h;
      if (at_boundary(far)) {
        take_way(far);
        mate_[far] = kNone;
        ways_end_.push_back(far);
        return;
      }
      todo.push_back(far);
    }
  }
  throw Error(ErrorCode::kGuarantee,
              "triangle " + std::to_string(start) +
                  " stays over in its fan, and no boundary edge is near for an outer Steiner point",
              {start});
}

void Fans::add_points() {
  std::optional<OuterPlaces> places;
  std::vector<std::uint8_t> has_point(mate_.size());
  const auto add_point = [&](std::span<const TriangleId> may_stay) {
    if (!places) places.emplace(input_.mesh);
    const auto [edge, place] = longest_with_place(input_.mesh, may_stay, *places);
    out_.add_split(edge, out_.add_steiner({place, 0, SteinerKind::kOutside}, edge));
    has_point[triangle_of(edge)] = 1;
    return triangle_of(edge);
  };
  for (Over& over : over_) {
    if (mate_[over.triangle] != kNone || over.may_stay.empty()) continue;
    // As long as no way has gone through the fan, any of its triangles may stay.
    bool whole = true;
    for (const HalfedgeId h : over.fan) {
      const HalfedgeId m = mate_[triangle_of(h)];
      whole &= m == kNone ? triangle_of(h) == over.triangle : m == previous_halfedge(h) || m == h;
    }
    if (!whole) over.may_stay = {over.triangle};
    const TriangleId alone = add_point(over.may_stay);
    if (alone != over.triangle) {
      mate_[alone] = kNone;
      pair_along(over.fan, alone);
    }
  }
  for (const TriangleId t : ways_end_) {
    if (mate_[t] == kNone && has_point[t] == 0) add_point({&t, 1});
  }
  for (TriangleId t = 0; t < mate_.size(); ++t) {
    if (mate_[t] != kNone && mate_[t] < cut_.twin[mate_[t]]) out_.add_pair(mate_[t]);
  }
}

}  // namespace

TriangleResult fan_triangulation(const TriangleMesh& input, const TriangleOptions& options) {
  require_planar(input);
  return Fans(input, options).run();
}

}  // namespace quadloom::quadrangulate
