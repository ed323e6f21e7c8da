// Places for outer Steiner points.
//
// Ramaswami, Ramos and Toussaint, Converting Triangulations to Quadrangulations, section 2: the outside
// is triangulated, and the point for an edge may lie anywhere in the edge's outer triangle.
//
// Steps:
//   1. find_pockets   the constrained Delaunay triangulation of the boundary edges and of the four
//                     corners of a frame far out; each boundary edge has a triangle of it, its
//                     pocket, on its outer side
//   2. place          a point strictly inside the pocket
//
//        r-----------q      The places are s for the edge a -> b, whose pocket is b, a, r, and t for
//        |`.  .      |      the edge r -> a of the same pocket. The first of them parts the pocket
//        | t`  s `   |      into three; the others stay inside the part at their edge, so that the
//        | .` .   `  |      triangles a s b and r t a share nothing but corners.
//        |.`.      ` |
//        a-----------b
//             mesh
//
// Pockets have disjoint insides and no boundary edge in them, and each chosen edge has a triangle of its
// own within a pocket, so nothing that replaces an edge meets anything else but at the edge's ends.
//
// What differs from the paper: it triangulates the pockets between polygon and hull, and says little of
// edges of the hull and of several edges with one pocket; the frame makes the first one ordinary, step 2
// does the second. The constrained Delaunay triangulation has the fattest pockets there are.
//
// Which point: over the middle of the edge, half of its length out, or a quarter, ..., the first one
// that is in the region (a real number near the middle always is); else whatever double place_in_triangle
// finds. First with a strictly convex quad, which in real numbers exists too.
//
// Degenerate input: holes, boundary cycles that touch at corners, hanging vertices, several components. An
// edge without an outer side (two boundary edges on each other, a boundary vertex within it) has no
// place. Cost: O(b log b) for b boundary edges.
#include "quadrangulate/outer_places.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "kernel/predicates_inline.hpp"
#include "quadloom/kernel.hpp"
#include "quadrangulate/place_inside.hpp"

namespace quadloom::quadrangulate {
namespace {

using kernel::orient;

constexpr int kHalvings = 48;

/// The frame's low and high end over [low, high], `out` away; among the doubles.
std::pair<double, double> widened(double low, double high, double out) {
  constexpr double kMost = std::numeric_limits<double>::max();
  const double below = std::max(low - out, -kMost), above = std::min(high + out, kMost);
  return {std::min(below, std::nextafter(low, -kMost)),
          std::max(above, std::nextafter(high, kMost))};
}

void append_frame(std::vector<Point>& points) {
  Point low = points[0], high = points[0];
  for (const Point p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const double out = std::max(high.x - low.x, high.y - low.y);
  const auto [left, right] = widened(low.x, high.x, out);
  const auto [bottom, top] = widened(low.y, high.y, out);
  for (const Point p :
       {Point{left, bottom}, Point{right, bottom}, Point{right, top}, Point{left, top}}) {
    points.push_back(p);
  }
}

/// The boundary edges as segments between their vertices, numbered anew.
PlanarInput outline_of(const Triangulation& mesh, const std::vector<HalfedgeId>& boundary) {
  PlanarInput out;
  std::vector<VertexId> number(mesh.points.size(), kNone);
  const auto numbered = [&](VertexId v) {
    if (number[v] == kNone) {
      number[v] = static_cast<VertexId>(out.points.size());
      out.points.push_back(mesh.points[v]);
    }
    return number[v];
  };
  for (const HalfedgeId h : boundary) {
    out.segments.push_back({numbered(mesh.origin(h)), numbered(mesh.target(h))});
  }
  return out;
}

ConstrainedResult triangulate_outside(const PlanarInput& outline,
                                      const std::vector<HalfedgeId>& boundary) {
  try {
    return constrained_delaunay(outline, Extent::kHull);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::kCrossing) throw;
    std::vector<std::size_t> culprits;
    for (const std::size_t edge : error.culprits()) culprits.push_back(boundary[edge]);
    throw Error(ErrorCode::kBadMesh,
                "the boundary of the mesh crosses itself, it has no outside for Steiner points",
                std::move(culprits));
  }
}

/// By boundary edge: whether another one has the same ends.
std::vector<std::uint8_t> find_doubled(const PlanarInput& outline,
                                       const std::vector<VertexId>& vertex) {
  std::vector<std::pair<std::pair<VertexId, VertexId>, std::size_t>> ends;
  for (const Segment s : outline.segments) {
    ends.push_back({std::minmax(vertex[s.from], vertex[s.to]), ends.size()});
  }
  std::vector<std::uint8_t> doubled(ends.size());
  std::sort(ends.begin(), ends.end());
  for (std::size_t i = 1; i < ends.size(); ++i) {
    if (ends[i].first != ends[i - 1].first) continue;
    doubled[ends[i].second] = doubled[ends[i - 1].second] = 1;
  }
  return doubled;
}

/// What an edge a -> b may have: strictly inside the triangle b, a, r; and the quad a, s, b, c
/// strictly convex.
struct Region {
  Point a, b, r, c;

  bool holds(Point s) const {
    return std::isfinite(s.x) && std::isfinite(s.y) && orient(b, a, s) > 0 && orient(a, r, s) > 0 &&
           orient(r, b, s) > 0;
  }
  bool holds_convex(Point s) const {
    return holds(s) && orient(a, s, c) > 0 && orient(s, b, c) > 0;
  }
};

template <class Fits>
std::optional<Point> over_the_middle(Point a, Point b, const Fits& fits) {
  const Point middle{a.x / 2 + b.x / 2, a.y / 2 + b.y / 2};
  const Point out{b.y - a.y, a.x - b.x};  // as long as the edge
  for (int k = 1; k <= kHalvings; ++k) {
    const double f = std::ldexp(1.0, -k);
    const Point s{middle.x + f * out.x, middle.y + f * out.y};
    if (fits(s)) return s;
  }
  return std::nullopt;
}

std::optional<Point> place_in(const Region& region) {
  const auto convex = [&](Point s) { return region.holds_convex(s); };
  const auto any = [&](Point s) { return region.holds(s); };
  if (const auto s = over_the_middle(region.a, region.b, convex)) return s;
  const std::array<Point, 3> pocket = {region.b, region.a, region.r};
  if (const auto s = place_in_triangle(pocket, convex)) return s;
  return place_in_triangle(pocket, any);
}

}  // namespace

OuterPlaces::OuterPlaces(const Triangulation& mesh) : mesh_(mesh) {
  for (HalfedgeId h = 0; h < mesh.twin.size(); ++h) {
    if (mesh.twin[h] == kNone) boundary_.push_back(h);
  }
  outer_.assign(boundary_.size(), kNone);
  if (!boundary_.empty()) find_pockets();
}

void OuterPlaces::find_pockets() {
  PlanarInput outline = outline_of(mesh_, boundary_);
  append_frame(outline.points);
  const ConstrainedResult outside = triangulate_outside(outline, boundary_);
  const std::vector<std::uint8_t> doubled = find_doubled(outline, outside.input_to_vertex);
  std::vector<std::uint32_t> pocket_of(outside.mesh.triangle_count(), kNone);
  for (HalfedgeId g = 0; g < outside.edge.size(); ++g) {
    const std::uint32_t e = outside.edge[g];
    if (e == kNone || doubled[e] != 0) continue;
    // The whole edge, seen from its outer side.
    const auto [from, to] = outline.segments[e];
    if (outside.mesh.origin(g) != outside.input_to_vertex[to] ||
        outside.mesh.target(g) != outside.input_to_vertex[from]) {
      continue;
    }
    const TriangleId t = triangle_of(g);
    if (pocket_of[t] == kNone) {
      pocket_of[t] = static_cast<std::uint32_t>(pockets_.size());
      Pocket pocket;
      for (std::uint32_t i = 0; i < 3; ++i) {
        pocket.corner[i] = outside.mesh.points[outside.mesh.tri_vertex[3 * t + i]];
      }
      pockets_.push_back(pocket);
    }
    outer_[e] = 3 * pocket_of[t] + g % 3;
  }
}

std::uint32_t OuterPlaces::outer_of(HalfedgeId h) const {
  const auto at = std::lower_bound(boundary_.begin(), boundary_.end(), h);
  return outer_[static_cast<std::size_t>(at - boundary_.begin())];
}

/// The triangles a, b, s and r, a, t of two edges of a pocket have no more in common than a if the
/// directions from a to t, s, b are in this order.
///
///              r
///              | `.
///              | t  `.
///              |   s  `.
///              a---------b     the mesh is below a-b and on the left of r-a
bool OuterPlaces::allows(HalfedgeId h, Point s) const {
  const std::uint32_t outer = outer_of(h);
  if (outer == kNone) return false;
  const Pocket& pocket = pockets_[outer / 3];
  const std::uint32_t edge = outer % 3, next = (edge + 1) % 3, last = (edge + 2) % 3;
  const Point b = pocket.corner[edge], a = pocket.corner[next];
  if (!Region{a, b, pocket.corner[last], {}}.holds(s)) return false;
  const auto &at_a = pocket.taken[next], &at_b = pocket.taken[last];
  return (!at_a || orient(a, *at_a, s) > 0) && (!at_b || orient(b, s, *at_b) > 0);
}

void OuterPlaces::take(HalfedgeId h, Point s) {
  const std::uint32_t outer = outer_of(h);
  pockets_[outer / 3].taken[outer % 3] = s;
}

std::optional<Point> OuterPlaces::place(HalfedgeId h) {
  const std::uint32_t outer = outer_of(h);
  if (outer == kNone) return std::nullopt;
  Pocket& pocket = pockets_[outer / 3];
  const std::uint32_t edge = outer % 3;
  Region region{pocket.corner[(edge + 1) % 3], pocket.corner[edge], pocket.corner[(edge + 2) % 3],
                mesh_.points[mesh_.apex(h)]};
  if (pocket.first) region.r = *pocket.first;
  const auto s = place_in(region);
  if (!pocket.first) pocket.first = s;
  return s;
}

Point OuterPlaces::place_or_throw(HalfedgeId h) {
  if (const auto s = place(h)) return *s;
  const VertexId a = mesh_.origin(h), b = mesh_.target(h);
  throw Error(ErrorCode::kGuarantee,
              "there is no place for a Steiner point outside the boundary edge from vertex " +
                  std::to_string(a) + " to vertex " + std::to_string(b),
              {a, b});
}

}  // namespace quadloom::quadrangulate
