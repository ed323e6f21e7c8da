// The judge of surfaces in space: what can be proved of them without asking where faces cut each
// other. Vertices are known by number.
//
//   1. check_corners     corner counts; every corner is a vertex, once in its face
//   2. check_places      used vertices are finite; those of the source are where they were
//   3. check_shapes      no face has all its corners on one line; strict convexity, if asked for
//   4. check_edges       no directed edge is in two faces
//   5. check_fans        the faces at a vertex make as many fans as in the source
//   6. check_boundary    the boundary edges are the source's, or chains of Steiner points
//   7. check_components  the same components, each with its Euler characteristic
//   8. check_steiner     how many Steiner points there are, and whether any is on the boundary
//
// A component whose faces agree at their edges is a surface with two sides; its Euler characteristic
// and its boundary say which one up to deformation. So the mesh is the source's surface, cut into
// other faces, through the same vertices.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "certify/corners.hpp"
#include "certify/edges.hpp"
#include "certify/outline.hpp"
#include "certify/polygon.hpp"
#include "certify/space.hpp"
#include "certify/topology.hpp"
#include "certify/wording.hpp"
#include "quadloom/certify.hpp"

namespace quadloom {
namespace {

using certify::DirectedEdge;
using certify::face_text;
using certify::Topology;
using certify::vertex_text;
using kernel::Places;

/// Heights that are there, whatever was given.
std::vector<double> heights(const PolygonMesh& mesh, std::span<const double> z) {
  if (z.empty()) return std::vector<double>(mesh.points.size(), 0);
  return {z.begin(), z.end()};
}

class SurfaceJudge {
 public:
  SurfaceJudge(const PolygonMesh& mesh, std::span<const double> z, const PolygonMesh& source,
               std::span<const double> source_z, const CertifyOptions& options)
      : mesh_(mesh),
        z_(heights(mesh, z)),
        source_(source),
        source_z_(heights(source, source_z)),
        options_(options),
        in_source_(std::max(mesh.points.size(), source.points.size()), 0) {
    for (const VertexId v : source.face_vertex) in_source_[v] = 1;
  }

  Certificate judge(std::span<const DirectedEdge> source_boundary) {
    (void)(check_corners() && check_places() && check_shapes() && check_edges() && check_fans() &&
           check_boundary(source_boundary) && check_components() && check_steiner());
    return std::move(out_);
  }

 private:
  bool check_corners();
  bool check_places();
  bool check_shapes();
  bool check_edges();
  bool check_fans();
  bool check_boundary(std::span<const DirectedEdge> source_boundary);
  bool check_components();
  bool check_same_components();
  bool check_steiner();

  bool is_steiner(VertexId v) const { return in_source_[v] == 0; }
  bool in_box(DirectedEdge edge, VertexId v) const;
  bool follow(DirectedEdge edge);

  const PolygonMesh& mesh_;
  std::vector<double> z_;
  const PolygonMesh& source_;
  std::vector<double> source_z_;
  const CertifyOptions& options_;
  Certificate out_;

  std::vector<std::uint8_t> in_source_;  // by vertex: a face of the source uses it
  std::vector<std::uint8_t> used_;
  Topology now_, before_;
  std::vector<DirectedEdge> boundary_;       // by their beginnings
  std::vector<std::uint32_t> boundary_at_;   // by vertex, into boundary_
  std::vector<std::uint8_t> boundary_used_;  // by edge: part of a source edge
};

bool SurfaceJudge::check_corners() {
  if (z_.size() != mesh_.points.size()) {
    return certify::fail(out_, Fault::kIndexOutOfRange, "the heights are not one a vertex", {});
  }
  return certify::judge_corners(mesh_, options_, out_, used_);
}

bool SurfaceJudge::check_places() {
  for (std::size_t v = 0; v < in_source_.size(); ++v) {
    const bool is_used = v < used_.size() && used_[v] != 0;
    if (is_used && !(std::isfinite(mesh_.points[v].x) && std::isfinite(mesh_.points[v].y) &&
                     std::isfinite(z_[v]))) {
      return certify::fail(out_, Fault::kNotFinite, vertex_text(mesh_, v) + " is not finite", {v});
    }
    if (in_source_[v] == 0) {
      out_.steiner += is_used ? 1 : 0;
      continue;
    }
    if (!is_used) {
      return certify::fail(out_, Fault::kMissingPoint,
                           "vertex " + std::to_string(v) + " of the source is in no face", {v});
    }
    if (mesh_.points[v] != source_.points[v] || z_[v] != source_z_[v]) {
      return certify::fail(out_, Fault::kMissingPoint,
                           vertex_text(mesh_, v) + " is not where the source has it", {v});
    }
    ++out_.points;
  }
  return true;
}

bool SurfaceJudge::check_shapes() {
  const Places places{mesh_.points, z_};
  for (std::size_t f = 0; f < mesh_.face_count(); ++f) {
    if (certify::on_a_line(places, mesh_.face(f))) {
      return certify::fail(out_, Fault::kNotSimple,
                           face_text(mesh_, f) + " has all its corners on one line", {f});
    }
    if (mesh_.face(f).size() != options_.corners) continue;
    const int turn = certify::smallest_turn_in_chart(places, mesh_.face(f));
    ++(turn > 0 ? out_.strictly_convex : turn == 0 ? out_.flat_cornered : out_.non_convex);
    if (options_.strictly_convex && turn <= 0) {
      return certify::fail(out_, Fault::kNotStrictlyConvex,
                           face_text(mesh_, f) + " is not strictly convex in its coordinate plane",
                           {f});
    }
  }
  return true;
}

bool SurfaceJudge::check_edges() {
  certify::require_few_vertices(mesh_);
  auto report = certify::match_edges(mesh_);
  boundary_ = std::move(report.alone);
  if (report.repeated.from == kNone) return true;
  certify::report_repeated_edge(mesh_, report.repeated.from, report.repeated.to, out_);
  return false;
}

bool SurfaceJudge::check_fans() {
  now_ = certify::topology_of(mesh_);
  before_ = certify::topology_of(source_);
  for (VertexId v = 0; v < used_.size(); ++v) {
    if (used_[v] == 0) continue;
    const std::uint32_t wanted = is_steiner(v) ? 1 : before_.fans[v];
    if (now_.fans[v] == wanted) continue;
    return certify::fail(out_, Fault::kFans,
                         "the faces at " + vertex_text(mesh_, v) + " make " +
                             std::to_string(now_.fans[v]) + " fans, not " + std::to_string(wanted),
                         {v});
  }
  return true;
}

/// Between the ends of the edge in each coordinate.
bool SurfaceJudge::in_box(DirectedEdge edge, VertexId v) const {
  const auto within = [](double a, double b, double c) {
    return std::min(a, b) <= c && c <= std::max(a, b);
  };
  const Point a = mesh_.points[edge.from], b = mesh_.points[edge.to], p = mesh_.points[v];
  return within(a.x, b.x, p.x) && within(a.y, b.y, p.y) &&
         within(z_[edge.from], z_[edge.to], z_[v]);
}

//    a --- s --- t --- b       the source's edge a -> b as the mesh has it; from a Steiner point
//                              only one boundary edge goes on, since it has one fan
bool SurfaceJudge::follow(DirectedEdge edge) {
  for (std::uint32_t first = boundary_at_[edge.from]; first < boundary_at_[edge.from + 1];
       ++first) {
    std::uint32_t last = first;
    std::size_t steps = 0;
    while (is_steiner(boundary_[last].to) && steps++ <= boundary_.size()) {
      last = boundary_at_[boundary_[last].to];
    }
    if (boundary_[last].to != edge.to || boundary_used_[first] != 0) continue;
    for (std::uint32_t e = first;; e = boundary_at_[boundary_[e].to]) {
      boundary_used_[e] = 1;
      if (e == last) return true;
      if (!options_.outer_steiner && !in_box(edge, boundary_[e].to)) return false;
    }
  }
  return false;
}

bool SurfaceJudge::check_boundary(std::span<const DirectedEdge> source_boundary) {
  out_.boundary = boundary_.size();
  std::ranges::sort(boundary_, {}, &DirectedEdge::from);
  boundary_at_.assign(mesh_.points.size() + 1, 0);
  for (const DirectedEdge& e : boundary_) ++boundary_at_[e.from + 1];
  for (std::size_t v = 1; v < boundary_at_.size(); ++v) boundary_at_[v] += boundary_at_[v - 1];
  boundary_used_.assign(boundary_.size(), 0);
  for (const DirectedEdge edge : source_boundary) {
    if (follow(edge)) continue;
    return certify::fail(out_, Fault::kBoundary,
                         "the source's boundary edge from " + vertex_text(mesh_, edge.from) +
                             " to " + vertex_text(mesh_, edge.to) +
                             " is not on the mesh's boundary",
                         {edge.from, edge.to});
  }
  const auto rest = std::ranges::find(boundary_used_, 0) - boundary_used_.begin();
  if (static_cast<std::size_t>(rest) == boundary_.size()) return true;
  const auto [from, to] = boundary_[static_cast<std::size_t>(rest)];
  return certify::fail(out_, Fault::kBoundary,
                       "the boundary edge from " + vertex_text(mesh_, from) + " to " +
                           vertex_text(mesh_, to) + " is not on the source's boundary",
                       {from, to});
}

/// Vertices of one fan say which component of the mesh is which of the source.
bool SurfaceJudge::check_same_components() {
  std::vector<std::uint32_t> there(before_.euler.size(), kNone), back(now_.euler.size(), kNone);
  for (VertexId v = 0; v < source_.points.size(); ++v) {
    if (in_source_[v] == 0 || before_.fans[v] != 1) continue;
    const std::uint32_t from = before_.component[v], to = now_.component[v];
    if (there[from] == kNone && back[to] == kNone) {
      there[from] = to;
      back[to] = from;
    } else if (there[from] != to || back[to] != from) {
      return certify::fail(out_, Fault::kTopology,
                           vertex_text(mesh_, v) + " is in another component than in the source",
                           {v});
    }
    if (now_.euler[to] == before_.euler[from]) continue;
    return certify::fail(out_, Fault::kTopology,
                         "the component of " + vertex_text(mesh_, v) +
                             " has the Euler characteristic " + std::to_string(now_.euler[to]) +
                             ", not " + std::to_string(before_.euler[from]),
                         {v});
  }
  return true;
}

bool SurfaceJudge::check_components() {
  if (!check_same_components()) return false;
  auto now = now_.euler, before = before_.euler;  // those that have bow-ties alone, too
  std::ranges::sort(now);
  std::ranges::sort(before);
  if (now == before) return true;
  return certify::fail(out_, Fault::kTopology,
                       std::to_string(now.size()) + " components, the source has " +
                           std::to_string(before.size()) + ", or of other Euler characteristics",
                       {});
}

bool SurfaceJudge::check_steiner() {
  if (out_.steiner > options_.steiner_at_most) {
    return certify::fail(out_, Fault::kTooManySteiner,
                         std::to_string(out_.steiner) +
                             " vertices are no vertices of the source, " +
                             std::to_string(options_.steiner_at_most) + " allowed",
                         {});
  }
  if (!options_.steiner_inside) return true;
  for (const DirectedEdge& e : boundary_) {
    if (!is_steiner(e.from)) continue;
    return certify::fail(out_, Fault::kSteinerOnBoundary,
                         vertex_text(mesh_, e.from) + " is on the boundary and not of the source",
                         {e.from});
  }
  return true;
}

}  // namespace

Certificate certify_surface(const PolygonMesh& mesh, std::span<const double> z,
                            const PolygonMesh& source, std::span<const double> source_z,
                            const CertifyOptions& options) {
  certify::check_options(options);
  if (source.face_count() == 0) throw Error(ErrorCode::kTooFewPoints, "the source has no faces");
  const auto edges = certify::check_source(source);
  if (!source_z.empty() && source_z.size() != source.points.size()) {
    throw Error(ErrorCode::kBadMesh, "the heights of the source are not one a vertex");
  }
  return SurfaceJudge(mesh, z, source, source_z, options).judge(edges.alone);
}

}  // namespace quadloom
