// Outer Steiner points: with a point outside every chosen edge the boundary is still simple.
#include "quadrangulate/outer_places.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "core/random.hpp"
#include "quadloom/quadloom.hpp"

namespace quadloom {
namespace {

using quadrangulate::OuterPlaces;

std::vector<HalfedgeId> boundary_of(const Triangulation& mesh) {
  std::vector<HalfedgeId> out;
  for (HalfedgeId h = 0; h < mesh.twin.size(); ++h) {
    if (mesh.twin[h] == kNone) out.push_back(h);
  }
  return out;
}

/// The triangles and one more triangle outside each edge, certified against the polygons.
void expect_places(const Triangulation& mesh, const std::vector<Polygon>& polygons,
                   const std::vector<HalfedgeId>& edges) {
  OuterPlaces places(mesh);
  PolygonMesh all = to_polygon_mesh(mesh);
  for (const HalfedgeId h : edges) {
    const auto s = places.place(h);
    ASSERT_TRUE(s.has_value()) << "halfedge " << h;
    all.add_face({{mesh.target(h), mesh.origin(h), static_cast<VertexId>(all.points.size())}});
    all.points.push_back(*s);
  }
  CertifyOptions options;
  options.corners = 3;
  options.outer_steiner = true;
  options.steiner_at_most = edges.size();
  const Certificate certificate = certify_polygons(all, polygons, {}, options);
  ASSERT_TRUE(certificate.ok()) << certificate.sentence;
  EXPECT_EQ(certificate.steiner, edges.size());
}

void expect_places_for(const Polygon& polygon, Random& random) {
  const Triangulation mesh = constrained_delaunay(polygon).mesh;
  std::vector<HalfedgeId> edges = boundary_of(mesh);
  for (std::size_t i = edges.size(); i > 1; --i) std::swap(edges[i - 1], edges[random.below(i)]);
  ASSERT_NO_FATAL_FAILURE(expect_places(mesh, {polygon}, edges));
  edges.resize(random.below(edges.size()));
  ASSERT_NO_FATAL_FAILURE(expect_places(mesh, {polygon}, edges));
}

TEST(OuterPlaces, RandomPolygonsWithAndWithoutHoles) {
  for (const PolygonGenerator& g : polygon_generators()) {
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
      Random random(seed);
      const std::size_t n = g.min_corners + random.below(seed % 50 == 0 ? 300 : 20);
      SCOPED_TRACE(std::string(g.name) + " " + std::to_string(n) + ", seed " +
                   std::to_string(seed));
      const Polygon polygon = generate_polygon(g.name, n, seed);
      ASSERT_NO_FATAL_FAILURE(expect_places_for(polygon, random));
      ASSERT_NO_FATAL_FAILURE(
          expect_places_for(with_holes(polygon, 1 + random.below(4), seed), random));
    }
  }
}

// A bay a unit in the last place wide, a hole of one triangle, corners that touch.
TEST(OuterPlaces, NarrowBays) {
  Random random(1);
  const double next = 1 + 0x1p-40;
  const Polygon bay{{{{0, 0}, {2, 0}, {2, 2}, {next, 2}, {next, 0.5}, {1, 0.5}, {1, 2}, {0, 2}}}};
  const Polygon needle{
      {{{0, 0}, {4, 0}, {4, 3}, {2 + 0x1p-30, 3}, {2, 1}, {2 - 0x1p-30, 3}, {0, 3}}}};
  const Polygon touching{{{{0, 0}, {4, 0}, {4, 4}, {2, 2}, {0, 4}}, {{2, 2}, {2, 1}, {1, 1}}}};
  for (const Polygon& polygon : {bay, needle, touching}) {
    ASSERT_NO_FATAL_FAILURE(expect_places_for(polygon, random));
  }
}

TEST(OuterPlaces, EveryMagnitude) {
  for (const int exponent : {-1000, -900, -300, 300, 900, 990}) {
    for (const PolygonGenerator& g : polygon_generators()) {
      SCOPED_TRACE(std::string(g.name) + " times 2^" + std::to_string(exponent));
      Random random(7);
      Polygon polygon = with_holes(generate_polygon(g.name, 20, 7), 2, 7);
      for (auto& ring : polygon.rings) {
        for (Point& p : ring) p = {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent)};
      }
      ASSERT_NO_FATAL_FAILURE(expect_places_for(polygon, random));
    }
  }
}

// Two triangles that lie side by side without being connected: no outside along the common edge.
TEST(OuterPlaces, EdgesWithoutAnOuterSide) {
  const std::vector<Point> points = {{0, 0}, {2, 0}, {1, 2}, {1, -2}, {1, 0}, {0.5, -1}, {1.5, -1}};
  const Triangulation side_by_side{points, {0, 1, 2, 1, 0, 3}, std::vector<HalfedgeId>(6, kNone)};
  OuterPlaces places(side_by_side);
  EXPECT_FALSE(places.place(0).has_value());
  EXPECT_FALSE(places.place(3).has_value());
  EXPECT_TRUE(places.place(1).has_value());
  // Vertex 4 of the lower triangle is on an edge of the upper one.
  const Triangulation hanging{points, {0, 1, 2, 4, 5, 6}, std::vector<HalfedgeId>(6, kNone)};
  OuterPlaces hanging_places(hanging);
  try {
    hanging_places.place_or_throw(0);
    FAIL() << "a place inside the other triangle";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kGuarantee);
    EXPECT_EQ(error.culprits(), (std::vector<std::size_t>{0, 1}));
  }
  EXPECT_TRUE(hanging_places.place(2).has_value());
}

TEST(OuterPlaces, RefusesMeshesThatOverlap) {
  const Triangulation crossing{{{0, 0}, {4, 0}, {2, 3}, {2, -1}, {5, 2}, {0, 2}},
                               {0, 1, 2, 3, 4, 5},
                               std::vector<HalfedgeId>(6, kNone)};
  try {
    OuterPlaces places(crossing);
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kBadMesh);
    EXPECT_EQ(error.culprits().size(), 2U);
  }
}

}  // namespace
}  // namespace quadloom
