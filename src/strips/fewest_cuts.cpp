// The fewest convex parts of a simple polygon without added points: Keil's dynamic programme (Keil 1985,
// "Decomposing a polygon into simpler components"; Keil and Snoeyink 2002), which theorem 2.3 of Arkin,
// Held, Mitchell and Skiena starts from.
//
// A chord is needed only if one of its ends is reflex (else its two parts make a convex one). For a pair
// i < k of corners that see each other, one of them reflex, let W(i, k) be the least number of chords
// that cut the part of the polygon with the corners i .. k into convex parts, and the base the part at
// i-k. All that matters of a base is its second corner a and its last but one, b: how wide it is at i
// and at k. A cut with one chord more is never better than W(i, k) with i-k itself cut. So of all
// best cuts those are kept whose (a, b) is nowhere wider than that of another: a list in which both ends
// ascend, as a wider angle at i comes with a narrower one at k.
//
//             j .-----.           The base is a fan of triangles from i if that is reflex (else from k):
//       b .---'        \.         the last one is i, j, k. What is beyond j-k is cut off, unless that is a
//       a '._           \.        side. What is beyond i-j is joined with the triangle if a list entry of
//            i --------- k        (i, j) leaves no reflex angle at i and j; else it is cut off.
//
//   1. look_around   the pairs, from Visibility
//   2. solve         W and its list for all pairs, i descending, k ascending
//   3. collect_cuts  the chords of one best cut, from the pair of the first and the last corner
//
// What we do differently. Collinear corners: convex parts may have flat corners, of which the fan from i
// has triangles without area. So pairs are taken that see each other only past corners, all of them on
// one side (Sight::kPastBefore, kPastAfter). They are never cut: the flat triangle beside them can be
// joined always. The list entry that fits is found by bisection, not by an amortised scan.
//
// The first corner is a reflex one, so that the pair of the first and the last corner has a reflex end.
// Cost: a pair for each of at most r n chords with a reflex end (r reflex corners), and those seen past
// others; for each a step for each chord at its other end: O(r n^2 log n) at worst, near O(n log n)
// where corners see few others. Both are counted first. No recursion. All decisions are signs of orient2d.
#include <algorithm>
#include <limits>

#include "kernel/predicates_inline.hpp"
#include "strips/convex_parts.hpp"
#include "strips/visibility.hpp"

namespace quadloom::strips {
namespace {

using PairId = std::uint32_t;

/// Corners are numbered from the first reflex one here.
class FewestCuts {
 public:
  FewestCuts(const PolygonDisc& disc, Position first) : disc_(disc), first_(first) {
    for (Position i = 0; i < size(); ++i) reflex_.push_back(disc.reflex(position(i)) ? 1 : 0);
  }

  std::optional<Cuts> find(std::size_t most_steps) {
    if (!look_around(most_steps) || steps() > most_steps) return std::nullopt;
    solve();
    return collect_cuts();
  }

 private:
  static constexpr std::uint32_t kNoCut = std::numeric_limits<std::uint32_t>::max();

  struct Base {
    Position second = 0;
    Position last_but_one = 0;
  };
  enum class Kind : std::uint8_t { kSide, kChord, kPast };
  struct Pair {
    Position from = 0;
    Position to = 0;
    Kind kind = Kind::kChord;
    std::uint32_t cuts = kNoCut;
    std::vector<Base> bases;  // both ends ascend
  };

  Position size() const { return disc_.size(); }
  Position position(Position i) const { return (first_ + i) % size(); }
  Point at(Position i) const { return disc_.at(position(i)); }
  bool convex(Position a, Position b, Position c) const {
    return kernel::orient(at(a), at(b), at(c)) >= 0;
  }

  bool look_around(std::size_t most_steps);
  std::size_t steps() const;
  void solve();
  void fan_from_first(Pair& pair);
  void fan_from_last(Pair& pair);
  void join_at_first(Pair& pair, const Pair& near, const Pair& link);
  void join_at_last(Pair& pair, const Pair& near, const Pair& link);
  static std::uint32_t cost_of_link(const Pair& link) {
    return link.kind == Kind::kSide ? 0 : link.cuts + 1;
  }
  Cuts collect_cuts() const;
  PairId find_pair(Position from, Position to) const;

  const PolygonDisc& disc_;
  Position first_;
  std::vector<std::uint8_t> reflex_;
  std::vector<Pair> pairs_;         // by first corner, then by last corner
  std::vector<std::size_t> begin_;  // per first corner
  std::vector<std::vector<PairId>>
      ends_;                    // per last corner the links solved, first corners descending
  std::vector<PairId> starts_;  // per last corner the pair with the first corner at hand
  std::vector<PairId> links_;   // those of the first corner at hand, last corners ascending
};

/// Pairs are seen from their reflex end, if both are from the first one. False if there are too many, or
/// too many triangles are looked into.
bool FewestCuts::look_around(std::size_t most_steps) {
  for (Position i = 0; i + 1 < size(); ++i) pairs_.push_back({i, i + 1, Kind::kSide, 0, {}});
  pairs_.push_back({0, size() - 1, Kind::kSide, kNoCut, {}});
  Visibility visibility(disc_);
  for (Position i = 0; i < size(); ++i) {
    if (reflex_[i] == 0) continue;
    if (pairs_.size() > most_steps || visibility.work() > most_steps) return false;
    for (const Seen& seen : visibility.look_from(position(i))) {
      const Position k = disc_.length(first_, seen.position);
      if (reflex_[k] != 0 && k < i) continue;
      const Kind kind = seen.sight == Sight::kChord ? Kind::kChord : Kind::kPast;
      pairs_.push_back({std::min(i, k), std::max(i, k), kind, kNoCut, {}});
    }
  }
  std::sort(pairs_.begin(), pairs_.end(), [](const Pair& p, const Pair& q) {
    return p.from != q.from ? p.from < q.from : p.to < q.to;
  });
  begin_.assign(std::size_t{size()} + 1, 0);
  for (const Pair& pair : pairs_) ++begin_[pair.from + 1];
  for (Position i = 0; i < size(); ++i) begin_[i + 1] += begin_[i];
  return true;
}

/// How many triangles solve() will look at, at most.
std::size_t FewestCuts::steps() const {
  std::vector<std::size_t> links_from(size(), 0), links_to(size(), 0);
  for (const Pair& pair : pairs_) {
    if (pair.kind == Kind::kPast) continue;
    ++links_from[pair.from];
    ++links_to[pair.to];
  }
  std::size_t sum = 0;
  for (const Pair& p : pairs_) sum += reflex_[p.from] != 0 ? links_to[p.to] : links_from[p.from];
  return sum;
}

void FewestCuts::solve() {
  ends_.resize(size());
  starts_.assign(size(), kNone);
  for (Position i = size(); i-- > 0;) {
    links_.clear();
    for (std::size_t p = begin_[i]; p < begin_[i + 1]; ++p) {
      Pair& pair = pairs_[p];
      if (pair.to > i + 1) {
        if (reflex_[i] != 0) {
          fan_from_first(pair);
        } else {
          fan_from_last(pair);
        }
      }
      starts_[pair.to] = static_cast<PairId>(p);
      if (pair.kind != Kind::kPast) links_.push_back(static_cast<PairId>(p));
    }
    for (std::size_t p = begin_[i]; p < begin_[i + 1]; ++p) starts_[pairs_[p].to] = kNone;
    for (const PairId link : links_) ends_[pairs_[link].to].push_back(link);
  }
}

void FewestCuts::fan_from_first(Pair& pair) {
  const std::vector<PairId>& links = ends_[pair.to];
  for (std::size_t l = links.size(); l-- > 0;) {
    const PairId near = starts_[pairs_[links[l]].from];
    if (near != kNone) join_at_first(pair, pairs_[near], pairs_[links[l]]);
  }
}

void FewestCuts::fan_from_last(Pair& pair) {
  for (std::size_t l = links_.size(); l-- > 0;) {
    const Pair& link = pairs_[links_[l]];
    const PairId near = find_pair(link.to, pair.to);
    if (near != kNone) join_at_last(pair, pairs_[near], link);
  }
  std::reverse(pair.bases.begin(), pair.bases.end());
}

/// The triangle i, j, k beyond near = i-j and link = j-k; j ascends from call to call.
void FewestCuts::join_at_first(Pair& pair, const Pair& near, const Pair& link) {
  const Position i = pair.from, j = near.to, k = pair.to;
  std::uint32_t cuts = near.cuts + cost_of_link(link);
  Position second = j;
  if (near.kind != Kind::kSide) {
    const auto fits =
        std::partition_point(near.bases.begin(), near.bases.end(),
                             [&](const Base& base) { return convex(base.last_but_one, j, k); });
    if (fits != near.bases.begin() && convex(k, i, (fits - 1)->second)) {
      second = (fits - 1)->second;
    } else if (near.kind == Kind::kChord) {
      ++cuts;
    } else {
      return;
    }
  }
  if (cuts > pair.cuts) return;
  if (cuts < pair.cuts) pair.bases.clear();
  pair.cuts = cuts;
  if (pair.bases.empty() || second > pair.bases.back().second) pair.bases.push_back({second, j});
}

/// The triangle i, j, k beyond link = i-j and near = j-k; j descends from call to call, and so do the
/// list's entries.
void FewestCuts::join_at_last(Pair& pair, const Pair& near, const Pair& link) {
  const Position i = pair.from, j = near.from, k = pair.to;
  std::uint32_t cuts = near.cuts + cost_of_link(link);
  Position last = j;
  if (near.kind != Kind::kSide) {
    const auto fits =
        std::partition_point(near.bases.begin(), near.bases.end(),
                             [&](const Base& base) { return !convex(i, j, base.second); });
    if (fits != near.bases.end() && convex(fits->last_but_one, k, i)) {
      last = fits->last_but_one;
    } else if (near.kind == Kind::kChord) {
      ++cuts;
    } else {
      return;
    }
  }
  if (cuts > pair.cuts) return;
  if (cuts < pair.cuts) pair.bases.clear();
  pair.cuts = cuts;
  if (pair.bases.empty() || last < pair.bases.back().last_but_one) pair.bases.push_back({j, last});
}

/// kNone if there is none.
PairId FewestCuts::find_pair(Position from, Position to) const {
  const auto begin = pairs_.begin() + static_cast<std::ptrdiff_t>(begin_[from]);
  const auto end = pairs_.begin() + static_cast<std::ptrdiff_t>(begin_[from + 1]);
  const auto it =
      std::lower_bound(begin, end, to, [](const Pair& p, Position k) { return p.to < k; });
  return it != end && it->to == to ? static_cast<PairId>(it - pairs_.begin()) : kNone;
}

Cuts FewestCuts::collect_cuts() const {
  Cuts cuts;
  std::vector<std::pair<PairId, Base>> todo;  // pairs, each with the base it is to have
  const auto cut = [&](const Pair& pair, PairId id) {
    if (pair.kind == Kind::kSide) return;
    cuts.emplace_back(position(pair.from), position(pair.to));
    todo.emplace_back(id, pair.bases.front());
  };
  const PairId all = find_pair(0, size() - 1);
  todo.emplace_back(all, pairs_[all].bases.front());
  while (!todo.empty()) {
    const PairId id = todo.back().first;
    const Base base = todo.back().second;
    todo.pop_back();
    const Pair& pair = pairs_[id];
    const bool from_first = reflex_[pair.from] != 0;
    const Position j = from_first ? base.last_but_one : base.second;
    const PairId before = find_pair(pair.from, j), after = find_pair(j, pair.to);
    const PairId near = from_first ? before : after, link = from_first ? after : before;
    cut(pairs_[link], link);
    if (base.second == base.last_but_one) {
      cut(pairs_[near], near);
      continue;
    }
    const auto& bases = pairs_[near].bases;
    const auto joined = std::find_if(bases.begin(), bases.end(), [&](const Base& b) {
      return from_first ? b.second == base.second : b.last_but_one == base.last_but_one;
    });
    todo.emplace_back(near, *joined);
  }
  return cuts;
}

}  // namespace

std::optional<Cuts> fewest_cuts(const PolygonDisc& disc, std::size_t most_steps) {
  for (Position i = 0; i < disc.size(); ++i) {
    if (disc.reflex(i)) return FewestCuts(disc, i).find(most_steps);
  }
  return Cuts{};
}

//        \  /       Of the sides and cuts at a corner, in the order of their other ends around the
//   in    \/ out    polygon, a part that arrives along one leaves along the one before it.
std::vector<std::vector<Position>> parts_between(const PolygonDisc& disc, const Cuts& cuts) {
  std::vector<std::vector<Position>> ends(disc.size());
  for (Position i = 0; i < disc.size(); ++i) ends[i] = {disc.next(i)};
  for (const auto& [i, k] : cuts) {
    ends[i].push_back(k);
    ends[k].push_back(i);
  }
  for (Position i = 0; i < disc.size(); ++i) {
    std::sort(ends[i].begin(), ends[i].end(),
              [&](Position a, Position b) { return disc.length(i, a) < disc.length(i, b); });
  }
  // Of the ways out of a corner: the place in `ends` of the one that a part takes which came from `from`.
  const auto way_out = [&](Position i, Position from) {
    if (from == disc.previous(i)) return ends[i].size() - 1;
    const auto it =
        std::lower_bound(ends[i].begin(), ends[i].end(), disc.length(i, from),
                         [&](Position a, Position length) { return disc.length(i, a) < length; });
    return static_cast<std::size_t>(it - ends[i].begin()) - 1;
  };
  std::vector<std::vector<std::uint8_t>> taken(disc.size());
  for (Position i = 0; i < disc.size(); ++i) taken[i].assign(ends[i].size(), 0);
  std::vector<std::vector<Position>> parts;
  for (Position start = 0; start < disc.size(); ++start) {
    for (std::size_t first = 0; first < ends[start].size(); ++first) {
      if (taken[start][first] != 0) continue;
      std::vector<Position>& part = parts.emplace_back();
      Position i = start;
      for (std::size_t way = first; taken[i][way] == 0;) {
        taken[i][way] = 1;
        part.push_back(i);
        const Position to = ends[i][way];
        way = way_out(to, i);
        i = to;
      }
    }
  }
  return parts;
}

}  // namespace quadloom::strips
