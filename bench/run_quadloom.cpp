// Quadloom's functions for bench/compare; the tasks are the names in kTasks and kFileTasks, on one thread, or on N as
// TASK@N. All results are what the library gives: indexed meshes, repeated points merged.
#include <filesystem>
#include <map>
#include <utility>

#include "measure.hpp"
#include "quadloom/io.hpp"
#include "quadloom/quadloom.hpp"
#include "quadloom/version.hpp"
#include "raw_meshes.hpp"

namespace {

using namespace quadloom;
using bench::Call;
using bench::Report;

// ---- Points to triangles. ----

void finish(const Triangulation& mesh, const Call& call, Report& report) {
  report.add("triangles", mesh.triangle_count());
  if (!call.result.empty()) bench::write_triangles(call.result, mesh.points, mesh.tri_vertex);
}

void run_delaunay(const Call& call, Report& report) {
  const std::vector<Point> points = bench::read_points(call.input);
  finish(bench::measure(report, [&] { return delaunay(points); }).mesh, call, report);
}

void run_constrained(const Call& call, Report& report) {
  const PlanarInput input = bench::read_planar(call.input);
  const auto task = [&] { return constrained_delaunay(input, Extent::kHull); };
  finish(bench::measure(report, task).mesh, call, report);
}

template <Splitter kSplitter>
void run_cycle(const Call& call, Report& report) {
  const std::vector<Point> points = bench::read_points(call.input);
  const auto task = [&] {
    return hamiltonian_cycle_triangulation(points, {.splitter = kSplitter});
  };
  const HamiltonianResult result = bench::measure(report, task);
  report.add("cycle", result.order == OrderKind::kCycle);
  finish(result.mesh, call, report);
}

void run_spiral_polygon(const Call& call, Report& report) {
  const std::vector<Point> points = bench::read_points(call.input);
  const SpiralPolygon polygon = bench::measure(report, [&] { return spiral_polygon(points); });
  finish(polygon.mesh, call, report);
  if (!call.result.empty()) bench::write_doubles(call.result + ".ring", polygon.ring);
}

// ---- Points to quads. ----

void finish(const Quadrangulation& mesh, const Call& call, Report& report) {
  report.add("quads", mesh.quad_count());
  if (!call.result.empty()) bench::write_quads(call.result, mesh);
}

template <PointMethod kMethod>
void run_quads(const Call& call, Report& report) {
  const std::vector<Point> points = bench::read_points(call.input);
  const auto task = [&] { return quadrangulate_points(points, {.method = kMethod}); };
  finish(bench::measure(report, task).mesh, call, report);
}

void run_convex(const Call& call, Report& report) {
  const std::vector<Point> points = bench::read_points(call.input);
  finish(bench::measure(report, [&] { return convex_quadrangulation(points); }).mesh, call, report);
}

void run_certify(const Call& call, Report& report) {
  const std::vector<Point> points = bench::read_points(call.input);
  const PolygonMesh mesh = to_polygon_mesh(quadrangulate_points(points).mesh);
  const auto task = [&] { return certify_points(mesh, points, {.triangles_allowed = 1}); };
  if (!bench::measure(report, task).ok()) throw std::runtime_error("not certified");
}

// ---- Triangles to quads: as a file has them, so that finding neighbours is timed, too. ----

PolygonMesh read_triangles(const Call& call) {
  PolygonMesh mesh;
  mesh.points = bench::read_points(call.input);
  const std::vector<VertexId> corners = bench::read_indices(call.input + ".triangles");
  for (std::size_t i = 0; i < corners.size(); i += 3) mesh.add_face({corners.data() + i, 3});
  return mesh;
}

void run_pair(const Call& call, Report& report, const TriangleOptions& options) {
  const PolygonMesh source = read_triangles(call);
  const auto task = [&] {
    return quadrangulate_triangles(connect_triangles(source).triangles, options);
  };
  finish(bench::measure(report, task).mesh, call, report);
}

void run_pair_default(const Call& call, Report& report) { run_pair(call, report, {}); }

void run_pair_exact(const Call& call, Report& report) {
  run_pair(call, report, {.effort = MatchingEffort::kExact});
}

void run_pair_triangles(const Call& call, Report& report) {
  run_pair(call, report, {.leftover = Leftover::kTriangle});
}

void run_pair_convex(const Call& call, Report& report) {
  const PolygonMesh source = read_triangles(call);
  const auto task = [&] {
    return convex_quadrangulation(connect_triangles(source).triangles).quads;
  };
  finish(bench::measure(report, task).mesh, call, report);
}

// ---- Matchings of the dual graph of the Delaunay triangulation. ----

void count(const DualMatching& matching, const std::vector<std::int32_t>& weight, Report& report) {
  report.add("pairs", (matching.mate.size() - matching.unmatched) / 2);
  report.add("weight", weight_of(matching, weight));
}

/// Greedy pairs come from the mesh: their weights are computed on the way, and timed.
void run_greedy(const Call& call, Report& report) {
  const Triangulation mesh = delaunay(bench::read_points(call.input)).mesh;
  const auto matching = bench::measure(report, [&] { return greedy_shape_matching(mesh); });
  count(matching, shape_weights(mesh), report);
}

/// The others have graph and weights before the clock starts, as LEMON has.
struct DualInput {
  DualGraph graph;
  std::vector<std::int32_t> weight;

  explicit DualInput(const Call& call) {
    const Triangulation mesh = delaunay(bench::read_points(call.input)).mesh;
    graph = dual_graph(mesh);
    weight = shape_weights(mesh);
  }
};

void require(bool proved) {
  if (!proved) throw std::runtime_error("the matching is not proved");
}

void run_cardinality(const Call& call, Report& report) {
  const DualInput input(call);
  const auto result = bench::measure(report, [&] { return maximum_matching(input.graph); });
  require(verify_tutte_berge(input.graph, result));
  count(result.matching, input.weight, report);
}

template <MatchingGoal kGoal>
void run_weight(const Call& call, Report& report) {
  const DualInput input(call);
  const auto task = [&] { return maximum_weight_matching(input.graph, input.weight, kGoal); };
  const MaximumWeightMatching result = bench::measure(report, task);
  require(verify_weight(input.graph, input.weight, kGoal, result));
  count(result.matching, input.weight, report);
}

void run_near(const Call& call, Report& report) {
  const DualInput input(call);
  const auto task = [&] {
    return near_maximum_weight_matching(input.graph, input.weight, MatchingGoal::kSizeThenWeight);
  };
  const NearMaximumMatching result = bench::measure(report, task);
  require(is_matching(input.graph, result.matching));
  count(result.matching, input.weight, report);
}

// ---- Strips: from triples of indices, so that finding neighbours is timed, too. ----

template <StripEncoding kEncoding, PathEffort kEffort>
void run_strips(const Call& call, Report& report) {
  const std::vector<Point> points = bench::read_points(call.input);
  const std::vector<VertexId> corners = bench::read_indices(call.input + ".triangles");
  StripOptions options;
  options.encoding = kEncoding;
  options.effort = kEffort;
  const StripResult result = bench::measure(
      report, [&] { return encode_strips(triangles_with_twins(points, corners), options); });
  report.add("indices", 3.0 * static_cast<double>(result.code.index.size()) /
                            static_cast<double>(corners.size()));
  if (!call.result.empty()) bench::write_doubles(call.result + ".strip", result.code.index);
}

// ---- Files. ----

/// A file beside the input, gone afterwards.
struct ScratchFile {
  std::string path;
  ScratchFile(const Call& call, const std::string& ending)
      : path(call.input + ".scratch." + ending) {}
  ~ScratchFile() { std::filesystem::remove(path); }
  void report_size(Report& report) const { report.add("file", std::filesystem::file_size(path)); }
};

void run_write_points(const Call& call, Report& report, const std::string& ending) {
  const std::vector<Point> points = bench::read_points(call.input);
  const ScratchFile file(call, ending);
  bench::measure(report, [&] { return io::write_points(file.path, points), 0; });
  file.report_size(report);
}

void run_read_points(const Call& call, Report& report, const std::string& ending) {
  const ScratchFile file(call, ending);
  io::write_points(file.path, bench::read_points(call.input));
  bench::measure(report, [&] { return io::read_points(file.path); });
  file.report_size(report);
}

io::MeshFile default_quads(const Call& call) {
  io::MeshFile file;
  file.mesh = to_polygon_mesh(quadrangulate_points(bench::read_points(call.input)).mesh);
  return file;
}

void run_write_mesh(const Call& call, Report& report, const std::string& ending) {
  const io::MeshFile mesh = default_quads(call);
  const ScratchFile file(call, ending);
  bench::measure(report, [&] { return io::write_mesh(file.path, mesh), 0; });
  file.report_size(report);
}

void run_read_mesh(const Call& call, Report& report, const std::string& ending) {
  const ScratchFile file(call, ending);
  io::write_mesh(file.path, default_quads(call));
  bench::measure(report, [&] { return io::read_mesh(file.path); });
  file.report_size(report);
}

// ---- The tasks by name. ----

using Task = void (*)(const Call&, Report&);
using FileTask = void (*)(const Call&, Report&, const std::string& ending);

const std::map<std::string, Task> kTasks = {
    {"delaunay", run_delaunay},
    {"constrained", run_constrained},
    {"cycle-random", run_cycle<Splitter::kRandom>},
    {"cycle-balanced", run_cycle<Splitter::kBalanced>},
    {"spiral-polygon", run_spiral_polygon},
    {"quads", run_quads<PointMethod::kDelaunay>},
    {"spiral", run_quads<PointMethod::kSpiral>},
    {"convex", run_convex},
    {"certify", run_certify},
    {"pair", run_pair_default},
    {"pair-exact", run_pair_exact},
    {"pair-triangles", run_pair_triangles},
    {"pair-convex", run_pair_convex},
    {"greedy", run_greedy},
    {"cardinality", run_cardinality},
    {"weight", run_weight<MatchingGoal::kWeight>},
    {"perfect", run_weight<MatchingGoal::kSizeThenWeight>},
    {"near", run_near},
    {"restart-fast", run_strips<StripEncoding::kRestart, PathEffort::kFast>},
    {"restart", run_strips<StripEncoding::kRestart, PathEffort::kStandard>},
    {"restart-thorough", run_strips<StripEncoding::kRestart, PathEffort::kThorough>},
    {"repeat", run_strips<StripEncoding::kRepeat, PathEffort::kStandard>},
};

const std::map<std::string, FileTask> kFileTasks = {
    // with the ending after a dot
    {"write-points", run_write_points},
    {"read-points", run_read_points},
    {"write-mesh", run_write_mesh},
    {"read-mesh", run_read_mesh},
};

void run(const Call& call, Report& report) {
  report.add_words("version", kVersion);
  const std::size_t at = call.task.find('@');
  const ThreadLimit limit(at == std::string::npos ? 1 : std::stoul(call.task.substr(at + 1)));
  const std::string name = call.task.substr(0, at);
  if (const auto task = kTasks.find(name); task != kTasks.end()) {
    return task->second(call, report);
  }
  const std::size_t dot = name.find('.');
  const auto task = kFileTasks.find(name.substr(0, dot));
  if (task == kFileTasks.end() || dot == std::string::npos) bench::unknown_task(call);
  task->second(call, report, name.substr(dot + 1));
}

}  // namespace

int main(int argc, char** argv) { return bench::run_program(argc, argv, run); }
