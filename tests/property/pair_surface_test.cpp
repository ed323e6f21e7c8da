// Pairing of surfaces in space.
#include <gtest/gtest.h>

#include <string>

#include "support/conversion_checks.hpp"
#include "support/surfaces.hpp"

namespace quadloom {
namespace {

using namespace test;

struct Case {
  std::string name;
  Surface surface;
};

std::vector<Case> cases() {
  std::vector<Case> out;
  for (int levels = 0; levels <= 4; ++levels) {
    out.push_back({"sphere " + std::to_string(levels), sphere(levels)});
  }
  out.push_back({"cube", cube(false)});
  out.push_back({"cube of quads", cube(true)});
  for (const VertexId n : {3U, 4U, 7U, 20U}) {
    out.push_back({"torus " + std::to_string(n), torus(n, n + 2, false)});
    out.push_back({"heights " + std::to_string(n), height_field(n, n + 1, false, n)});
  }
  return out;
}

void check_surface(const TriangleMesh& mesh, const TriangleResult& result, std::size_t triangles) {
  CertifyOptions wanted;
  wanted.triangles_allowed = triangles;
  const Certificate certificate = certify_surface(to_polygon_mesh(result.mesh), result.z,
                                                  to_polygon_mesh(mesh.mesh), mesh.z, wanted);
  ASSERT_TRUE(certificate.ok()) << certificate.sentence;
  EXPECT_EQ(certificate.triangles, triangles);
  check_kept_edges(mesh, result);
  check_sources(mesh, result);
}

TEST(PairSurface, AllQuadsOnClosedAndOpenOnes) {
  std::size_t walks = 0, crossings = 0;
  for (const Case& c : cases()) {
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
      SCOPED_TRACE(c.name + ", seed " + std::to_string(seed));
      Random random(seed);
      ConnectOptions connect;
      connect.space = Space::kSurface;
      TriangleMesh mesh = connect_triangles(c.surface.mesh, c.surface.z, connect).triangles;
      if (seed % 3 == 1) mesh.region = random_regions(mesh.mesh, 3, random);
      if (seed % 4 == 2) mesh.keep = random_kept_edges(mesh.mesh, 10, random);
      if (seed % 5 == 0) keep_sharp_edges(mesh, 30);
      if (!mesh.given_pair
               .empty()) {  // a given quad is one face: of one region, nothing kept inside
        mesh.keep.clear();
        mesh.region.clear();
      }
      TriangleOptions options;
      options.leftover = seed % 2 == 0 ? Leftover::kWalk : Leftover::kSteiner;
      options.pairs = seed % 7 == 0 ? PairKind::kConvex : PairKind::kAuto;
      const TriangleResult result = quadrangulate_triangles(mesh, options);
      check_surface(mesh, result, 0);
      walks += result.statistics.walks;
      crossings += result.statistics.crossings;
      if (HasFailure()) return;
    }
  }
  EXPECT_GT(walks, 100U);
  EXPECT_GT(crossings, 10U);
}

}  // namespace
}  // namespace quadloom
