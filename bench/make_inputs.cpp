// Inputs for bench/compare, called as measure.hpp says:
//
//   make_inputs KIND:N NAME       NAME.points: points of `quadloom generate`, in random order
//   make_inputs triangles NAME    NAME.triangles: their Delaunay triangulation
//   make_inputs dual NAME         NAME.dual: its dual graph, weights by shape
//   make_inputs segments:N NAME   NAME.segments: about N segments that do not cross, each across many of the triangles
//
// Segments are edges of the Delaunay triangulation of a sample of the points.
#include "core/random.hpp"
#include "quadloom/dual.hpp"
#include "quadloom/generate.hpp"
#include "raw_meshes.hpp"

namespace {

using namespace quadloom;

/// In random order: what a generator's order could give away counts for nobody.
std::vector<Point> shuffled(std::vector<Point> points) {
  Random random(2);
  for (std::size_t i = points.size(); i > 1; --i) std::swap(points[i - 1], points[random.below(i)]);
  return points;
}

template <class Action>
void for_each_edge(const Triangulation& mesh, Action action) {
  for (HalfedgeId h = 0; h < mesh.twin.size(); ++h) {
    if (mesh.twin[h] == kNone || h < mesh.twin[h]) action(h);
  }
}

/// Of repeated points the first is the corner.
void make_triangles(const std::string& name) {
  const DelaunayResult result = delaunay(bench::read_points(name));
  std::vector<VertexId> first(result.mesh.points.size(), kNone), corners;
  for (VertexId i = 0; i < result.input_to_vertex.size(); ++i) {
    VertexId& at = first[result.input_to_vertex[i]];
    at = std::min(at, i);
  }
  for (const VertexId v : result.mesh.tri_vertex) corners.push_back(first[v]);
  bench::write_doubles(name + ".triangles", corners);
}

void make_dual(const std::string& name) {
  const Triangulation mesh = delaunay(bench::read_points(name)).mesh;
  const std::vector<std::int32_t> weight = shape_weights(mesh);
  std::vector<double> edges;
  for_each_edge(mesh, [&](HalfedgeId h) {
    if (mesh.twin[h] == kNone) return;
    edges.insert(edges.end(),
                 {double(triangle_of(h)), double(triangle_of(mesh.twin[h])), double(weight[h])});
  });
  bench::write_doubles(name + ".dual", edges);
}

/// The edges of the triangulation of the first third as many points.
void make_segments(const std::string& name, std::size_t count) {
  std::vector<Point> points = bench::read_points(name);
  points.resize(std::min(points.size(), count / 3));
  const DelaunayResult sample = delaunay(points);
  if (sample.mesh.points.size() != points.size())
    throw std::runtime_error("repeated points in the sample");
  std::vector<double> ends;
  for_each_edge(sample.mesh, [&](HalfedgeId h) {
    ends.insert(ends.end(), {double(sample.mesh.origin(h)), double(sample.mesh.target(h))});
  });
  bench::write_doubles(name + ".segments", ends);
}

void run(const bench::Call& call, bench::Report&) {
  const std::size_t colon = call.task.find(':');
  const std::string what = call.task.substr(0, colon);
  const std::size_t count =
      colon == std::string::npos ? 0 : std::stoull(call.task.substr(colon + 1));
  if (what == "triangles") {
    make_triangles(call.input);
  } else if (what == "dual") {
    make_dual(call.input);
  } else if (what == "segments") {
    make_segments(call.input, count);
  } else {
    bench::write_points(call.input, shuffled(generate_points(what, count)));
  }
}

}  // namespace

int main(int argc, char** argv) { return bench::run_program(argc, argv, run); }
