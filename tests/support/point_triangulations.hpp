// All triangulations of a few points, by exact cover from one open side to the next.
#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "quadloom/core.hpp"
#include "quadloom/kernel.hpp"
#include "support/all_triangulations.hpp"

namespace quadloom::test {

class AllPointTriangulations {
 public:
  using Triangle = std::array<VertexId, 3>;  // counter-clockwise
  using Visitor = std::function<void(const std::vector<Triangle>&)>;

  /// Distinct points, not all on a line.
  explicit AllPointTriangulations(std::vector<Point> points) : points_(std::move(points)) {
    const auto n = static_cast<VertexId>(points_.size());
    for (VertexId a = 0; a < n; ++a) {
      for (VertexId b = 0; b < n; ++b) {
        for (VertexId c = 0; c < n; ++c) {
          if (is_empty({a, b, c})) at_side_[{a, b}].push_back({a, b, c});
        }
      }
    }
  }

  void visit(const Visitor& visitor) {
    const std::vector<VertexId> hull = convex_hull(points_);
    open_.clear();
    for (std::size_t i = 0; i < hull.size(); ++i) {
      open_.insert({hull[i], hull[(i + 1) % hull.size()]});
    }
    extend(visitor);
  }

 private:
  using Side = std::pair<VertexId, VertexId>;

  int turn(VertexId a, VertexId b, VertexId c) const {
    return orient2d(points_[a], points_[b], points_[c]);
  }

  bool is_empty(Triangle t) const {
    if (turn(t[0], t[1], t[2]) <= 0) return false;
    for (VertexId v = 0; v < points_.size(); ++v) {
      if (std::find(t.begin(), t.end(), v) != t.end()) continue;
      if (turn(t[0], t[1], v) >= 0 && turn(t[1], t[2], v) >= 0 && turn(t[2], t[0], v) >= 0) {
        return false;
      }
    }
    return true;
  }

  /// Whether a side of one has the other altogether on its outer side.
  bool apart(Triangle s, Triangle t) const {
    const auto parts = [&](Triangle from, Triangle other) {
      for (std::size_t i = 0; i < 3; ++i) {
        if (std::all_of(other.begin(), other.end(),
                        [&](VertexId v) { return turn(from[i], from[(i + 1) % 3], v) <= 0; })) {
          return true;
        }
      }
      return false;
    };
    return parts(s, t) || parts(t, s);
  }

  void extend(const Visitor& visitor) {
    if (open_.empty()) {
      visitor(chosen_);
      return;
    }
    const Side side = *open_.begin();
    for (const Triangle t : at_side_[side]) {
      if (!std::all_of(chosen_.begin(), chosen_.end(), [&](Triangle c) { return apart(c, t); })) {
        continue;
      }
      const std::set<Side> before = open_;
      for (std::size_t i = 0; i < 3; ++i) {
        const VertexId a = t[i], b = t[(i + 1) % 3];
        if (open_.erase({a, b}) == 0) open_.insert({b, a});
      }
      chosen_.push_back(t);
      extend(visitor);
      chosen_.pop_back();
      open_ = before;
    }
  }

  std::vector<Point> points_;
  std::map<Side, std::vector<Triangle>> at_side_;
  std::set<Side> open_;  // that a triangle to come must have
  std::vector<Triangle> chosen_;
};

/// The same as meshes.
inline void for_all_point_triangulations(const std::vector<Point>& points,
                                         const std::function<void(const Triangulation&)>& visitor) {
  AllPointTriangulations(points).visit([&](const auto& triangles) {
    std::vector<VertexId> corners;
    for (const auto& t : triangles) corners.insert(corners.end(), t.begin(), t.end());
    visitor(connected(points, std::move(corners)));
  });
}

}  // namespace quadloom::test
