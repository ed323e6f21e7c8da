// The first triangles of a Hamiltonian cycle: the hull's points seen from an inner point, and from
// more of them where others are in the way.
//
// The paper joins any inner point v to the hull's points. Where points lie on such an edge, a spoke,
// it would not do: the cycle crosses the spoke, and with points on a crossed edge it can get stuck
// (see points_hamiltonian.cpp). So a run of such dirty spokes between two clean ones gets a centre of
// its own, q, and v - q is an edge that the cycle does not cross and on which points may lie:
//
//     u_i ---- * ---- u_j           the cycle: ... v u_i q, the fan of q from u_i to u_j, q u_j v ...
//       \ \    |    / /
//        \  \  |  /  /              q's own spokes may be dirty again: its fan is treated in the
//         \   \q/   /               same way. q is chosen so that q - u_i and q - u_j are clean: no
//          \   |   /                point is nearer to the line u_i u_j on q's side of it.
//           \  |  /
//            \ | /
//              v
//
//   1. locate        the points of a fan by its spokes: in a sector between two spokes, or on one
//   2. treat_fan     clean sectors are wedges; each run of dirty spokes is handed to
//   3. choose_centre the point on the middle one of the dirty spokes that is nearest to the hull, if
//                    it is joined to u_i and u_j by clean spokes; else, if the run is less than half
//                    a turn, the nearest point beyond the chord u_i u_j, the nearest before it, or the
//                    only one on it; and
//   4. add_centre    two wedges beside v - q and the fan of q, to be treated in its turn
//
// Not every set has a Hamiltonian cycle triangulation, even with points inside the hull. The corners
// a, b, c of a triangle and a pinwheel of three inner points, p on the segment from a to q, q on the
// one from b to r, r on the one from c to p, have a single triangulation:
//
//          c              seven triangles: p q r; three at the sides (a b q, b c r, c a p); and three
//         / \.            more (a q p, b r q, c p r). Each edge inside joins one of the first four to
//        / r \.           one of the last three, so that a cycle would have as many of both. It has a
//       / p q \.          path.
//      a-------b
//
// Nor does this search find all that there are: where no centre is found or the fans are nested too
// deeply it tries another v (all of them in small sets; in big ones some at random and some near the
// hull). Cost: O(m log h) for m inner points, a try and a level of nesting.
#include "strips/hamiltonian_start.hpp"

#include <algorithm>

#include "kernel/predicates_inline.hpp"
#include "quadloom/kernel.hpp"

namespace quadloom::strips {
namespace {

using kernel::orient;

constexpr std::size_t kAllTried = 64;      // inner points up to which each is tried as v
constexpr std::size_t kSomeTried = 24;     // of more
constexpr std::uint32_t kMostNested = 64;  // fans in fans; keeps the cost near-linear

/// Which centre a run gets if there are several.
enum class Prefer { kOnSpoke, kBeyondChord, kBeforeChord };

/// The triangles that `centre` makes with the hull's edges from hull point `first` to `last`, numbers
/// that may go past the end and around. first + h == last: all of them.
struct Fan {
  Place centre;
  std::uint32_t first = 0, last = 0;
  Range inside;
  std::uint32_t depth = 0;
};

class Start {
 public:
  Start(std::span<const Place> hull, std::vector<Place>& inner) : hull_(hull), inner_(inner) {}

  bool try_centre(std::uint32_t v, Prefer prefer) {
    wedges_.clear();
    todo_.clear();
    prefer_ = prefer;
    centres_ = 0;
    std::swap(inner_[v], inner_.back());
    const auto count = static_cast<std::uint32_t>(inner_.size());
    todo_.push_back(
        {{}, {inner_.back(), 0, static_cast<std::uint32_t>(hull_.size()), {0, count - 1}, 0}});
    while (!todo_.empty()) {
      const Item item = todo_.back();
      todo_.pop_back();
      if (item.wedge) {
        wedges_.push_back(*item.wedge);
      } else if (!treat_fan(item.fan)) {
        return false;
      }
    }
    return true;
  }

  CycleStart take() { return {std::move(wedges_), centres_}; }

 private:
  /// What is to do, the next in the order of the cycle on top: a wedge that is done, or a fan.
  struct Item {
    std::optional<Wedge> wedge;
    Fan fan;
  };

  const Place& hull(std::uint32_t i) const { return hull_[i % hull_.size()]; }

  /// Whether p is less than half a turn counter-clockwise of the direction to the first spoke.
  static bool in_first_half(Point centre, Point spoke, Point p) {
    const int side = orient(centre, spoke, p);
    return side > 0 || (side == 0 && dot_sign(centre, spoke, centre, p) > 0);
  }

  /// 2 i: on spoke i from the first; 2 i + 1: between it and the next.
  void locate(const Fan& fan, std::vector<std::uint32_t>& cell) const {
    const Point c = fan.centre.at;
    const Point first = hull(fan.first).at;
    const std::uint32_t spokes =
        fan.last - fan.first == hull_.size() ? fan.last - fan.first : fan.last - fan.first + 1;
    std::uint32_t half = 1;  // spokes before it are in the first half
    while (half < spokes && in_first_half(c, first, hull(fan.first + half).at)) ++half;
    cell.clear();
    for (std::uint32_t i = fan.inside.begin; i < fan.inside.end; ++i) {
      const Point p = inner_[i].at;
      const bool front = in_first_half(c, first, p);
      std::uint32_t low = front ? 0 : half - 1;  // p is on or after this spoke
      std::uint32_t high = front ? half : spokes;
      bool on_low = front && orient(c, first, p) == 0;
      while (high - low > 1) {
        const std::uint32_t middle = low + (high - low) / 2;
        const int side = orient(c, hull(fan.first + middle).at, p);
        if (side >= 0) {
          low = middle;
          on_low = side == 0;
        } else {
          high = middle;
        }
      }
      cell.push_back(2 * low + (on_low ? 0 : 1));
    }
  }

  bool treat_fan(Fan fan) {
    if (fan.depth > kMostNested) return false;
    ++centres_;
    std::vector<std::uint32_t> cell;
    locate(fan, cell);
    const std::uint32_t sectors = fan.last - fan.first;
    std::vector<char> dirty(sectors + 1, 0);
    for (const std::uint32_t c : cell) {
      if (c % 2 == 0) dirty[c / 2] = 1;
    }
    if (sectors == hull_.size()) {  // around: begin with a clean spoke
      const auto clean =
          static_cast<std::uint32_t>(std::find(dirty.begin(), dirty.end() - 1, 0) - dirty.begin());
      if (clean == sectors) return false;
      std::rotate(dirty.begin(), dirty.begin() + clean, dirty.end() - 1);
      for (std::uint32_t& c : cell) c = (c + 2 * (sectors - clean)) % (2 * sectors);
      fan.first += clean;
      fan.last += clean;
    }
    std::vector<std::uint32_t> begin;
    sort_into_cells(inner_, fan.inside, cell, 2 * sectors, begin, buffer_);
    const std::size_t top = todo_.size();
    for (std::uint32_t i = 0; i < sectors;) {
      std::uint32_t j = i + 1;
      while (dirty[j]) ++j;
      const Range inside = {begin[2 * i], begin[2 * j]};
      if (j == i + 1) {
        todo_.push_back(
            {Wedge{fan.centre, hull(fan.first + i), hull(fan.first + j), inside, {}}, {}});
      } else {
        const std::uint32_t middle = i + (j - i) / 2;
        const Range on_spoke = {begin[2 * middle], begin[2 * middle + 1]};
        const Fan run = {fan.centre, fan.first + i, fan.first + j, inside, fan.depth};
        if (!add_centre(run, on_spoke)) return false;
      }
      i = j;
    }
    std::reverse(todo_.begin() + static_cast<std::ptrdiff_t>(top), todo_.end());
    return true;
  }

  /// The point on the spoke that is farthest from the run's centre, if no point of the run is on the
  /// way from there to its first and its last hull point; else kNone.
  std::uint32_t farthest_on_spoke(const Fan& run, Range spoke) const {
    const Point v = run.centre.at;
    const Point a = hull(run.first).at;
    const Point b = hull(run.last).at;
    std::uint32_t far = spoke.begin;
    for (std::uint32_t i = spoke.begin; i < spoke.end; ++i) {
      if (lex_less(v, inner_[i].at) == lex_less(inner_[far].at, inner_[i].at)) far = i;
    }
    const Point q = inner_[far].at;
    if (orient(v, a, q) <= 0 || orient(v, q, b) <= 0) return kNone;
    const auto in_the_way = [&](Point p, Point end) {
      return orient(q, end, p) == 0 && dot_sign(p, q, p, end) < 0;
    };
    for (std::uint32_t i = run.inside.begin; i < run.inside.end; ++i) {
      if (in_the_way(inner_[i].at, a) || in_the_way(inner_[i].at, b)) return kNone;
    }
    return far;
  }

  /// The index of the centre for a run, or kNone.
  std::uint32_t choose_centre(const Fan& run, Range spoke) const {
    if (prefer_ == Prefer::kOnSpoke) {
      if (const std::uint32_t far = farthest_on_spoke(run, spoke); far != kNone) return far;
    }
    const Point a = hull(run.first).at;
    const Point b = hull(run.last).at;
    if (orient(run.centre.at, a, b) <= 0) return kNone;
    std::uint32_t beyond = kNone, before = kNone, on = kNone;
    std::size_t count_on = 0;
    for (std::uint32_t i = run.inside.begin; i < run.inside.end; ++i) {
      const Point p = inner_[i].at;
      const int side = orient(a, b, p);
      if (side == 0) {
        ++count_on;
        on = i;
        continue;
      }
      std::uint32_t& best = side < 0 ? beyond : before;
      const bool nearer = best == kNone || cross_sign(a, b, inner_[best].at, p) * side < 0;
      if (nearer) best = i;
    }
    const std::uint32_t wish = prefer_ == Prefer::kBeforeChord ? before : beyond;
    const std::uint32_t other = prefer_ == Prefer::kBeforeChord ? beyond : before;
    if (wish != kNone) return wish;
    if (other != kNone) return other;
    return count_on == 1 ? on : kNone;
  }

  bool add_centre(const Fan& run, Range spoke) {
    const Place v = run.centre;
    const Place a = hull(run.first);
    const Place b = hull(run.last);
    const std::uint32_t chosen = choose_centre(run, spoke);
    if (chosen == kNone) return false;
    std::swap(inner_[chosen], inner_[run.inside.begin]);
    const Place q = inner_[run.inside.begin];
    const Range rest = {run.inside.begin + 1, run.inside.end};
    enum : std::uint32_t { kBesideA, kOnEdge, kFan, kBesideB };
    std::vector<std::uint32_t> cell;
    for (std::uint32_t i = rest.begin; i < rest.end; ++i) {
      const Point p = inner_[i].at;
      const int side = orient(v.at, q.at, p);
      if (side == 0) {
        cell.push_back(dot_sign(q.at, v.at, q.at, p) > 0 ? kOnEdge : kFan);
      } else if (side < 0) {
        cell.push_back(orient(a.at, q.at, p) > 0 ? kBesideA : kFan);
      } else {
        cell.push_back(orient(q.at, b.at, p) > 0 ? kBesideB : kFan);
      }
    }
    std::vector<std::uint32_t> begin;
    sort_into_cells(inner_, rest, cell, 4, begin, buffer_);
    const auto range = [&](std::uint32_t c) { return Range{begin[c], begin[c + 1]}; };
    sort_along(inner_, range(kOnEdge));
    todo_.push_back({Wedge{a, v, q, range(kBesideA), range(kOnEdge)}, {}});
    todo_.push_back({{}, {q, run.first, run.last, range(kFan), run.depth + 1}});
    todo_.push_back({Wedge{b, q, v, range(kBesideB), range(kOnEdge)}, {}});
    return true;
  }

  std::span<const Place> hull_;
  std::vector<Place>& inner_;
  std::vector<Place> buffer_;
  std::vector<Item> todo_;
  std::vector<Wedge> wedges_;
  std::size_t centres_ = 0;
  Prefer prefer_ = Prefer::kOnSpoke;
};

/// The inner point nearest to the line of some edge of the hull.
std::size_t nearest_to_an_edge(std::span<const Place> hull, std::span<const Place> inner,
                               Random& random) {
  const std::size_t i = random.below(hull.size());
  const Point a = hull[i].at, b = hull[(i + 1) % hull.size()].at;
  std::size_t best = 0;
  for (std::size_t k = 1; k < inner.size(); ++k) {
    if (cross_sign(a, b, inner[best].at, inner[k].at) < 0) best = k;
  }
  return best;
}

}  // namespace

std::optional<CycleStart> start_cycle(std::span<const Place> hull, std::vector<Place>& inner,
                                      Random& random) {
  Start start(hull, inner);
  const bool all = inner.size() <= kAllTried;
  const std::vector<Place> candidates = all ? inner : std::vector<Place>{};
  const std::size_t tries = all ? inner.size() : kSomeTried;
  for (std::size_t i = 0; i < tries; ++i) {
    for (const Prefer prefer : {Prefer::kOnSpoke, Prefer::kBeyondChord, Prefer::kBeforeChord}) {
      std::size_t v = 0;
      if (all) {
        while (inner[v].vertex != candidates[i].vertex) ++v;
      } else {
        v = i % 2 == 0 ? random.below(inner.size()) : nearest_to_an_edge(hull, inner, random);
      }
      if (start.try_centre(static_cast<std::uint32_t>(v), prefer)) return start.take();
    }
  }
  return std::nullopt;
}

}  // namespace quadloom::strips
