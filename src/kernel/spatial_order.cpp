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

#include "core/large_array.hpp"
#include "core/parallel.hpp"
#include "kernel/hilbert.hpp"
#include "quadloom/kernel.hpp"

namespace quadloom {
namespace {

constexpr std::size_t kShortRun = 32;     // sorted by comparisons of coordinates
constexpr std::size_t kRadixSort = 4096;  // from this size on, counting beats comparing
constexpr unsigned kDigit = 11;           // three digits for a key of 32 bits
constexpr std::size_t kTwoDigits = std::size_t{1} << 20;
constexpr std::size_t kBuckets = std::size_t{1} << kDigit;
constexpr std::size_t kBlock = std::size_t{1} << 16;  // of a long run, for a thread
constexpr std::size_t kMostBlocks = 64;               // that sort_by_digits counts by themselves

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

  void include(const Grid& other) {
    include(other.low_);
    include(other.high_);
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
    parallel_invoke([&] { words_ = large_vector<Word>(n); },
                    [&] { scratch_ = large_vector<Word>(n); });
    parallel_for_blocks(n, kBlock, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) words_[i] = i;
    });
    pending_.push_back({0, n});
    while (!pending_.empty()) {
      const Run r = pending_.back();
      pending_.pop_back();
      refine(r);
    }
    auto order = large_vector<VertexId>(n);
    parallel_for_blocks(n, kBlock, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) order[i] = index_of(words_[i]);
    });
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
    std::vector<Grid> part((r.end - r.begin - 1) / kBlock + 1);
    parallel_for_blocks(r.end - r.begin, kBlock, [&](std::size_t begin, std::size_t end) {
      Grid own;  // its corners stay in registers
      for (std::size_t i = r.begin + begin; i < r.begin + end; ++i) {
        own.include(points_[index_of(words_[i])]);
      }
      part[begin / kBlock] = own;
    });
    Grid grid;
    for (const Grid& p : part) grid.include(p);
    if (!grid.finish()) return false;
    parallel_for_blocks(r.end - r.begin, kBlock, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = r.begin + begin; i < r.begin + end; ++i) {
        const VertexId v = index_of(words_[i]);
        words_[i] = Word{grid.key(points_[v])} << 32 | v;
      }
    });
    return true;
  }

  // By counting, least digit first. Up to a million points the upper 22 bits of the key part nearly
  // all of them, and two passes are enough; the runs that they leave are sorted by comparing.
  void sort_keys(Run r) {
    if (r.end - r.begin < kRadixSort) {
      std::sort(words_.begin() + static_cast<std::ptrdiff_t>(r.begin),
                words_.begin() + static_cast<std::ptrdiff_t>(r.end));
    } else if (r.end - r.begin <= kTwoDigits) {
      constexpr unsigned kLowest = 64 - 2 * kDigit;
      sort_by_digits<2>(r, kLowest);
      sort_runs(r, kLowest);
    } else {
      sort_by_digits<3>(r, 32);
    }
  }

  /// Sorts each run of equal bits from `lowest` on. The blocks end where runs end.
  void sort_runs(Run r, unsigned lowest) {
    Word* const words = words_.data();
    const auto end_of_run = [words, lowest](std::size_t i, std::size_t end) {
      const Word upper = words[i] >> lowest;
      do ++i;
      while (i < end && words[i] >> lowest == upper);
      return i;
    };
    std::vector<std::size_t> cut = {r.begin};
    while (cut.back() < r.end) {
      cut.push_back(end_of_run(std::min(cut.back() + kBlock, r.end) - 1, r.end));
    }
    parallel_tasks(cut.size() - 1, [&](std::size_t block) {
      for (std::size_t i = cut[block], j = i; i < cut[block + 1]; i = j) {
        j = end_of_run(i, cut[block + 1]);
        if (j - i > 1) std::sort(words + i, words + j);
      }
    });
  }

  using Counts = std::array<std::uint32_t, kBuckets>;

  // Each block counts its digits; the sums over buckets, and in a bucket over blocks, are the places
  // where each block puts its words.
  template <unsigned kDigits>
  void sort_by_digits(Run r, unsigned lowest) {
    const std::size_t n = r.end - r.begin;
    const std::size_t block = std::max(kBlock, n / kMostBlocks + 1);
    Word *from = words_.data() + r.begin, *to = scratch_.data();
    std::vector<Counts> place((n - 1) / block + 1);
    for (unsigned d = 0; d < kDigits; ++d) {
      const auto digit = [shift = lowest + d * kDigit](Word w) {
        return w >> shift & (kBuckets - 1);
      };
      parallel_for_blocks(n, block, [&](std::size_t begin, std::size_t end) {
        Counts& count = place[begin / block];
        count.fill(0);
        for (std::size_t i = begin; i < end; ++i) ++count[digit(from[i])];
      });
      std::uint32_t sum = 0;
      for (std::size_t bucket = 0; bucket < kBuckets; ++bucket) {
        for (Counts& count : place) sum += std::exchange(count[bucket], sum);
      }
      parallel_for_blocks(n, block, [&](std::size_t begin, std::size_t end) {
        Counts& next = place[begin / block];
        for (std::size_t i = begin; i < end; ++i) to[next[digit(from[i])]++] = from[i];
      });
      std::swap(from, to);
    }
    if (kDigits % 2 == 1) {  // the words ended in the scratch
      parallel_for_blocks(n, block, [&](std::size_t begin, std::size_t end) {
        std::copy(from + begin, from + end, to + begin);
      });
    }
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
