// Our Delaunay triangulation against CGAL's in the same process, in alternating rounds: medians of
// seconds and their ratio. Both end with what a program needs: ours with an indexed mesh (points,
// corners, neighbours, duplicates merged), CGAL's with its own structure; no time for turning that
// into indices is counted.
//
//   compare_delaunay [--threads N] [rounds]              the table
//   compare_delaunay [--threads N] rounds KIND n ...     points of `quadloom generate`, in random order
//
// Ours is measured on one thread and on N, two unless told otherwise; CGAL's has one.
#include <CGAL/Delaunay_triangulation_2.h>
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

using quadloom::Point;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Delaunay = CGAL::Delaunay_triangulation_2<Kernel>;

/// In random order: what a generator's order could give away counts for neither.
std::vector<Point> shuffled(const std::string& kind, std::size_t n) {
  std::vector<Point> points = quadloom::generate_points(kind, n);
  quadloom::Random random(2);
  for (std::size_t i = points.size(); i > 1; --i) std::swap(points[i - 1], points[random.below(i)]);
  return points;
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double median(std::vector<double> v) {
  std::nth_element(v.begin(), v.begin() + static_cast<std::ptrdiff_t>(v.size() / 2), v.end());
  return v[v.size() / 2];
}

std::size_t threads = 2;

/// Seconds of delaunay() on so many threads, and how many triangles there are.
double time_ours(const std::vector<Point>& points, std::size_t on, std::size_t& faces) {
  const quadloom::ThreadLimit limit(on);
  const auto start = std::chrono::steady_clock::now();
  const quadloom::DelaunayResult result = quadloom::delaunay(points);
  const double seconds = seconds_since(start);
  faces = result.mesh.triangle_count();
  return seconds;
}

void compare(const std::string& kind, std::size_t n, int rounds) {
  const std::vector<Point> points = shuffled(kind, n);
  std::vector<Kernel::Point_2> cgal_points;
  for (const Point& p : points) cgal_points.emplace_back(p.x, p.y);
  std::vector<double> one, more, theirs, ratio_of_one, ratio_of_more;
  std::size_t faces = 0, cgal_faces = 0;
  for (int i = 0; i < rounds; ++i) {
    one.push_back(time_ours(points, 1, faces));
    more.push_back(time_ours(points, threads, faces));
    const auto start = std::chrono::steady_clock::now();
    const Delaunay cgal(cgal_points.begin(), cgal_points.end());
    theirs.push_back(seconds_since(start));
    cgal_faces = cgal.number_of_faces();
    ratio_of_one.push_back(one.back() / theirs.back());
    ratio_of_more.push_back(more.back() / theirs.back());
  }
  std::printf("%-14s %9zu %10.4f %10.4f %10.4f %8.3f %8.3f   %s\n", kind.c_str(), points.size(),
              median(one), median(more), median(theirs), median(ratio_of_one),
              median(ratio_of_more), faces == cgal_faces ? "" : "faces differ!");
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc > 2 && std::string(argv[1]) == "--threads") {
    threads = static_cast<std::size_t>(std::max(1, std::atoi(argv[2])));
    argc -= 2;
    argv += 2;
  }
  const int rounds = argc > 1 ? std::max(1, std::atoi(argv[1])) : 7;
  std::printf("%-14s %9s %10s %8zu th. %10s %8s %8s\n", "points", "n", "1 thread s", threads,
              "CGAL s", "ratio", "ratio");
  if (argc > 3) {
    for (int i = 2; i + 1 < argc; i += 2) {
      compare(argv[i], static_cast<std::size_t>(std::atof(argv[i + 1])), rounds);
    }
    return 0;
  }
  compare("uniform", 10000, 9 * rounds);
  compare("uniform", 100000, 3 * rounds);
  compare("uniform", 1000000, rounds);
  compare("grid", 1000000, rounds);
  compare("circle", 100000, rounds);
  return 0;
}
