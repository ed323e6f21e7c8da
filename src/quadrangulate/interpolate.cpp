// Numbers of added points from those of the vertices that they were made from.
#include <algorithm>
#include <cmath>

#include "quadloom/quadrangulate.hpp"

namespace quadloom {
namespace {

struct Vector {
  double x, y, z;
};

// Differences of vertices over a common length, so that products neither overflow nor vanish.
class Places {
 public:
  Places(std::span<const Point> points, std::span<const double> z) : points_(points), z_(z) {}

  double extent(VertexId from, VertexId to) const {
    const Point a = points_[from], b = points_[to];
    const double flat = std::max(std::fabs(b.x - a.x), std::fabs(b.y - a.y));
    return z_.empty() ? flat : std::max(flat, std::fabs(z_[to] - z_[from]));
  }
  Vector step(VertexId from, VertexId to, double scale) const {
    const Point a = points_[from], b = points_[to];
    return {(b.x - a.x) / scale, (b.y - a.y) / scale, z_.empty() ? 0 : (z_[to] - z_[from]) / scale};
  }

 private:
  std::span<const Point> points_;
  std::span<const double> z_;
};

double dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

void share_evenly(Blend& blend) {
  const auto parents = std::count_if(blend.parent.begin(), blend.parent.end(),
                                     [](VertexId v) { return v != kNone; });
  for (std::size_t i = 0; i < 3; ++i) {
    blend.share[i] = blend.parent[i] == kNone ? 0 : 1 / static_cast<double>(parents);
  }
}

// Where p projects to on a -> b, from 0 at a to 1 at b.
void share_along(Blend& blend, const Places& at) {
  const auto [a, b, none] = blend.parent;
  const double scale = at.extent(a, b);
  if (!(scale > 0) || !std::isfinite(scale)) return share_evenly(blend);
  const Vector ab = at.step(a, b, scale);
  const double t = std::clamp(dot(at.step(a, blend.vertex, scale), ab) / dot(ab, ab), 0.0, 1.0);
  blend.share = {1 - t, t, 0};
}

// Barycentric coordinates: the solution of least squares, exact for a point of the triangle.
void share_within(Blend& blend, const Places& at) {
  const auto [a, b, c] = blend.parent;
  const double scale = std::max(at.extent(a, b), at.extent(a, c));
  if (!(scale > 0) || !std::isfinite(scale)) return share_evenly(blend);
  const Vector u = at.step(a, b, scale), v = at.step(a, c, scale),
               p = at.step(a, blend.vertex, scale);
  const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), pu = dot(p, u), pv = dot(p, v);
  const double area = uu * vv - uv * uv;
  if (!(area > 0)) return share_evenly(blend);
  const double beta = (pu * vv - pv * uv) / area, gamma = (pv * uu - pu * uv) / area;
  const std::array<double, 3> raw = {std::max(0.0, 1 - beta - gamma), std::max(0.0, beta),
                                     std::max(0.0, gamma)};
  const double sum = raw[0] + raw[1] + raw[2];
  if (!std::isfinite(sum)) return share_evenly(blend);
  for (std::size_t i = 0; i < 3; ++i) blend.share[i] = raw[i] / sum;
}

}  // namespace

std::vector<Blend> blends(std::span<const SteinerPoint> steiner, std::span<const Point> points,
                          std::span<const double> z) {
  const Places at(points, z);
  std::vector<Blend> out;
  out.reserve(steiner.size());
  for (const SteinerPoint& s : steiner) {
    Blend& blend = out.emplace_back(Blend{s.vertex, s.parents, {}});
    if (s.kind != SteinerKind::kInner && s.parents[1] != kNone) {
      blend.parent[2] = kNone;
      share_along(blend, at);
    } else if (s.parents[2] != kNone) {
      share_within(blend, at);
    } else {
      share_evenly(blend);
    }
  }
  return out;
}

void interpolate(std::span<const Blend> blends, std::span<double> values) {
  for (const Blend& blend : blends) {
    double value = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      if (blend.share[i] != 0) value += blend.share[i] * values[blend.parent[i]];
    }
    values[blend.vertex] = value;
  }
}

CarriedValues carry_values(std::span<const double> input, std::span<const VertexId> input_to_vertex,
                           std::span<const Point> points, std::span<const SteinerPoint> steiner) {
  CarriedValues out;
  out.values.assign(points.size(), 0);
  std::vector<bool> known(points.size(), false);
  for (std::size_t i = 0; i < input.size(); ++i) {
    const VertexId v = input_to_vertex[i];
    if (v == kNone) continue;
    if (!known[v]) {
      out.values[v] = input[i];
      known[v] = true;
    } else if (out.values[v] != input[i]) {
      ++out.differing;
    }
  }
  interpolate(blends(steiner, points), out.values);
  return out;
}

}  // namespace quadloom
