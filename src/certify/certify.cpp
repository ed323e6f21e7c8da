// The judge: proves from the faces alone that a mesh tiles a convex region once and keeps the
// input. It trusts nothing that the mesh's maker computed, and uses the exact predicates only. What
// the steps prove together is in docs/algorithms/certify.md.
//
//   1. check_corners     the arrays fit together; corner counts; every corner is a vertex, once in its
//                        face
//   2. check_finite      used vertices have finite coordinates
//   3. check_shapes      each face is a simple counter-clockwise polygon of positive area
//   4. check_edges       no directed edge is in two faces
//   5. check_distinct    no two used vertices at the same place
//   6. check_input       every input point is a used vertex, bit for bit (-0.0 is 0.0)
//   7. check_boundary    the edges without a reverse: one weakly convex cycle, once around; or, for
//                        polygons and meshes (check_outline), the given edges, winding once
//   8. check_steiner     how many vertices are no input points, and whether any is on the boundary
//
// Each step may rely on those before it. Unused vertices are not looked at.
//
// If the boundary must be convex, check_convex_tiling comes instead of 4, 5 and 7: the sides of all faces
// that are left when opposite ones cancel (boundary_chain) must make that cycle. This proves that the
// faces tile the region once, and 4 and 5 follow. It takes half of the time; only if it fails the steps
// are gone through one by one, to find out what is wrong.
//
// Cost: linear in the size of the mesh and the input (expected, for the hash tables), but for sorting the
// edges at a vertex and k log k for faces of many corners. The passes over the faces run in blocks on
// several threads, which count for themselves; the first fault is that of the first block that has one.

#include "quadloom/certify.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "certify/blocks.hpp"
#include "certify/boundary.hpp"
#include "certify/corners.hpp"
#include "certify/edge_sums.hpp"
#include "certify/edges.hpp"
#include "certify/outline.hpp"
#include "certify/places.hpp"
#include "certify/polygon.hpp"
#include "certify/wording.hpp"

namespace quadloom {
namespace {

using certify::DirectedEdge;
using certify::face_text;
using certify::judge_polygon;
using certify::OutlineEdge;
using certify::Places;
using certify::point_text;
using certify::vertex_text;

constexpr std::size_t kMostCulprits = 16;

class Judge {
 public:
  /// Without an outline the boundary must be convex.
  Judge(const PolygonMesh& mesh, std::span<const Point> input, const CertifyOptions& options,
        const std::vector<OutlineEdge>* outline = nullptr)
      : mesh_(mesh), input_(input), options_(options), outline_(outline), places_(mesh.points) {}

  Certificate judge() {
    (void)(check_corners() && check_finite() && check_shapes() &&
           (check_convex_tiling()
                ? check_input() && keep_boundary()
                : check_edges() && check_distinct() && check_input() && check_boundary()) &&
           check_steiner());
    return std::move(out_);
  }

 private:
  /// What a vertex is; a used vertex is a Steiner point until an input point is found there.
  enum class Role : std::uint8_t { kUnused, kSteiner, kInput };

  bool check_corners();
  bool check_finite();
  bool check_shapes();
  bool check_convex_tiling();
  bool check_edges();
  bool check_distinct();
  bool check_input();
  bool check_boundary();
  bool check_outline();
  bool check_steiner();

  bool judge_shapes(std::size_t first, std::size_t last, Certificate& out) const;
  void count_turns(std::size_t corners, int smallest_turn, Certificate& out) const;
  VertexId vertex_at(Point p);
  bool keep_boundary();

  const PolygonMesh& mesh_;
  std::span<const Point> input_;
  const CertifyOptions& options_;
  const std::vector<OutlineEdge>* outline_;
  Certificate out_;

  std::vector<Role> role_;
  std::size_t used_ = 0;
  std::vector<DirectedEdge> boundary_edges_;
  std::vector<VertexId> boundary_;
  Places places_;
};

bool Judge::check_corners() {
  std::vector<std::uint8_t> used;
  if (!certify::judge_corners(mesh_, options_, out_, used)) return false;
  role_.assign(used.size(), Role::kUnused);
  for (std::size_t v = 0; v < used.size(); ++v) {
    if (used[v] == 0) continue;
    role_[v] = Role::kSteiner;
    ++used_;
  }
  return true;
}

bool Judge::check_finite() {
  for (std::size_t v = 0; v < role_.size(); ++v) {
    const Point p = mesh_.points[v];
    if (role_[v] != Role::kUnused && !(std::isfinite(p.x) && std::isfinite(p.y))) {
      return certify::fail(out_, Fault::kNotFinite, vertex_text(mesh_, v) + " is not finite", {v});
    }
  }
  return true;
}

void Judge::count_turns(std::size_t corners, int smallest_turn, Certificate& out) const {
  if (corners != options_.corners) return;
  ++(smallest_turn > 0    ? out.strictly_convex
     : smallest_turn == 0 ? out.flat_cornered
                          : out.non_convex);
}

bool Judge::judge_shapes(std::size_t first, std::size_t last, Certificate& out) const {
  std::vector<Point> corners;
  for (std::size_t f = first; f < last; ++f) {
    const auto face = mesh_.face(f);
    corners.resize(face.size());
    for (std::size_t i = 0; i < face.size(); ++i) corners[i] = mesh_.points[face[i]];
    const auto verdict = judge_polygon(corners);
    if (!verdict.simple) {
      std::string places;
      for (const Point p : std::span(corners).first(std::min<std::size_t>(8, corners.size()))) {
        places += ' ';
        places += point_text(p);
      }
      return certify::fail(
          out, Fault::kNotSimple,
          face_text(mesh_, f) +
              " is not a simple counter-clockwise polygon of positive area:" + places,
          {f});
    }
    count_turns(corners.size(), verdict.smallest_turn, out);
    if (options_.strictly_convex && corners.size() == options_.corners &&
        verdict.smallest_turn <= 0) {
      return certify::fail(
          out, Fault::kNotStrictlyConvex,
          face_text(mesh_, f) + (verdict.smallest_turn == 0
                                     ? " is not strictly convex, it has a flat corner"
                                     : " is not convex"),
          {f});
    }
  }
  return true;
}

bool Judge::check_shapes() {
  auto parts = certify::judge_in_blocks(
      mesh_.face_count(), [&](std::size_t first, std::size_t last, Certificate& part) {
        judge_shapes(first, last, part);
      });
  for (Certificate& part : parts) {
    out_.strictly_convex += part.strictly_convex;
    out_.flat_cornered += part.flat_cornered;
    out_.non_convex += part.non_convex;
    if (!part.ok()) {
      return certify::fail(out_, part.fault, std::move(part.sentence), std::move(part.culprits));
    }
  }
  return true;
}

bool Judge::check_convex_tiling() {
  if (outline_ != nullptr) return false;
  certify::require_few_vertices(mesh_);
  auto report = certify::judge_boundary(mesh_, certify::boundary_chain(mesh_));
  boundary_ = std::move(report.cycle);
  return report.sentence.empty();
}

bool Judge::check_edges() {
  certify::require_few_vertices(mesh_);
  auto report = certify::match_edges(mesh_);
  if (report.repeated.from != kNone) {
    certify::report_repeated_edge(mesh_, report.repeated.from, report.repeated.to, out_);
    return false;
  }
  boundary_edges_ = std::move(report.alone);
  return true;
}

bool Judge::check_distinct() {
  places_.reserve(used_);
  for (VertexId v = 0; v < role_.size(); ++v) {
    if (role_[v] == Role::kUnused) continue;
    const VertexId first = places_.insert(v);
    if (first != v) {
      return certify::fail(
          out_, Fault::kRepeatedVertex,
          vertex_text(mesh_, first) + " and vertex " + std::to_string(v) + " are at the same place",
          {first, v});
    }
  }
  return true;
}

VertexId Judge::vertex_at(Point p) {
  if (places_.empty()) {
    places_.reserve(used_);
    for (VertexId v = 0; v < role_.size(); ++v) {
      if (role_[v] != Role::kUnused) places_.insert(v);
    }
  }
  return places_.find(p);
}

bool Judge::check_input() {
  if (input_.empty()) {
    std::ranges::replace(role_, Role::kSteiner, Role::kInput);
    out_.points = used_;
    return true;
  }
  std::size_t missing = 0;
  std::vector<std::size_t> culprits;
  // Most makers keep the order of the points, so that the next vertex is looked at first: the table is
  // then hardly asked, and not even made if no point is there twice.
  VertexId next = 0;
  for (std::size_t i = 0; i < input_.size(); ++i) {
    const bool is_next =
        next < role_.size() && role_[next] != Role::kUnused && mesh_.points[next] == input_[i];
    const VertexId v = is_next ? next++ : vertex_at(input_[i]);
    if (v == kNone) {
      if (missing++ < kMostCulprits) culprits.push_back(i);
    } else {
      out_.points += role_[v] == Role::kSteiner ? 1 : 0;
      role_[v] = Role::kInput;
    }
  }
  if (missing == 0) return true;
  const std::size_t first = culprits[0];
  return certify::fail(
      out_, Fault::kMissingPoint,
      "input point " + std::to_string(first) + " " + point_text(input_[first]) +
          " is no vertex of a face" +
          (missing > 1 ? ", nor are " + std::to_string(missing - 1) + " others" : ""),
      std::move(culprits));
}

bool Judge::check_outline() {
  std::vector<std::uint8_t> is_steiner(role_.size());
  for (std::size_t v = 0; v < role_.size(); ++v) is_steiner[v] = role_[v] == Role::kSteiner ? 1 : 0;
  auto report = certify::match_outline(mesh_, boundary_edges_, *outline_, places_, is_steiner,
                                       options_.outer_steiner);
  if (report.sentence.empty()) report = certify::judge_winding(mesh_, boundary_edges_);
  if (!report.sentence.empty()) {
    return certify::fail(out_, Fault::kBoundary, std::move(report.sentence),
                         std::move(report.culprits));
  }
  for (const DirectedEdge& e : boundary_edges_) boundary_.push_back(e.from);
  out_.boundary = boundary_edges_.size();
  return true;
}

bool Judge::check_boundary() {
  if (outline_ != nullptr) return check_outline();
  auto report = certify::judge_boundary(mesh_, boundary_edges_);
  if (!report.sentence.empty()) {
    return certify::fail(out_, Fault::kBoundary, std::move(report.sentence),
                         std::move(report.culprits));
  }
  boundary_ = std::move(report.cycle);
  return keep_boundary();
}

bool Judge::keep_boundary() {
  out_.boundary = boundary_.size();
  return true;
}

bool Judge::check_steiner() {
  out_.steiner = used_ - out_.points;
  if (out_.steiner > options_.steiner_at_most) {
    return certify::fail(out_, Fault::kTooManySteiner,
                         std::to_string(out_.steiner) + " vertices are no input points, " +
                             std::to_string(options_.steiner_at_most) + " allowed",
                         {});
  }
  if (!options_.steiner_inside) return true;
  const auto on_rim =
      std::ranges::find_if(boundary_, [&](VertexId v) { return role_[v] == Role::kSteiner; });
  if (on_rim == boundary_.end()) return true;
  return certify::fail(out_, Fault::kSteinerOnBoundary,
                       vertex_text(mesh_, *on_rim) + " is on the boundary and no input point",
                       {*on_rim});
}

}  // namespace

Certificate certify_points(const PolygonMesh& mesh, std::span<const Point> input,
                           const CertifyOptions& options) {
  certify::check_options(options);
  return Judge(mesh, input, options).judge();
}

Certificate certify_polygons(const PolygonMesh& mesh, std::span<const Polygon> polygons,
                             std::span<const Point> inner, const CertifyOptions& options) {
  certify::check_options(options);
  std::vector<Point> input;
  for (const Polygon& polygon : polygons) {
    for (const auto& ring : polygon.rings) input.insert(input.end(), ring.begin(), ring.end());
  }
  input.insert(input.end(), inner.begin(), inner.end());
  if (input.empty()) throw Error(ErrorCode::kTooFewPoints, "there are no polygons to judge by");
  const auto outline = certify::outline_of(polygons);
  return Judge(mesh, input, options, &outline).judge();
}

Certificate certify_mesh(const PolygonMesh& mesh, const PolygonMesh& source,
                         const CertifyOptions& options) {
  certify::check_options(options);
  const auto outline = certify::outline_of(source);
  std::vector<std::uint8_t> used(source.points.size(), 0);
  for (const VertexId v : source.face_vertex) used[v] = 1;
  std::vector<Point> input;
  for (std::size_t v = 0; v < used.size(); ++v) {
    if (used[v] != 0) input.push_back(source.points[v]);
  }
  if (input.empty()) throw Error(ErrorCode::kTooFewPoints, "the source has no faces");
  return Judge(mesh, input, options, &outline).judge();
}

}  // namespace quadloom
