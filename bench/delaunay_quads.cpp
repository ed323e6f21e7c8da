// Where the time of the Delaunay-shaped methods goes: each stage as a ratio to our Delaunay
// triangulation of the same points in the same run, and what comes out.
//
//   delaunay_quads [--runs N] [--kind NAME] [--plain | --convex] POINTS...
//
// The medians of N runs (5), of both methods or one, on uniform points or another kind.
//
// Stages are those that a run reports; "input" is the triangulation in another order.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "quadloom/quadloom.hpp"

namespace {

using namespace quadloom;
using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

/// Times the stages of one run after the other.
class StageTimes {
 public:
  Progress progress() {
    return [this](std::string_view stage, double) {
      const Clock::time_point now = Clock::now();
      close(now);
      name_ = stage;
      since_ = now;
      return true;
    };
  }
  void start_run() { name_.clear(); }
  void end_run() {
    close(Clock::now());
    for (auto& [name, stage] : stages_) {
      stage.runs.push_back(stage.now);
      stage.now = 0;
    }
  }
  /// In the order in which they came first.
  std::vector<std::pair<std::string, double>> medians() {
    std::vector<std::pair<std::string, double>> out;
    for (auto& [name, stage] : stages_) {
      std::sort(stage.runs.begin(), stage.runs.end());
      out.emplace_back(name, stage.runs[stage.runs.size() / 2]);
    }
    return out;
  }

 private:
  struct Stage {
    double now = 0;
    std::vector<double> runs;
  };
  void close(Clock::time_point now) {
    if (name_.empty()) return;
    const auto same = [&](const auto& entry) { return entry.first == name_; };
    auto at = std::find_if(stages_.begin(), stages_.end(), same);
    if (at == stages_.end()) at = stages_.insert(at, {name_, Stage{}});
    at->second.now += Seconds(now - since_).count();
  }

  std::vector<std::pair<std::string, Stage>> stages_;
  std::string name_;
  Clock::time_point since_;
};

double median_of_delaunay(const std::vector<Point>& points, int runs) {
  std::vector<double> times;
  for (int run = 0; run < runs; ++run) {
    const Clock::time_point start = Clock::now();
    const DelaunayResult result = delaunay(points);
    times.push_back(Seconds(Clock::now() - start).count());
  }
  std::sort(times.begin(), times.end());
  return times[times.size() / 2];
}

void print_stages(StageTimes& times, double unit) {
  const auto medians = times.medians();
  double sum = 0;
  for (const auto& [name, seconds] : medians) {
    fmt::print("  {:<12} {:8.3f} s {:7.2f}\n", name, seconds, seconds / unit);
    sum += seconds;
  }
  fmt::print("  {:<12} {:8.3f} s {:7.2f}\n", "all", sum, sum / unit);
}

void print_quads(const Quadrangulation& mesh, const std::vector<Point>& points) {
  const PolygonMesh faces = to_polygon_mesh(mesh);
  const Certificate verdict = certify_points(faces, points);
  fmt::print("  {} quads, {} triangles; flat {}, non-convex {} ({:.3f}%); mean shape {:.4f}; {}\n",
             mesh.quad_count(), mesh.triangle_count(), verdict.flat_cornered, verdict.non_convex,
             100.0 * static_cast<double>(verdict.flat_cornered + verdict.non_convex) /
                 static_cast<double>(mesh.quad_count()),
             measure_quality(faces).mean_shape, verdict.ok() ? "certified" : verdict.sentence);
}

void plain(const std::vector<Point>& points, int runs) {
  const double unit = median_of_delaunay(points, runs);
  StageTimes times;
  PointOptions options;
  options.odd_boundary = OddBoundary::kTriangle;
  options.progress = times.progress();
  PointResult result;
  for (int run = 0; run < runs; ++run) {
    times.start_run();
    result = quadrangulate_points(points, options);
    times.end_run();
  }
  fmt::print("quadrangulate_points, {} points; delaunay {:.3f} s\n", points.size(), unit);
  print_stages(times, unit);
  const PointStatistics& s = result.statistics;
  fmt::print("  unmatched {}, walks {} of {} steps, slides {}\n", s.unmatched_greedy, s.walks,
             s.walk_steps, s.slides);
  print_quads(result.mesh, points);
}

void convex(const std::vector<Point>& points, int runs) {
  const double unit = median_of_delaunay(points, runs);
  StageTimes times;
  ConvexOptions options;
  options.odd_boundary = OddBoundary::kTriangle;
  options.progress = times.progress();
  ConvexResult result;
  for (int run = 0; run < runs; ++run) {
    times.start_run();
    result = convex_quadrangulation(points, options);
    times.end_run();
  }
  fmt::print("convex_quadrangulation, {} points; delaunay {:.3f} s\n", points.size(), unit);
  print_stages(times, unit);
  const MendStatistics& s = result.statistics.mending;
  fmt::print("  bad {}, after moves {}, stars {}, cases {}; points added {}\n", s.bad,
             s.bad_after_moves, s.stars, s.cases, result.steiner.size());
  print_quads(result.mesh, points);
}

}  // namespace

int main(int argc, char** argv) {
  int runs = 5;
  std::string kind = "uniform";
  std::vector<std::size_t> sizes;
  bool with_plain = true, with_convex = true;
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    if (word == "--runs" && i + 1 < argc) {
      runs = std::stoi(argv[++i]);
    } else if (word == "--kind" && i + 1 < argc) {
      kind = argv[++i];
    } else if (word == "--plain") {
      with_convex = false;
    } else if (word == "--convex") {
      with_plain = false;
    } else {
      sizes.push_back(std::stoul(argv[i]));
    }
  }
  if (sizes.empty()) sizes = {100'000, 1'000'000};
  for (const std::size_t n : sizes) {
    const std::vector<Point> points = generate_points(kind, n);
    if (with_plain) plain(points, runs);
    if (with_convex) convex(points, runs);
  }
}
