// Conversions of surfaces in space, each judged by the surface that it was made from.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/random.hpp"
#include "quadloom/quadloom.hpp"
#include "support/surfaces.hpp"

namespace quadloom {
namespace {

struct Method {
  TriangleMethod method;
  Leftover leftover;
};
constexpr Method kMethods[] = {{TriangleMethod::kPair, Leftover::kWalk},
                               {TriangleMethod::kPair, Leftover::kSteiner},
                               {TriangleMethod::kPair, Leftover::kTriangle},
                               {TriangleMethod::kQPercolate, Leftover::kWalk},
                               {TriangleMethod::kSubdivide, Leftover::kWalk}};

test::Surface random_surface(Random& random, std::uint64_t seed) {
  const auto across = static_cast<VertexId>(3 + random.below(9));
  const auto along = static_cast<VertexId>(3 + random.below(9));
  const bool quads = random.below(3) == 0;
  switch (seed % 4) {
    case 0:
      return test::torus(across, along, quads);
    case 1:
      return test::sphere(static_cast<int>(random.below(4)));
    case 2:
      return test::cube(quads);
    default:
      return test::height_field(across, along, quads, seed);
  }
}

TEST(SurfaceConversions, AreTheirSurfaces) {
  for (std::uint64_t seed = 1; seed <= 120; ++seed) {
    Random random(seed);
    test::Surface surface = random_surface(random, seed);
    test::shuffle_faces(surface.mesh, random, 0.2);
    const TriangleMesh source =
        connect_triangles(surface.mesh, surface.z, {.space = Space::kSurface}).triangles;
    const PolygonMesh faces = to_polygon_mesh(source.mesh);
    for (const auto& [method, leftover] : kMethods) {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", method " +
                   std::to_string(static_cast<int>(method)) + ", leftover " +
                   std::to_string(static_cast<int>(leftover)));
      TriangleOptions options;
      options.method = method;
      options.leftover = leftover;
      const TriangleResult result = quadrangulate_triangles(source, options);
      CertifyOptions wanted;
      wanted.steiner_at_most = result.steiner.size();
      if (leftover == Leftover::kTriangle) wanted.triangles_allowed = result.mesh.triangle_count();
      const Certificate verdict =
          certify_surface(to_polygon_mesh(result.mesh), result.z, faces, source.z, wanted);
      ASSERT_TRUE(verdict.ok()) << verdict.sentence;
      EXPECT_EQ(verdict.steiner, result.steiner.size());
      const Quality quality = measure_quality(to_polygon_mesh(result.mesh), result.z);
      EXPECT_EQ(quality.strictly_convex, verdict.strictly_convex);
      EXPECT_EQ(quality.non_convex, verdict.non_convex);
    }
  }
}

TEST(SurfaceConversions, KeepSharpEdges) {
  for (const bool quads : {false, true}) {
    const test::Surface cube = test::cube(quads);
    TriangleMesh source = connect_triangles(cube.mesh, cube.z).triangles;
    ASSERT_EQ(keep_sharp_edges(source, 60), 12U);
    const TriangleResult result = quadrangulate_triangles(source);
    EXPECT_EQ(result.mesh.quad_count(), 6U);  // the sides of the cube
    EXPECT_TRUE(result.steiner.empty());
    const Quality quality = measure_quality(to_polygon_mesh(result.mesh), result.z);
    EXPECT_DOUBLE_EQ(quality.min_shape, 1);
  }
}

}  // namespace
}  // namespace quadloom
