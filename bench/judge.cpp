// Judges what a program of bench/compare wrote, whoever's it is, by exact predicates alone: called as measure.hpp says, with
// the kind of result as the task. Prints figures, and "wrong" with a sentence if the result is not what it should be.
//
//   delaunay      tiles the hull of all points, and no edge has a point in the circle of the triangle across
//   constrained   the same, but segments may be such edges, and all of them are edges
//   triangles     tiles the hull of all points; cycle: and each triangle is beside the one before, the last beside the first
//   polygon       the ring is a spiral polygon through all points
//   quads         figures of the faces; "wrong" says what keeps it from being a mesh of all points and no triangle but one
//   restart       the strips draw the triangles of the input; repeat: without restarts
#include <algorithm>
#include <array>
#include <map>

#include "quadloom/certify.hpp"
#include "quadloom/strips.hpp"
#include "raw_meshes.hpp"

namespace {

using namespace quadloom;
using bench::Call;
using bench::Report;

void say_wrong(Report& report, const std::string& sentence) { report.add_words("wrong", sentence); }

// ---- Triangles. ----

using Edge = std::pair<VertexId, VertexId>;

/// Edges with a point in the circle of the triangle across, as numbers of the mesh.
std::vector<Edge> edges_not_delaunay(const Triangulation& mesh) {
  std::vector<Edge> found;
  const auto at = [&](VertexId v) { return mesh.points[v]; };
  for (HalfedgeId h = 0; h < mesh.twin.size(); ++h) {
    const HalfedgeId twin = mesh.twin[h];
    if (twin == kNone || twin < h) continue;
    const VertexId a = mesh.origin(h), b = mesh.target(h);
    if (incircle(at(a), at(b), at(mesh.apex(h)), at(mesh.apex(twin))) > 0)
      found.push_back(std::minmax(a, b));
  }
  return found;
}

/// Of the segments, those that are no edge; each is taken from the edges that are not Delaunay.
std::size_t missing_segments(const Call& call, const Triangulation& mesh,
                             std::vector<Edge>& not_delaunay) {
  const PlanarInput input = bench::read_planar(call.input);
  std::vector<std::pair<Point, VertexId>> number;
  const auto less = [](const auto& a, const auto& b) { return lex_less(a.first, b.first); };
  for (VertexId v = 0; v < mesh.points.size(); ++v) number.emplace_back(mesh.points[v], v);
  std::sort(number.begin(), number.end(), less);
  const auto vertex = [&](VertexId input_point) {
    return std::lower_bound(number.begin(), number.end(),
                            std::pair(input.points[input_point], VertexId{0}), less)
        ->second;
  };
  std::vector<Edge> segments, edges;
  for (const Segment& s : input.segments)
    segments.push_back(std::minmax(vertex(s.from), vertex(s.to)));
  for (HalfedgeId h = 0; h < mesh.twin.size(); ++h)
    edges.push_back(std::minmax(mesh.origin(h), mesh.target(h)));
  for (auto* list : {&segments, &edges, &not_delaunay}) std::sort(list->begin(), list->end());
  std::vector<Edge> free;
  std::set_difference(not_delaunay.begin(), not_delaunay.end(), segments.begin(), segments.end(),
                      std::back_inserter(free));
  not_delaunay = free;
  return static_cast<std::size_t>(std::count_if(
      segments.begin(), segments.end(),
      [&](const Edge& s) { return !std::binary_search(edges.begin(), edges.end(), s); }));
}

void judge_triangles(const Call& call, Report& report) {
  const PolygonMesh mesh = bench::read_mesh(call.result);
  const Certificate verdict =
      certify_points(mesh, bench::read_points(call.input), {.corners = 3, .steiner_at_most = 0});
  if (!verdict.ok()) return say_wrong(report, verdict.sentence);
  if (call.task == "cycle") {
    const Certificate order = certify_order(mesh, OrderKind::kCycle);
    if (!order.ok()) say_wrong(report, order.sentence);
  }
  if (call.task == "cycle" || call.task == "triangles") return;
  const Triangulation triangles = triangles_with_twins(mesh.points, mesh.face_vertex);
  std::vector<Edge> not_delaunay = edges_not_delaunay(triangles);
  if (call.task == "constrained") {
    const std::size_t missing = missing_segments(call, triangles, not_delaunay);
    if (missing > 0) return say_wrong(report, std::to_string(missing) + " segments are no edges");
  }
  if (!not_delaunay.empty())
    say_wrong(report, std::to_string(not_delaunay.size()) + " edges are not Delaunay");
}

void judge_polygon(const Call& call, Report& report) {
  const std::vector<Point> vertices = bench::read_points(call.result);
  std::vector<Point> ring;
  for (const VertexId v : bench::read_indices(call.result + ".ring")) ring.push_back(vertices[v]);
  const Certificate verdict = certify_spiral_polygon(ring, bench::read_points(call.input));
  if (!verdict.ok()) say_wrong(report, verdict.sentence);
}

// ---- Quads. ----

enum class Shape { kConvex, kNonConvex, kTurnedOver };

Shape shape_of(const PolygonMesh& mesh, std::span<const VertexId> face) {
  const std::size_t k = face.size();
  std::array<int, 4> turn = {};
  for (std::size_t i = 0; i < k; ++i) {
    turn[i] = orient2d(mesh.points[face[(i + k - 1) % k]], mesh.points[face[i]],
                       mesh.points[face[(i + 1) % k]]);
  }
  if (std::all_of(turn.begin(), turn.begin() + static_cast<std::ptrdiff_t>(k),
                  [](int t) { return t > 0; })) {
    return Shape::kConvex;
  }
  const bool one_way = k == 4 && ((turn[0] > 0 && turn[2] > 0) || (turn[1] > 0 && turn[3] > 0));
  return one_way ? Shape::kNonConvex : Shape::kTurnedOver;
}

std::vector<Point> distinct(std::vector<Point> points) {
  std::sort(points.begin(), points.end(), lex_less);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

std::vector<Point> used_places(const PolygonMesh& mesh) {
  std::vector<Point> used;
  for (const VertexId v : mesh.face_vertex) used.push_back(mesh.points[v]);
  return distinct(std::move(used));
}

std::size_t count_without(const std::vector<Point>& a, const std::vector<Point>& b) {
  std::vector<Point> rest;
  std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(rest), lex_less);
  return rest.size();
}

void judge_quads(const Call& call, Report& report) {
  const std::vector<Point> points = bench::read_points(call.input);
  const PolygonMesh mesh = bench::read_mesh(call.result);
  std::array<std::size_t, 3> shapes = {};
  for (std::size_t f = 0; f < mesh.face_count(); ++f)
    ++shapes[static_cast<std::size_t>(shape_of(mesh, mesh.face(f)))];
  const std::vector<Point> places = distinct(points), used = used_places(mesh);
  const Quality quality = measure_quality(mesh);
  report.add("quads", quality.quads).add("triangles", quality.triangles);
  report.add("non_convex", shapes[1]).add("turned_over", shapes[2]);
  report.add("lost", count_without(places, used)).add("added", count_without(used, places));
  report.add("min_angle", quality.min_angle)
      .add("max_angle", quality.max_angle)
      .add("mean_shape", quality.mean_shape);
  const Certificate verdict = certify_points(mesh, points, {.triangles_allowed = 1});
  if (!verdict.ok()) say_wrong(report, verdict.sentence);
}

// ---- Strips. ----

void judge_strips(const Call& call, Report& report) {
  StripCode code;
  code.encoding = call.task == "restart" ? StripEncoding::kRestart : StripEncoding::kRepeat;
  code.index = bench::read_indices(call.result + ".strip");
  if (!same_triangles(decode_strips(code), bench::read_indices(call.input + ".triangles"))) {
    say_wrong(report, "the strips are of other triangles");
  }
}

void run(const Call& call, Report& report) {
  using Judge = void (*)(const Call&, Report&);
  static const std::map<std::string, Judge> judges = {
      {"delaunay", judge_triangles},  {"constrained", judge_triangles},
      {"triangles", judge_triangles}, {"cycle", judge_triangles},
      {"polygon", judge_polygon},     {"quads", judge_quads},
      {"restart", judge_strips},      {"repeat", judge_strips}};
  const auto judge = judges.find(call.task);
  if (judge == judges.end()) bench::unknown_task(call);
  judge->second(call, report);
}

}  // namespace

int main(int argc, char** argv) { return bench::run_program(argc, argv, run); }
