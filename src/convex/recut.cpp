// A small polygon with points inside in strictly convex quads: exhaustive search, cut short.
//
//   1. find_lefts     for each two points the set of those on the left of their line; exact
//   2. find_edges     segments inside the polygon that no corner or point inside lies on or cuts off
//   3. search         the open edge (a side of the polygon, or of a quad, without a quad on its left) with
//                     the fewest quads that fit on its left; each of them in turn, best or luckiest first
//
//          d ---- c         A quad fits if it is strictly convex, has none of the points that must be
//          |      |         vertices in it or on it, and each side is an open edge (then it is closed) or an
//     -- a ====== b --      edge that no quad placed so far crosses or covers (then its reverse is open).
//
// What is found is right whatever the search believes about crossings: strictly convex quads with matched
// edges tile the polygon, by the argument at `tiles` in patch.hpp. Differs from points_exact.cpp: there all faces
// are listed beforehand, here few of them are ever looked at.
//
// Degenerate input: collinear points, repeated x or y. Cost: O(N^3) exact turns for N points in all, then
// O(N^2) set operations a step or so.
#include "convex/recut.hpp"

#include <algorithm>
#include <array>
#include <bit>

#include "kernel/predicates_inline.hpp"
#include "kernel/squareness.hpp"

namespace quadloom::convex {
namespace {

constexpr std::uint32_t bit(std::size_t k) { return std::uint32_t{1} << k; }

/// Calls with each element; stops where the call returns false.
template <class Call>
bool for_each(std::uint32_t set, Call&& call) {
  for (; set != 0; set &= set - 1) {
    if (!call(static_cast<std::size_t>(std::countr_zero(set)))) return false;
  }
  return true;
}

}  // namespace

RecutSearch::RecutSearch(std::span<const Point> corner, std::span<const Point> inside,
                         std::span<const Point> places)
    : corners_(corner.size()), given_(corners_ + inside.size()), n_(given_ + places.size()) {
  auto at = std::copy(corner.begin(), corner.end(), p_.begin());
  at = std::copy(inside.begin(), inside.end(), at);
  std::copy(places.begin(), places.end(), at);
  find_lefts();
  find_edges();
}

std::optional<Recut> RecutSearch::find(std::size_t most_added, std::size_t steps, RecutOrder order,
                                       Random& random) {
  most_added_ = most_added;
  steps_left_ = steps;
  order_ = order;
  random_ = &random;
  placed_.clear();
  if (!search(start())) return std::nullopt;
  return result();
}

void RecutSearch::find_lefts() {
  for (std::size_t i = 0; i < n_; ++i) {
    for (std::size_t j = i + 1; j < n_; ++j) {
      for (std::size_t k = j + 1; k < n_; ++k) {
        const int sign = kernel::orient(p_[i], p_[j], p_[k]);
        if (sign == 0) continue;
        const std::size_t a = sign > 0 ? i : j, b = sign > 0 ? j : i;
        left_[a * kMostRecutPoints + b] |= bit(k);
        left_[b * kMostRecutPoints + k] |= bit(a);
        left_[k * kMostRecutPoints + a] |= bit(b);
      }
    }
  }
}

/// Whether the direction from corner i to point j points into the polygon.
bool RecutSearch::inside_at(std::size_t i, std::size_t j) const {
  const std::size_t before = (i + corners_ - 1) % corners_, after = (i + 1) % corners_;
  const bool left_of_before = (left(before, i) & bit(j)) != 0;
  const bool left_of_after = (left(i, after) & bit(j)) != 0;
  const bool convex = (left(before, i) & bit(after)) != 0;
  return convex ? left_of_before && left_of_after : left_of_before || left_of_after;
}

/// For collinear points: whether k is between a and b.
bool RecutSearch::between(std::size_t a, std::size_t k, std::size_t b) const {
  return (lex_less(p_[a], p_[k]) && lex_less(p_[k], p_[b])) ||
         (lex_less(p_[b], p_[k]) && lex_less(p_[k], p_[a]));
}

bool RecutSearch::is_edge(std::size_t a, std::size_t b) const {
  for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)}) {
    if (from < corners_ && !inside_at(from, to)) return false;
  }
  const Set on_line = all_given() & ~(left(a, b) | left(b, a) | bit(a) | bit(b));
  if (!for_each(on_line, [&](std::size_t k) { return !between(a, k, b); })) {
    return false;
  }
  // Sides i whose ends are strictly on the two sides of the line; then a and b must not be so of theirs.
  const Set on_left = left(a, b), on_right = left(b, a);
  const auto next_of = [&](Set set) {  // bit i of it is bit i + 1 of the set, around the corners
    return (set >> 1) | ((set & 1) << (corners_ - 1));
  };
  const Set apart = (on_left & next_of(on_right)) | (on_right & next_of(on_left));
  return for_each(apart & (bit(corners_) - 1), [&](std::size_t i) {
    const std::size_t next = i + 1 == corners_ ? 0 : i + 1;
    const Set to_left = left(i, next), to_right = left(next, i);
    return !(((to_left & bit(a)) != 0 && (to_right & bit(b)) != 0) ||
             ((to_left & bit(b)) != 0 && (to_right & bit(a)) != 0));
  });
}

void RecutSearch::find_edges() {
  for (std::size_t b = 1; b < n_; ++b) {
    for (std::size_t a = 0; a < b; ++a) {
      const bool side = b < corners_ && (b == a + 1 || (a == 0 && b + 1 == corners_));
      if (side || !is_edge(a, b)) continue;
      edge_[a] |= bit(b);
      edge_[b] |= bit(a);
    }
  }
}

RecutSearch::State RecutSearch::start() const {
  State state;
  state.free = edge_;
  for (std::size_t i = 0; i < corners_; ++i) {
    const std::size_t next = (i + 1) % corners_;
    state.free[i] |= bit(next);
    state.open[i] |= bit(next);
  }
  state.vertices = all_given();
  return state;
}

/// The quads that fit on the left of a -> b; stops where the call returns false.
template <class Call>
bool RecutSearch::quads_at(const State& state, std::size_t a, std::size_t b, Call&& call) const {
  const std::size_t may_add = most_added_ - state.added;
  const auto is_new = [&](std::size_t k) { return (state.vertices & bit(k)) == 0; };
  return for_each(left(a, b) & state.free[b], [&](std::size_t c) {
    const std::size_t new_c = is_new(c) ? 1 : 0;
    if (new_c > may_add) return true;
    const Set on_left = left(a, b) & left(b, c);
    return for_each(on_left & left(a, c) & state.free[c], [&](std::size_t d) {
      if ((state.free[d] & bit(a)) == 0) return true;
      if (new_c + (is_new(d) ? 1 : 0) > may_add) return true;
      if ((on_left & left(c, d) & left(d, a) & state.vertices) != 0) return true;
      return call(c, d);
    });
  });
}

/// The quads at the open edge that has the fewest; false if one has none.
bool RecutSearch::fewest_quads(const State& state, Quads& out) {
  std::size_t fewest = kMostRecutPoints * kMostRecutPoints, from = 0, to = 0;
  const std::size_t first = random_->below(n_);
  for (std::size_t i = 0; i < n_ && fewest > 1; ++i) {
    const std::size_t a = first + i < n_ ? first + i : first + i - n_;
    for_each(state.open[a], [&](std::size_t b) {
      std::size_t count = 0;
      quads_at(state, a, b, [&](std::size_t, std::size_t) { return ++count < fewest; });
      if (count < fewest) {
        fewest = count;
        from = a;
        to = b;
      }
      return fewest > 0;
    });
    if (fewest == 0) return false;
  }
  quads_at(state, from, to, [&](std::size_t c, std::size_t d) {
    const auto byte = [](std::size_t k) { return static_cast<std::uint8_t>(k); };
    Quad quad{{byte(from), byte(to), byte(c), byte(d)}, 0};
    const double shape = kernel::squareness(p_[from], p_[to], p_[c], p_[d]);
    quad.score = random_->uniform() * (order_ == RecutOrder::kShape ? 0.3 : 1) +
                 (order_ == RecutOrder::kShape ? shape : 0);
    out.push_back(quad);
    return true;
  });
  std::sort(out.begin(), out.end(), [](const Quad& a, const Quad& b) {
    return a.score != b.score ? a.score > b.score : a.corner < b.corner;
  });
  return true;
}

/// The new edge a - b: nothing crosses it.
void RecutSearch::close_off(State& state, std::size_t a, std::size_t b) const {
  const Set on_left = left(a, b), on_right = left(b, a);
  for_each(on_left, [&](std::size_t u) {
    const Set across = on_right & left(u, a) & left(b, u) & state.free[u];
    state.free[u] &= ~across;
    return for_each(across, [&](std::size_t w) {
      state.free[w] &= ~bit(u);
      return true;
    });
  });
}

void RecutSearch::place(State& state, const Quad& quad) const {
  const auto& q = quad.corner;
  Set inside = ~Set{0};
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t a = q[i], b = q[(i + 1) % 4];
    inside &= left(a, b);
    if ((state.vertices & bit(a)) == 0) {
      state.vertices |= bit(a);
      ++state.added;
    }
    if ((state.open[a] & bit(b)) != 0) {
      state.open[a] &= ~bit(b);
    } else {
      state.open[b] |= bit(a);
      close_off(state, a, b);
    }
    state.free[a] &= ~bit(b);
  }
  for (std::size_t i = 0; i < 4; ++i) state.free[q[i]] &= ~bit(q[(i + 2) % 4]);
  for_each(inside, [&](std::size_t k) {  // places that are covered
    state.free[k] = 0;
    return true;
  });
  if (inside != 0) {
    for (std::size_t k = 0; k < n_; ++k) state.free[k] &= ~inside;
  }
}

bool RecutSearch::search(const State& state) {
  const bool done =
      std::all_of(state.open.begin(), state.open.end(), [](Set set) { return set == 0; });
  if (done) return true;
  Quads quads;
  if (!fewest_quads(state, quads)) return false;
  for (const Quad& quad : quads) {
    if (steps_left_ == 0) return false;
    --steps_left_;
    State next = state;
    place(next, quad);
    placed_.push_back(quad);
    if (search(next)) return true;
    placed_.pop_back();
  }
  return false;
}

Recut RecutSearch::result() const {
  Recut out;
  std::array<std::uint8_t, kMostRecutPoints> name{};
  for (std::size_t k = 0; k < given_; ++k) name[k] = static_cast<std::uint8_t>(k);
  for (const Quad& quad : placed_) {
    for (const std::uint8_t k : quad.corner) {
      if (k < given_ || name[k] != 0) continue;
      name[k] = static_cast<std::uint8_t>(given_ + out.places.size());
      out.places.push_back(static_cast<std::uint8_t>(k - given_));
    }
  }
  for (const Quad& quad : placed_) {
    const auto& q = quad.corner;
    out.quads.push_back({name[q[0]], name[q[1]], name[q[2]], name[q[3]]});
  }
  return out;
}

// A mesh with f sides, r points inside and k added ones has f / 2 - 1 + r + k quads and so f / 2 - 2 + 2 (r + k)
// inner edges. A corner that is not convex needs one, a point inside three; corners of one colour (every other
// one) share none.
bool may_be_recut(std::span<const Point> corner, std::size_t inside, std::size_t added) {
  const std::size_t sides = corner.size(), points = inside + added;
  std::array<std::size_t, 2> need{};
  for (std::size_t i = 0; i < sides; ++i) {
    const Point before = corner[(i + sides - 1) % sides], after = corner[(i + 1) % sides];
    if (kernel::orient(before, corner[i], after) <= 0) ++need[i % 2];
  }
  const std::size_t edges = sides / 2 + 2 * points;  // and two less
  return std::max(need[0], need[1]) + 2 <= edges && need[0] + need[1] + 3 * points + 4 <= 2 * edges;
}

}  // namespace quadloom::convex
