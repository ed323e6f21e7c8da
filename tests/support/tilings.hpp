// All quadrangulations of very few points in whole coordinates, by exact cover: quads and triangles that
// overlap nowhere and whose areas add up to the hull's. Integer arithmetic, no predicates of the library.
#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <vector>

#include "quadloom/core.hpp"

namespace quadloom::testing {

struct Tilings {
  std::size_t count = 0;        // quadrangulations; with one triangle if there is none without
  std::size_t quads = 0;        // in each
  std::size_t most_convex = 0;  // strictly convex quads in one
};

class TilingSearch {
 public:
  explicit TilingSearch(const std::vector<Point>& points) {
    for (const Point p : points) {
      points_.push_back({static_cast<std::int64_t>(p.x), static_cast<std::int64_t>(p.y)});
    }
    find_tiles();
    for (std::size_t i = 0; i < tiles_.size(); ++i) {
      for (std::size_t j = 0; j < tiles_.size(); ++j) apart_[i][j] = !overlap(tiles_[i], tiles_[j]);
    }
  }

  Tilings count() {
    extend(0, std::bitset<kMostTiles>().set(), hull_area(), false, {0, 0, 0});
    return found_;
  }

 private:
  using At = std::array<std::int64_t, 2>;
  using Triangle = std::array<At, 3>;
  static constexpr std::size_t kMostTiles = 256;  // 7 points: 3 x 35 quads and 35 triangles
  struct Tile {
    std::vector<Triangle> parts;  // one or two, counter-clockwise
    std::int64_t area = 0;        // twice
    bool convex = false;
  };

  static std::int64_t cross(At a, At b, At c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  }
  static std::int64_t area(const Triangle& t) { return cross(t[0], t[1], t[2]); }
  static bool holds(const Triangle& t, At p) {
    return cross(t[0], t[1], p) >= 0 && cross(t[1], t[2], p) >= 0 && cross(t[2], t[0], p) >= 0;
  }

  /// Two triangles have a common inner point unless a side of one has the other on its outer side.
  static bool overlap(const Triangle& s, const Triangle& t) {
    const auto parts = [](const Triangle& from, const Triangle& other) {
      for (std::size_t i = 0; i < 3; ++i) {
        bool outside = true;
        for (const At p : other) outside = outside && cross(from[i], from[(i + 1) % 3], p) <= 0;
        if (outside) return true;
      }
      return false;
    };
    return !parts(s, t) && !parts(t, s);
  }
  static bool overlap(const Tile& s, const Tile& t) {
    for (const Triangle& a : s.parts) {
      for (const Triangle& b : t.parts) {
        if (overlap(a, b)) return true;
      }
    }
    return false;
  }

  /// Twice, by the sum of a fan of the hull's sides, found as the pairs with nothing to their right.
  std::int64_t hull_area() const {
    std::int64_t sum = 0;
    for (const At a : points_) {
      for (const At b : points_) {
        bool side = a != b;
        for (const At p : points_) {
          const std::int64_t turn = cross(a, b, p);
          const std::int64_t along = (p[0] - a[0]) * (b[0] - p[0]) + (p[1] - a[1]) * (b[1] - p[1]);
          if (turn < 0 || (turn == 0 && along < 0)) side = false;  // a -> b is a whole side
        }
        if (side) sum += a[0] * b[1] - a[1] * b[0];
      }
    }
    return sum;
  }

  bool empty(const Tile& tile, const std::vector<At>& corners) const {
    for (const At p : points_) {
      bool corner = false, inside = false;
      for (const At c : corners) corner = corner || c == p;
      for (const Triangle& part : tile.parts) inside = inside || holds(part, p);
      if (inside && !corner) return false;
    }
    return true;
  }

  void find_tiles() {
    const std::size_t n = points_.size();
    for (std::size_t a = 0; a < n; ++a) {
      for (std::size_t b = a + 1; b < n; ++b) {
        for (std::size_t c = b + 1; c < n; ++c) {
          add_triangle(points_[a], points_[b], points_[c]);
          for (std::size_t d = c + 1; d < n; ++d) {
            add_quad({points_[a], points_[b], points_[c], points_[d]});
            add_quad({points_[a], points_[c], points_[b], points_[d]});
            add_quad({points_[a], points_[b], points_[d], points_[c]});
          }
        }
      }
    }
  }

  void add_triangle(At a, At b, At c) {
    Tile tile;
    tile.parts = {cross(a, b, c) > 0 ? Triangle{a, b, c} : Triangle{a, c, b}};
    tile.area = area(tile.parts[0]);
    if (tile.area > 0 && empty(tile, {a, b, c})) tiles_.push_back(tile);
  }

  /// The cycle, either way around, as two triangles beside a diagonal, if it is two such.
  void add_quad(std::vector<At> q) {
    for (int turned = 0; turned < 2; ++turned, q = {q[3], q[2], q[1], q[0]}) {
      for (std::size_t k = 0; k < 2; ++k) {
        Tile tile;
        tile.parts = {{q[k], q[k + 1], q[k + 2]}, {q[k], q[k + 2], q[(k + 3) % 4]}};
        if (area(tile.parts[0]) <= 0 || area(tile.parts[1]) <= 0) continue;
        tile.area = area(tile.parts[0]) + area(tile.parts[1]);
        tile.convex = true;
        for (std::size_t i = 0; i < 4; ++i) {
          tile.convex = tile.convex && cross(q[i], q[(i + 1) % 4], q[(i + 2) % 4]) > 0;
        }
        if (empty(tile, q)) tiles_.push_back(tile);
        return;
      }
    }
  }

  void extend(std::size_t from, std::bitset<kMostTiles> free, std::int64_t left, bool triangle,
              Tilings sum) {
    if (left == 0) {
      ++found_.count;
      found_.quads = sum.quads;
      found_.most_convex = std::max(found_.most_convex, sum.most_convex);
      return;
    }
    for (std::size_t i = from; i < tiles_.size(); ++i) {
      const bool is_triangle = tiles_[i].parts.size() == 1;
      if (!free[i] || tiles_[i].area > left || (is_triangle && triangle)) continue;
      Tilings with = sum;
      with.quads += is_triangle ? 0 : 1;
      with.most_convex += tiles_[i].convex ? 1 : 0;
      extend(i + 1, free & apart_[i], left - tiles_[i].area, triangle || is_triangle, with);
    }
  }

  std::vector<At> points_;
  std::vector<Tile> tiles_;
  std::array<std::bitset<kMostTiles>, kMostTiles> apart_;
  Tilings found_;
};

inline Tilings all_tilings(const std::vector<Point>& points) {
  return TilingSearch(points).count();
}

}  // namespace quadloom::testing
