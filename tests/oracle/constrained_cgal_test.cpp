// The same triangles as CGAL's constrained Delaunay triangulation, where no four points are on a
// circle: there is only one then.
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "core/random.hpp"
#include "quadloom/generate.hpp"
#include "support/cgal_triangles.hpp"
#include "support/constrained_checks.hpp"
#include "support/delaunay_checks.hpp"

namespace quadloom {
namespace {

using Cgal = CGAL::Constrained_Delaunay_triangulation_2<CgalKernel>;

TriangleSet cgal_triangles(const PlanarInput& input) {
  const NumberedInput in = number_input(input);
  Cgal cgal;
  std::vector<Cgal::Vertex_handle> vertex;
  for (const Point p : in.points) vertex.push_back(cgal.insert({p.x, p.y}));
  for (const Segment s : in.edges) {
    if (vertex[s.from] != vertex[s.to]) cgal.insert_constraint(vertex[s.from], vertex[s.to]);
  }
  return finite_triangles(cgal);
}

bool proper_or_overlap(Point a, Point b, Point c, Point d) {
  const int o1 = orient2d(a, b, c), o2 = orient2d(a, b, d), o3 = orient2d(c, d, a),
            o4 = orient2d(c, d, b);
  return (o1 * o2 < 0 && o3 * o4 < 0) || (o1 == 0 && o2 == 0);
}

// Points between -1 and 1 in random positions: cocircular by no chance worth the name.
TEST(ConstrainedAgainstCgal, RandomSegments) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    PlanarInput input;
    input.points = generate_points("uniform", 10 + random.below(300), seed);
    for (int i = 0; i < 100; ++i) {
      const auto from = static_cast<VertexId>(random.below(input.points.size()));
      const auto to = static_cast<VertexId>(random.below(input.points.size()));
      const bool free = std::none_of(input.segments.begin(), input.segments.end(), [&](Segment s) {
        return proper_or_overlap(input.points[from], input.points[to], input.points[s.from],
                                 input.points[s.to]);
      });
      if (free && from != to) input.segments.push_back({from, to});
    }
    ASSERT_EQ(triangle_set(constrained_delaunay(input, Extent::kHull).mesh), cgal_triangles(input));
  }
}

TEST(ConstrainedAgainstCgal, PolygonsWithCornersInRandomPlaces) {
  for (const std::string kind : {"star", "two-opt"}) {
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
      const std::size_t n = 10 * seed;
      SCOPED_TRACE(kind + " " + std::to_string(n) + ", seed " + std::to_string(seed));
      PlanarInput input;
      input.polygons.push_back(generate_polygon(kind, n, seed));
      ASSERT_EQ(triangle_set(constrained_delaunay(input, Extent::kHull).mesh),
                cgal_triangles(input));
    }
  }
}

// With ties, and with holes: as many triangles.
TEST(ConstrainedAgainstCgal, EveryKindOfPolygon) {
  for (const PolygonGenerator& g : polygon_generators()) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      SCOPED_TRACE(std::string(g.name) + " 200, seed " + std::to_string(seed));
      PlanarInput input;
      input.polygons.push_back(with_holes(g.make(200, seed), 40, seed));
      ASSERT_EQ(constrained_delaunay(input, Extent::kHull).mesh.triangle_count(),
                cgal_triangles(input).size());
    }
  }
}

}  // namespace
}  // namespace quadloom
