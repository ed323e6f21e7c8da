// Every kind of damage to a valid mesh is caught, and the two ways to judge a polygon agree.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "certify/polygon.hpp"
#include "core/random.hpp"
#include "quadloom/certify.hpp"
#include "quadloom/kernel.hpp"
#include "support/grid_mesh.hpp"

namespace quadloom {
namespace {

constexpr std::uint64_t kRounds = 300;

/// A random valid mesh, and random choices within it.
struct Subject {
  explicit Subject(std::uint64_t seed)
      : random(seed),
        columns(static_cast<VertexId>(3 + random.below(6))),
        rows(static_cast<VertexId>(3 + random.below(6))),
        mesh(test::grid_mesh(columns, rows, seed)),
        input(mesh.points) {}

  VertexId below(std::size_t n) { return static_cast<VertexId>(random.below(n)); }
  VertexId any_face() { return below(mesh.face_count()); }
  VertexId vertex(VertexId i, VertexId j) const { return j * (columns + 1) + i; }
  VertexId inner_vertex() { return vertex(1 + below(columns - 1), 1 + below(rows - 1)); }
  VertexId bottom_vertex() { return vertex(1 + below(columns - 1), 0); }
  VertexId* corners(std::size_t f) { return mesh.face_vertex.data() + 4 * f; }
  void erase_face(std::size_t f) {
    const auto at = mesh.face_vertex.begin() + static_cast<std::ptrdiff_t>(4 * f);
    mesh.face_vertex.erase(at, at + 4);
    mesh.face_begin.pop_back();
  }

  Random random;
  VertexId columns, rows;
  PolygonMesh mesh;
  std::vector<Point> input;
};

/// Applies the damage to many meshes. The mesh must be valid before, and have one of the faults
/// after, with the input points and without them (where `alone`: the damage shows in the mesh).
template <class Damage>
void expect_caught(Damage damage, std::vector<Fault> faults, bool alone = true,
                   const CertifyOptions& options = {}) {
  for (std::uint64_t seed = 1; seed <= kRounds; ++seed) {
    SCOPED_TRACE(seed);
    Subject s(seed);
    ASSERT_TRUE(certify_points(s.mesh, s.input).ok());
    damage(s);
    const auto verdict = certify_points(s.mesh, s.input, options);
    ASSERT_TRUE(std::ranges::count(faults, verdict.fault) > 0)
        << static_cast<int>(verdict.fault) << ' ' << verdict.sentence;
    ASSERT_FALSE(verdict.sentence.empty());
    if (alone) {
      ASSERT_FALSE(certify_points(s.mesh, {}, options).ok());
    }
  }
}

TEST(CertifyMutation, VertexMovedOverAnEdge) {
  const auto damage = [](Subject& s) {
    const VertexId v = s.inner_vertex();
    const VertexId steps = 1 + s.below(2);
    const Point by = s.random.below(2) == 0 ? Point{3.2, 1.6} : Point{-1.6, -4.8};
    s.mesh.points[v] = {s.mesh.points[v].x + steps * by.x, s.mesh.points[v].y + steps * by.y};
  };
  expect_caught(damage, {Fault::kNotSimple});
}

TEST(CertifyMutation, CornersSwapped) {
  const auto damage = [](Subject& s) {
    VertexId* c = s.corners(s.any_face());
    const auto i = s.below(4);
    std::swap(c[i], c[(i + 1 + s.below(3)) % 4]);
  };
  expect_caught(damage, {Fault::kNotSimple, Fault::kRepeatedEdge, Fault::kBoundary});
}

TEST(CertifyMutation, FaceDropped) {
  expect_caught([](Subject& s) { s.erase_face(s.any_face()); },
                {Fault::kBoundary, Fault::kMissingPoint});
}

TEST(CertifyMutation, FaceDuplicated) {
  const auto damage = [](Subject& s) {
    std::array<VertexId, 4> copy;
    std::copy_n(s.corners(s.any_face()), 4, copy.begin());
    std::rotate(copy.begin(), copy.begin() + s.below(4), copy.end());
    s.mesh.add_face(copy);
  };
  expect_caught(damage, {Fault::kRepeatedEdge});
}

TEST(CertifyMutation, PointsMerged) {
  expect_caught(
      [](Subject& s) {
        const VertexId v = s.inner_vertex();
        s.mesh.points[v] = s.mesh.points[v + 1 + s.below(s.columns)];
      },
      {Fault::kNotSimple, Fault::kRepeatedVertex});
  expect_caught(
      [](Subject& s) {
        const VertexId v = s.inner_vertex();
        std::ranges::replace(s.mesh.face_vertex, v, v + 1);
      },
      {Fault::kRepeatedCorner});
}

TEST(CertifyMutation, VertexOfItsOwn) {
  // A face gets its own copy of a corner: a crack of no width.
  const auto damage = [](Subject& s) {
    VertexId* c = s.corners(s.any_face());
    VertexId& corner = c[s.below(4)];
    if (std::ranges::count(s.mesh.face_vertex, corner) < 2) {
      s.mesh.points[corner].x = std::nextafter(s.mesh.points[corner].x, 1e9);
      return;
    }
    s.mesh.points.push_back(s.mesh.points[corner]);
    corner = static_cast<VertexId>(s.mesh.points.size() - 1);
  };
  expect_caught(damage, {Fault::kRepeatedVertex, Fault::kMissingPoint}, false);
}

TEST(CertifyMutation, TJunction) {
  //   d-------c        one side of the edge a-b is split at m, the other is not
  //   |     / |
  //   a---m---b
  const auto damage = [](Subject& s) {
    const VertexId column = s.below(s.columns), row = 1 + s.below(s.rows - 1);
    VertexId* f = s.corners(row * s.columns + column);
    const auto [a, b, c, d] = std::array{f[0], f[1], f[2], f[3]};
    const Point p = s.mesh.points[a], q = s.mesh.points[b];
    const auto m = static_cast<VertexId>(s.mesh.points.size());
    s.mesh.points.push_back({(p.x + q.x) / 2, (p.y + q.y) / 2});
    f[1] = m;
    s.mesh.add_face(std::array{m, b, c});
  };
  expect_caught(damage, {Fault::kBoundary}, true, {.triangles_allowed = 1});
}

TEST(CertifyMutation, FaceReversed) {
  expect_caught([](Subject& s) { std::reverse(s.corners(0), s.corners(0) + 4); },
                {Fault::kNotSimple});
}

TEST(CertifyMutation, InputPointLost) {
  const auto damage = [](Subject& s) {
    const VertexId i = s.below(s.input.size());
    double& coordinate = s.random.below(2) == 0 ? s.input[i].x : s.input[i].y;
    coordinate = std::nextafter(coordinate, s.random.below(2) == 0 ? 1e9 : -1e9);
  };
  expect_caught(damage, {Fault::kMissingPoint}, false);
}

TEST(CertifyMutation, BoundaryBent) {
  // By one ulp inwards or outwards: outwards its neighbours on the side turn right.
  const auto damage = [](Subject& s) {
    Point& p = s.mesh.points[s.bottom_vertex()];
    p.y = std::nextafter(p.y, s.random.below(2) == 0 ? 1e9 : -1e9);
    s.input = s.mesh.points;
  };
  expect_caught(damage, {Fault::kBoundary});
}

TEST(CertifyMutation, AnyCornerReplaced) {
  const auto damage = [](Subject& s) {
    VertexId& corner = s.mesh.face_vertex[s.below(s.mesh.face_vertex.size())];
    corner = static_cast<VertexId>((corner + 1 + s.below(s.mesh.points.size() - 1)) %
                                   s.mesh.points.size());
  };
  expect_caught(damage,
                {Fault::kRepeatedCorner, Fault::kNotSimple, Fault::kRepeatedEdge,
                 Fault::kMissingPoint, Fault::kBoundary},
                false);
}

// ---- Polygons. ----

std::vector<Point> random_polygon(Random& random, std::size_t corners, std::uint64_t grid) {
  std::vector<Point> out;
  for (std::size_t i = 0; i < corners; ++i) {
    out.push_back(
        {static_cast<double>(random.below(grid)), static_cast<double>(random.below(grid))});
  }
  return out;
}

/// Makes a simple polygon of a random one: un-crosses edges (2-opt), which shortens it.
std::vector<Point> untangled(std::vector<Point> p) {
  const auto crossing = [&](std::size_t i, std::size_t j) {
    const Point a = p[i], b = p[i + 1], c = p[j], d = p[(j + 1) % p.size()];
    return orient2d(a, b, c) * orient2d(a, b, d) < 0 && orient2d(c, d, a) * orient2d(c, d, b) < 0;
  };
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 0; i + 2 < p.size(); ++i) {
      for (std::size_t j = i + 2; j < p.size(); ++j) {
        if (!crossing(i, j)) continue;
        std::reverse(p.begin() + static_cast<std::ptrdiff_t>(i + 1),
                     p.begin() + static_cast<std::ptrdiff_t>(j + 1));
        changed = true;
      }
    }
  }
  return p;
}

TEST(JudgePolygon, SweepAgreesWithAllPairs) {
  std::size_t simple = 0, other = 0;
  for (std::uint64_t seed = 1; seed <= 20000; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const auto corners = 4 + random.below(12);
    auto p = random_polygon(random, corners, 3 + random.below(12));
    if (random.below(4) != 0) p = untangled(std::move(p));
    const bool by_pairs = certify::edges_disjoint_by_pairs(p);
    ASSERT_EQ(certify::edges_disjoint_by_sweep(p), by_pairs);
    ++(by_pairs ? simple : other);
  }
  EXPECT_GT(simple, 2000U);
  EXPECT_GT(other, 2000U);
}

TEST(JudgePolygon, QuadRuleAgreesWithAllPairs) {
  for (std::uint64_t seed = 1; seed <= 20000; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const auto p = random_polygon(random, 4, 4);
    // A fifth corner in the middle of an edge, by doubling, leaves the quad what it is.
    std::vector<Point> five;
    for (const Point q : p) five.push_back({2 * q.x, 2 * q.y});
    five.push_back({p[3].x + p[0].x, p[3].y + p[0].y});
    ASSERT_EQ(certify::judge_polygon(p).simple, certify::judge_polygon(five).simple);
  }
}

TEST(JudgePolygon, BigPolygonsBySweep) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    auto p = untangled(random_polygon(random, 150, 1000));
    ASSERT_EQ(certify::edges_disjoint_by_sweep(p), certify::edges_disjoint_by_pairs(p));
    std::swap(p[10], p[100]);
    ASSERT_EQ(certify::edges_disjoint_by_sweep(p), certify::edges_disjoint_by_pairs(p));
  }
}

}  // namespace
}  // namespace quadloom
