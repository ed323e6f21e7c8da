// Sequential triangulations of points of which at most two are strictly inside the hull.
//
// Arkin, Held, Mitchell, Skiena, "Hamiltonian triangulations for fast rendering", lemma 4.2: there is one
// if the points are in general position. O(h log h) for h points on the hull.
//
//   1. no_inner       from a corner of the hull to and fro: k, k + 1, k - 1, k + 2, ...
//   2. one_inner      a hull edge b c and a hull point a whose triangle has q in it: a b q c a
//   3. two_together   a hull edge u v such that q is in the triangle p u v; t and y are beside it:
//                     s t p u q v p y s for any other hull point s; or the sequence begins there, with
//                     t p u q v p y t or p u q v p y u
//   4. two_apart      a b q c a, to and fro, then a b p c a of another hull edge
//
//        c _______ b                 a b q c a: the triangles a b q, b q c, q c a. The edges a b and c a
//         \ `q' /                    are diagonals or hull edges; beyond each of them, hull points alone,
//          \ | /     .               the sequence goes on to and fro ...
//            a
//
// Beyond a diagonal the sequence has no choice (an Arc), and ends at some corner, which must be none
// inside a hull edge: then, and only then, all triangles there have an area.
//
// Why nothing else needs to be tried, in general position or not. A triangle of hull points that the
// sequence leaves by its second side has its third side on the hull (what is beyond could not be reached
// any more), so between triangles with an inner corner the sequence goes to and fro. The same inner point
// comes again after four places at least (after three a triangle would repeat), and not after a triangle
// of hull points, which would separate it from itself. With q alone each place of it, but at the ends of
// the sequence, covers three of the triangles around it; so it has one place and three triangles. With
// two, only two triangles have both as corners, and a hull point is surrounded by no triangles: what is
// left of all words is 3 and 4, forwards or backwards. (The tests compare with all triangulations.)
//
// What differs from the paper: its cases are chosen by the line through the inner points, and rest on
// general position. Here the answer is exact for any points; it can be no if points are on hull edges or
// the inner points on a line with a hull point.
//
// Cost: O(h log h) as a rule; a bucket of step 4 that many diagonals fall into costs its size.
#include "strips/sequential_hull.hpp"

#include <algorithm>

#include "kernel/predicates_inline.hpp"

namespace quadloom::strips {
namespace {

using Sequence = std::vector<VertexId>;

/// The hull points beyond a diagonal, from the ring's place `low` to `high` (unrolled: low < high < low +
/// h, or low + h for a single corner). The sequence, whose last two vertices are the ends, goes on with
/// the one after `low` or the one before `high`, and then by turns.
struct Arc {
  std::size_t low = 0, high = 0;
  bool from_low = true;

  std::size_t between() const { return high - low - 1; }
};

/// An inner point in a triangle with a hull edge, a b q c a. `word` is what stands after the two vertices
/// by which it is entered.
struct Block {
  Arc before;  // what is beyond the first edge, read backwards
  Arc entry;   // the same edge, seen from the outside: the block is beyond it
  Arc after;   // beyond the last edge
  std::vector<VertexId> word;
};

class HullSequences {
 public:
  HullSequences(std::span<const Point> points, std::span<const VertexId> hull)
      : points_(points), hull_(hull) {
    const std::size_t h = hull.size();
    for (std::size_t i = 0; i < h; ++i) {
      corner_.push_back(turn(hull[(i + h - 1) % h], hull[i], hull[(i + 1) % h]) != 0);
    }
  }

  std::optional<Sequence> no_inner() const {
    for (std::size_t k = 0; k < hull_.size(); ++k) {
      const Arc rest = {k, k + hull_.size(), true};
      if (!corner_[k] || !can_end(rest)) continue;
      Sequence out = {at(k)};
      append(rest, out);
      return out;
    }
    return std::nullopt;
  }

  std::optional<Sequence> one_inner(VertexId q) const {
    for (const Block& block : blocks(q)) {
      if (can_end(block.before) && can_end(block.after)) {
        return joined(block.before, block.word, block.after);
      }
    }
    return std::nullopt;
  }

  /// q in a triangle of p and a hull edge.
  std::optional<Sequence> two_together(VertexId p, VertexId q) const {
    const std::size_t h = hull_.size();
    for (std::size_t i = 0; i < h; ++i) {
      const VertexId u = at(i), v = at(i + 1);
      if (turn(p, u, q) <= 0 || turn(p, q, v) <= 0) continue;
      const VertexId t = at(i + h - 1), y = at(i + 2);
      if (turn(y, u, p) > 0) {
        const Arc rest = arc(i + 2, i, true);
        if (can_end(rest)) return joined({}, {p, u, q, v, p, y, u}, rest);
      }
      if (turn(v, t, p) > 0) {
        const Arc rest = arc(i + 1, i + h - 1, false);
        if (can_end(rest)) return joined({}, {p, v, q, u, p, t, v}, rest);
      }
      if (h < 4) continue;
      for (const bool from_low : {true, false}) {
        const Arc rest = arc(i + 2, i + h - 1, from_low);
        if (turn(y, t, p) <= 0 || !can_end(rest)) continue;
        if (from_low) return joined({}, {t, p, u, q, v, p, y, t}, rest);
        return joined({}, {y, p, v, q, u, p, t, y}, rest);
      }
      for (std::size_t k = i + 3; k < i + h - 1; ++k) {
        const VertexId s = at(k);
        const Arc after = arc(i + 2, k, true), before = arc(k, i + h - 1, false);
        if (turn(s, t, p) <= 0 || turn(y, s, p) <= 0 || !can_end(after) || !can_end(before)) {
          continue;
        }
        return joined(before, {s, t, p, u, q, v, p, y, s}, after);
      }
    }
    return std::nullopt;
  }

  /// First q, then p.
  std::optional<Sequence> two_apart(VertexId q, VertexId p) const {
    std::vector<Block> second = blocks(p);
    std::vector<std::vector<std::size_t>> bucket(2 * hull_.size());
    for (std::size_t i = 0; i < second.size(); ++i) {
      if (can_end(second[i].after)) bucket[key(second[i].entry)].push_back(i);
    }
    for (const Block& first : blocks(q)) {
      if (!can_end(first.before)) continue;
      for (const std::size_t i : bucket[key(first.after)]) {
        const auto between = way(first.after, second[i].entry);
        if (!between) continue;
        Sequence middle = first.word;
        middle.insert(middle.end(), between->begin(), between->end());
        middle.insert(middle.end(), second[i].word.begin() + 2, second[i].word.end());
        return joined(first.before, middle, second[i].after);
      }
    }
    return std::nullopt;
  }

 private:
  VertexId at(std::size_t i) const { return hull_[i % hull_.size()]; }
  int turn(VertexId a, VertexId b, VertexId c) const {
    return kernel::orient(points_[a], points_[b], points_[c]);
  }

  /// From one place of the ring counter-clockwise to another one.
  Arc arc(std::size_t low, std::size_t high, bool from_low) const {
    const std::size_t h = hull_.size();
    low %= h;
    high %= h;
    return {low, high > low ? high : high + h, from_low};
  }

  bool can_end(const Arc& arc) const {
    const std::size_t between = arc.between();
    if (between == 0) return true;
    const bool at_low = arc.from_low == (between % 2 == 1);
    const std::size_t steps = (between + 1) / 2;
    return corner_[(at_low ? arc.low + steps : arc.high - steps) % hull_.size()];
  }

  void append(const Arc& arc, Sequence& out) const {
    std::size_t low = arc.low, high = arc.high;
    for (bool from_low = arc.from_low; low + 1 < high; from_low = !from_low) {
      out.push_back(at(from_low ? ++low : --high));
    }
  }

  /// An Arc without points between its ends adds nothing; Arc{} is none.
  Sequence joined(const Arc& before, const Sequence& word, const Arc& after) const {
    Sequence out;
    if (before.high != 0) append(before, out);
    std::reverse(out.begin(), out.end());
    out.insert(out.end(), word.begin(), word.end());
    append(after, out);
    return out;
  }

  /// All triangles a b c with a hull edge b c that have q strictly inside, forwards and backwards. Seen
  /// from a, the hull points before b are on one side of the line to q and those from c on on the other.
  std::vector<Block> blocks(VertexId q) const {
    const std::size_t h = hull_.size();
    std::vector<Block> out;
    for (std::size_t a = 0; a < h; ++a) {
      std::size_t b = a + 1, c = a + h - 1;
      while (c - b > 1) {
        const std::size_t middle = b + (c - b) / 2;
        (turn(at(a), at(middle), q) > 0 ? b : c) = middle;
      }
      if (turn(at(a), at(c), q) == 0) continue;
      const Arc low_side = arc(a, b, false), high_side = arc(c, a, true);
      Block forwards{low_side, arc(b, a, false), high_side, {at(a), at(b), q, at(c), at(a)}};
      Block backwards{high_side, arc(a, c, true), low_side, {at(a), at(c), q, at(b), at(a)}};
      out.push_back(std::move(forwards));
      out.push_back(std::move(backwards));
    }
    return out;
  }

  /// Arcs that follow from each other have the same key.
  std::size_t key(const Arc& arc) const {
    const std::size_t turns = 2 * hull_.size();
    return (arc.low + arc.high + turns - (arc.from_low ? 0 : 1)) % turns;
  }

  /// What the sequence goes through from one arc to a later one of the same key; none if that is no part of
  /// the first.
  std::optional<Sequence> way(const Arc& from, Arc to) const {
    if (to.low < from.low) {
      to.low += hull_.size();
      to.high += hull_.size();
    }
    if (to.high > from.high) return std::nullopt;
    Sequence out;
    Arc arc = from;
    while (arc.low != to.low || arc.high != to.high) {
      if (arc.low > to.low || arc.high < to.high) return std::nullopt;
      out.push_back(at(arc.from_low ? ++arc.low : --arc.high));
      arc.from_low = !arc.from_low;
    }
    if (arc.from_low != to.from_low) return std::nullopt;
    return out;
  }

  std::span<const Point> points_;
  std::span<const VertexId> hull_;
  std::vector<bool> corner_;  // by place in the ring: not inside a hull edge
};

}  // namespace

std::optional<Sequence> sequence_of_few_inner(std::span<const Point> points,
                                              std::span<const VertexId> hull,
                                              std::span<const VertexId> inner) {
  const HullSequences sequences(points, hull);
  if (inner.empty()) return sequences.no_inner();
  if (inner.size() == 1) return sequences.one_inner(inner[0]);
  if (auto found = sequences.two_together(inner[0], inner[1])) return found;
  if (auto found = sequences.two_together(inner[1], inner[0])) return found;
  if (auto found = sequences.two_apart(inner[0], inner[1])) return found;
  return sequences.two_apart(inner[1], inner[0]);
}

}  // namespace quadloom::strips
