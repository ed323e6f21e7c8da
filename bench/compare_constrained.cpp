// Our constrained Delaunay triangulation against CGAL's in the same process, in alternating rounds:
// medians of seconds and their ratio. Random points, and segments that do not cross: edges of a
// Delaunay triangulation of a sample of the points, so each is long among the points and crosses
// many triangles. Both end as in compare_delaunay.
//
//   compare_constrained [rounds]
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "core/random.hpp"
#include "quadloom/generate.hpp"
#include "quadloom/kernel.hpp"

namespace {

using quadloom::PlanarInput;
using quadloom::Point;
using quadloom::VertexId;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Constrained = CGAL::Constrained_Delaunay_triangulation_2<Kernel>;

/// About `segments` edges of the Delaunay triangulation of the first segments / 3 points.
PlanarInput make_input(std::vector<Point> points, std::size_t segments) {
  PlanarInput input;
  const std::vector<Point> sample(points.begin(),
                                  points.begin() + static_cast<std::ptrdiff_t>(segments / 3));
  const quadloom::Triangulation mesh = quadloom::delaunay(sample).mesh;
  for (quadloom::HalfedgeId h = 0; h < mesh.twin.size(); ++h) {
    if (mesh.twin[h] == quadloom::kNone || h < mesh.twin[h]) {
      input.segments.push_back({mesh.origin(h), mesh.target(h)});
    }
  }
  input.points = std::move(points);
  return input;
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double median(std::vector<double> v) {
  std::nth_element(v.begin(), v.begin() + static_cast<std::ptrdiff_t>(v.size() / 2), v.end());
  return v[v.size() / 2];
}

void compare(const std::string& name, const PlanarInput& input, int rounds) {
  std::vector<Kernel::Point_2> cgal_points;
  for (const Point& p : input.points) cgal_points.emplace_back(p.x, p.y);
  std::vector<std::pair<std::size_t, std::size_t>> cgal_segments;
  for (const auto& s : input.segments) cgal_segments.emplace_back(s.from, s.to);
  std::vector<double> ours, points_only, theirs, ratio;
  std::size_t faces = 0, cgal_faces = 0;
  for (int i = 0; i < rounds; ++i) {
    auto start = std::chrono::steady_clock::now();
    faces = quadloom::constrained_delaunay(input, quadloom::Extent::kHull).mesh.triangle_count();
    ours.push_back(seconds_since(start));
    start = std::chrono::steady_clock::now();
    (void)quadloom::delaunay(input.points);
    points_only.push_back(seconds_since(start));
    start = std::chrono::steady_clock::now();
    Constrained cgal;
    cgal.insert_constraints(cgal_points.begin(), cgal_points.end(), cgal_segments.begin(),
                            cgal_segments.end());
    theirs.push_back(seconds_since(start));
    cgal_faces = cgal.number_of_faces();
    ratio.push_back(ours.back() / theirs.back());
  }
  std::printf("%-14s %9zu %9zu %10.4f %10.4f %10.4f %8.3f   %s\n", name.c_str(),
              input.points.size(), input.segments.size(), median(ours), median(points_only),
              median(theirs), median(ratio), faces == cgal_faces ? "" : "faces differ!");
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const int rounds = argc > 1 ? std::max(1, std::atoi(argv[1])) : 5;
  std::printf("%-14s %9s %9s %10s %10s %10s %8s\n", "points", "n", "segments", "ours s",
              "no segm. s", "CGAL s", "ratio");
  for (const char* kind : {"uniform", "clusters", "grid"}) {
    for (const std::size_t n : {100000UL, 1000000UL}) {
      for (const std::size_t segments : {1000UL, 10000UL, 100000UL}) {
        auto points = quadloom::generate_points(kind, n, 1);
        quadloom::Random random(2);  // so that the sample is spread
        for (std::size_t i = points.size(); i > 1; --i) {
          std::swap(points[i - 1], points[random.below(i)]);
        }
        compare(kind, make_input(std::move(points), segments), rounds);
      }
    }
  }
  return 0;
}
