#include "elevation.hpp"

#include <algorithm>
#include <cmath>

namespace quadloom::app {
namespace {

// Where p projects to on a -> b, from 0 at a to 1 at b.
double projection(Point a, Point b, Point p) {
  const double scale = std::max(std::fabs(b.x - a.x), std::fabs(b.y - a.y));
  const double ux = (b.x - a.x) / scale, uy = (b.y - a.y) / scale;
  const double t = ((p.x - a.x) / scale * ux + (p.y - a.y) / scale * uy) / (ux * ux + uy * uy);
  return std::clamp(t, 0.0, 1.0);
}

double steiner_elevation(const std::vector<double>& z, std::span<const Point> points,
                         const SteinerPoint& s) {
  const auto [a, b, c] = s.parents;
  if (s.kind != SteinerKind::kInner && b != kNone) {
    const double t = projection(points[a], points[b], points[s.vertex]);
    return z[a] + t * (z[b] - z[a]);
  }
  double sum = 0;
  int count = 0;
  for (const VertexId parent : s.parents) {
    if (parent == kNone) continue;
    sum += z[parent];
    ++count;
  }
  return count > 0 ? sum / count : 0;
}

}  // namespace

Elevation carry_elevation(std::span<const double> input_z,
                          std::span<const VertexId> input_to_vertex, std::span<const Point> points,
                          std::span<const SteinerPoint> steiner) {
  Elevation out;
  out.z.assign(points.size(), 0);
  std::vector<bool> known(points.size(), false);
  for (std::size_t i = 0; i < input_z.size(); ++i) {
    const VertexId v = input_to_vertex[i];
    if (!known[v]) {
      out.z[v] = input_z[i];
      known[v] = true;
    } else if (out.z[v] != input_z[i]) {
      ++out.other_z;
    }
  }
  for (const SteinerPoint& s : steiner) out.z[s.vertex] = steiner_elevation(out.z, points, s);
  return out;
}

}  // namespace quadloom::app
