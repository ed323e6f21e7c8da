// Every simple polygon with a few corners on a small grid, for exhaustive tests.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "quadloom/core.hpp"

namespace quadloom::testing {

/// Calls use(corners) for each simple counter-clockwise polygon with N corners on the width x width
/// grid, flat corners included, from its lexicographically smallest corner. Integers alone, nothing
/// of the library.
template <std::size_t N, class Use>
class GridPolygons {
 public:
  GridPolygons(int width, const Use& use) : width_(width), use_(use) {}

  void run() {
    for (corner_[0] = 0; corner_[0] < width_ * width_; ++corner_[0]) extend(1);
  }

 private:
  int x(int i) const { return i / width_; }
  int y(int i) const { return i % width_; }
  int turn(int a, int b, int c) const {
    const int cross = (x(b) - x(a)) * (y(c) - y(a)) - (y(b) - y(a)) * (x(c) - x(a));
    return (cross > 0) - (cross < 0);
  }
  bool on_segment(int a, int b, int p) const {
    return turn(a, b, p) == 0 && std::min(x(a), x(b)) <= x(p) && x(p) <= std::max(x(a), x(b)) &&
           std::min(y(a), y(b)) <= y(p) && y(p) <= std::max(y(a), y(b));
  }
  bool meet(int a, int b, int c, int d) const {
    return on_segment(a, b, c) || on_segment(a, b, d) || on_segment(c, d, a) ||
           on_segment(c, d, b) ||
           (turn(a, b, c) != turn(a, b, d) && turn(c, d, a) != turn(c, d, b));
  }
  bool turns_back(int a, int b, int c) const { return on_segment(a, b, c) || on_segment(b, c, a); }

  /// All ways to go on from corners 0 .. k - 1.
  void extend(std::size_t k) {
    if (k == N) {
      if (closes()) report();
      return;
    }
    for (int next = corner_[0] + 1; next < width_ * width_; ++next) {
      if (!fits(k, next)) continue;
      corner_[k] = next;
      extend(k + 1);
    }
  }

  bool fits(std::size_t k, int next) const {
    if (std::find(corner_.begin(), corner_.begin() + k, next) != corner_.begin() + k) return false;
    if (k >= 2 && turns_back(corner_[k - 2], corner_[k - 1], next)) return false;
    for (std::size_t j = 0; j + 2 < k; ++j) {
      if (meet(corner_[k - 1], next, corner_[j], corner_[j + 1])) return false;
    }
    return true;
  }

  bool closes() const {
    for (std::size_t j = 1; j + 2 < N; ++j) {
      if (meet(corner_[N - 1], corner_[0], corner_[j], corner_[j + 1])) return false;
    }
    int area = 0;
    for (std::size_t i = 0; i < N; ++i) {
      const int a = corner_[i], b = corner_[(i + 1) % N];
      area += x(a) * y(b) - x(b) * y(a);
    }
    return area > 0 && !turns_back(corner_[N - 2], corner_[N - 1], corner_[0]) &&
           !turns_back(corner_[N - 1], corner_[0], corner_[1]);
  }

  void report() const {
    std::array<Point, N> out;
    for (std::size_t i = 0; i < N; ++i) {
      out[i] = {static_cast<double>(x(corner_[i])), static_cast<double>(y(corner_[i]))};
    }
    use_(out);
  }

  int width_;
  const Use& use_;
  std::array<int, N> corner_{};
};

template <std::size_t N, class Use>
void for_each_grid_polygon(int width, const Use& use) {
  GridPolygons<N, Use>(width, use).run();
}

}  // namespace quadloom::testing
