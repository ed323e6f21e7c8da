// Fans of a three-coloured polygon.
//
// Ramaswami, Ramos and Toussaint, Converting Triangulations to Quadrangulations, theorem 2.1, after Fisk's
// proof of the art gallery theorem: the corners of a triangulated simple polygon have three colours such
// that each triangle has all three, so the corners of any one colour part the triangles into fans, which
// start and end at edges of the polygon. Along a fan triangles are paired; a fan of an odd number of
// triangles takes one outer Steiner point. One colour has at most n / 3 corners: at most n / 3 points.
//
// Steps, for each part (triangles connected without crossing an edge that stays):
//   1. require_tree     it must be a polygon without holes and inner vertices: its dual is a tree
//   2. colour_corners   the first triangle's corners at will, then over each dual edge
//   3. choose_colour    the one with the fewest odd fans
//   4. pair_fan         for each of its corners
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
// the number of boundary edges.
//
// Degenerate input: parts of one triangle, collinear corners. A part that is no such polygon is an Error
// that names an inner vertex, or a triangle next to the hole. A fan that touches edges to keep alone, if it
// is odd, has no place. Cost: O(n), and O(n log n) for the places.
#include "quadrangulate/triangulation_fans.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>

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
    require_trees();
    colour_corners();
    const std::vector<Colour> chosen = choose_colours();
    report_progress(options_.progress, "pairing", 0);
    for (const HalfedgeId h : boundary_edges(cut_)) {
      if (colour_[h] == chosen[parts_.part[triangle_of(h)]]) pair_fan(h);
    }
    return out_.take();
  }

 private:
  void require_trees() const;
  [[noreturn]] void refuse(std::uint32_t part) const;
  void colour_corners();
  std::vector<Colour> choose_colours() const;
  std::vector<HalfedgeId> fan_of(HalfedgeId first) const;
  void pair_fan(HalfedgeId first);

  const TriangleMesh& input_;
  const TriangleOptions& options_;
  const Triangulation cut_;
  const MeshParts parts_;
  QuadCollector out_;
  std::optional<OuterPlaces> places_;
  std::vector<Colour> colour_;  // of the corner that a halfedge starts at
};

void Fans::require_trees() const {
  std::vector<std::size_t> halfedges(parts_.count());
  for (HalfedgeId h = 0; h < cut_.twin.size(); ++h) {
    halfedges[parts_.part[triangle_of(h)]] += cut_.twin[h] != kNone;
  }
  for (std::uint32_t p = 0; p < parts_.count(); ++p) {
    if (halfedges[p] / 2 + 1 != parts_.triangles[p]) refuse(p);
  }
}

/// A part whose dual has a cycle: around a vertex without a border edge, or around a hole.
void Fans::refuse(std::uint32_t part) const {
  std::vector<std::uint8_t> on_border(cut_.points.size());
  for (HalfedgeId h = 0; h < cut_.twin.size(); ++h) {
    if (cut_.twin[h] == kNone) on_border[cut_.origin(h)] = on_border[cut_.target(h)] = 1;
  }
  TriangleId first = kNone;
  for (HalfedgeId h = 0; h < cut_.twin.size(); ++h) {
    if (parts_.part[triangle_of(h)] != part) continue;
    if (first == kNone) first = triangle_of(h);
    if (on_border[cut_.origin(h)] != 0) continue;
    throw Error(ErrorCode::kBadMesh,
                "fans are for polygons without inner vertices, and vertex " +
                    std::to_string(cut_.origin(h)) + " is one",
                {cut_.origin(h)});
  }
  throw Error(ErrorCode::kBadMesh,
              "fans are for polygons without holes, and the part of triangle " +
                  std::to_string(first) + " has a hole",
              {first});
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
        const HalfedgeId twin = cut_.twin[h];
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
  for (HalfedgeId h = first; h != kNone; h = cut_.twin[previous_halfedge(h)]) out.push_back(h);
  return out;
}

std::vector<Colour> Fans::choose_colours() const {
  std::vector<std::array<std::size_t, 3>> odd_fans(parts_.count());
  for (const HalfedgeId h : boundary_edges(cut_)) {
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
  const std::vector<HalfedgeId> fan = fan_of(first);
  TriangleId alone = kNone;
  if (fan.size() % 2 == 1) {
    std::vector<TriangleId> may_stay;
    for (std::size_t i = 0; i < fan.size(); i += 2) may_stay.push_back(triangle_of(fan[i]));
    if (!places_) places_.emplace(input_.mesh);
    const auto [edge, place] = longest_with_place(input_.mesh, may_stay, *places_);
    out_.add_split(edge, out_.add_steiner({place, 0, SteinerKind::kOutside}, edge));
    alone = triangle_of(edge);
    ++out_.statistics().unmatched;
  }
  for (std::size_t i = 0; i < fan.size(); i += 2) {
    if (triangle_of(fan[i]) == alone)
      --i;
    else
      out_.add_pair(previous_halfedge(fan[i]));
  }
}

}  // namespace

TriangleResult fan_triangulation(const TriangleMesh& input, const TriangleOptions& options) {
  require_planar(input);
  return Fans(input, options).run();
}

}  // namespace quadloom::quadrangulate
