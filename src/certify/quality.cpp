// Shape figures: one pass over the faces, in blocks on several threads, whose figures are put together in
// order: sums are the same for any number of threads. Which quads are convex is decided exactly; angles,
// lengths and shapes are plain floating point, with differences halved where they would overflow.
// On a surface angles and lengths are those in space; which corners turn in and out is seen in the
// coordinate plane that the face is nearest to.

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "certify/corners.hpp"
#include "certify/edge_sums.hpp"
#include "certify/layout.hpp"
#include "certify/polygon.hpp"
#include "certify/space.hpp"
#include "certify/wording.hpp"
#include "core/parallel.hpp"
#include "quadloom/certify.hpp"
#include "quadloom/kernel.hpp"

namespace quadloom {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Products of two such numbers neither overflow nor underflow.
bool is_tame(double size) { return size > 1e-70 && size < 1e70; }

/// hypot, which takes twice as long for being right in the last place and at the ends of the range.
double length_of(double x, double y) {
  return is_tame(std::max(std::fabs(x), std::fabs(y))) ? std::sqrt(x * x + y * y)
                                                       : std::hypot(x, y);
}

/// b - a; scaled, so that its larger component is about 1, unless it is tame.
Point direction(Point a, Point b) {
  Point d = {b.x - a.x, b.y - a.y};
  // Most need no scaling, which would cost as much as the arc tangent.
  if (is_tame(std::max(std::fabs(d.x), std::fabs(d.y)))) return d;
  if (!std::isfinite(d.x) || !std::isfinite(d.y)) d = {b.x / 2 - a.x / 2, b.y / 2 - a.y / 2};
  const double size = std::max(std::fabs(d.x), std::fabs(d.y));
  if (size == 0) return d;
  const int exponent = std::ilogb(size);
  return {std::scalbn(d.x, -exponent), std::scalbn(d.y, -exponent)};
}

/// The angle inside a counter-clockwise face at `at`, degrees in [0, 360).
double inner_angle(Point before, Point at, Point after) {
  const Point u = direction(at, after), v = direction(at, before);
  const double angle = std::atan2(u.x * v.y - u.y * v.x, u.x * v.x + u.y * v.y);
  const double degrees = angle * (180 / std::numbers::pi);
  return degrees < 0 ? degrees + 360 : degrees;
}

template <std::size_t N>
void count_in(std::array<std::size_t, N>& bins, double share) {
  const double place = std::clamp(share * static_cast<double>(N), 0.0, static_cast<double>(N - 1));
  ++bins[static_cast<std::size_t>(place)];
}

/// The figures of a block of faces.
struct Part {
  Quality figures;
  std::vector<double> aspect;  // of the quads
  double side_sum = 0;
  double shape_sum = 0;
};

/// Measures a block of faces.
class Measure {
 public:
  Measure(const PolygonMesh& mesh, kernel::Places places, Part& part)
      : mesh_(mesh), places_(places), part_(part), out_(part.figures) {
    out_.min_angle = out_.min_edge = out_.min_shape = kInfinity;
  }

  void measure_face(std::size_t f);

  double length(VertexId a, VertexId b, double scale = 1) const;

 private:
  void check_face(std::size_t f) const;
  double corner_angle(std::size_t i) const;
  double aspect() const;
  double shape_in_space() const;
  void measure_angle(double angle);
  void measure_quad();

  std::size_t before(std::size_t i) const { return i == 0 ? face_.size() - 1 : i - 1; }
  std::size_t after(std::size_t i) const { return i + 1 == face_.size() ? 0 : i + 1; }

  const PolygonMesh& mesh_;
  kernel::Places places_;
  Part& part_;
  Quality& out_;
  std::span<const VertexId> face_;
  std::vector<Point> corners_;  // of face_, in the plane or its coordinate plane
  std::vector<double> side_;    // side i goes from corner i to the next one
};

void Measure::check_face(std::size_t f) const {
  const auto corners = mesh_.face(f);
  if (corners.size() < 3) {
    throw Error(ErrorCode::kBadMesh, certify::face_text(mesh_, f) + " has fewer than three corners",
                {f});
  }
  for (const VertexId v : corners) {
    if (v >= mesh_.points.size()) {
      throw Error(ErrorCode::kIndexOutOfRange,
                  certify::face_text(mesh_, f) + " names a vertex that is not there", {f, v});
    }
    if (!std::isfinite(mesh_.points[v].x) || !std::isfinite(mesh_.points[v].y) ||
        !std::isfinite(places_.at(v).z)) {
      throw Error(ErrorCode::kNotFinite, certify::vertex_text(mesh_, v) + " is not finite", {v});
    }
  }
}

void Measure::measure_angle(double angle) {
  out_.min_angle = std::min(out_.min_angle, angle);
  out_.max_angle = std::max(out_.max_angle, angle);
  count_in(out_.angle_histogram, angle / 360);
}

double Measure::length(VertexId a, VertexId b, double scale) const {
  const kernel::Vector3 p = places_.at(a), q = places_.at(b);
  const double x = q.x * scale - p.x * scale, y = q.y * scale - p.y * scale;
  return places_.planar() ? length_of(x, y) : std::hypot(x, y, q.z * scale - p.z * scale);
}

/// The angle inside the face, degrees in [0, 360).
double Measure::corner_angle(std::size_t i) const {
  const std::size_t k = before(i), m = after(i);
  if (places_.planar()) return inner_angle(corners_[k], corners_[i], corners_[m]);
  const double angle =
      certify::angle_in_space(places_.at(face_[k]), places_.at(face_[i]), places_.at(face_[m]));
  const bool turns_right = orient2d(corners_[k], corners_[i], corners_[m]) < 0;
  return turns_right && angle > 0 ? 360 - angle : angle;
}

/// Longest over shortest side.
double Measure::aspect() const {
  const bool overflow = std::ranges::any_of(side_, [](double side) { return std::isinf(side); });
  double longest = 0, shortest = kInfinity;
  for (std::size_t i = 0; i < side_.size(); ++i) {
    const double side = overflow ? length(face_[i], face_[after(i)], 0.25) : side_[i];
    longest = std::max(longest, side);
    shortest = std::min(shortest, side);
  }
  return shortest > 0 ? longest / shortest : kInfinity;
}

/// quad_shape by the angles in space; the quad is strictly convex in its coordinate plane.
double Measure::shape_in_space() const {
  double worst = 0;
  for (std::size_t i = 0; i < 4; ++i) worst = std::max(worst, std::fabs(90 - corner_angle(i)));
  return 1 - worst / 90;
}

void Measure::measure_face(std::size_t f) {
  check_face(f);
  face_ = mesh_.face(f);
  const kernel::Chart chart =
      places_.planar() ? kernel::Chart() : kernel::Chart(certify::area_of(places_, face_));
  corners_.clear();
  side_.clear();
  for (const VertexId v : face_) corners_.push_back(places_.seen(chart, v));
  for (std::size_t i = 0; i < face_.size(); ++i) {
    measure_angle(corner_angle(i));
    const double side = length(face_[i], face_[after(i)]);
    out_.max_edge = std::max(out_.max_edge, side);
    out_.min_edge = std::min(out_.min_edge, side);
    part_.side_sum += side;
    side_.push_back(side);
  }
  if (corners_.size() == 4) {
    measure_quad();
  } else {
    ++(corners_.size() == 3 ? out_.triangles : out_.other_faces);
  }
}

void Measure::measure_quad() {
  ++out_.quads;
  const auto verdict = certify::judge_polygon(corners_);
  const int turn = verdict.simple ? verdict.smallest_turn : -1;
  ++(turn > 0 ? out_.strictly_convex : turn == 0 ? out_.flat_cornered : out_.non_convex);
  const double shape = places_.planar()
                           ? quad_shape(corners_[0], corners_[1], corners_[2], corners_[3])
                       : turn > 0 ? shape_in_space()
                                  : 0;
  part_.shape_sum += shape;
  out_.min_shape = std::min(out_.min_shape, shape);
  count_in(out_.shape_histogram, shape);
  part_.aspect.push_back(aspect());
}

constexpr std::size_t kFacesOfPart = std::size_t{1} << 14;

std::vector<Part> measure_parts(const PolygonMesh& mesh, kernel::Places places) {
  const std::size_t faces = mesh.face_count();
  std::vector<Part> parts(faces / kFacesOfPart + (faces % kFacesOfPart != 0 ? 1 : 0));
  parallel_tasks_in_order(parts.size(), [&](std::size_t i) {
    const std::size_t first = i * kFacesOfPart, last = std::min(faces, first + kFacesOfPart);
    parts[i].aspect.reserve(last - first);
    Measure measure(mesh, places, parts[i]);
    for (std::size_t f = first; f < last; ++f) measure.measure_face(f);
  });
  return parts;
}

template <std::size_t N>
void add(std::array<std::size_t, N>& sum, const std::array<std::size_t, N>& bins) {
  for (std::size_t i = 0; i < N; ++i) sum[i] += bins[i];
}

/// Adds what is counted and what is least or greatest; means are of all parts.
void add(Quality& sum, const Quality& part) {
  sum.quads += part.quads;
  sum.triangles += part.triangles;
  sum.other_faces += part.other_faces;
  sum.strictly_convex += part.strictly_convex;
  sum.flat_cornered += part.flat_cornered;
  sum.non_convex += part.non_convex;
  sum.min_angle = std::min(sum.min_angle, part.min_angle);
  sum.max_angle = std::max(sum.max_angle, part.max_angle);
  sum.min_shape = std::min(sum.min_shape, part.min_shape);
  sum.min_edge = std::min(sum.min_edge, part.min_edge);
  sum.max_edge = std::max(sum.max_edge, part.max_edge);
  add(sum.angle_histogram, part.angle_histogram);
  add(sum.shape_histogram, part.shape_histogram);
}

/// The sides of all faces, and those on the boundary once more: twice every edge.
void finish_edges(const PolygonMesh& mesh, kernel::Places places, const std::vector<Part>& parts,
                  Quality& out) {
  double sum = 0;
  for (const Part& part : parts) sum += part.side_sum;
  const auto boundary = certify::boundary_chain(mesh);
  Part none;
  const Measure measure(mesh, places, none);
  for (const auto [from, to] : boundary) sum += measure.length(from, to);
  const std::size_t sides = mesh.face_vertex.size() + boundary.size();
  out.edges = sides / 2;
  out.mean_edge = sum / static_cast<double>(sides);
}

void finish_quads(std::vector<Part>& parts, Quality& out) {
  if (out.quads == 0) {
    out.min_shape = 0;
    return;
  }
  double sum = 0;
  std::vector<double> aspect;
  aspect.reserve(out.quads);
  for (Part& part : parts) {
    sum += part.shape_sum;
    const auto values = std::exchange(part.aspect, {});
    aspect.insert(aspect.end(), values.begin(), values.end());
  }
  out.mean_shape = sum / static_cast<double>(out.quads);
  const auto middle = aspect.begin() + static_cast<std::ptrdiff_t>(aspect.size() / 2);
  std::ranges::nth_element(aspect, middle);
  out.median_aspect = *middle;
  out.max_aspect = *std::max_element(middle, aspect.end());
}

Quality measure(const PolygonMesh& mesh, std::span<const double> z) {
  if (!certify::layout_fits(mesh)) {
    throw Error(ErrorCode::kBadMesh, "the faces' beginnings do not fit the list of corners");
  }
  if (!z.empty() && z.size() != mesh.points.size()) {
    throw Error(ErrorCode::kBadMesh, "the heights are not one a vertex");
  }
  if (mesh.face_count() == 0) return {};
  certify::require_few_vertices(mesh);
  const kernel::Places places{mesh.points, z};
  std::vector<Part> parts = measure_parts(mesh, places);
  Quality out = parts[0].figures;
  for (std::size_t i = 1; i < parts.size(); ++i) add(out, parts[i].figures);
  finish_edges(mesh, places, parts, out);
  finish_quads(parts, out);
  return out;
}

}  // namespace

Quality measure_quality(const PolygonMesh& mesh) { return measure(mesh, {}); }

Quality measure_quality(const PolygonMesh& mesh, std::span<const double> z) {
  return measure(mesh, z);
}

}  // namespace quadloom
