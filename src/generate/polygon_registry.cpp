// The kinds of polygons by name, and holes.
#include <array>
#include <string>

#include "core/random.hpp"
#include "generate/elementary.hpp"
#include "generate/polygons.hpp"
#include "quadloom/generate.hpp"

namespace quadloom {
namespace {

using namespace generate;

constexpr std::array<PolygonGenerator, 6> kPolygons = {{
    {"star", "corners in random directions and distances around a point", 4, make_star_polygon},
    {"two-opt", "random corners in a random order, untangled", 3, make_two_opt_polygon},
    {"comb", "thin teeth on a bar", 5, make_comb_polygon},
    {"spiral", "a corridor that winds around its end", 4, make_spiral_polygon},
    {"rectilinear", "unit cells grown at random", 4, make_rectilinear_polygon},
    {"fisk", "one triangulation, which needs n / 3 outer Steiner points", 3, make_fisk_polygon},
}};

const PolygonGenerator& find_polygon_generator(std::string_view kind) {
  std::string names;
  for (const PolygonGenerator& g : kPolygons) {
    if (g.name == kind) return g;
    names += names.empty() ? "" : ", ";
    names += g.name;
  }
  throw Error(ErrorCode::kBadOption,
              "no kind of polygon is called '" + std::string(kind) + "'; there are " + names);
}

}  // namespace

std::span<const PolygonGenerator> polygon_generators() { return kPolygons; }

Polygon generate_polygon(std::string_view kind, std::size_t n, std::uint64_t seed) {
  const PolygonGenerator& g = find_polygon_generator(kind);
  if (n < g.min_corners || n > kMaxPoints) {
    throw Error(ErrorCode::kBadOption,
                std::string(kind) + " needs from " + std::to_string(g.min_corners) + " to " +
                    std::to_string(kMaxPoints) + " corners, not " + std::to_string(n));
  }
  return g.make(n, seed);
}

Polygon with_holes(const Polygon& polygon, std::size_t holes, std::uint64_t seed) {
  const Triangulation mesh = constrained_delaunay(polygon).mesh;
  std::vector<TriangleId> chosen(mesh.triangle_count());
  for (TriangleId t = 0; t < chosen.size(); ++t) chosen[t] = t;
  Random random(seed);
  shuffle(chosen, random);
  if (chosen.size() > holes) chosen.resize(holes);

  Polygon out = polygon;
  for (auto& ring : out.rings) {
    for (Point& p : ring) p = {8 * p.x, 8 * p.y};
  }
  for (const TriangleId t : chosen) {
    const Point a = mesh.points[mesh.tri_vertex[3 * t]],
                b = mesh.points[mesh.tri_vertex[3 * t + 1]],
                c = mesh.points[mesh.tri_vertex[3 * t + 2]];
    const Point sum{a.x + b.x + c.x, a.y + b.y + c.y};
    auto& ring = out.rings.emplace_back();
    for (const Point p : {a, b, c}) ring.push_back({5 * p.x + sum.x, 5 * p.y + sum.y});
  }
  return out;
}

}  // namespace quadloom
