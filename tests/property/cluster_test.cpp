// Clusters of quads parted anew, against brute force over all partings of small polygons.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "convex/best_parting.hpp"
#include "convex/price.hpp"
#include "core/random.hpp"
#include "quadloom/quadloom.hpp"

namespace quadloom {
namespace {

using namespace convex;

/// The fewest quads that are not strictly convex over all partings of a polygon into quads of its corners,
/// kNone if there is none. The quad at side n-1, 0 is any; what is left of it are up to three polygons.
std::size_t fewest_bad(const std::vector<Point>& p) {
  const std::size_t n = p.size();
  if (n == 2) return 0;
  const auto piece = [&](std::size_t i, std::size_t j) {
    return std::vector<Point>(p.begin() + static_cast<std::ptrdiff_t>(i),
                              p.begin() + static_cast<std::ptrdiff_t>(j) + 1);
  };
  // A piece must be a simple polygon of its own, the right way around.
  const auto fits = [](const std::vector<Point>& q) {
    if (q.size() == 2) return true;
    try {
      const auto mesh = constrained_delaunay(Polygon{{q}}).mesh;
      if (mesh.triangle_count() + 2 != q.size()) return false;
    } catch (const Error&) {
      return false;
    }
    const std::size_t low =
        static_cast<std::size_t>(std::min_element(q.begin(), q.end(), lex_less) - q.begin());
    return orient2d(q[(low + q.size() - 1) % q.size()], q[low], q[(low + 1) % q.size()]) > 0;
  };
  std::size_t best = kNone;
  for (std::size_t a = 1; a < n - 1; a += 2) {
    for (std::size_t b = a + 1; b < n - 1; b += 2) {
      const std::vector<Point> quad = {p[0], p[a], p[b], p[n - 1]};
      const auto first = piece(0, a), middle = piece(a, b), last = piece(b, n - 1);
      if (!fits(quad) || !fits(first) || !fits(middle) || !fits(last)) continue;
      std::size_t bad = 0;
      for (std::size_t i = 0; i < 4; ++i) {
        if (orient2d(quad[i], quad[(i + 1) % 4], quad[(i + 2) % 4]) <= 0) bad = 1;
      }
      for (const auto& rest : {first, middle, last}) {
        const std::size_t more = fewest_bad(rest);
        bad = more == kNone || bad == kNone ? kNone : bad + more;
      }
      if (bad != kNone) best = std::min(best, bad);
    }
  }
  return best;
}

TEST(BestParting, FewestBadQuadsAsByBruteForce) {
  std::size_t with_bad = 0, without = 0, impossible = 0;
  for (std::uint64_t seed = 1; seed <= 6000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const char* kind = seed % 3 == 0 ? "rectilinear" : seed % 3 == 1 ? "star" : "two-opt";
    std::vector<Point> ring = generate_polygon(kind, 4 + 2 * random.below(3), seed).rings[0];
    if (ring.size() % 2 == 1 || ring.size() > 10) continue;
    const std::size_t low = static_cast<std::size_t>(
        std::min_element(ring.begin(), ring.end(), lex_less) - ring.begin());
    if (orient2d(ring[(low + ring.size() - 1) % ring.size()], ring[low],
                 ring[(low + 1) % ring.size()]) < 0) {
      std::reverse(ring.begin(), ring.end());
    }
    const std::size_t wanted = fewest_bad(ring);
    const auto parting = best_parting(ring, 1e17, Stars::kNone, price);
    ASSERT_EQ(parting.has_value(), wanted != kNone);
    if (!parting) {
      ++impossible;
      continue;
    }
    EXPECT_EQ(parting->bad_quads(), wanted);
    (wanted == 0 ? without : with_bad) += 1;
    PolygonMesh mesh;
    mesh.points = ring;
    for (const ClusterQuad& q : parting->quads)
      mesh.add_face(std::array<VertexId, 4>{q[0], q[1], q[2], q[3]});
    const Polygon polygon{{ring}};
    const Certificate certificate = certify_polygons(mesh, {&polygon, 1});
    EXPECT_TRUE(certificate.ok()) << certificate.sentence;
    EXPECT_EQ(certificate.faces - certificate.strictly_convex, wanted);
    if (HasFailure()) return;
  }
  EXPECT_GT(with_bad, 30U);
  EXPECT_GT(without, 30U);
  EXPECT_GT(impossible, 5U);
}

TEST(BestParting, StarsMakeStrictlyConvexQuads) {
  std::size_t stars = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::vector<Point> ring = generate_polygon("star", 8, seed).rings[0];
    const auto parting = best_parting(ring, 1e17, Stars::kAllowed, price);
    if (!parting || parting->added.empty() || parting->bad_quads() > 0) continue;
    ++stars;
    PolygonMesh mesh;
    mesh.points = ring;
    mesh.points.insert(mesh.points.end(), parting->added.begin(), parting->added.end());
    for (const ClusterQuad& q : parting->quads)
      mesh.add_face(std::array<VertexId, 4>{q[0], q[1], q[2], q[3]});
    const Polygon polygon{{ring}};
    const Certificate certificate = certify_polygons(
        mesh, {&polygon, 1}, {}, {.steiner_inside = true, .strictly_convex = true});
    EXPECT_TRUE(certificate.ok()) << certificate.sentence;
    if (HasFailure()) return;
  }
  EXPECT_GT(stars, 30U);
}

}  // namespace
}  // namespace quadloom
