// Hamiltonian orders of given triangulations against brute force, and of bigger meshes.
#include <gtest/gtest.h>

#include <iostream>
#include <map>
#include <set>

#include "core/random.hpp"
#include "quadloom/quadloom.hpp"
#include "strips/frontier_search.hpp"
#include "support/grid_points.hpp"
#include "support/order_checks.hpp"
#include "support/point_triangulations.hpp"
#include "support/surfaces.hpp"

namespace quadloom {
namespace {

/// All ways on from every start.
class BruteForce {
 public:
  BruteForce(const Triangulation& mesh, OrderKind kind)
      : mesh_(mesh), kind_(kind), seen_(mesh.triangle_count()) {}

  bool exists() {
    if (kind_ == OrderKind::kCycle && seen_.size() < 3) return false;
    for (start_ = 0; start_ < seen_.size(); ++start_) {
      if (from(start_, 1)) return true;
      if (kind_ == OrderKind::kCycle) return false;  // a cycle is through every triangle
    }
    return false;
  }

 private:
  bool from(TriangleId t, std::size_t count) {
    if (count == seen_.size()) {
      return kind_ == OrderKind::kPath || test::shared_edge(mesh_, t, start_).has_value();
    }
    seen_[t] = true;
    for (HalfedgeId h = 3 * t; h < 3 * t + 3; ++h) {
      if (mesh_.twin[h] == kNone || seen_[triangle_of(mesh_.twin[h])]) continue;
      if (from(triangle_of(mesh_.twin[h]), count + 1)) return true;
    }
    seen_[t] = false;
    return false;
  }

  const Triangulation& mesh_;
  OrderKind kind_;
  std::vector<bool> seen_;
  TriangleId start_ = 0;
};

constexpr OrderKind kKinds[] = {OrderKind::kPath, OrderKind::kCycle};

HamiltonianOrder checked(const Triangulation& mesh, OrderKind kind) {
  OrderSearchOptions options;
  options.kind = kind;
  const HamiltonianOrder found = hamiltonian_order(mesh, options);
  EXPECT_EQ(found.answer == Answer::kYes, !found.order.empty());
  EXPECT_EQ(found.answer == Answer::kNo, found.reason != NoOrder::kNoReason);
  if (found.answer == Answer::kYes) test::expect_order(mesh, found.order, kind);
  return found;
}

void compare(const Triangulation& mesh, std::map<NoOrder, std::size_t>& reasons) {
  for (const OrderKind kind : kKinds) {
    const HamiltonianOrder found = checked(mesh, kind);
    EXPECT_EQ(found.answer, BruteForce(mesh, kind).exists() ? Answer::kYes : Answer::kNo);
    ++reasons[found.reason];
  }
}

TEST(HamiltonianOrder, AllTriangulationsOfSmallSetsAsByBruteForce) {
  constexpr std::uint64_t kSeed = 20261130;
  Random random(kSeed);
  std::map<NoOrder, std::size_t> reasons;
  for (int i = 0; i < 120; ++i) {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", set " + std::to_string(i));
    const auto points = i % 3 == 0 ? testing::uniform_points(random, 4 + random.below(5))
                                   : testing::random_grid_points(random, 4 + random.below(5), 4, 4);
    if (testing::all_collinear(points)) continue;
    test::for_all_point_triangulations(points,
                                       [&](const Triangulation& mesh) { compare(mesh, reasons); });
    if (HasFailure()) return;
  }
  for (const auto& [reason, times] : reasons) {
    std::cout << static_cast<int>(reason) << ": " << times << '\n';
  }
  EXPECT_GT(reasons[NoOrder::kNoReason], 1000U);
  EXPECT_GT(reasons[NoOrder::kEars], 100U);
}

// Pieces of grids, tori and spheres, which have holes, bridges, necks and several components.
TEST(HamiltonianOrder, RandomPiecesOfSurfacesAsByBruteForce) {
  constexpr std::uint64_t kSeed = 20261201;
  Random random(kSeed);
  std::map<NoOrder, std::size_t> reasons;
  const std::vector<test::Surface> wholes = {test::torus(3, 3, false), test::torus(3, 4, false),
                                             test::sphere(1), test::cube(false),
                                             test::height_field(4, 3, false, 1)};
  for (int i = 0; i < 3000; ++i) {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", piece " + std::to_string(i));
    const test::Surface& whole = wholes[random.below(wholes.size())];
    const auto faces = test::faces_of(whole.mesh);
    const double share = 0.6 + 0.4 * random.uniform();
    std::vector<std::vector<VertexId>> some;
    for (const auto& face : faces) {
      if (i < 5 || random.uniform() < share) some.push_back(face);
    }
    if (some.empty()) continue;
    PolygonMesh piece = whole.mesh;
    test::set_faces(piece, some);
    compare(connect_triangles(piece, whole.z, {.space = Space::kSurface}).triangles.mesh, reasons);
    if (HasFailure()) return;
  }
  for (const auto& [reason, times] : reasons) {
    std::cout << static_cast<int>(reason) << ": " << times << '\n';
  }
  for (const NoOrder reason : {NoOrder::kNoReason, NoOrder::kComponents, NoOrder::kEars,
                               NoOrder::kBridges, NoOrder::kPairing, NoOrder::kExhausted}) {
    EXPECT_GT(reasons[reason], 0U) << static_cast<int>(reason);
  }
}

TEST(HamiltonianOrder, WithTheSearchAlone) {
  constexpr std::uint64_t kSeed = 20261202;
  Random random(kSeed);
  std::size_t yes = 0, no = 0, missed = 0;
  for (int i = 0; i < 300; ++i) {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", set " + std::to_string(i));
    const Triangulation mesh = delaunay(testing::uniform_points(random, 5 + random.below(12))).mesh;
    const DualGraph graph = dual_graph(mesh);
    const strips::FrontierOrder order = strips::frontier_order(graph);
    for (const OrderKind kind : kKinds) {
      const bool exists = BruteForce(mesh, kind).exists();
      const auto all = strips::frontier_search(graph, order, kind, {0, 1U << 22}, {});
      EXPECT_EQ(all.answer, exists ? Answer::kYes : Answer::kNo);
      if (exists) test::expect_order(mesh, all.order, kind);
      ++(exists ? yes : no);
      // A beam may miss an order, but neither makes one up nor denies one.
      const auto some = strips::frontier_search(graph, order, kind, {3, 1U << 22}, {});
      EXPECT_NE(some.answer, exists ? Answer::kNo : Answer::kYes);
      if (some.answer == Answer::kYes) test::expect_order(mesh, some.order, kind);
      if (exists && some.answer != Answer::kYes) ++missed;
    }
    if (HasFailure()) return;
  }
  std::cout << yes << " yes, " << no << " no, " << missed << " missed by the beam\n";
  EXPECT_GT(yes, 100U);
  EXPECT_GT(no, 20U);
  EXPECT_GT(missed, 0U);
}

TEST(HamiltonianOrder, MeshesOfAFewHundredTriangles) {
  std::size_t known = 0, all = 0;
  for (const char* kind : {"uniform", "jittered-grid", "gaussian", "grid", "hex-grid", "circles"}) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      SCOPED_TRACE(std::string(kind) + " seed " + std::to_string(seed));
      const Triangulation mesh = delaunay(generate_points(kind, 180, seed)).mesh;
      for (const OrderKind order : kKinds) {
        const auto found = checked(mesh, order);
        ++all;
        known += found.answer != Answer::kUnknown ? 1 : 0;
      }
    }
  }
  std::cout << known << " of " << all << " known\n";
  EXPECT_GE(known, all * 9 / 10);
}

TEST(HamiltonianOrder, TheLimitMakesItUnknown) {
  const Triangulation mesh = delaunay(generate_points("uniform", 300, 1)).mesh;
  OrderSearchOptions options;
  options.work_at_most = 100;
  const HamiltonianOrder found = hamiltonian_order(mesh, options);
  EXPECT_EQ(found.answer, Answer::kUnknown);
  EXPECT_TRUE(found.order.empty());
  EXPECT_LE(found.work, 100U);
}

TEST(HamiltonianOrder, NamesWhatIsInTheWay) {
  const std::vector<Point> points = {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, -3}, {7, 2}, {2, 7}};
  // A square of two triangles with three ears.
  const auto eared = test::connected(points, {0, 1, 2, 0, 2, 3, 1, 0, 4, 2, 1, 5, 3, 2, 6});
  const auto ears = checked(eared, OrderKind::kPath);
  EXPECT_EQ(ears.reason, NoOrder::kEars);
  EXPECT_EQ(ears.culprits, (std::vector<TriangleId>{2, 3, 4}));
  const auto two = test::connected(points, {0, 1, 2, 0, 2, 3});
  EXPECT_EQ(checked(two, OrderKind::kCycle).reason, NoOrder::kTooFew);
  EXPECT_EQ(checked(two, OrderKind::kPath).answer, Answer::kYes);
  const auto far = test::connected(points, {0, 1, 4, 3, 2, 6});
  EXPECT_EQ(checked(far, OrderKind::kPath).culprits, (std::vector<TriangleId>{0, 1}));
  OrderSearchOptions options;
  options.kind = OrderKind::kSequential;
  EXPECT_THROW(hamiltonian_order(two, options), Error);
  EXPECT_THROW(hamiltonian_order(Triangulation{}), Error);
}

}  // namespace
}  // namespace quadloom
