// The default on the sets that need many added points: how near it comes to the paper's constructions.
#include <gtest/gtest.h>

#include <string>

#include "quadloom/quadloom.hpp"

namespace quadloom {
namespace {

std::size_t added_points(const char* kind, std::size_t n) {
  const auto points = generate_points(kind, n, 1);
  ConvexOptions options;
  options.odd_boundary = OddBoundary::kTriangle;
  const ConvexResult result = convex_quadrangulation(points, options);
  CertifyOptions wanted;
  wanted.triangles_allowed = 1;
  wanted.steiner_inside = true;
  wanted.strictly_convex = true;
  const Certificate certificate = certify_points(to_polygon_mesh(result.mesh), points, wanted);
  EXPECT_TRUE(certificate.ok()) << certificate.sentence;
  return result.steiner.size();
}

// Theorem 2.1 needs ceil(m / 2) - 1. Longer lines take more than this bound: 24 for m = 40, 104 for m = 194.
TEST(LowerBoundCounts, ShortLines) {
  for (std::size_t m = 4; m <= 31; m += 3) {
    SCOPED_TRACE("m " + std::to_string(m));
    EXPECT_LE(added_points("bhrs-line", m + 3), (m + 1) / 2 + 3);
  }
}

}  // namespace
}  // namespace quadloom
