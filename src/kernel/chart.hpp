// Charts: patches of a surface in space seen in a coordinate plane, where predicates are exact.
//
// The chart of a patch drops the coordinate that its area vector is longest in. The two others are the
// doubles that were given, so whether corners turn left in the chart is decided exactly; which
// chart is taken is a matter of rounding alone, and any is as good near a tie. In the plane (no z)
// there is one chart, the identity.
#pragma once

#include <array>
#include <cmath>
#include <span>

#include "quadloom/core.hpp"

namespace quadloom::kernel {

struct Vector3 {
  double x = 0, y = 0, z = 0;
  friend Vector3 operator+(Vector3 a, Vector3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Vector3 operator-(Vector3 a, Vector3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
};

inline Vector3 cross(Vector3 a, Vector3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double dot(Vector3 a, Vector3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/// A coordinate plane, seen from the side that makes a patch counter-clockwise.
class Chart {
 public:
  Chart() = default;  // the plane of x and y
  explicit Chart(Vector3 area) {
    const double x = std::fabs(area.x), y = std::fabs(area.y), z = std::fabs(area.z);
    if (x > y && x > z) {
      dropped_ = Dropped::kX;
      turned_ = area.x < 0;
    } else if (y > z) {
      dropped_ = Dropped::kY;
      turned_ = area.y < 0;
    } else {
      turned_ = area.z < 0;
    }
  }

  Point operator()(Point p, double z) const {
    const Point seen = dropped_ == Dropped::kX   ? Point{p.y, z}
                       : dropped_ == Dropped::kY ? Point{z, p.x}
                                                 : p;
    return turned_ ? Point{seen.y, seen.x} : seen;
  }
  Point operator()(Vector3 p) const { return (*this)({p.x, p.y}, p.z); }

  /// The point on the plane of three corners that is seen at `seen`, up to rounding in the
  /// coordinate that the chart drops.
  Vector3 lift(Point seen, const std::array<Vector3, 3>& corner) const {
    const Point a = (*this)(corner[0]), b = (*this)(corner[1]), c = (*this)(corner[2]);
    const double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    const double v = ((seen.x - a.x) * (c.y - a.y) - (seen.y - a.y) * (c.x - a.x)) / area;
    const double w = ((b.x - a.x) * (seen.y - a.y) - (b.y - a.y) * (seen.x - a.x)) / area;
    const auto dropped = [&](double at_a, double at_b, double at_c) {
      return at_a + v * (at_b - at_a) + w * (at_c - at_a);
    };
    const Point p = turned_ ? Point{seen.y, seen.x} : seen;
    if (dropped_ == Dropped::kX) return {dropped(corner[0].x, corner[1].x, corner[2].x), p.x, p.y};
    if (dropped_ == Dropped::kY) return {p.y, dropped(corner[0].y, corner[1].y, corner[2].y), p.x};
    return {p.x, p.y, dropped(corner[0].z, corner[1].z, corner[2].z)};
  }

  /// The coordinate that is dropped.
  double depth(Point p, double z) const {
    return dropped_ == Dropped::kX ? p.x : dropped_ == Dropped::kY ? p.y : z;
  }

  /// The place that is seen at `seen` and has this depth.
  Vector3 lift(Point seen, double depth) const {
    const Point p = turned_ ? Point{seen.y, seen.x} : seen;
    return dropped_ == Dropped::kX   ? Vector3{depth, p.x, p.y}
           : dropped_ == Dropped::kY ? Vector3{p.y, depth, p.x}
                                     : Vector3{p.x, p.y, depth};
  }

 private:
  enum class Dropped : unsigned char { kX, kY, kZ };
  Dropped dropped_ = Dropped::kZ;
  bool turned_ = false;
};

/// Vertices of a planar mesh (z empty) or a surface.
struct Places {
  std::span<const Point> points;
  std::span<const double> z;

  bool planar() const { return z.empty(); }
  Vector3 at(VertexId v) const { return {points[v].x, points[v].y, planar() ? 0 : z[v]}; }
  /// Twice the area of a triangle, along its normal.
  Vector3 area(VertexId a, VertexId b, VertexId c) const {
    return cross(at(b) - at(a), at(c) - at(a));
  }
  Chart chart(VertexId a, VertexId b, VertexId c) const {
    return planar() ? Chart() : Chart(area(a, b, c));
  }
  Point seen(const Chart& chart, VertexId v) const {
    return planar() ? points[v] : chart(points[v], z[v]);
  }
};

}  // namespace quadloom::kernel
