// The meshes of the two sets that need the most Steiner points known.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "quadloom/quadloom.hpp"

namespace quadloom {
namespace {

/// Gtest failures unless the mesh is strictly convex with this many Steiner points.
void expect_mesh(const std::vector<Point>& points, const Quadrangulation& mesh, std::size_t steiner,
                 std::size_t triangles) {
  CertifyOptions wanted;
  wanted.strictly_convex = true;
  wanted.steiner_inside = true;
  wanted.triangles_allowed = triangles;
  const Certificate certificate = certify_points(to_polygon_mesh(mesh), points, wanted);
  EXPECT_TRUE(certificate.ok()) << certificate.sentence;
  EXPECT_EQ(certificate.points, points.size());
  EXPECT_EQ(certificate.steiner, steiner);
  EXPECT_EQ(certificate.triangles, triangles);
  ASSERT_EQ(mesh.points.size(), points.size() + steiner);
  for (std::size_t i = 0; i < points.size(); ++i) EXPECT_EQ(mesh.points[i], points[i]);
}

std::size_t line_count(std::size_t m) {
  switch (m % 4) {
    case 0:
      return m / 2 + 1;
    case 1:
      return (m + 1) / 2 + 1;
    case 2:
      return m / 2 + 2;
    default:
      return (m + 1) / 2;
  }
}

TEST(LowerBoundMeshes, TheLine) {
  for (std::size_t m = 3; m <= 203; ++m) {
    SCOPED_TRACE(m);
    const auto points = generate_points("bhrs-line", m + 3);
    expect_mesh(points, mesh_of_bhrs_line(points), line_count(m), 0);
    EXPECT_LE(line_count(m), (m + 4) / 2);  // ceil((m + 3) / 2)
    if (HasFailure()) return;
  }
}

TEST(LowerBoundMeshes, TheShortLines) {
  const std::vector<Point> one = {{0, 0}, {2, 0}, {1, 1}, {1, -1}};
  expect_mesh(one, mesh_of_bhrs_line(one), 0, 0);
  const auto two = generate_points("bhrs-line", 5);
  expect_mesh(two, mesh_of_bhrs_line(two), 3, 0);
}

TEST(LowerBoundMeshes, AnyLineOfTheDescription) {
  for (std::size_t m = 1; m <= 40; ++m) {
    SCOPED_TRACE(m);
    std::vector<Point>
        points;  // uneven steps down a slope, the other two points far off the middle
    for (std::size_t i = 0; i <= m; ++i) {
      const double x = static_cast<double>(i * i + i);
      points.push_back({-3 * x, -2 * x});
    }
    points.push_back({points[m].x, points[m].y - 1});
    points.push_back({0, 0.001});
    expect_mesh(points, mesh_of_bhrs_line(points), m == 1 ? 0 : m == 2 ? 3 : line_count(m), 0);
    for (Point& p : points) p = {std::ldexp(p.x, 1000), std::ldexp(p.y, -1000)};
    expect_mesh(points, mesh_of_bhrs_line(points), m == 1 ? 0 : m == 2 ? 3 : line_count(m), 0);
    if (HasFailure()) return;
  }
}

TEST(LowerBoundMeshes, TheRing) {
  for (std::size_t n = 6; n <= 408; n += 2) {
    SCOPED_TRACE(n);
    const auto points = generate_points("bhrs-ring", n);
    const bool odd = n % 4 != 0;
    expect_mesh(points, mesh_of_bhrs_ring(points), odd ? (n + 3) / 4 : n / 4 + 1, odd ? 1 : 0);
    if (HasFailure()) return;
  }
}

TEST(LowerBoundMeshes, BigOnes) {
  const auto line = generate_points("bhrs-line", 100'003);
  expect_mesh(line, mesh_of_bhrs_line(line), line_count(100'000), 0);
  const auto ring = generate_points("bhrs-ring", 20'000);
  expect_mesh(ring, mesh_of_bhrs_ring(ring), 5001, 0);
}

ErrorCode refused(const std::function<Quadrangulation()>& make) {
  try {
    make();
  } catch (const Error& error) {
    return error.code();
  }
  ADD_FAILURE() << "not refused";
  return ErrorCode::kCancelled;
}

TEST(LowerBoundMeshes, OtherSetsAreRefused) {
  const auto line = generate_points("bhrs-line", 12), ring = generate_points("bhrs-ring", 12);
  const auto refuse_line = [](std::vector<Point> points) {
    return refused([&] { return mesh_of_bhrs_line(points); });
  };
  const auto refuse_ring = [](std::vector<Point> points) {
    return refused([&] { return mesh_of_bhrs_ring(points); });
  };
  EXPECT_EQ(refuse_line({{0, 0}, {1, 0}, {0, 1}}), ErrorCode::kBadOption);
  EXPECT_EQ(refuse_line(ring), ErrorCode::kBadOption);
  EXPECT_EQ(refuse_ring(line), ErrorCode::kBadOption);
  auto points = line;
  std::swap(points[3], points[4]);
  EXPECT_EQ(refuse_line(points), ErrorCode::kBadOption);
  points = line;
  std::swap(points[10], points[11]);
  EXPECT_EQ(refuse_line(points), ErrorCode::kBadOption);
  points = line;
  points[5].y = 0x1p-1074;
  EXPECT_EQ(refuse_line(points), ErrorCode::kBadOption);
  points = line;
  points[5].y = std::nan("");
  EXPECT_EQ(refuse_line(points), ErrorCode::kNotFinite);
  points = line;
  points[10] = {100, 0.5};  // the line's last point is no hull corner
  EXPECT_EQ(refuse_line(points), ErrorCode::kBadOption);

  points = ring;
  points.pop_back();
  EXPECT_EQ(refuse_ring(points), ErrorCode::kBadOption);
  points = ring;
  std::swap(points[7], points[8]);
  EXPECT_EQ(refuse_ring(points), ErrorCode::kBadOption);
  points = ring;
  points[7] = {points[7].x / 2, points[7].y / 2};  // too far from its edge
  EXPECT_EQ(refuse_ring(points), ErrorCode::kBadOption);
  // A star: every corner turns left, but the corners are not the hull in order.
  std::vector<Point> star(10);
  const auto five = generate_points("circle", 5);
  for (std::size_t i = 0; i < 5; ++i) {
    const Point a = five[2 * i % 5], b = five[(2 * i + 2) % 5];
    star[i] = a;
    star[5 + i] = {(a.x + b.x) / 2 * 0.99, (a.y + b.y) / 2 * 0.99};
  }
  EXPECT_EQ(refuse_ring(star), ErrorCode::kBadOption);
}

/// Rings that are stretched, pulled and mapped: the mean still serves, or the answer is an error.
TEST(LowerBoundMeshes, OtherRingsOfTheDescription) {
  std::size_t refused_sets = 0;
  for (std::size_t k = 3; k <= 40; ++k) {
    for (const double pull : {0.0, 0.05, 0.9}) {
      SCOPED_TRACE(::testing::Message() << "k " << k << ", pull " << pull);
      auto points = generate_points("bhrs-ring", 2 * k);
      for (Point& p : points) {  // a projective map keeps what is left of what
        const double w = 1 - pull * p.x;
        p = {p.x / w, std::ldexp(p.y / w, -40)};
      }
      try {
        const bool odd = k % 2 == 1;
        expect_mesh(points, mesh_of_bhrs_ring(points), odd ? (k + 1) / 2 : k / 2 + 1, odd ? 1 : 0);
      } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::kGuarantee) << error.what();
        EXPECT_EQ(pull, 0.9) << error.what();
        ++refused_sets;
      }
      if (HasFailure()) return;
    }
  }
  EXPECT_GT(refused_sets, 0U);
}

/// Between neighbouring doubles there is no place for a Steiner point: said, not made up.
TEST(LowerBoundMeshes, NoPlaceBetweenNeighbouringDoubles) {
  const double one = 0x1p52;
  std::vector<Point> points;
  for (int i = 0; i <= 4; ++i) points.push_back({one + i, one});
  points.push_back({one + 2, one + 1});
  points.push_back({one + 2, one - 1});
  EXPECT_EQ(refused([&] { return mesh_of_bhrs_line(points); }), ErrorCode::kGuarantee);
}

}  // namespace
}  // namespace quadloom
