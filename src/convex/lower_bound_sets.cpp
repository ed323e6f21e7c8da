// Point sets that need many Steiner points, recognised (Bremner, Hurtado, Ramaswami and Sacristan, theorems
// 2.1 to 2.4): whatever cuts these sets anew piece by piece is some per cent above the theorems' meshes,
// which are as good as the best possible.
//
//   1. line_order    the hull has four corners, all other points are on one of its diagonals: in order
//                    along it, then the corner on its left and the one on its right
//      ring_order    two convex layers of k points: the hull's corners, then for each of its edges
//                    the point b(i) that a ray from a(i) along the edge, turning inwards, meets first
//   2. mesh_of_bhrs_line, mesh_of_bhrs_ring, which check exactly that the set is one
//   3. in_given_order, and parents_of: the Delaunay triangle that a Steiner point is in
//
//          top                                 a2 ----- a1      b(i) is where the tangent from a(i) to the
//        /  |  \                               | b1  b0 |       inner layer touches it, so the b's are that
//      v0-v1-v2-v3                             | b2  b3 |       layer in its order, from b(0) on.
//        \  |  /                               a3 ----- a0
//         bottom
//
// Cost: O(n log n); parents by walks from one Steiner point to the next.
#include "convex/lower_bound_sets.hpp"

#include <algorithm>
#include <utility>

#include "kernel/predicates_inline.hpp"
#include "quadloom/kernel.hpp"

namespace quadloom::convex {
namespace {

using Order = std::vector<VertexId>;

std::optional<Order> line_order(const std::vector<Point>& points) {
  const Order hull = convex_hull(points);
  if (hull.size() != 4) return std::nullopt;
  for (const std::size_t k : {0U, 1U}) {
    VertexId from = hull[k], to = hull[k + 2];
    VertexId right = hull[k + 1], left = hull[(k + 3) % 4];
    if (lex_less(points[to], points[from])) {
      std::swap(from, to);
      std::swap(left, right);
    }
    Order order;
    for (VertexId v = 0; v < points.size(); ++v) {
      if (v != left && v != right && kernel::orient(points[from], points[to], points[v]) == 0) {
        order.push_back(v);
      }
    }
    if (order.size() + 2 != points.size()) continue;
    std::sort(order.begin(), order.end(),
              [&](VertexId v, VertexId w) { return lex_less(points[v], points[w]); });
    order.insert(order.end(), {left, right});
    return order;
  }
  return std::nullopt;
}

std::optional<Order> ring_order(const std::vector<Point>& points) {
  const std::size_t k = points.size() / 2;
  if (points.size() % 2 == 1 || k < 3) return std::nullopt;
  const ConvexLayers layers = convex_layers(points);
  if (layers.count() != 2 || layers.layer(0).size() != k) return std::nullopt;
  const auto outer = layers.layer(0), inner = layers.layer(1);
  std::size_t touched = 0;  // seen from a(0) all others are left of the line to that point
  for (std::size_t i = 1; i < k; ++i) {
    if (kernel::orient(points[outer[0]], points[inner[touched]], points[inner[i]]) < 0) touched = i;
  }
  Order order(outer.begin(), outer.end());
  for (std::size_t i = 0; i < k; ++i) order.push_back(inner[(touched + i) % k]);
  return order;
}

/// None if the set is no such set, or if a place of the theorem is not there.
template <class Mesh>
std::optional<Quadrangulation> mesh_in_order(const std::vector<Point>& points, const Order& order,
                                             Mesh mesh_of) {
  std::vector<Point> sorted;
  for (const VertexId v : order) sorted.push_back(points[v]);
  try {
    return mesh_of(sorted);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::kBadOption && error.code() != ErrorCode::kGuarantee) throw;
    return std::nullopt;
  }
}

Quadrangulation in_given_order(Quadrangulation mesh, const std::vector<Point>& points,
                               const Order& order) {
  std::copy(points.begin(), points.end(), mesh.points.begin());
  for (auto* corners : {&mesh.quad_vertex, &mesh.tri_vertex}) {
    for (VertexId& v : *corners) v = v < order.size() ? order[v] : v;
  }
  return mesh;
}

/// Finds triangles by walks that begin where the last one ended.
class Locator {
 public:
  explicit Locator(std::span<const Point> points) : mesh_(delaunay(points).mesh) {}

  /// Of a point inside the hull.
  std::array<VertexId, 3> triangle_of_point(Point p) {
    for (HalfedgeId h = edge_before(p); h != kNone; h = edge_before(p)) {
      t_ = triangle_of(mesh_.twin[h]);
    }
    return {mesh_.tri_vertex[3 * t_], mesh_.tri_vertex[3 * t_ + 1], mesh_.tri_vertex[3 * t_ + 2]};
  }

 private:
  /// An edge of the triangle that has the point on its other side, kNone if there is none.
  HalfedgeId edge_before(Point p) const {
    for (HalfedgeId h = 3 * t_; h < 3 * t_ + 3; ++h) {
      if (kernel::orient(mesh_.points[mesh_.origin(h)], mesh_.points[mesh_.target(h)], p) < 0) {
        return h;
      }
    }
    return kNone;
  }

  Triangulation mesh_;
  TriangleId t_ = 0;
};

ConvexResult result_of(Quadrangulation mesh, const std::vector<Point>& points, std::size_t hull) {
  ConvexResult result;
  result.input_vertices = points.size();
  result.statistics.hull_points = hull;
  Locator locator(points);
  for (auto v = static_cast<VertexId>(points.size()); v < mesh.points.size(); ++v) {
    result.steiner.push_back({v, SteinerKind::kInner, locator.triangle_of_point(mesh.points[v])});
  }
  result.mesh = std::move(mesh);
  return result;
}

}  // namespace

std::optional<ConvexResult> lower_bound_mesh(const std::vector<Point>& points) {
  if (const auto order = line_order(points)) {
    if (auto mesh = mesh_in_order(points, *order, mesh_of_bhrs_line)) {
      return result_of(in_given_order(std::move(*mesh), points, *order), points, 4);
    }
  } else if (const auto ring = ring_order(points)) {
    if (auto mesh = mesh_in_order(points, *ring, mesh_of_bhrs_ring)) {
      return result_of(in_given_order(std::move(*mesh), points, *ring), points, points.size() / 2);
    }
  }
  return std::nullopt;
}

}  // namespace quadloom::convex
