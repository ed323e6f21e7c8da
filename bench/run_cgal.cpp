// CGAL's triangulations for bench/compare: `delaunay` of INPUT.points, `constrained` with INPUT.segments besides. Points
// are CGAL's before the clock starts, and its own structure is the result; turning that into indices is not timed.
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Unique_hash_map.h>

#include <utility>

#include "measure.hpp"

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Delaunay = CGAL::Delaunay_triangulation_2<Kernel>;
using Constrained = CGAL::Constrained_Delaunay_triangulation_2<Kernel>;
using Points = std::vector<Kernel::Point_2>;
using Segments = std::vector<std::pair<std::size_t, std::size_t>>;

Points read_points(const std::string& input) {
  const std::vector<double> values = bench::read_doubles(input + ".points");
  Points points;
  for (std::size_t i = 0; i < values.size(); i += 2) points.emplace_back(values[i], values[i + 1]);
  return points;
}

Segments read_segments(const std::string& input) {
  const std::vector<double> values = bench::read_doubles(input + ".segments");
  Segments segments;
  for (std::size_t i = 0; i < values.size(); i += 2) {
    segments.emplace_back(static_cast<std::size_t>(values[i]),
                          static_cast<std::size_t>(values[i + 1]));
  }
  return segments;
}

template <class Mesh>
void finish(const Mesh& mesh, const std::string& result, bench::Report& report) {
  report.add("triangles", mesh.number_of_faces());
  if (result.empty()) return;
  std::vector<double> points, corners;
  CGAL::Unique_hash_map<typename Mesh::Vertex_handle, double> number;
  for (auto v = mesh.finite_vertices_begin(); v != mesh.finite_vertices_end(); ++v) {
    number[v] = static_cast<double>(points.size() / 2);
    points.insert(points.end(), {v->point().x(), v->point().y()});
  }
  for (auto f = mesh.finite_faces_begin(); f != mesh.finite_faces_end(); ++f) {
    for (int i = 0; i < 3; ++i) corners.push_back(number[f->vertex(i)]);
  }
  bench::write_doubles(result + ".points", points);
  bench::write_doubles(result + ".triangles", corners);
}

void run(const bench::Call& call, bench::Report& report) {
  report.add_words("version", CGAL_VERSION_STR);
  const Points points = read_points(call.input);
  if (call.task == "delaunay") {
    const auto task = [&] { return Delaunay(points.begin(), points.end()); };
    finish(bench::measure(report, task), call.result, report);
  } else if (call.task == "constrained") {
    const Segments segments = read_segments(call.input);
    const auto task = [&] {
      Constrained mesh;
      mesh.insert_constraints(points.begin(), points.end(), segments.begin(), segments.end());
      return mesh;
    };
    finish(bench::measure(report, task), call.result, report);
  } else {
    bench::unknown_task(call);
  }
}

}  // namespace

int main(int argc, char** argv) { return bench::run_program(argc, argv, run); }
