// Each stage and each whole method on generated sets of 10^4, 10^5 and 10^6 points.
//
//   stages_benchmark [--benchmark_filter=REGEX]     Google Benchmark's options; a row is STAGE/KIND/POINTS
#include <benchmark/benchmark.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "quadloom/quadloom.hpp"

namespace {

using namespace quadloom;

const std::vector<Point>& points_of(const std::string& kind, std::size_t n) {
  static std::map<std::pair<std::string, std::size_t>, std::vector<Point>> cache;
  std::vector<Point>& points = cache[{kind, n}];
  if (points.empty()) points = generate_points(kind, n);
  return points;
}

using Stage = void (*)(benchmark::State&, const std::vector<Point>&);

void spatial_order_stage(benchmark::State& state, const std::vector<Point>& points) {
  for (auto _ : state) benchmark::DoNotOptimize(spatial_order(points));
}

void hull_stage(benchmark::State& state, const std::vector<Point>& points) {
  for (auto _ : state) benchmark::DoNotOptimize(convex_hull(points));
}

void delaunay_stage(benchmark::State& state, const std::vector<Point>& points) {
  for (auto _ : state) benchmark::DoNotOptimize(delaunay(points));
}

void layers_stage(benchmark::State& state, const std::vector<Point>& points) {
  for (auto _ : state) benchmark::DoNotOptimize(convex_layers(points));
}

void spiral_stage(benchmark::State& state, const std::vector<Point>& points) {
  const ConvexLayers layers = convex_layers(points);
  for (auto _ : state) benchmark::DoNotOptimize(convex_spiral(points, layers));
}

void serpentine_stage(benchmark::State& state, const std::vector<Point>& points) {
  for (auto _ : state) benchmark::DoNotOptimize(serpentine_triangulation(points));
}

void pairing_stage(benchmark::State& state, const std::vector<Point>& points) {
  const Triangulation mesh = delaunay(points).mesh;
  std::size_t unmatched = 0;
  for (auto _ : state) unmatched = greedy_shape_matching(mesh).unmatched;
  state.counters["unmatched"] = static_cast<double>(unmatched);
}

template <Splitter kSplitter>
void cycle_stage(benchmark::State& state, const std::vector<Point>& points) {
  HamiltonianResult result;
  for (auto _ : state) result = hamiltonian_cycle_triangulation(points, {.splitter = kSplitter});
  state.counters["cycle"] = result.order == OrderKind::kCycle ? 1 : 0;
  state.counters["levels"] = static_cast<double>(result.statistics.levels);
}

void spiral_polygon_stage(benchmark::State& state, const std::vector<Point>& points) {
  for (auto _ : state) benchmark::DoNotOptimize(spiral_polygon(points));
}

void certify_stage(benchmark::State& state, const std::vector<Point>& points) {
  const PolygonMesh mesh = to_polygon_mesh(quadrangulate_points(points).mesh);
  for (auto _ : state) {
    if (!certify_points(mesh, points).ok()) state.SkipWithError("not certified");
  }
}

/// A whole method, with what its result says about itself; certified once.
template <PointMethod kMethod>
void method_stage(benchmark::State& state, const std::vector<Point>& points) {
  PointResult result;
  for (auto _ : state) result = quadrangulate_points(points, {.method = kMethod});
  const Certificate verdict = certify_points(to_polygon_mesh(result.mesh), points);
  if (!verdict.ok()) state.SkipWithError(verdict.sentence.c_str());
  state.counters["convex%"] = 100.0 * static_cast<double>(verdict.strictly_convex) /
                              static_cast<double>(result.mesh.quad_count());
  state.counters["walks"] = static_cast<double>(result.statistics.walks);
  state.counters["fell_back"] = result.statistics.fell_back_to_spiral ? 1 : 0;
}

void add_rows(const char* name, Stage stage, const std::vector<std::string>& kinds) {
  for (const std::string& kind : kinds) {
    for (const std::size_t n : {10'000U, 100'000U, 1'000'000U}) {
      const std::string row = std::string(name) + "/" + kind + "/" + std::to_string(n);
      benchmark::RegisterBenchmark(
          row.c_str(), [=](benchmark::State& state) { stage(state, points_of(kind, n)); })
          ->Unit(benchmark::kMillisecond)
          ->MinTime(0.2);
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> kinds = {"uniform", "grid", "towns-like"};
  add_rows("spatial_order", spatial_order_stage, kinds);
  add_rows("convex_hull", hull_stage, kinds);
  add_rows("delaunay", delaunay_stage, kinds);
  add_rows("convex_layers", layers_stage, kinds);
  add_rows("convex_spiral", spiral_stage, kinds);
  add_rows("serpentine_triangulation", serpentine_stage, kinds);
  add_rows("greedy_shape_matching", pairing_stage, kinds);
  add_rows("method_delaunay", method_stage<PointMethod::kDelaunay>, kinds);
  add_rows("method_spiral", method_stage<PointMethod::kSpiral>, kinds);
  add_rows("method_insertion", method_stage<PointMethod::kInsertion>, kinds);
  add_rows("method_subdivide", method_stage<PointMethod::kSubdivide>, kinds);
  add_rows("hamiltonian_cycle_random", cycle_stage<Splitter::kRandom>, kinds);
  add_rows("hamiltonian_cycle_balanced", cycle_stage<Splitter::kBalanced>, kinds);
  add_rows("spiral_polygon", spiral_polygon_stage, kinds);
  add_rows("certify_points", certify_stage, kinds);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
}
