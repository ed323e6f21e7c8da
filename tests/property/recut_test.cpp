// Polygons with points inside cut into strictly convex quads by search, judged by certify.
#include "convex/recut.hpp"

#include <gtest/gtest.h>

#include <string>

#include "convex/places.hpp"
#include "quadloom/quadloom.hpp"

namespace quadloom {
namespace {

using namespace convex;

TEST(Recut, TilesThePolygonWithAllPointsInside) {
  std::size_t found_without = 0, found_with = 0, ruled_out = 0;
  for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const std::size_t corners = 4 + 2 * random.below(4);
    const std::vector<Point> ring = generate_polygon("star", corners, seed).rings[0];
    const std::vector<Point> inside = random_places(ring, {}, random.below(4), random);
    const std::vector<Point> places = random_places(ring, inside, 8, random);
    const std::size_t most = random.below(3);
    RecutSearch search(ring, inside, places);
    const auto order = seed % 2 == 0 ? RecutOrder::kShape : RecutOrder::kRandom;
    const auto recut = search.find(most, 500, order, random);
    if (!may_be_recut(ring, inside.size(), most)) {
      EXPECT_FALSE(recut);
      ++ruled_out;
    }
    if (!recut) continue;
    (recut->places.empty() ? found_without : found_with) += 1;
    PolygonMesh mesh;
    mesh.points = ring;
    mesh.points.insert(mesh.points.end(), inside.begin(), inside.end());
    for (const std::uint8_t k : recut->places) mesh.points.push_back(places[k]);
    for (const ClusterQuad& q : recut->quads) {
      mesh.add_face(std::array<VertexId, 4>{q[0], q[1], q[2], q[3]});
    }
    const Polygon polygon{{ring}};
    const Certificate certificate = certify_polygons(
        mesh, {&polygon, 1}, inside,
        {.steiner_at_most = most, .steiner_inside = true, .strictly_convex = true});
    EXPECT_TRUE(certificate.ok()) << certificate.sentence;
    if (HasFailure()) return;
  }
  EXPECT_GT(found_without, 50U);
  EXPECT_GT(found_with, 50U);
  EXPECT_GT(ruled_out, 50U);
}

TEST(Recut, PlacesAreInside) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const std::vector<Point> ring = generate_polygon("two-opt", 4 + seed % 9, seed).rings[0];
    for (const Point p : random_places(ring, {}, 10, random)) {
      bool inside = false;
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point a = ring[i], b = ring[(i + 1) % ring.size()];
        const int side = orient2d(a, b, p);
        if (a.y <= p.y && p.y < b.y && side > 0) inside = !inside;
        if (b.y <= p.y && p.y < a.y && side < 0) inside = !inside;
      }
      EXPECT_TRUE(inside);
    }
  }
}

}  // namespace
}  // namespace quadloom
