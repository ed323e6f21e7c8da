// Shape figures: one pass over the faces. Which quads are convex is decided exactly; angles,
// lengths and shapes are plain floating point, with differences halved where they would overflow.
// On a surface angles and lengths are those in space; which corners turn in and out is seen in the
// coordinate plane that the face is nearest to.

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "certify/edges.hpp"
#include "certify/layout.hpp"
#include "certify/polygon.hpp"
#include "certify/space.hpp"
#include "certify/wording.hpp"
#include "quadloom/certify.hpp"
#include "quadloom/kernel.hpp"

namespace quadloom {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// b - a, scaled so that its larger component is about 1.
Point direction(Point a, Point b) {
  Point d = {b.x - a.x, b.y - a.y};
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

class Measure {
 public:
  Measure(const PolygonMesh& mesh, std::span<const double> z)
      : mesh_(mesh), places_{mesh.points, z} {}

  Quality run() {
    check();
    if (mesh_.face_count() == 0) return out_;
    out_.min_angle = out_.min_edge = out_.min_shape = kInfinity;
    for (std::size_t f = 0; f < mesh_.face_count(); ++f) measure_face(f);
    finish_edges();
    finish_quads();
    return out_;
  }

 private:
  void check() const;
  double length(VertexId a, VertexId b, double scale = 1) const;
  double corner_angle(std::size_t i) const;
  double aspect() const;
  double shape_in_space() const;
  void measure_face(std::size_t f);
  void measure_angle(double angle);
  void measure_quad();
  void finish_edges();
  void finish_quads();

  std::size_t before(std::size_t i) const { return i == 0 ? face_.size() - 1 : i - 1; }
  std::size_t after(std::size_t i) const { return i + 1 == face_.size() ? 0 : i + 1; }

  const PolygonMesh& mesh_;
  kernel::Places places_;
  Quality out_;
  std::span<const VertexId> face_;
  std::vector<Point> corners_;  // of face_, in the plane or its coordinate plane
  std::vector<double> aspect_;
  double side_sum_ = 0;
  double shape_sum_ = 0;
};

void Measure::check() const {
  if (!certify::layout_fits(mesh_)) {
    throw Error(ErrorCode::kBadMesh, "the faces' beginnings do not fit the list of corners");
  }
  if (!places_.planar() && places_.z.size() != mesh_.points.size()) {
    throw Error(ErrorCode::kBadMesh, "the heights are not one a vertex");
  }
  for (std::size_t f = 0; f < mesh_.face_count(); ++f) {
    const auto corners = mesh_.face(f);
    if (corners.size() < 3) {
      throw Error(ErrorCode::kBadMesh,
                  certify::face_text(mesh_, f) + " has fewer than three corners", {f});
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
}

void Measure::measure_angle(double angle) {
  out_.min_angle = std::min(out_.min_angle, angle);
  out_.max_angle = std::max(out_.max_angle, angle);
  count_in(out_.angle_histogram, angle / 360);
}

double Measure::length(VertexId a, VertexId b, double scale) const {
  const kernel::Vector3 p = places_.at(a), q = places_.at(b);
  const double x = q.x * scale - p.x * scale, y = q.y * scale - p.y * scale;
  return places_.planar() ? std::hypot(x, y) : std::hypot(x, y, q.z * scale - p.z * scale);
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
  double longest = 0, shortest = kInfinity;
  for (std::size_t i = 0; i < face_.size(); ++i) {
    const double side = length(face_[i], face_[after(i)], 0.25);  // no overflow
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
  face_ = mesh_.face(f);
  const kernel::Chart chart =
      places_.planar() ? kernel::Chart() : kernel::Chart(certify::area_of(places_, face_));
  corners_.clear();
  for (const VertexId v : face_) corners_.push_back(places_.seen(chart, v));
  for (std::size_t i = 0; i < face_.size(); ++i) {
    measure_angle(corner_angle(i));
    const double side = length(face_[i], face_[after(i)]);
    out_.max_edge = std::max(out_.max_edge, side);
    out_.min_edge = std::min(out_.min_edge, side);
    side_sum_ += side;
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
  shape_sum_ += shape;
  out_.min_shape = std::min(out_.min_shape, shape);
  count_in(out_.shape_histogram, shape);
  aspect_.push_back(aspect());
}

/// Twice every edge: the sides of all faces, and those on the boundary once more.
void Measure::finish_edges() {
  const auto alone = certify::match_edges(mesh_).alone;
  for (const auto [from, to] : alone) {
    side_sum_ += length(from, to);
  }
  out_.mean_edge = side_sum_ / static_cast<double>(mesh_.face_vertex.size() + alone.size());
}

void Measure::finish_quads() {
  if (out_.quads == 0) {
    out_.min_shape = 0;
    return;
  }
  out_.mean_shape = shape_sum_ / static_cast<double>(out_.quads);
  const auto middle = aspect_.begin() + static_cast<std::ptrdiff_t>(aspect_.size() / 2);
  std::ranges::nth_element(aspect_, middle);
  out_.median_aspect = *middle;
  out_.max_aspect = *std::max_element(middle, aspect_.end());
}

}  // namespace

Quality measure_quality(const PolygonMesh& mesh) { return Measure(mesh, {}).run(); }

Quality measure_quality(const PolygonMesh& mesh, std::span<const double> z) {
  return Measure(mesh, z).run();
}

}  // namespace quadloom
