// A quad with a point inside, and a lone quad, in strictly convex quads (Bremner, Hurtado, Ramaswami
// and Sacristan, section 3.1.3 and theorem 3.8): with three and with four Steiner points.
//
// By the count of hexagon.cpp a strictly convex mesh of a quad with inner points has at least four of
// them, and with four it is the quad around another one, corner joined to corner. So three and four
// are not only enough but the fewest, and the inner point is one of the inner quad's corners:
//
//      c ---------------- b      1. patch_quad_with_point   for each edge u -> v of the quad and each
//      | \  t ------- i / |         way around: s joined to u and i, so that the quad u, v, i, s is
//      |    |         |   |         strictly convex. What is left is a hexagon, in which two points
//      |    w ------- s   |         are enough (rrcccc-2 in the paper)
//      | /              \ |      2. patch_quad              an inner point in the quad's kernel, then
//      d ---------------- a         the same
//
// Differs from the paper: it places s next to the reflex corner and to one that i sees; here all
// eight ways are tried, first in the middle of their regions. Degenerate input: flat corners are
// reflex ones. Cost: constant.
#include "convex/quad.hpp"

#include <algorithm>

#include "convex/hexagon.hpp"

namespace quadloom::convex {
namespace {

using Quad = std::array<Corner, 4>;

/// Quad corner k as seen from edge `start` in one of the two directions.
const Corner& view(const Quad& q, int start, bool reflected, int k) {
  return q[((reflected ? start + 1 - k : start + k) + 4) % 4];
}

void add_left(OpenRegion& region, bool reflected, const Corner& p, const Corner& q) {
  reflected ? region.add(q.at, p.at) : region.add(p.at, q.at);
}

class InnerQuadSearch {
 public:
  InnerQuadSearch(std::span<const Point> given, const Quad& quad, Corner inner, Effort effort,
                  Patch& patch)
      : given_(given), quad_(quad), inner_(inner), effort_(effort), patch_(patch) {}

  bool search() {
    for (const bool anywhere : {false, true}) {
      for (int way = 0; way < 8; ++way) {
        if (cut(way / 2, way % 2 != 0, anywhere)) return true;
      }
    }
    return false;
  }

 private:
  /// s in wedge(u), left of v -> i and of u -> i; v must turn left on the way from u to i.
  bool cut(int start, bool reflected, bool anywhere) {
    const Corner &before = view(quad_, start, reflected, 3), &u = view(quad_, start, reflected, 0),
                 &v = view(quad_, start, reflected, 1);
    OpenRegion region(given_);
    add_left(region, reflected, before, u);
    add_left(region, reflected, u, v);
    add_left(region, reflected, v, inner_);
    add_left(region, reflected, u, inner_);
    if (!anywhere) {
      for (int i = 0; i < 4; ++i) region.add_if_room(quad_[i].at, quad_[(i + 1) % 4].at);
      const auto place = region.place(effort_);
      return place && finish(start, reflected, *place);
    }
    patch_.as_in_paper = false;
    const auto places = region.places(effort_);
    return std::any_of(places.begin(), places.end(),
                       [&](Point place) { return finish(start, reflected, place); });
  }

  bool finish(int start, bool reflected, Point place) {
    const Patch old = patch_;
    const Corner s = patch_.add_steiner(place);
    const auto corner = [&](int k) { return view(quad_, start, reflected, k); };
    Hexagon rest = {corner(1), corner(2), corner(3), corner(0), s, inner_};
    std::array<Corner, 4> face = {corner(0), corner(1), inner_, s};
    if (reflected) {
      std::reverse(rest.begin(), rest.end());
      std::reverse(face.begin(), face.end());
    }
    patch_.add_quad(face[0], face[1], face[2], face[3]);
    const bool convex = strictly_convex(face[0], face[1], face[2], face[3]);
    if (convex && HexagonSearch(given_, effort_, patch_).solve(rest, 2)) return true;
    patch_ = old;
    return false;
  }

  std::span<const Point> given_;
  const Quad& quad_;
  Corner inner_;
  Effort effort_;
  Patch& patch_;
};

Quad corners_of(const std::array<Point, 4>& points) {
  Quad out;
  for (std::uint32_t i = 0; i < 4; ++i) out[i] = {points[i], i};
  return out;
}

}  // namespace

std::optional<Patch> patch_quad_with_point(const std::array<Point, 4>& corners, Point inner) {
  const std::array<Point, 5> given = {corners[0], corners[1], corners[2], corners[3], inner};
  for (const Effort effort : {Effort::kFloat, Effort::kExact}) {
    Patch patch;
    patch.given = 5;
    if (InnerQuadSearch(given, corners_of(corners), {inner, 4}, effort, patch).search() &&
        tiles(given, 4, patch)) {
      return patch;
    }
  }
  return std::nullopt;
}

std::optional<Patch> patch_quad(const std::array<Point, 4>& corners) {
  const Quad quad = corners_of(corners);
  if (strictly_convex(quad[0], quad[1], quad[2], quad[3])) {
    Patch patch;
    patch.given = 4;
    patch.add_quad(quad[0], quad[1], quad[2], quad[3]);
    return patch;
  }
  OpenRegion inside(corners);
  for (int i = 0; i < 4; ++i) inside.add(corners[i], corners[(i + 1) % 4]);
  for (const Effort effort : {Effort::kFloat, Effort::kExact}) {
    for (const Point place : inside.places(effort)) {
      Patch patch;
      patch.given = 4;
      const Corner inner = patch.add_steiner(place);
      if (InnerQuadSearch(corners, quad, inner, effort, patch).search() &&
          tiles(corners, 4, patch)) {
        return patch;
      }
    }
  }
  return std::nullopt;
}

}  // namespace quadloom::convex
