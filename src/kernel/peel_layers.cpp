// Convex layers ("onion peeling"), band after band from the outside in.
//
// A layer does not depend on what is inside the hull of the points well inside. So the points are put into
// bands that are likely to be peeled one after the other; of all bands further in, their core, its hull
// alone takes part, until one of its points is peeled. What is worked on is small enough for the cache.
//
//   1. put_in_bands    between layers of a sample (layer_bands.hpp), each in lexicographic order
//   2. find_cores      the hull of all bands from each one on, from the innermost outwards
//   3. peel_bands      the next band or more and what is left of those before:
//                      points_outside   of the core's upper chain, with that chain, and of the lower one
//                      peel_with        chains of both, layer after layer, until a point of the core is
//                                       peeled: PeeledChain, or TreeChain if that has too much work
//
// A core's hull may have been peeled in part before its band is reached; then it is no use, and the next
// one is taken.
//
// Cost. The bands taken at once have as many points as are left of those before, or are the last; so the
// points worked on are 3 n in all. A core is only found if its hull has not more points than the
// bands since the core before: O(n). Peeling with hull trees is O(n log n) (hull_tree.hpp), and PeeledChain
// is given up where it takes longer than that: O(n log n) in all, whatever the bands (Chazelle 1985 has
// the bound; Hershberger and Suri 1992 the use of a deletion-only hull). For a million uniform points this
// takes a quarter of the time of two hull trees over all points; for a grid, where it is these that do
// the work, half as long again.
//
// Degenerate input: both chains keep collinear points, vertical runs included, so every boundary
// point belongs to the layer. If the rest lies on a line, both chains are the whole rest.
#include "kernel/peel_layers.hpp"

#include <algorithm>
#include <numeric>

#include "kernel/hull_tree.hpp"
#include "kernel/layer_bands.hpp"
#include "kernel/peeled_chain.hpp"
#include "kernel/predicates_inline.hpp"

namespace quadloom::kernel {
namespace {

using Places = std::vector<VertexId>;

// Places looked at by PeeledChain, for each one at the start and for each one that is peeled, where hull
// trees begin to be faster.
constexpr std::size_t kStartWork = 2;
constexpr std::size_t kPeelWork = 16;

/// PeeledChain by a hull tree over the places. A place that is removed with the other chain is
/// deleted here when it comes to light, for until then it hides nothing that matters.
class TreeChain {
 public:
  TreeChain(std::span<const Point> points, Places places, HullSide side)
      : places_(std::move(places)), points_(points_of(points, places_)), tree_(points_, side) {}

  void peel(const std::vector<char>& removed) {
    chain_.clear();
    for (VertexId p = tree_.first(); p != kNone;) {
      const VertexId place = places_[p];
      if (removed[place]) {
        p = tree_.erase(p);
      } else {
        chain_.push_back(place);
        p = tree_.next(p);
      }
    }
  }

  std::size_t size() const { return chain_.size(); }
  VertexId operator[](std::size_t i) const { return chain_[i]; }
  static std::size_t work() { return 0; }

 private:
  static std::vector<Point> points_of(std::span<const Point> points, const Places& places) {
    std::vector<Point> of;
    of.reserve(places.size());
    for (const VertexId place : places) of.push_back(points[place]);
    return of;
  }

  Places places_;
  std::vector<Point> points_;
  HullTree tree_;
  Places chain_;
};

class Peeling {
 public:
  Peeling(std::span<const Point> sorted, const Progress& progress, PeelingSizes sizes)
      : progress_(progress), removed_(sorted.size(), 0) {
    put_in_bands(sorted, sizes);
    find_cores();
  }

  ConvexLayers run() {
    layers_.vertex.reserve(points_.size());
    PeeledChain lower(points_, HullSide::kLower), upper(points_, HullSide::kUpper);
    while (layers_.vertex.size() < points_.size()) peel_bands(lower, upper);
    for (VertexId& v : layers_.vertex) v = sorted_place_[v];
    return std::move(layers_);
  }

 private:
  struct Chains {
    Places lower, upper;
  };

  void put_in_bands(std::span<const Point> sorted, PeelingSizes sizes) {
    begin_ = {0, static_cast<VertexId>(sorted.size())};
    sorted_place_.resize(sorted.size());
    if (sorted.size() < 4 * sizes.band) {
      points_.assign(sorted.begin(), sorted.end());
      std::iota(sorted_place_.begin(), sorted_place_.end(), VertexId{0});
      return;
    }
    std::vector<Point> sample;
    for (std::size_t i = sizes.sample / 2; i < sorted.size(); i += sizes.sample) {
      sample.push_back(sorted[i]);
    }
    const LayerBands bands =
        layer_bands(sorted, sample, peel_layers(sample, {}, sizes), sizes.band / sizes.sample);
    begin_.assign(bands.count + 2, 0);
    for (const std::uint32_t band : bands.of_point) ++begin_[band + 2];
    for (std::size_t b = 2; b < begin_.size(); ++b) begin_[b] += begin_[b - 1];
    points_.resize(sorted.size());
    for (VertexId i = 0; i < sorted.size(); ++i) {
      const VertexId place = begin_[bands.of_point[i] + 1]++;
      points_[place] = sorted[i];
      sorted_place_[place] = i;
    }
    begin_.pop_back();
  }

  std::size_t bands() const { return begin_.size() - 1; }
  bool less(VertexId a, VertexId b) const { return lex_less(points_[a], points_[b]); }

  /// What is left of bands [from, to), in lexicographic order.
  Places places_of(std::size_t from, std::size_t to) const {
    Places places;
    for (VertexId place = begin_[from]; place < begin_[to]; ++place) {
      if (!removed_[place]) places.push_back(place);
    }
    if (to - from > 1) {
      std::sort(places.begin(), places.end(), [&](VertexId a, VertexId b) { return less(a, b); });
    }
    return places;
  }

  Places merged(const Places& a, const Places& b) const {
    Places both(a.size() + b.size());
    std::merge(a.begin(), a.end(), b.begin(), b.end(), both.begin(),
               [&](VertexId p, VertexId q) { return less(p, q); });
    return both;
  }

  Places chain_of(const Places& places, int sign) const {
    Places chain;
    for (const VertexId c : places) {
      while (chain.size() >= 2 &&
             sign * orient(points_[chain.end()[-2]], points_[chain.back()], points_[c]) > 0) {
        chain.pop_back();
      }
      chain.push_back(c);
    }
    return chain;
  }

  void find_cores() {
    cores_.resize(bands() + 1);
    Chains core;
    std::size_t to = bands();
    for (std::size_t b = bands(); b-- > 1;) {
      if (begin_[to] - begin_[b] < core.lower.size() + core.upper.size()) continue;
      const Places places = places_of(b, to);
      core.lower = chain_of(merged(places, core.lower), -1);
      core.upper = chain_of(merged(places, core.upper), 1);
      cores_[b] = core;
      to = b;
    }
  }

  bool usable(const Chains& core) const {
    const auto left = [&](VertexId place) { return !removed_[place]; };
    return !core.lower.empty() && std::all_of(core.lower.begin(), core.lower.end(), left) &&
           std::all_of(core.upper.begin(), core.upper.end(), left);
  }

  void peel_bands(PeeledChain& lower, PeeledChain& upper) {
    const std::size_t from = next_band_;
    do {
      ++next_band_;
    } while (next_band_ < bands() &&
             (begin_[next_band_] - begin_[from] < rest_.size() || !usable(cores_[next_band_])));
    rest_ = merged(rest_, places_of(from, next_band_));
    const Chains& core = cores_[next_band_];
    Places below = points_outside(core.lower, -1), above = points_outside(core.upper, 1);
    bool done = false;
    if (!by_trees_) {
      lower.start(below);
      upper.start(above);
      done = peel_with(lower, upper, below.size() + above.size());
    }
    if (!done) {
      by_trees_ = true;
      keep_left(below);
      keep_left(above);
      TreeChain lower_tree(points_, std::move(below), HullSide::kLower);
      TreeChain upper_tree(points_, std::move(above), HullSide::kUpper);
      lower_tree.peel(removed_);
      upper_tree.peel(removed_);
      peel_with(lower_tree, upper_tree, 0);
    }
    keep_left(rest_);
  }

  void keep_left(Places& places) const {
    const auto gone = [&](VertexId place) { return removed_[place] != 0; };
    places.erase(std::remove_if(places.begin(), places.end(), gone), places.end());
  }

  /// The core's upper (sign 1) or lower chain and, of the rest, all but what is strictly on its
  /// inner side.
  Places points_outside(const Places& chain, int sign) const {
    Places places;
    std::size_t k = 0;  // places of the chain on the left
    for (const VertexId p : rest_) {
      while (k < chain.size() && less(chain[k], p)) places.push_back(chain[k++]);
      const bool beside = k == 0 || k == chain.size();
      const auto side = [&](Point a, Point b) { return sign * cross_filter(a, b, a, points_[p]); };
      if (beside || side(points_[chain[k - 1]], points_[chain[k]]) >= 0) places.push_back(p);
    }
    places.insert(places.end(), chain.begin() + static_cast<std::ptrdiff_t>(k), chain.end());
    return places;
  }

  /// Peels until a point of the core is peeled or none is left; false if that takes too much work.
  template <class Chain>
  bool peel_with(Chain& lower, Chain& upper, std::size_t at_start) {
    std::size_t most = kStartWork * at_start;
    while (lower.size() > 0) {
      report_progress(
          progress_, "convex layers",
          static_cast<double>(layers_.vertex.size()) / static_cast<double>(points_.size()));
      const std::size_t begin = layers_.vertex.size();
      append_layer(lower, upper);
      bool of_core = false;
      for (std::size_t i = begin; i < layers_.vertex.size(); ++i) {
        removed_[layers_.vertex[i]] = 1;
        of_core |= layers_.vertex[i] >= begin_[next_band_];
      }
      if (of_core) return true;
      most += kPeelWork * (layers_.vertex.size() - begin);
      if (lower.work() + upper.work() > most) return false;
      lower.peel(removed_);
      upper.peel(removed_);
    }
    return true;
  }

  /// The boundary of what both chains enclose.
  template <class Chain>
  void append_layer(const Chain& lower, const Chain& upper) {
    std::vector<VertexId>& out = layers_.vertex;
    for (std::size_t i = 0; i < lower.size(); ++i) out.push_back(lower[i]);
    const bool flat = lower.size() == 1 || lower[1] == upper[1];
    if (!flat) {
      for (std::size_t i = upper.size() - 1; i-- > 1;) out.push_back(upper[i]);
    }
    layers_.begin.push_back(static_cast<std::uint32_t>(out.size()));
  }

  const Progress& progress_;
  std::vector<Point> points_;           // band by band
  std::vector<VertexId> begin_;         // of each band
  std::vector<VertexId> sorted_place_;  // of each point
  std::vector<char> removed_;
  std::vector<Chains> cores_;  // of all bands from this one on; empty if not found
  Places rest_;                // of the bands before the next one
  std::size_t next_band_ = 0;
  bool by_trees_ = false;
  ConvexLayers layers_;
};

}  // namespace

ConvexLayers peel_layers(std::span<const Point> sorted, const Progress& progress,
                         PeelingSizes sizes) {
  return Peeling(sorted, progress, sizes).run();
}

}  // namespace quadloom::kernel
