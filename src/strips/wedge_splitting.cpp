// A triangle of the cycle is split by one of the points in it, and what comes of it in its turn, until
// no point is inside any (Arkin, Held, Mitchell and Skiena, theorem 3.1, figure 12):
//
//               a                  The cycle comes over a e and leaves over a f; between them it now
//             / | \.               visits  a e p (pivot e),  e f p (pivot p),  f a p (pivot f).
//        ->  /  p  \  ->           It crosses e p and p f, so no point may be on them; points on a p,
//           / /   \ \.             which it does not cross, wait there (Wedge::base) and cut the two
//          e --------- f           triangles beside it into fans at the end.
//
//   1. choose_splitter  at random (lemma 3.2), or as Avis and ElGindy (1987): among the middle third of
//                       the points by their angle at a the one nearest to e f. At most 2/3 of the points
//                       are on either side of a p, and at most 2/3 in e f p, where none of the others of
//                       the middle third is. The middle third is selected in linear time in the worst
//                       case (medians of medians, middle_third.hpp).
//   2. split            as above, if no point is on e p and p f. The cells of the points are found without a
//                       branch (CellFilter: half the time of asking one sign after the other)
//   3. split_by_chain   otherwise: all points b_1, b_2, ... on the ray from e (or f) through p at once.
//                       The cycle winds around the ray and crosses every piece of it:
//
//            a              A_i = a b_i b_i+1, F_i = f b_i b_i+1, with e for b_0; the cycle visits
//           /:\.            A_0 F_0 F_1 A_1 A_2 F_2 ... and at last the triangle a b_k f. It crosses b_i f
//          / : b2           for odd and b_i a for even i: if a point is on one of these, the chain ends
//         /  b1  \.         before b_i, and b_i and all after it stay in the last triangle
//        e --------- f
//
//   4. split_nearest    if that leaves no chain: by the point nearest to e f, whose edges to e and f no
//                       other can be on
//   5. emit             a triangle without points inside, as the fan of its pivot over its base
//
// Cost. Without three points on a line: O(n log n) in expectation with random splitters, in the worst
// case with balanced ones, whose nesting is at most log n / log(3/2) deep. With points on lines the
// bounds hold as long as most splitters are not blocked, or come with most of what blocks them, as is so
// in grids and on few lines; a proof for all sets there is not. No recursion: what is to do is a list.
#include "strips/wedge_splitting.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "kernel/predicates_inline.hpp"
#include "quadloom/kernel.hpp"
#include "strips/middle_third.hpp"

namespace quadloom::strips {
namespace {

using kernel::orient;

constexpr std::size_t kReportEvery = 1 << 12;  // wedges

class Splitting {
 public:
  Splitting(std::vector<Place>& places, const HamiltonianOptions& options, Random& random,
            SplittingStatistics& statistics)
      : places_(places), options_(options), random_(random), statistics_(statistics) {}

  std::vector<VertexId> run(const std::vector<Wedge>& wedges, std::size_t count) {
    corners_.reserve(3 * count);
    todo_.reserve(wedges.size() + 256);
    for (auto w = wedges.rbegin(); w != wedges.rend(); ++w) todo_.push_back({*w, 0});
    std::size_t done = 0;
    while (!todo_.empty()) {
      const Item item = todo_.back();
      todo_.pop_back();
      if (++done % kReportEvery == 0) {
        report_progress(options_.progress, "cycle",
                        static_cast<double>(corners_.size()) / (3 * static_cast<double>(count)));
      }
      statistics_.levels = std::max<std::size_t>(statistics_.levels, item.level);
      if (item.wedge.inside.empty()) {
        emit(item.wedge);
      } else {
        level_ = item.level + 1;
        choose_splitter(item.wedge);
        if (!split(item.wedge) && !split_by_chain(item.wedge)) split_nearest(item.wedge);
      }
    }
    return std::move(corners_);
  }

 private:
  struct Item {
    Wedge wedge;
    std::uint32_t level = 0;
  };
  enum Cell : std::uint32_t { kFrom, kMiddle, kTo, kOnPivot, kOnFrom, kOnTo, kCells };

  /// The cell of most points without a branch: the three signs that tell cells apart, if all are certain.
  /// One bound for all points, which are in the triangle's box (kernel::cross_bound).
  class CellFilter {
   public:
    CellFilter(const Wedge& w, int s, Point p)
        : p_(p),
          flip_(s > 0 ? 0U : 7U),
          pivot_(to(w.pivot.at)),
          from_(to(w.from.at)),
          to_(to(w.to.at)) {
      const auto [left, right] = std::minmax({w.pivot.at.x, w.from.at.x, w.to.at.x});
      const auto [low, high] = std::minmax({w.pivot.at.y, w.from.at.y, w.to.at.y});
      bound_ = kernel::cross_bound({left, low}, {right, high});
    }

    /// kCells if not certain.
    std::uint32_t cell(Point q) const {
      constexpr std::array<std::uint32_t, 8> kOfSigns = {kMiddle, kTo,   kMiddle, kTo,
                                                         kFrom,   kFrom, kMiddle, kMiddle};
      const Point d = to(q);
      const double pivot = side(pivot_, d), from = side(from_, d), to = side(to_, d);
      const double least = std::min({std::fabs(pivot), std::fabs(from), std::fabs(to)});
      const unsigned signs = (pivot > 0 ? 4U : 0U) | (from > 0 ? 2U : 0U) | (to > 0 ? 1U : 0U);
      return least > bound_ ? kOfSigns[signs ^ flip_] : static_cast<std::uint32_t>(kCells);
    }

   private:
    Point to(Point q) const { return {q.x - p_.x, q.y - p_.y}; }
    static double side(Point a, Point b) { return a.x * b.y - a.y * b.x; }

    Point p_;
    unsigned flip_;
    Point pivot_, from_, to_;
    double bound_;
  };

  std::span<Place> inside(const Wedge& w) {
    return {places_.data() + w.inside.begin, places_.data() + w.inside.end};
  }

  /// +1 if the wedge's pivot, from, to turn left.
  static int turn(const Wedge& w) { return orient(w.pivot.at, w.from.at, w.to.at); }

  /// Brings the splitter to the front of the points inside.
  void choose_splitter(const Wedge& w) {
    const std::span<Place> points = inside(w);
    if (options_.splitter == Splitter::kRandom) {
      std::swap(points.front(), points[random_.below(points.size())]);
      return;
    }
    const int s = turn(w);
    const Point a = w.pivot.at;
    const std::span<Place> middle = middle_third(
        points, [&](const Place& p, const Place& q) { return orient(a, p.at, q.at) == s; });
    std::swap(points.front(), nearest_to_base(w, middle));
  }

  /// The first of those nearest to the line of the base; at least one point.
  static Place& nearest_to_base(const Wedge& w, std::span<Place> points) {
    const int s = turn(w);
    Place* best = points.data();
    for (Place& p : points) {
      if (cross_sign(w.from.at, w.to.at, best->at, p.at) * s < 0) best = &p;
    }
    return *best;
  }

  /// Where q is in the triangle that p splits, w turning left if s is 1.
  static Cell cell_of(const Wedge& w, int s, Point p, Point q) {
    const int of_pivot = s * orient(p, w.pivot.at, q);
    if (of_pivot > 0) {
      const int of_from = s * orient(p, w.from.at, q);
      return of_from < 0 ? kFrom : of_from == 0 ? kOnFrom : kMiddle;
    }
    if (of_pivot < 0) {
      const int of_to = s * orient(p, w.to.at, q);
      return of_to > 0 ? kTo : of_to == 0 ? kOnTo : kMiddle;
    }
    return s * orient(p, w.from.at, q) < 0 ? kOnPivot : kMiddle;
  }

  /// cell_of for all places of `rest`, and how many there are in each cell.
  void locate(const Wedge& w, int s, Point p, Range rest) {
    cell_.resize(rest.size());
    count_ = {};
    const CellFilter filter(w, s, p);
    for (std::uint32_t i = 0; i < rest.size(); ++i) {
      const Point q = places_[rest.begin + i].at;
      std::uint32_t cell = filter.cell(q);
      if (cell == kCells) cell = cell_of(w, s, p, q);
      cell_[i] = cell;
      ++count_[cell];
    }
    statistics_.locations += rest.size();
  }

  /// By the point at the front; false, and nothing done, if points are on the edges to be crossed.
  bool split(const Wedge& w) {
    const Place p = places_[w.inside.begin];
    const Range rest = {w.inside.begin + 1, w.inside.end};
    locate(w, turn(w), p.at, rest);
    blocked_ = {count_[kOnFrom] != 0, count_[kOnTo] != 0};
    if (blocked_[0] || blocked_[1]) return false;
    sort_into_cells(places_, rest, cell_, kCells, begin_, buffer_);
    sort_along(places_, range(kOnPivot));
    add({w.to, p, w.pivot, range(kTo), range(kOnPivot)});
    add({p, w.from, w.to, range(kMiddle), w.base});
    add({w.from, w.pivot, p, range(kFrom), range(kOnPivot)});
    return true;
  }

  Range range(std::size_t cell) const { return {begin_[cell], begin_[cell + 1]}; }
  void add(const Wedge& w) { todo_.push_back({w, level_}); }

  void split_nearest(const Wedge& w) {
    std::swap(places_[w.inside.begin], nearest_to_base(w, inside(w)));
    split(w);
  }

  /// After split() found points between the splitter and an end of the base.
  bool split_by_chain(const Wedge& w) {
    ++statistics_.chains;
    chain_cells_.clear();
    if (!blocked_[0]) {  // the ray is from `to`: the same with the cycle going the other way
      if (!cut_by_chain(reversed(w))) return false;
      for (auto c = chain_cells_.begin(); c != chain_cells_.end(); ++c) add(reversed(*c));
    } else {
      if (!cut_by_chain(w)) return false;
      for (auto c = chain_cells_.rbegin(); c != chain_cells_.rend(); ++c) add(*c);
    }
    return true;
  }

  /// The number of b_1 ... b_k that the ray from `centre` through p is not before, when they are seen
  /// in this order and s = 1 is a turn to the left; `on` if p is on the last of them.
  std::uint32_t rib_of(Point centre, int s, Point p, bool& on) const {
    std::uint32_t low = 0, high = static_cast<std::uint32_t>(chain_.size()) + 1;
    on = false;
    while (high - low > 1) {
      const std::uint32_t middle = low + (high - low) / 2;
      const int side = s * orient(centre, chain_[middle - 1].at, p);
      if (side >= 0) {
        low = middle;
        on = side == 0;
      } else {
        high = middle;
      }
    }
    return low;
  }

  /// Takes the points on the ray from `from` through the splitter out, the nearest first; the others
  /// stay in front of them.
  Range take_chain(const Wedge& w) {
    const Point e = w.from.at;
    const Point p = places_[w.inside.begin].at;
    const auto begin = places_.begin() + w.inside.begin;
    const auto end = places_.begin() + w.inside.end;
    const auto first =
        std::partition(begin, end, [&](const Place& q) { return orient(e, p, q.at) != 0; });
    const bool ascending = lex_less(e, p);
    std::sort(first, end, [&](const Place& a, const Place& b) {
      return ascending ? lex_less(a.at, b.at) : lex_less(b.at, a.at);
    });
    chain_.assign(first, end);
    return {w.inside.begin, static_cast<std::uint32_t>(first - places_.begin())};
  }

  //  Cells of the points beside the chain: 2 c for A_c, 2 c + 1 for F_c, c < k; then the last triangle,
  //  then the ribs b_1 ... b_k that the cycle does not cross.
  bool cut_by_chain(const Wedge& w) {
    const Range rest = take_chain(w);
    const int s = turn(w);
    const auto all = static_cast<std::uint32_t>(chain_.size());
    // Per point: 4 times its rib, plus 2 if on it, plus 1 if on f's side.
    cell_.resize(rest.size());
    std::uint32_t kept = all;
    for (std::uint32_t i = 0; i < rest.size(); ++i) {
      const Point q = places_[rest.begin + i].at;
      const bool beside_to = s * orient(w.from.at, chain_[0].at, q) < 0;
      const Point apex = beside_to ? w.to.at : w.pivot.at;
      bool on = false;
      const std::uint32_t rib = rib_of(apex, beside_to ? -s : s, q, on);
      cell_[i] = 4 * rib + (on ? 2 : 0) + (beside_to ? 1 : 0);
      const bool crossed = beside_to == (rib % 2 == 1);
      if (on && crossed) kept = std::min(kept, rib - 1);
    }
    statistics_.locations += rest.size();
    if (kept == 0) return false;
    const std::uint32_t last = 2 * kept;
    for (std::uint32_t& c : cell_) {
      const std::uint32_t rib = c / 4;
      const bool on = (c & 2U) != 0;
      c = on && rib <= kept ? last + rib : rib >= kept ? last : 2 * rib + (c & 1U);
    }
    // What is left of the chain goes into the last triangle, after the others.
    for (std::uint32_t i = kept; i < all; ++i) cell_.push_back(last);
    std::copy(chain_.begin() + kept, chain_.end(), places_.begin() + rest.end);
    std::copy(chain_.begin(), chain_.begin() + kept, places_.begin() + rest.end + (all - kept));
    sort_into_cells(places_, {rest.begin, rest.end + (all - kept)}, cell_, last + kept + 1, begin_,
                    buffer_);
    for (std::uint32_t rib = 1; rib <= kept; ++rib) sort_along(places_, range(last + rib));
    wind_around_chain(w, kept);
    return true;
  }

  void wind_around_chain(const Wedge& w, std::uint32_t kept) {
    const Place a = w.pivot, f = w.to;
    const auto b = [&](std::uint32_t i) -> const Place& { return i == 0 ? w.from : chain_[i - 1]; };
    const auto rib = [&](std::uint32_t i) { return i == 0 ? Range{} : range(2 * kept + i); };
    for (std::uint32_t i = 0; i < kept; ++i) {
      const Range of_a = range(2 * i), of_f = range(2 * i + 1);
      const Range to_f = i == 0 ? w.base : rib(i);
      if (i % 2 == 0) {
        chain_cells_.push_back({b(i), a, b(i + 1), of_a, rib(i + 1)});
        chain_cells_.push_back({b(i + 1), b(i), f, of_f, to_f});
      } else {
        chain_cells_.push_back({b(i), f, b(i + 1), of_f, rib(i + 1)});
        chain_cells_.push_back({b(i + 1), b(i), a, of_a, rib(i)});
      }
    }
    const Range last = range(2 * kept);
    if (kept % 2 == 1) {
      chain_cells_.push_back({f, b(kept), a, last, rib(kept)});
    } else {
      chain_cells_.push_back({a, b(kept), f, last, rib(kept)});
    }
  }

  /// Fan of the pivot over the points on the base.
  void emit(const Wedge& w) {
    const bool left = turn(w) > 0;
    VertexId before = w.from.vertex;
    const auto add_triangle = [&](VertexId v) {
      corners_.insert(corners_.end(), {w.pivot.vertex, left ? before : v, left ? v : before});
      before = v;
    };
    const bool ascending = lex_less(w.from.at, w.to.at);
    for (std::uint32_t i = 0; i < w.base.size(); ++i) {
      add_triangle(places_[ascending ? w.base.begin + i : w.base.end - 1 - i].vertex);
    }
    add_triangle(w.to.vertex);
  }

  std::vector<Place>& places_;
  const HamiltonianOptions& options_;
  Random& random_;
  SplittingStatistics& statistics_;
  std::vector<Item> todo_;  // the next in the cycle's order on top
  std::uint32_t level_ = 0;
  std::vector<std::uint32_t> cell_, begin_;
  std::array<std::uint32_t, kCells> count_ = {};
  std::array<bool, 2> blocked_ = {};  // towards `from`, towards `to`
  std::vector<Place> buffer_, chain_;
  std::vector<Wedge> chain_cells_;  // in the order of the cycle
  std::vector<VertexId> corners_;
};

}  // namespace

std::vector<VertexId> split_wedges(const std::vector<Wedge>& wedges, std::vector<Place>& places,
                                   std::size_t count, const HamiltonianOptions& options,
                                   Random& random, SplittingStatistics& statistics) {
  return Splitting(places, options, random, statistics).run(wedges, count);
}

}  // namespace quadloom::strips
