// Triangulations made Hamiltonian: cycles, angles, kept edges, regions, on every kind of mesh.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <numbers>
#include <set>

#include "core/random.hpp"
#include "quadloom/quadloom.hpp"
#include "support/grid_mesh.hpp"
#include "support/grid_points.hpp"
#include "support/surfaces.hpp"

namespace quadloom {
namespace {

double min_angle(const Triangulation& mesh, const std::vector<double>& z) {
  double least = 180;
  for (HalfedgeId h = 0; h < mesh.tri_vertex.size(); ++h) {
    const auto side = [&](VertexId a, VertexId b) {
      const double dz = z.empty() ? 0 : z[a] - z[b];
      return std::hypot(mesh.points[a].x - mesh.points[b].x, mesh.points[a].y - mesh.points[b].y,
                        dz);
    };
    // Half the angle's tangent, from the sides: exact enough for needles (Kahan).
    double a = side(mesh.origin(h), mesh.target(h)), b = side(mesh.origin(h), mesh.apex(h));
    const double c = side(mesh.target(h), mesh.apex(h));
    if (a < b) std::swap(a, b);
    const double mu = b >= c ? c - (a - b) : b - (a - c);
    const double tangent =
        std::sqrt(std::max(0.0, ((a - b) + c) * mu) / ((a + (b + c)) * ((a - c) + b)));
    least = std::min(least, 2 * std::atan(tangent) * 180 / std::numbers::pi);
  }
  return least;
}

/// By how many degrees the rounding of coordinates can turn the shortest edge, and a few times that.
double rounding_turns(const Triangulation& mesh) {
  double greatest = 0, shortest = HUGE_VAL;
  for (HalfedgeId h = 0; h < mesh.tri_vertex.size(); ++h) {
    const Point a = mesh.points[mesh.origin(h)], b = mesh.points[mesh.target(h)];
    greatest = std::max({greatest, std::fabs(a.x), std::fabs(a.y)});
    shortest = std::min(shortest, std::hypot(a.x - b.x, a.y - b.y));
  }
  return 8 * std::ldexp(greatest, -52) / shortest * 180 / std::numbers::pi;
}

PolygonMesh piece(const Triangulation& mesh, std::uint32_t from, std::uint32_t to) {
  PolygonMesh out;
  out.points = mesh.points;
  for (std::uint32_t t = from; t < to; ++t) {
    out.add_face(std::span(mesh.tri_vertex).subspan(3 * t, 3));
  }
  return out;
}

/// Components of the triangles over the edges that `open` lets through.
template <class Open>
std::size_t components(const Triangulation& mesh, const Open& open) {
  std::vector<bool> seen(mesh.triangle_count());
  std::size_t count = 0;
  for (TriangleId root = 0; root < seen.size(); ++root) {
    if (seen[root]) continue;
    ++count;
    seen[root] = true;
    std::vector<TriangleId> stack = {root};
    while (!stack.empty()) {
      const TriangleId t = stack.back();
      stack.pop_back();
      for (HalfedgeId h = 3 * t; h < 3 * t + 3; ++h) {
        if (mesh.twin[h] == kNone || !open(h) || seen[triangle_of(mesh.twin[h])]) continue;
        seen[triangle_of(mesh.twin[h])] = true;
        stack.push_back(triangle_of(mesh.twin[h]));
      }
    }
  }
  return count;
}

void check_kept(const TriangleMesh& input, const HamiltonianRefinement& made) {
  std::set<std::pair<VertexId, VertexId>> flagged, wanted;
  for (HalfedgeId h = 0; h < made.mesh.keep.size(); ++h) {
    if (made.mesh.keep[h] == 0) continue;
    flagged.insert(std::minmax(made.mesh.mesh.origin(h), made.mesh.mesh.target(h)));
  }
  std::set<std::pair<VertexId, VertexId>> edges;
  for (HalfedgeId h = 0; h < made.mesh.mesh.tri_vertex.size(); ++h) {
    edges.insert(std::minmax(made.mesh.mesh.origin(h), made.mesh.mesh.target(h)));
  }
  for (HalfedgeId h = 0; h < input.keep.size(); ++h) {
    if (input.keep[h] == 0) continue;
    const VertexId a = input.mesh.origin(h), b = input.mesh.target(h);
    if (edges.contains(std::minmax(a, b))) {
      wanted.insert(std::minmax(a, b));
      continue;
    }
    VertexId middle = kNone;
    for (const SteinerPoint& s : made.steiner) {
      if (s.kind == SteinerKind::kOnEdge &&
          std::minmax(s.parents[0], s.parents[1]) == std::minmax(a, b)) {
        middle = s.vertex;
      }
    }
    ASSERT_NE(middle, kNone) << "edge " << a << ' ' << b << " is lost";
    for (const VertexId end : {a, b}) {
      EXPECT_TRUE(edges.contains(std::minmax(middle, end)));
      wanted.insert(std::minmax(middle, end));
    }
  }
  EXPECT_EQ(flagged, wanted);
}

TriangleMesh planar(Triangulation mesh) {
  TriangleMesh out;
  out.mesh = std::move(mesh);
  return out;
}

HamiltonianRefinement check(const TriangleMesh& input) {
  const HamiltonianRefinement made = hamiltonian_refinement(input);
  const Triangulation& mesh = made.mesh.mesh;
  const std::size_t k = input.mesh.triangle_count();
  const auto stays = [&](HalfedgeId h) {
    const HalfedgeId g = input.mesh.twin[h];
    if (!input.given_pair.empty() && input.given_pair[triangle_of(h)] == h) return false;
    return (!input.keep.empty() && (input.keep[h] != 0 || input.keep[g] != 0)) ||
           (!input.region.empty() && input.region[triangle_of(h)] != input.region[triangle_of(g)]);
  };
  EXPECT_EQ(made.input_vertices, input.mesh.points.size());
  EXPECT_EQ(mesh.triangle_count(), 3 * k + 2 * made.midpoints);
  EXPECT_EQ(made.steiner.size(), k + made.midpoints);
  const std::size_t whole = components(input.mesh, [](HalfedgeId) { return true; });
  EXPECT_EQ(made.cycle_count(), whole);
  EXPECT_EQ(made.flips + made.midpoints, k - whole);
  if (input.z.empty() && made.moved == 0) {
    EXPECT_EQ(made.midpoints,
              components(input.mesh, [&](HalfedgeId h) { return !stays(h); }) - whole);
  }

  CertifyOptions promise;
  promise.corners = 3;
  promise.steiner_at_most = k + made.midpoints;
  promise.steiner_inside = true;
  const PolygonMesh source = to_polygon_mesh(input.mesh), result = to_polygon_mesh(mesh);
  const Certificate verdict = input.z.empty()
                                  ? certify_mesh(result, source, promise)
                                  : certify_surface(result, made.mesh.z, source, input.z, promise);
  EXPECT_TRUE(verdict.ok()) << verdict.sentence;
  for (std::size_t c = 0; c < made.cycle_count(); ++c) {
    const Certificate cycle =
        certify_order(piece(mesh, made.cycle_begin[c], made.cycle_begin[c + 1]), OrderKind::kCycle);
    EXPECT_TRUE(cycle.ok()) << cycle.sentence;
  }
  EXPECT_EQ(made.cycle_begin.back(), mesh.triangle_count());

  const double before = min_angle(input.mesh, input.z), after = min_angle(mesh, made.mesh.z);
  if (std::isfinite(before) && std::isfinite(after) && before > 1e-5) {
    EXPECT_NEAR(before, made.min_angle_before, 1e-6 * before);
    EXPECT_NEAR(after, made.min_angle_after, 1e-6 * after);
    if (input.z.empty() && made.moved == 0) {
      EXPECT_GE(after + rounding_turns(mesh), before / 2 * (1 - 1e-9));
    }
  }

  check_kept(input, made);
  EXPECT_EQ(made.mesh.region.size(), input.region.empty() ? 0 : mesh.triangle_count());
  for (TriangleId t = 0; t < made.source.size(); ++t) {
    const auto [a, b] = made.source[t];
    EXPECT_LT(a, k);
    if (input.region.empty()) continue;
    EXPECT_EQ(made.mesh.region[t], input.region[a]);
    if (b != kNone) {
      EXPECT_EQ(input.region[a], input.region[b]);
    }
  }
  EXPECT_EQ(std::count(mesh.twin.begin(), mesh.twin.end(), kNone),
            std::count(input.mesh.twin.begin(), input.mesh.twin.end(), kNone));
  for (HalfedgeId h = 0; h < mesh.twin.size(); ++h) {
    if (mesh.twin[h] == kNone) continue;
    EXPECT_EQ(mesh.origin(h), mesh.target(mesh.twin[h]));
    EXPECT_EQ(mesh.twin[mesh.twin[h]], h);
    EXPECT_EQ(mesh.origin(mesh.twin[h]), mesh.target(h));
  }
  return made;
}

TEST(HamiltonianRefinement, DelaunayOfEveryGenerator) {
  std::size_t moved = 0, better = 0, refused = 0;
  for (const Generator& g : generators()) {
    for (const std::size_t n : {g.min_points, std::size_t{12}, std::size_t{400}}) {
      SCOPED_TRACE(std::string(g.name) + " " + std::to_string(n));
      try {
        const auto made = check(planar(delaunay(g.make(n, 1)).mesh));
        EXPECT_EQ(made.midpoints, 0U);
        moved += made.moved;
        better += made.min_angle_after > 0.51 * made.min_angle_before ? 1 : 0;
      } catch (const Error& e) {  // triangles without a double inside
        EXPECT_EQ(e.code(), ErrorCode::kGuarantee);
        EXPECT_EQ(g.name, "near-line") << e.what();
        ++refused;
      }
      if (HasFailure()) return;
    }
  }
  std::cout << moved << " points not at the incentre, " << better
            << " meshes with angles above half, " << refused << " refused\n";
  EXPECT_GT(better, 0U);
  EXPECT_LE(refused, 2U);
}

TEST(HamiltonianRefinement, SmallSetsOfEveryShape) {
  constexpr std::uint64_t kSeed = 20261130;
  Random random(kSeed);
  for (int i = 0; i < 400; ++i) {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", set " + std::to_string(i));
    const auto points = testing::random_grid_points(random, 3 + random.below(12), 6, 6);
    if (testing::all_collinear(points)) continue;
    check(planar(delaunay(points).mesh));
    if (HasFailure()) return;
  }
}

// Random edges to keep and regions: as few midpoints as there are parts to join.
TEST(HamiltonianRefinement, KeptEdgesAndRegions) {
  constexpr std::uint64_t kSeed = 20261201;
  Random random(kSeed);
  std::size_t midpoints = 0;
  for (int i = 0; i < 150; ++i) {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", mesh " + std::to_string(i));
    TriangleMesh input;
    if (i % 2 == 0) {
      input.mesh = delaunay(generate_points("jittered-grid", 4 + random.below(60), i + 1)).mesh;
    } else {
      input = connect_triangles(test::grid_mesh(1 + static_cast<VertexId>(random.below(6)), 3, i))
                  .triangles;
    }
    const std::size_t k = input.mesh.triangle_count();
    input.keep.assign(3 * k, 0);
    const double share = random.uniform();
    for (HalfedgeId h = 0; h < 3 * k; ++h) input.keep[h] = random.uniform() < share ? 1 : 0;
    if (i % 3 == 0 && input.given_pair.empty()) {
      for (std::size_t t = 0; t < k; ++t) {
        input.region.push_back(static_cast<std::uint32_t>(random.below(3)));
      }
    }
    if (!input.given_pair.empty()) {  // the diagonals of given quads are no edges to keep
      for (TriangleId t = 0; t < k; ++t) {
        if (input.given_pair[t] != kNone) input.keep[input.given_pair[t]] = 0;
      }
    }
    midpoints += check(input).midpoints;
    if (HasFailure()) return;
  }
  EXPECT_GT(midpoints, 1000U);
}

TEST(HamiltonianRefinement, PolygonsWithHolesAndTheirSegments) {
  for (const PolygonGenerator& g : polygon_generators()) {
    for (const std::size_t holes : {std::size_t{0}, std::size_t{3}}) {
      SCOPED_TRACE(std::string(g.name) + ", holes " + std::to_string(holes));
      const Polygon polygon =
          with_holes(g.make(std::max<std::size_t>(60, g.min_corners), 1), holes);
      check(planar(constrained_delaunay(polygon).mesh));
      if (HasFailure()) return;
    }
  }
}

TEST(HamiltonianRefinement, SurfacesAndSeveralComponents) {
  for (const auto& surface : {test::torus(7, 9, false), test::sphere(2), test::cube(false),
                              test::height_field(5, 4, false, 3)}) {
    auto connected = connect_triangles(surface.mesh, surface.z, {.space = Space::kSurface});
    const auto made = check(connected.triangles);
    std::cout << connected.triangles.mesh.triangle_count() << " triangles, smallest angle "
              << made.min_angle_before << " -> " << made.min_angle_after << '\n';
    keep_sharp_edges(connected.triangles, 20);
    check(connected.triangles);
  }
  PolygonMesh apart;
  apart.points = {{0, 0}, {1, 0}, {0, 1}, {5, 0}, {6, 0}, {5, 1}, {6, 1}, {9, 9}};
  for (const std::array<VertexId, 3> f : {std::array<VertexId, 3>{0, 1, 2}, {3, 4, 5}, {4, 6, 5}}) {
    apart.add_face(f);
  }
  const auto made = check(connect_triangles(apart).triangles);
  EXPECT_EQ(made.cycle_count(), 2U);
}

// Triangles a few units in the last place wide: another place than the incentre, or an error that names
// the triangle; never a mesh that is wrong.
TEST(HamiltonianRefinement, Needles) {
  std::size_t made_well = 0, refused = 0, moved = 0;
  constexpr std::uint64_t kSeed = 20261202;
  Random random(kSeed);
  for (int i = 0; i < 300; ++i) {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", set " + std::to_string(i));
    const double unit = std::ldexp(1, -52 + static_cast<int>(random.below(4)));
    std::vector<Point> points;
    for (int p = 0; p < 6; ++p) {
      points.push_back({1 + unit * static_cast<double>(random.below(i % 2 == 0 ? 64 : 8)),
                        1 + unit * static_cast<double>(random.below(4))});
    }
    if (testing::all_collinear(distinct_points(points).points)) continue;
    try {
      moved += check(planar(delaunay(points).mesh)).moved;
      ++made_well;
    } catch (const Error& e) {
      if (e.code() == ErrorCode::kTooFewPoints || e.code() == ErrorCode::kAllCollinear) continue;
      EXPECT_EQ(e.code(), ErrorCode::kGuarantee) << e.what();
      EXPECT_FALSE(e.culprits().empty());
      ++refused;
    }
    if (HasFailure()) return;
  }
  std::cout << made_well << " made, " << moved << " points moved, " << refused << " refused\n";
  EXPECT_GT(made_well, 0U);
  EXPECT_GT(moved, 0U);
  EXPECT_GT(refused, 0U);
}

TEST(HamiltonianRefinement, RefusesWhatDoesNotAgree) {
  EXPECT_THROW(hamiltonian_refinement(TriangleMesh{}), Error);
  TriangleMesh input = connect_triangles(test::grid_mesh(2, 2)).triangles;
  input.keep.assign(5, 0);
  EXPECT_THROW(hamiltonian_refinement(input), Error);
}

}  // namespace
}  // namespace quadloom
