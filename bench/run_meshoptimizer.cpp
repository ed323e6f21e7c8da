// meshoptimizer's strips for bench/compare: `restart` and `repeat` of the triangles INPUT.triangles, each after its
// optimisation of their order for strips.
#include <meshoptimizer.h>

#include "measure.hpp"

namespace {

using Indices = std::vector<unsigned>;

void run(const bench::Call& call, bench::Report& report) {
  report.add_words("version", std::to_string(MESHOPTIMIZER_VERSION / 1000) + "." +
                                  std::to_string(MESHOPTIMIZER_VERSION / 10 % 100));
  if (call.task != "restart" && call.task != "repeat") bench::unknown_task(call);
  const unsigned restart = call.task == "restart" ? ~0U : 0U;
  const std::vector<double> doubles = bench::read_doubles(call.input + ".triangles");
  const Indices corners(doubles.begin(), doubles.end());
  const std::size_t vertices = *std::max_element(corners.begin(), corners.end()) + std::size_t{1};
  const Indices strip = bench::measure(report, [&] {
    Indices cached(corners.size()), out(meshopt_stripifyBound(corners.size()));
    meshopt_optimizeVertexCacheStrip(cached.data(), corners.data(), corners.size(), vertices);
    out.resize(meshopt_stripify(out.data(), cached.data(), cached.size(), vertices, restart));
    return out;
  });
  report.add("indices",
             3.0 * static_cast<double>(strip.size()) / static_cast<double>(corners.size()));
  if (!call.result.empty()) bench::write_doubles(call.result + ".strip", strip);
}

}  // namespace

int main(int argc, char** argv) { return bench::run_program(argc, argv, run); }
