// Maximum-weight matchings: the certificate on every graph, brute force on the small ones.
#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "core/random.hpp"
#include "quadloom/dual.hpp"
#include "quadloom/generate.hpp"
#include "quadloom/kernel.hpp"
#include "support/matching_checks.hpp"

namespace quadloom {
namespace {

using test::brute_force_matching;
using test::random_graph;
using test::random_weights;

constexpr MatchingGoal kGoals[] = {MatchingGoal::kWeight, MatchingGoal::kSizeThenWeight};

void expect_best(const DualGraph& graph, const std::vector<std::int32_t>& weight) {
  for (const MatchingGoal goal : kGoals) {
    const MaximumWeightMatching result = maximum_weight_matching(graph, weight, goal);
    ASSERT_TRUE(verify_weight(graph, weight, goal, result));
    if (goal == MatchingGoal::kSizeThenWeight) {
      ASSERT_EQ(result.matching.unmatched, maximum_matching(graph).matching.unmatched);
    }
    if (graph.node_count() <= 14) {
      const bool size_first = goal == MatchingGoal::kSizeThenWeight;
      ASSERT_EQ(result.weight, brute_force_matching(graph, weight, size_first).weight);
    }
    const NearMaximumMatching near = near_maximum_weight_matching(graph, weight, goal);
    ASSERT_TRUE(is_matching(graph, near.matching));
    ASSERT_EQ(near.weight, weight_of(near.matching, weight));
    ASSERT_LE(near.weight, result.weight);
    ASSERT_GE(near.upper_bound, result.weight);
    if (goal == MatchingGoal::kSizeThenWeight) {
      ASSERT_EQ(near.matching.unmatched, result.matching.unmatched);
    }
  }
}

TEST(MaximumWeight, RandomGraphs) {
  for (std::uint64_t seed = 1; seed <= 10000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const auto n = static_cast<TriangleId>(seed % 20 == 0 ? random.below(400) : random.below(15));
    const DualGraph graph = random_graph(n, 0.4 + 0.6 * random.uniform(), random);
    expect_best(graph, random_weights(graph, random));
    if (HasFatalFailure()) return;
  }
}

TEST(MaximumWeight, DualsOfEveryGenerator) {
  for (const Generator& g : generators()) {
    for (const std::size_t n : {10UL, 200UL, 2000UL}) {
      SCOPED_TRACE(std::string(g.name) + " " + std::to_string(n) + ", seed 6");
      const DualGraph graph = dual_graph(delaunay(generate_points(g.name, n, 6)).mesh);
      Random random(n);
      expect_best(graph, random_weights(graph, random));
      if (HasFatalFailure()) return;
    }
  }
}

// Only sizes count: every slack is 0 or the whole weight, blossoms are shrunk all at once.
TEST(MaximumWeight, EqualWeights) {
  for (const Generator& g : generators()) {
    SCOPED_TRACE(std::string(g.name) + " 1000, seed 7");
    const DualGraph graph = dual_graph(delaunay(generate_points(g.name, 1000, 7)).mesh);
    expect_best(graph, std::vector<std::int32_t>(graph.twin.size(), 3));
    if (HasFatalFailure()) return;
  }
}

TEST(MaximumWeight, TheCertificateCanFail) {
  Random random(11);
  const DualGraph graph = dual_graph(delaunay(generate_points("uniform", 100, 11)).mesh);
  const std::vector<std::int32_t> weight = random_weights(graph, random);
  constexpr MatchingGoal kGoal = MatchingGoal::kSizeThenWeight;
  const MaximumWeightMatching good = maximum_weight_matching(graph, weight, kGoal);
  ASSERT_TRUE(verify_weight(graph, weight, kGoal, good));
  ASSERT_FALSE(good.certificate.set_dual.empty());
  EXPECT_FALSE(verify_weight(graph, weight, MatchingGoal::kWeight, good));
  const auto fails_with = [&](const auto& damage) {
    MaximumWeightMatching bad = good;
    damage(bad, bad.certificate);
    return !verify_weight(graph, weight, kGoal, bad);
  };
  using Result = MaximumWeightMatching;
  using Proof = WeightCertificate;
  EXPECT_TRUE(fails_with([](Result& r, Proof&) { ++r.weight; }));
  EXPECT_TRUE(fails_with([](Result& r, Proof&) { r.matching.unmatched += 2; }));
  EXPECT_TRUE(fails_with([](Result&, Proof& p) { p.bonus = 0; }));
  EXPECT_TRUE(fails_with([](Result&, Proof& p) { ++p.node_dual[0]; }));
  EXPECT_TRUE(fails_with([](Result&, Proof& p) { --p.node_dual[0]; }));
  EXPECT_TRUE(fails_with([](Result&, Proof& p) { p.node_dual.pop_back(); }));
  EXPECT_TRUE(fails_with([](Result&, Proof& p) { p.set_dual[0] += 2; }));
  EXPECT_TRUE(fails_with([](Result&, Proof& p) { p.set_dual[0] = -p.set_dual[0]; }));
  EXPECT_TRUE(fails_with([](Result&, Proof& p) { p.set_dual.pop_back(); }));
  EXPECT_TRUE(fails_with([](Result&, Proof& p) { p.parent_of_set[0] = 0; }));
  EXPECT_TRUE(fails_with([](Result&, Proof& p) { p.parent_of_set[0] = kNone - 1; }));
  EXPECT_TRUE(fails_with([](Result&, Proof& p) { p.set_of_node[0] = kNone - 1; }));
  EXPECT_TRUE(fails_with([](Result&, Proof& p) {
    for (std::uint32_t& s : p.set_of_node) s = kNone;
  }));
}

TEST(MaximumWeight, RefusesWeightsThatDoNotFit) {
  const DualGraph pair{{3, kNone, kNone, 0, kNone, kNone}};
  const std::vector<std::int32_t> uneven = {1, 0, 0, 2, 0, 0}, few = {1, 0, 0};
  EXPECT_THROW(maximum_weight_matching(pair, uneven, MatchingGoal::kWeight), Error);
  EXPECT_THROW(maximum_weight_matching(pair, few, MatchingGoal::kWeight), Error);
  EXPECT_EQ(maximum_weight_matching({}, {}, MatchingGoal::kSizeThenWeight).weight, 0);
}

// The largest weights of either sign.
TEST(MaximumWeight, WholeRangeOfWeights) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const DualGraph graph = random_graph(14, 0.9, random);
    std::vector<std::int32_t> weight(graph.twin.size());
    for (HalfedgeId h = 0; h < weight.size(); ++h) {
      if (graph.twin[h] == kNone || graph.twin[h] < h) continue;
      weight[h] = weight[graph.twin[h]] = random.below(2) == 0
                                              ? std::numeric_limits<std::int32_t>::max()
                                              : std::numeric_limits<std::int32_t>::min();
    }
    expect_best(graph, weight);
    if (HasFatalFailure()) return;
  }
}

TEST(NearMaximumWeight, IsWithinThreePercentOnDelaunayDuals) {
  for (const char* kind : {"uniform", "clusters", "grid"}) {
    SCOPED_TRACE(std::string(kind) + " 5000, seed 8");
    const Triangulation mesh = delaunay(generate_points(kind, 5000, 8)).mesh;
    const DualGraph graph = dual_graph(mesh);
    const std::vector<std::int32_t> weight = shape_weights(mesh);
    for (const MatchingGoal goal : kGoals) {
      const NearMaximumMatching near = near_maximum_weight_matching(graph, weight, goal);
      EXPECT_GE(near.weight * 100, near.upper_bound * 97);
    }
  }
}

TEST(ShapeWeights, FollowTheShapeOfStrictlyConvexPairs) {
  for (const Generator& g : generators()) {
    SCOPED_TRACE(std::string(g.name) + " 500, seed 12");
    const Triangulation mesh = delaunay(generate_points(g.name, 500, 12)).mesh;
    const std::vector<std::int32_t> weight = shape_weights(mesh);
    for (HalfedgeId h = 0; h < mesh.twin.size(); ++h) {
      if (mesh.twin[h] == kNone) {
        ASSERT_EQ(weight[h], 0);
        continue;
      }
      ASSERT_EQ(weight[h], weight[mesh.twin[h]]);
      const Point a = mesh.points[mesh.origin(h)], b = mesh.points[mesh.target(h)];
      const Point c = mesh.points[mesh.apex(h)], d = mesh.points[mesh.apex(mesh.twin[h])];
      const bool convex = orient2d(c, a, d) > 0 && orient2d(d, b, c) > 0;
      ASSERT_EQ(weight[h] > 0, convex);
      if (convex && g.name == "uniform") {
        ASSERT_NEAR(weight[h], 0.5 + 65535 * quad_shape(a, d, b, c), 0.6);
      }
    }
    const DualGraph graph = dual_graph(mesh), convex = heavy_edges(graph, weight, 1);
    for (HalfedgeId h = 0; h < mesh.twin.size(); ++h) {
      ASSERT_EQ(convex.twin[h], weight[h] > 0 ? graph.twin[h] : kNone);
    }
  }
}

}  // namespace
}  // namespace quadloom
