// The lower-bound configurations in strictly convex quads: certified, with the theorems' counts.
#include <gtest/gtest.h>

#include "quadloom/quadloom.hpp"

namespace quadloom {
namespace {

std::vector<Point> make(std::string_view name, std::size_t n) {
  for (const Generator& generator : generators()) {
    if (generator.name == name) return generator.make(n, 1);
  }
  return {};
}

void expect_mesh(const std::vector<Point>& points, const ConvexResult& result, std::size_t steiner,
                 std::size_t triangles) {
  CertifyOptions wanted;
  wanted.strictly_convex = true;
  wanted.steiner_inside = true;
  wanted.triangles_allowed = triangles;
  const Certificate certificate = certify_points(to_polygon_mesh(result.mesh), points, wanted);
  EXPECT_TRUE(certificate.ok()) << certificate.sentence;
  EXPECT_EQ(certificate.steiner, steiner);
  EXPECT_EQ(result.steiner.size(), steiner);
  EXPECT_EQ(certificate.triangles, triangles);
  for (const SteinerPoint& s : result.steiner) {
    const auto at = [&](std::size_t k) { return result.mesh.points[s.parents[k]]; };
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_GE(orient2d(at(k), at((k + 1) % 3), result.mesh.points[s.vertex]), 0);
    }
  }
}

TEST(LowerBoundMeshes, Line) {
  for (std::size_t m = 4; m <= 200; ++m) {
    SCOPED_TRACE("m = " + std::to_string(m));
    const auto points = make("bhrs-line", m + 3);
    const std::size_t theorem[] = {m / 2 + 1, (m + 1) / 2 + 1, m / 2 + 2, (m + 1) / 2};
    expect_mesh(points, bhrs_line_mesh(points), theorem[m % 4], 0);
    EXPECT_LE(theorem[m % 4], (m + 4) / 2);
  }
}

TEST(LowerBoundMeshes, Ring) {
  for (std::size_t k = 4; k <= 150; ++k) {
    SCOPED_TRACE("k = " + std::to_string(k));
    const auto points = make("bhrs-ring", 2 * k);
    expect_mesh(points, bhrs_ring_mesh(points), k / 2 + 1, k % 2);
  }
}

TEST(LowerBoundMeshes, RefuseOtherSets) {
  const auto code_of = [](auto mesh, const std::vector<Point>& points) {
    try {
      mesh(points);
    } catch (const Error& error) {
      return error.code();
    }
    return ErrorCode::kFile;
  };
  EXPECT_EQ(code_of(bhrs_line_mesh, make("bhrs-line", 6)), ErrorCode::kBadOption);
  EXPECT_EQ(code_of(bhrs_ring_mesh, make("uniform", 7)), ErrorCode::kBadOption);
  EXPECT_NE(code_of(bhrs_line_mesh, make("uniform", 20)), ErrorCode::kFile);
  EXPECT_NE(code_of(bhrs_ring_mesh, make("uniform", 20)), ErrorCode::kFile);
}

}  // namespace
}  // namespace quadloom
