// The spiral serpentine polygon by the paper's own procedure, quadratic: the oracle for spiral_polygon.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "quadloom/kernel.hpp"

namespace quadloom::testing {

struct LiteralSpiralPolygon {
  std::vector<std::array<VertexId, 3>> triangles;  // pivot, pass-through point, new point
  std::size_t iterations = 0;
  bool stuck = false;                   // the algorithm backed up twice
  std::size_t most_layers_between = 0;  // of a new point and the pivot
};

/// Iwerks and Mitchell, section 1. Points must be distinct and not all collinear; `left_out` are not
/// looked at.
inline LiteralSpiralPolygon literal_spiral_polygon(const std::vector<Point>& points,
                                                   const std::vector<VertexId>& left_out = {}) {
  LiteralSpiralPolygon out;
  std::vector<char> visited(points.size(), 0);
  for (const VertexId v : left_out) visited[v] = 1;
  std::vector<std::size_t> depth(points.size());
  const ConvexLayers layers = convex_layers(points);
  for (std::size_t i = 0; i < layers.count(); ++i) {
    for (const VertexId v : layers.layer(i)) depth[v] = i;
  }
  VertexId first = 0;
  for (VertexId v = 1; v < points.size(); ++v) {
    const Point p = points[v], q = points[first];
    if (p.y < q.y || (p.y == q.y && p.x > q.x)) first = v;
  }
  visited[first] = 1;
  const auto nearer = [&](VertexId pivot, VertexId a, VertexId b) {
    return dot_sign(points[a], points[pivot], points[a], points[b]) < 0;
  };
  // The first unvisited point that the ray from the pivot meets when it turns by less than half a turn
  // from the pass-through point (kNone: from the horizontal), the nearest on it; kNone if there is none.
  const auto next = [&](VertexId pivot, VertexId pass) {
    VertexId best = kNone;
    for (VertexId v = 0; v < points.size(); ++v) {
      if (visited[v]) continue;
      if (pass != kNone && orient2d(points[pivot], points[pass], points[v]) <= 0) continue;
      const int side = best == kNone ? -1 : orient2d(points[pivot], points[best], points[v]);
      if (side < 0 || (side == 0 && nearer(pivot, v, best))) best = v;
    }
    return best;
  };
  std::size_t left = points.size() - left_out.size() - 1;
  VertexId pivot = first, previous = kNone;
  VertexId pass = next(first, kNone);
  visited[pass] = 1;
  --left;
  while (left > 0) {
    ++out.iterations;
    const VertexId q = next(pivot, pass);
    if (q != kNone) {
      visited[q] = 1;
      --left;
      out.triangles.push_back({pivot, pass, q});
      const auto between = std::minmax(depth[pivot], depth[q]);
      out.most_layers_between = std::max(out.most_layers_between, between.second - between.first);
      previous = pivot;
      pivot = q;
    } else if (previous == kNone) {
      out.stuck = true;
      break;
    } else {
      pass = pivot;
      pivot = previous;
      previous = kNone;
    }
  }
  return out;
}

/// The points inside the hull's edge that begins at the lowest point (of those the one farthest right),
/// counter-clockwise, in order.
inline std::vector<VertexId> inside_first_edge(const std::vector<Point>& points) {
  const std::vector<VertexId> hull = convex_hull(points);
  std::size_t start = 0;
  for (std::size_t i = 1; i < hull.size(); ++i) {
    const Point p = points[hull[i]], q = points[hull[start]];
    if (p.y < q.y || (p.y == q.y && p.x > q.x)) start = i;
  }
  const auto at = [&](std::size_t i) { return hull[(start + i) % hull.size()]; };
  std::vector<VertexId> inside;
  for (std::size_t i = 1; orient2d(points[at(0)], points[at(i)], points[at(i + 1)]) == 0; ++i) {
    inside.push_back(at(i));
  }
  return inside;
}

/// The polygon that the triangles of a serpentine path make up, counter-clockwise from the pivot of the
/// first one.
inline std::vector<VertexId> ring_of_path(const std::vector<std::array<VertexId, 3>>& triangles) {
  std::vector<VertexId> outer = {triangles[0][1]}, inner = {triangles[0][0]};
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const bool last = t + 1 == triangles.size();
    const bool pass_stays = !last && triangles[t + 1][1] == triangles[t][1];
    (pass_stays ? inner : outer).push_back(triangles[t][2]);
  }
  std::vector<VertexId> ring = {inner[0]};
  ring.insert(ring.end(), outer.begin(), outer.end());
  ring.insert(ring.end(), inner.rbegin(), inner.rend() - 1);
  return ring;
}

}  // namespace quadloom::testing
