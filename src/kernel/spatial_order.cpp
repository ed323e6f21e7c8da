// A permutation along a Hilbert curve, equal points next to each other.
//
// Steps:
//   1. keyed       each point's cell in a grid of 2^16 x 2^16 over the bounding box, numbered along
//                  the curve; beside it the point's index, both in one 64-bit word
//   2. sort_keys   stable, so that equal keys stay in the order of their indices
//   3. refine      each run of equal keys: a short one is sorted lexicographically; a long one (a
//                  cluster, or many decades of coordinates) goes through 1 to 3 over its own box
//
// The keys steer locality alone: a rounded key is as good as any, since equal points have equal
// keys and every run is told apart by the coordinates themselves.
//
// Degenerate input: all points equal, on a line, over the whole range of doubles.
// Cost: O(n) for each round of refinement. A round parts the extremes of its run, and what stays
// together shrinks by 2^16, so there are at most 2 * 2100 / 16 rounds, in practice one or two.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "kernel/hilbert.hpp"
#include "quadloom/kernel.hpp"

namespace quadloom {
namespace {

constexpr std::size_t kShortRun = 32;     // sorted by comparisons of coordinates
constexpr std::size_t kRadixSort = 4096;  // from this size on, counting beats comparing
constexpr unsigned kDigit = 11;           // three digits for a key of 32 bits
constexpr std::size_t kTwoDigits = std::size_t{1} << 20;
constexpr std::size_t kBuckets = std::size_t{1} << kDigit;

using Word = std::uint64_t;  // key << 32 | index

std::uint32_t key_of(Word w) { return static_cast<std::uint32_t>(w >> 32); }
VertexId index_of(Word w) { return static_cast<VertexId>(w); }

/// Maps coordinates to cells: monotone in each coordinate, the same scale for both.
class Grid {
 public:
  void include(Point p) {
    low_.x = std::min(low_.x, p.x);
    low_.y = std::min(low_.y, p.y);
    high_.x = std::max(high_.x, p.x);
    high_.y = std::max(high_.y, p.y);
  }

  /// To be called after the last include. False if the box is a single point.
  bool finish() {
    if (low_.x == high_.x && low_.y == high_.y) return false;
    const auto extent = [&] {
      return std::max(high_.x * pre_ - low_.x * pre_, high_.y * pre_ - low_.y * pre_);
    };
    if (!(extent() < 0x1p1000)) pre_ = 0x1p-100;
    if (extent() < 0x1p-900) pre_ = 0x1p300;  // the coordinates are then below 2^-800
    scale_ = 65535.999 / extent();
    low_ = {low_.x * pre_, low_.y * pre_};
    return true;
  }

  std::uint32_t key(Point p) const {
    return kernel::hilbert_position(cell(p.x * pre_ - low_.x), cell(p.y * pre_ - low_.y));
  }

 private:
  std::uint32_t cell(double offset) const {
    return static_cast<std::uint32_t>(std::min(offset * scale_, 65535.0));
  }

  Point low_ = {HUGE_VAL, HUGE_VAL}, high_ = {-HUGE_VAL, -HUGE_VAL};
  double pre_ = 1;  // a power of two that keeps the extent away from overflow and underflow
  double scale_ = 1;
};

class SpatialSort {
 public:
  explicit SpatialSort(std::span<const Point> points) : points_(points) {}

  std::vector<VertexId> run() {
    const std::size_t n = points_.size();
    words_.resize(n);
    for (std::size_t i = 0; i < n; ++i) words_[i] = i;
    scratch_.resize(n);
    pending_.push_back({0, n});
    while (!pending_.empty()) {
      const Run r = pending_.back();
      pending_.pop_back();
      refine(r);
    }
    std::vector<VertexId> order(n);
    for (std::size_t i = 0; i < n; ++i) order[i] = index_of(words_[i]);
    return order;
  }

 private:
  struct Run {
    std::size_t begin, end;
  };

  /// Sorts a run of words (equal keys, indices ascending), leaving long ties pending.
  void refine(Run r) {
    if (r.end - r.begin <= kShortRun) {
      sort_by_coordinates(r);
    } else if (keyed(r)) {
      sort_keys(r);
      split(r);
    }
  }

  void sort_by_coordinates(Run r) {
    const auto less = [this](Word u, Word v) {
      const Point p = points_[index_of(u)], q = points_[index_of(v)];
      return p == q ? index_of(u) < index_of(v) : lex_less(p, q);
    };
    std::sort(words_.begin() + static_cast<std::ptrdiff_t>(r.begin),
              words_.begin() + static_cast<std::ptrdiff_t>(r.end), less);
  }

  bool keyed(Run r) {
    Grid grid;
    for (std::size_t i = r.begin; i < r.end; ++i) grid.include(points_[index_of(words_[i])]);
    if (!grid.finish()) return false;
    for (std::size_t i = r.begin; i < r.end; ++i) {
      const VertexId v = index_of(words_[i]);
      words_[i] = Word{grid.key(points_[v])} << 32 | v;
    }
    return true;
  }

  // By counting, least digit first. Up to a million points the upper 22 bits of the key part nearly
  // all of them, and two passes are enough; the runs that they leave are sorted by comparing.
  void sort_keys(Run r) {
    const auto begin = words_.begin() + static_cast<std::ptrdiff_t>(r.begin);
    const auto end = words_.begin() + static_cast<std::ptrdiff_t>(r.end);
    if (r.end - r.begin < kRadixSort) {
      std::sort(begin, end);
    } else if (r.end - r.begin <= kTwoDigits) {
      sort_by_digits<2>(r, 64 - 2 * kDigit);
      for (auto i = begin; i != end;) {
        const Word upper = *i >> (64 - 2 * kDigit);
        auto j = i + 1;
        while (j != end && *j >> (64 - 2 * kDigit) == upper) ++j;
        if (j - i > 1) std::sort(i, j);
        i = j;
      }
    } else {
      sort_by_digits<3>(r, 32);
    }
  }

  template <unsigned kDigits>
  void sort_by_digits(Run r, unsigned lowest) {
    const auto digit = [lowest](Word w, unsigned d) {
      return w >> (lowest + d * kDigit) & (kBuckets - 1);
    };
    const std::size_t n = r.end - r.begin;
    Word *from = words_.data() + r.begin, *to = scratch_.data();
    std::array<std::array<std::uint32_t, kBuckets>, kDigits> count{};
    for (std::size_t i = 0; i < n; ++i) {
      for (unsigned d = 0; d < kDigits; ++d) ++count[d][digit(from[i], d)];
    }
    for (unsigned d = 0; d < kDigits; ++d) {
      std::uint32_t sum = 0;
      for (std::uint32_t& c : count[d]) sum += std::exchange(c, sum);
      for (std::size_t i = 0; i < n; ++i) to[count[d][digit(from[i], d)]++] = from[i];
      std::swap(from, to);
    }
    if (kDigits % 2 == 1) std::copy(from, from + n, to);  // the words ended in the scratch
  }

  void split(Run r) {
    for (std::size_t i = r.begin; i < r.end;) {
      std::size_t j = i + 1;
      while (j < r.end && key_of(words_[j]) == key_of(words_[i])) ++j;
      if (j - i > kShortRun) {
        pending_.push_back({i, j});
      } else if (j - i > 1) {
        sort_by_coordinates({i, j});
      }
      i = j;
    }
  }

  std::span<const Point> points_;
  std::vector<Word> words_, scratch_;
  std::vector<Run> pending_;
};

}  // namespace

std::vector<VertexId> spatial_order(std::span<const Point> points) {
  return SpatialSort(points).run();
}

}  // namespace quadloom
