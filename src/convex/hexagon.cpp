// A hexagon in strictly convex quads with at most three inner Steiner points (Bremner, Hurtado,
// Ramaswami and Sacristan, theorem 3.2).
//
// A mesh of a hexagon with k inner points has k + 2 quads and 2k + 1 inner edges by Euler's formula, and
// two-colours its points; in a strictly convex one every inner point has at least three edges. So the
// inner points have at least k - 1 edges among them, and for k = 2 and 3 make a path, each with three
// edges. That leaves very few meshes, and the search can go through all of them:
//
//   0 points   split   one of the three long diagonals
//   1 point    star    joined to every other corner: two ways
//   2 points   cut     s cuts one corner off (it is joined to the corner's neighbours), then the star of
//                      what is left, s among its ends: the other point cuts the opposite corner, three
//                      ways
//   3 points   cut     s cuts one corner off, then two points as above: a path of three points, of
//                      which the outer two cut two corners at distance two, six ways
//
//   1:  c -------- b     2:  c -------- b     3:  d ------ c ------ b
//       |  \       |         |  \       |         |      /   \      |
//       d    s --- a         |    s --- a         |    u - t - s    |
//       |  /       |         d -- t     |         |   /    |    \   |
//       e -------- f         |      \   |         e ------ f ------ a
//                            e -------- f
//
// A mesh is right if all its quads are strictly convex, nothing else has to be looked at: see tiles().
// So questions of who sees whom, on which the paper's proof rests, do not come up, flat corners are
// nothing special, and hexagons that touch themselves in a corner are served as well.
//
//   split         exact
//   star          the place is an intersection of nine half-planes: exact up to OpenRegion::place
//   cut           the first point in the middle of the paper's region (hexagon_cases.cpp), then the rest
//   cut_anywhere  where fewer points are possible than the paper uses, or rounding leaves no room: any
//                 corner, the first point at several places of its region (OpenRegion::places)
//
// Everything is tried in floating point first, with 0, 1, 2, 3 points, and then again with exact places.
// So "not with fewer points" is exact for none, true up to the width of doubles for one, and not
// certain for two.
//
// Differs from the paper: its regions lie inside of the hexagon, which is not convex. The lines of the
// hexagon's edges are added one after the other as long as the region stays non-empty (add_if_room):
// a point in the middle of the region without them can be outside. Degenerate input: flat corners are
// reflex ones. Cost: constant; microseconds, milliseconds at worst where exact places are needed.
#include "convex/hexagon.hpp"

#include <string_view>

#include "convex/hexagon_cases.hpp"

namespace quadloom::convex {
namespace {

int around(int corner) { return (corner + 6) % 6; }

}  // namespace

int most_points(const char* pattern) {
  const std::string_view name = pattern;
  if (name == "cccccc") return 0;
  return name == "rccccc" || name == "rrcccc" || name == "rccrcc" ? 2 : 3;
}

bool HexagonSearch::solve(const Hexagon& h, int points) {
  if (points == 0) return split(h);
  if (points == 1) return star(h);
  if (cut(h, points)) return true;
  return (effort_ == Effort::kFloat || points == 2) && cut_anywhere(h, points);
}

bool HexagonSearch::split(const Hexagon& h) {
  for (int i = 0; i < 3; ++i) {
    const auto& [a, b, c, d] = std::array{h[i], h[i + 1], h[i + 2], h[i + 3]};
    const Corner &e = h[around(i + 4)], &f = h[around(i + 5)];
    if (!strictly_convex(a, b, c, d) || !strictly_convex(d, e, f, a)) continue;
    patch_.add_quad(a, b, c, d);
    patch_.add_quad(d, e, f, a);
    return true;
  }
  return false;
}

bool HexagonSearch::star(const Hexagon& h) { return star_of(h, 0) || star_of(h, 1); }

/// Joined to corners first, first + 2, first + 4; the other three must be strictly convex.
bool HexagonSearch::star_of(const Hexagon& h, int first) {
  for (int i = first; i < 6; i += 2) {
    if (!turns_left(h[i], h[around(i + 1)], h[around(i + 2)])) return false;
  }
  OpenRegion region(given_);
  for (int i = 0; i < 6; ++i) region.add(h[i].at, h[around(i + 1)].at);
  for (int i = first; i < 6; i += 2) region.add(h[i].at, h[around(i + 2)].at);
  const auto place = region.place(effort_);
  if (!place) return false;
  const Corner s = patch_.add_steiner(*place);
  for (int i = first; i < 6; i += 2) patch_.add_quad(h[i], h[around(i + 1)], h[around(i + 2)], s);
  return true;
}

/// Where s may be to cut the corner off in a strictly convex quad.
OpenRegion HexagonSearch::region_of(const Hexagon& h, int corner) const {
  const Point previous = h[around(corner - 1)].at, next = h[around(corner + 1)].at;
  OpenRegion region(given_);
  region.add(previous, h[corner].at);
  region.add(h[corner].at, next);
  region.add(previous, next);
  return region;
}

bool HexagonSearch::cut_at(const Hexagon& h, int corner, Point place, int points) {
  const Patch before = patch_;
  const Corner s = patch_.add_steiner(place);
  Hexagon rest = h;
  rest[corner] = s;
  patch_.add_quad(h[around(corner - 1)], h[corner], h[around(corner + 1)], s);
  if (solve(rest, points - 1)) return true;
  patch_ = before;
  return false;
}

bool HexagonSearch::cut(const Hexagon& h, int points) {
  for (const Cut& c : first_cuts(h)) {
    if (!turns_left(h[around(c.corner - 1)], h[c.corner], h[around(c.corner + 1)])) continue;
    OpenRegion region = region_of(h, c.corner);
    for (const HalfPlane& side : c.within) region.add(side);
    for (int i = 0; i < 6; ++i) region.add_if_room(h[i].at, h[around(i + 1)].at);
    const auto place = region.place(effort_);
    if (place && cut_at(h, c.corner, *place, points)) return true;
  }
  return false;
}

/// Of the corners beside the cut both must be strictly convex after a cut that is followed by a star;
/// before another cut one of them is enough.
bool HexagonSearch::cut_anywhere(const Hexagon& h, int points) {
  const Patch before = patch_;
  patch_.as_in_paper = false;
  for (int corner = 0; corner < 6; ++corner) {
    const Corner &previous = h[around(corner - 1)], &next = h[around(corner + 1)];
    if (!turns_left(previous, h[corner], next)) continue;
    for (int beside = points == 2 ? 3 : 1; beside <= 3; ++beside) {
      OpenRegion region = region_of(h, corner);
      if ((beside & 1) != 0) region.add(h[around(corner - 2)].at, previous.at);
      if ((beside & 2) != 0) region.add(next.at, h[around(corner + 2)].at);
      for (const Point place : region.places(effort_)) {
        if (cut_at(h, corner, place, points)) return true;
      }
    }
  }
  patch_ = before;
  return false;
}

std::optional<Patch> patch_hexagon(const std::array<Point, 6>& corners, int most) {
  Hexagon h;
  for (std::uint32_t i = 0; i < 6; ++i) h[i] = {corners[i], i};
  for (const Effort effort : {Effort::kFloat, Effort::kExact}) {
    for (int points = 0; points <= most; ++points) {
      Patch patch;
      patch.given = 6;
      if (HexagonSearch(corners, effort, patch).solve(h, points) && tiles(corners, 6, patch)) {
        return patch;
      }
    }
  }
  return std::nullopt;
}

}  // namespace quadloom::convex
