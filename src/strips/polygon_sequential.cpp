// Whether a polygon has a sequential triangulation: Arkin, Held, Mitchell and Skiena, theorem 4.4. O(E),
// E the chords of the visibility graph, and O(n) space.
//
// The vertices of such a triangulation, in the order of its sequence, go to and fro along the two sides
// of the polygon from a first corner k:
//
//      k + 1   k + 2   k + 3        k, k + 1, k - 1, k + 2, k - 2, ...    chords: sums 2k and 2k + 1
//     /   |  \  |  \  |             k, k - 1, k + 1, k - 2, k + 2, ...    chords: sums 2k and 2k - 1
//    k    |    \|    \|   ...
//     \_ k - 1 _ k - 2 ..           (the sum of a chord's ends, modulo n)
//
// So its chords are all pairs with the sum s or s + 1, for one s, that are not neighbours: n - 3 of them
// that cross nowhere. It exists if and only if all of these are chords.
//
//   1. polygon_disc     the corners in a circle
//   2. count_votes      for each sum modulo n, how many chords have it (Visibility, corner by corner)
//   3. find_full_sum    an s whose sum and the next one have as many as there are pairs
//   4. sequence_from    the sequence that belongs to it, as triangles
//
// What we do differently: the paper counts votes for first corners, of two kinds; a chord votes for the
// corners in the middle of either side, which are the two ends of the sequence. Sums say the same with one
// count, and the chords need not be kept.
//
// Degenerate input: chords touch no other corners (see Visibility), so a sequence found has no flat
// triangle, and one that is refused would have one. Cost: that of looking from every corner.
#include <optional>

#include "strips/polygon_path.hpp"
#include "strips/visibility.hpp"

namespace quadloom {
namespace strips {
namespace {

/// Per sum modulo n the number of chords. A chord is seen from both ends and counts from the first.
std::vector<Position> count_votes(const PolygonDisc& disc) {
  std::vector<Position> votes(disc.size(), 0);
  Visibility visibility(disc);
  for (Position i = 0; i < disc.size(); ++i) {
    for (const Seen& seen : visibility.look_from(i)) {
      if (seen.sight != Sight::kChord || seen.position < i) continue;
      ++votes[(std::uint64_t{i} + seen.position) % disc.size()];
    }
  }
  return votes;
}

/// The pairs of that sum that are not neighbours. Two corners are their own partners if n and s are
/// even, none if n is even and s is odd, else one; two pairs are neighbours if s is odd and n even, else
/// one if n is odd.
Position pairs_of_sum(Position n, Position s) {
  if (n % 2 == 1) return (n - 1) / 2 - 1;
  return s % 2 == 0 ? (n - 2) / 2 : n / 2 - 2;
}

std::optional<Position> find_full_sum(const std::vector<Position>& votes) {
  const auto n = static_cast<Position>(votes.size());
  for (Position s = 0; s < n; ++s) {
    const Position after = s + 1 == n ? 0 : s + 1;
    if (votes[s] == pairs_of_sum(n, s) && votes[after] == pairs_of_sum(n, after)) return s;
  }
  return std::nullopt;
}

//   s even: the first corner is k = s / 2, and k + 1 comes next. s odd: k = (s + 1) / 2, then k - 1.
std::vector<Position> sequence_from(const PolygonDisc& disc, Position s) {
  const Position first = (s + 1) / 2 % disc.size();
  Position up = first, down = first;
  std::vector<Position> sequence = {first};
  for (bool rises = s % 2 == 0; sequence.size() < disc.size(); rises = !rises) {
    Position& end = rises ? up : down;
    end = rises ? disc.next(end) : disc.previous(end);
    sequence.push_back(end);
  }
  return sequence;
}

std::vector<Position> triangles_of(const PolygonDisc& disc, const std::vector<Position>& sequence) {
  std::vector<Position> corners;
  for (std::size_t i = 0; i + 2 < sequence.size(); ++i) {
    const Position a = sequence[i], b = sequence[i + 1], c = sequence[i + 2];
    const bool left = orient2d(disc.at(a), disc.at(b), disc.at(c)) > 0;
    corners.insert(corners.end(), {a, left ? b : c, left ? c : b});
  }
  return corners;
}

}  // namespace
}  // namespace strips

std::optional<PolygonOrder> sequential_triangulation(const Polygon& polygon) {
  strips::PolygonDisc disc = strips::polygon_disc(polygon);
  std::vector<strips::Position> corners = {0, 1, 2};
  if (disc.size() > 3) {
    const auto sum = strips::find_full_sum(strips::count_votes(disc));
    if (!sum) return std::nullopt;
    corners = strips::triangles_of(disc, strips::sequence_from(disc, *sum));
  }
  return strips::order_of_disc(std::move(disc), corners, OrderKind::kSequential);
}

}  // namespace quadloom
