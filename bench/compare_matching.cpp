// Our matchings against LEMON's in the same process, on duals of Delaunay triangulations with shape
// weights: seconds of the processor and their ratio, and that sizes and weights agree. LEMON's time excludes building
// its graph and reading the result, ours includes everything.
//
//   compare_matching [points [kind [rounds]]]     default: 100,000 points of several kinds, 1 round
//
// LEMON's maximum matching takes minutes on large grids; a number of points over 300,000 skips it
// there.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

#include "quadloom/dual.hpp"
#include "quadloom/generate.hpp"
#include "quadloom/kernel.hpp"
#include "support/lemon_matching.hpp"

namespace {

using quadloom::DualGraph;
using quadloom::HalfedgeId;
using quadloom::MatchingGoal;
using quadloom::test::LemonEdge;
using quadloom::test::LemonResult;
using Weights = std::vector<std::int32_t>;

struct Figure {
  double seconds = 0;
  std::size_t size = 0;
  std::int64_t weight = 0;
};

template <class Run>
Figure timed(const Weights& weight, Run run) {
  const std::clock_t start = std::clock();
  const quadloom::DualMatching matching = run();
  const double took = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  return {took, (matching.mate.size() - matching.unmatched) / 2,
          quadloom::weight_of(matching, weight)};
}

void print(const char* what, const Figure& ours, const LemonResult& lemon, bool weights_count) {
  const bool agree = ours.size == lemon.size || weights_count;
  std::printf("  %-34s %9.3f %9.3f %7.3f  %s\n", what, ours.seconds, lemon.seconds,
              ours.seconds / lemon.seconds,
              agree && (!weights_count || ours.weight == lemon.weight) ? "same" : "DIFFER");
  std::fflush(stdout);
}

std::vector<LemonEdge> lemon_edges(const DualGraph& graph, const Weights& weight) {
  std::vector<LemonEdge> edges;
  for (HalfedgeId h = 0; h < graph.twin.size(); ++h) {
    if (graph.twin[h] == quadloom::kNone || graph.twin[h] < h) continue;
    edges.push_back({quadloom::triangle_of(h), graph.across(h), weight[h]});
  }
  return edges;
}

void compare(const DualGraph& graph, const Weights& weight, bool is_grid) {
  const std::size_t nodes = graph.node_count();
  const std::vector<LemonEdge> edges = lemon_edges(graph, weight);
  const Figure size = timed(weight, [&] { return quadloom::maximum_matching(graph).matching; });
  if (is_grid && nodes > 600'000) {
    std::printf("  %-34s %9.3f %9s\n", "maximum", size.seconds, "skipped");
  } else {
    print("maximum", size, quadloom::test::lemon_maximum(nodes, edges), false);
  }
  const auto exact = [&](MatchingGoal goal) {
    return timed(weight,
                 [&] { return quadloom::maximum_weight_matching(graph, weight, goal).matching; });
  };
  print("maximum weight", exact(MatchingGoal::kWeight),
        quadloom::test::lemon_maximum_weight(nodes, edges), true);
  const Figure best = exact(MatchingGoal::kSizeThenWeight);
  if (2 * best.size == nodes) {
    print("maximum-weight perfect", best, quadloom::test::lemon_perfect(nodes, edges), true);
  } else {
    std::printf("  %-34s %9.3f %9s   (%zu nodes unmatched)\n", "maximum weight of maximum size",
                best.seconds, "none", nodes - 2 * best.size);
  }
  quadloom::NearMaximumMatching near;
  const Figure fast = timed(weight, [&] {
    near = quadloom::near_maximum_weight_matching(graph, weight, MatchingGoal::kSizeThenWeight);
    return near.matching;
  });
  const auto per_cent = [&](std::int64_t above) {
    return 100 * static_cast<double>(above - near.weight) / static_cast<double>(best.weight);
  };
  std::printf("  %-34s %9.3f   gap %.2f%%, bound %.2f%%\n", "near-optimal of maximum size",
              fast.seconds, per_cent(best.weight), per_cent(near.upper_bound));
}

void compare_kind(const std::string& kind, std::size_t n) {
  const quadloom::Triangulation mesh =
      quadloom::delaunay(quadloom::generate_points(kind, n, 1)).mesh;
  const DualGraph graph = quadloom::dual_graph(mesh);
  Weights weight;
  const Figure greedy =
      timed(quadloom::shape_weights(mesh), [&] { return quadloom::greedy_shape_matching(mesh); });
  weight = quadloom::shape_weights(mesh);
  std::printf("%s, %zu nodes\n  %-34s %9.3f\n", kind.c_str(), graph.node_count(), "greedy by shape",
              greedy.seconds);
  compare(graph, weight, kind == "grid");
  std::printf("%s, strictly convex pairs\n", kind.c_str());
  compare(quadloom::heavy_edges(graph, weight, 1), weight, kind == "grid");
}

}  // namespace

int main(int argc, char** argv) {
  const std::size_t n = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 100'000;
  const int rounds = argc > 3 ? std::max(1, std::atoi(argv[3])) : 1;
  std::printf("  %-34s %9s %9s %7s\n", "", "ours s", "LEMON s", "ratio");
  for (const std::string kind : {"uniform", "clusters", "grid"}) {
    if (argc > 2 && kind != argv[2]) continue;
    for (int i = 0; i < rounds; ++i) compare_kind(kind, n);
  }
  return 0;
}
