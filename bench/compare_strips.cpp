// Our strips against meshoptimizer's stripifier, after its cache optimisation for strips, in the same
// process, in alternating rounds: indices a triangle, medians of seconds and of their ratio. Both start
// from triples of indices: our time has that of finding neighbours in it. Every code of ours is
// decoded and compared with the source.
//
//   compare_strips [rounds]                 the table
//   compare_strips rounds MESH|KIND:N ...   mesh files, and Delaunay triangulations of generated points
#include <meshoptimizer.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "core/random.hpp"
#include "quadloom/generate.hpp"
#include "quadloom/io.hpp"
#include "quadloom/strips.hpp"

namespace {

using quadloom::PathEffort;
using quadloom::StripEncoding;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

double median(std::vector<double> v) {
  std::nth_element(v.begin(), v.begin() + static_cast<std::ptrdiff_t>(v.size() / 2), v.end());
  return v[v.size() / 2];
}

struct Triangles {
  std::vector<quadloom::Point> points;
  std::vector<quadloom::VertexId> corners;
};

Triangles delaunay_of(const std::string& kind, std::size_t n) {
  std::vector<quadloom::Point> points = quadloom::generate_points(kind, n);
  quadloom::Random random(2);
  for (std::size_t i = points.size(); i > 1; --i) std::swap(points[i - 1], points[random.below(i)]);
  quadloom::Triangulation mesh = quadloom::delaunay(points).mesh;
  return {std::move(mesh.points), std::move(mesh.tri_vertex)};
}

/// A mesh file, points to triangulate (.csv), or KIND:N.
Triangles triangles_of(const std::string& what) {
  const auto colon = what.find(':');
  if (colon != std::string::npos) {
    return delaunay_of(what.substr(0, colon),
                       static_cast<std::size_t>(std::atof(what.c_str() + colon + 1)));
  }
  if (what.ends_with(".csv") || what.ends_with(".xyz")) {
    quadloom::Triangulation mesh = quadloom::delaunay(quadloom::io::read_points(what).points).mesh;
    return {std::move(mesh.points), std::move(mesh.tri_vertex)};
  }
  quadloom::io::MeshFile file = quadloom::io::read_mesh(what);
  quadloom::Triangulation mesh = quadloom::connect_triangles(file.mesh, file.z).triangles.mesh;
  return {std::move(mesh.points), std::move(mesh.tri_vertex)};
}

struct Figure {
  double per_triangle = 0;
  double seconds = 0;
};

Figure theirs(const Triangles& mesh, StripEncoding encoding) {
  const auto start = Clock::now();
  std::vector<unsigned> cached(mesh.corners.size()), strip(mesh.corners.size() / 3 * 5);
  meshopt_optimizeVertexCacheStrip(cached.data(), mesh.corners.data(), mesh.corners.size(),
                                   mesh.points.size());
  const std::size_t size =
      meshopt_stripify(strip.data(), cached.data(), cached.size(), mesh.points.size(),
                       encoding == StripEncoding::kRestart ? ~0U : 0U);
  return {3.0 * static_cast<double>(size) / static_cast<double>(mesh.corners.size()),
          seconds_since(start)};
}

Figure ours(const Triangles& mesh, StripEncoding encoding, PathEffort effort) {
  const auto start = Clock::now();
  quadloom::StripOptions options;
  options.encoding = encoding;
  options.effort = effort;
  const quadloom::StripResult result =
      quadloom::encode_strips(quadloom::triangles_with_twins(mesh.points, mesh.corners), options);
  const double seconds = seconds_since(start);
  if (!quadloom::same_triangles(quadloom::decode_strips(result.code), mesh.corners)) {
    std::puts("the strips are of other triangles!");
    std::exit(1);
  }
  return {3.0 * static_cast<double>(result.code.index.size()) /
              static_cast<double>(mesh.corners.size()),
          seconds};
}

void compare(const std::string& what, int rounds) {
  const Triangles mesh = triangles_of(what);
  const std::string name = what.substr(what.rfind('/') + 1);
  for (const auto& [encoding, encoding_name] : {std::pair(StripEncoding::kRestart, "restart"),
                                                std::pair(StripEncoding::kRepeat, "repeat")}) {
    for (const auto& [effort, effort_name] :
         {std::pair(PathEffort::kFast, "fast"), std::pair(PathEffort::kStandard, "standard"),
          std::pair(PathEffort::kThorough, "thorough")}) {
      if (effort == PathEffort::kThorough && mesh.corners.size() > 1'000'000) continue;
      std::vector<double> our_seconds, their_seconds, ratio;
      Figure us, them;
      for (int i = 0; i < rounds; ++i) {
        us = ours(mesh, encoding, effort);
        them = theirs(mesh, encoding);
        our_seconds.push_back(us.seconds);
        their_seconds.push_back(them.seconds);
        ratio.push_back(us.seconds / them.seconds);
      }
      std::printf("%-20s %9zu %-8s %-9s %8.4f %8.4f %9.4f %9.4f %7.2f\n", name.c_str(),
                  mesh.corners.size() / 3, encoding_name, effort_name, us.per_triangle,
                  them.per_triangle, median(our_seconds), median(their_seconds), median(ratio));
      std::fflush(stdout);
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  const int rounds = argc > 1 ? std::max(1, std::atoi(argv[1])) : 7;
  std::printf("%-20s %9s %-8s %-9s %8s %8s %9s %9s %7s\n", "mesh", "triangles", "encoding",
              "effort", "ours", "theirs", "ours s", "theirs s", "ratio");
  if (argc > 2) {
    for (int i = 2; i < argc; ++i) compare(argv[i], rounds);
    return 0;
  }
  for (const char* what : {"uniform:1e5", "uniform:1e6", "grid:1e6", "jittered-grid:1e6"}) {
    compare(what, rounds);
  }
  return 0;
}
