// Steps: place_of for each edge; bulge_around for those that have no place.
//
// A place is sought at the midpoint as rounded, then outwards from it by doublings of one unit in the
// last place, then exactly on the edge (kernel/point_on_segment.hpp, a complete search). Each one is
// accepted by exact predicates alone; what is computed in floating point only proposes.
//
// Cost: O(1) an edge; a bulge costs its length for each height tried.
#include "quadrangulate/subdivision_boundary.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "kernel/point_on_segment.hpp"
#include "quadloom/kernel.hpp"
#include "quadrangulate/subdivision_places.hpp"

namespace quadloom::quadrangulate {
namespace {

constexpr int kNudges = 64;              // doublings of one unit in the last place
constexpr int kHeights = 40;             // halvings and doublings of a bulge's height
constexpr double kSlightTurn = 0x1p-20;  // sine of a turn that a bulge may go around

bool turns_left(Point a, Point b, Point c) { return orient2d(a, b, c) > 0; }
bool is_finite(Point p) { return std::isfinite(p.x) && std::isfinite(p.y); }
Point minus(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
double length(Point v) { return std::hypot(v.x, v.y); }

}  // namespace

SubdivisionBoundary::SubdivisionBoundary(std::vector<Point> polygon)
    : polygon_(std::move(polygon)), edge_place_(polygon_.size()), cap_(polygon_.size()) {}

std::optional<std::size_t> SubdivisionBoundary::place_all() {
  std::vector<std::size_t> without;
  for (std::size_t i = 0; i < size(); ++i) {
    edge_place_[i] = place_of(i);
    if (!edge_place_[i]) without.push_back(i);
  }
  for (const std::size_t i : without) {
    if (!edge_place_[i] && !bulge_around(i)) return i;
  }
  return std::nullopt;
}

/// The neighbours' points count as far as they are placed.
///
///      before ---- a           b ---- after      (the polygon is above)
///                    ` .   . '
///                       m
bool SubdivisionBoundary::fits(std::size_t i, Point m) const {
  if (!is_finite(m)) return false;
  const Point a = polygon_[i];
  const Point b = polygon_[after(i)];
  const Point from = edge_place_[before(i)].value_or(polygon_[before(i)]);
  const Point to = edge_place_[after(i)].value_or(polygon_[after(after(i))]);
  const int side = orient2d(a, b, m);
  if (side > 0) return false;
  if (side < 0) return turns_left(from, a, m) && turns_left(m, b, to);
  const bool between = lex_less(a, b) ? lex_less(a, m) && lex_less(m, b)  //
                                      : lex_less(b, m) && lex_less(m, a);
  return between && orient2d(from, a, m) >= 0 && orient2d(m, b, to) >= 0;
}

std::optional<Point> SubdivisionBoundary::place_of(std::size_t i) const {
  const Point a = polygon_[i];
  const Point b = polygon_[after(i)];
  const Point middle = along_edge(a, b, 4);
  if (fits(i, middle)) return middle;
  for (int step = 0; step < kNudges; ++step) {
    const Point place = nudged_right(middle, a, b, step);
    if (fits(i, place)) return place;
  }
  const auto place = kernel::point_on_segment(a, b);
  return place && fits(i, *place) ? place : std::nullopt;
}

bool SubdivisionBoundary::almost_straight(std::size_t i) const {
  const Point in = minus(polygon_[i], polygon_[before(i)]);
  const Point out = minus(polygon_[after(i)], polygon_[i]);
  const double sine = (in.x / length(in)) * (out.y / length(out)) -  //
                      (in.y / length(in)) * (out.x / length(out));
  return std::fabs(sine) < kSlightTurn && in.x / length(in) * out.x + in.y / length(in) * out.y > 0;
}

/// The longest chain about edge i whose inner corners are almost straight, then heights from a
/// sixteenth of its shortest edge on.
std::optional<SubdivisionBoundary::Chain> SubdivisionBoundary::bulge_around(std::size_t i) {
  std::size_t first = i;
  std::size_t count = 1;
  while (almost_straight(first) && count < size()) {
    first = before(first);
    ++count;
  }
  for (std::size_t end = after(i); almost_straight(end) && count < size(); end = after(end))
    ++count;
  if (count >= size()) return std::nullopt;

  double shortest = HUGE_VAL;
  for (std::size_t k = 0, j = first; k < count; ++k, j = after(j)) {
    shortest = std::min(shortest, length(minus(polygon_[after(j)], polygon_[j])));
  }
  for (int power = 4; power < kHeights; ++power) {
    if (bulge({first, count}, std::ldexp(shortest, -power))) return Chain{first, count};
  }
  for (int power = -3; power < kHeights; ++power) {
    if (bulge({first, count}, std::ldexp(shortest, power))) return Chain{first, count};
  }
  return std::nullopt;
}

/// Puts the points of the chain's edges, and the caps between them, on a parabola of that height over
/// the chain; false and nothing changed if the polygon would not be strictly convex.
bool SubdivisionBoundary::bulge(Chain chain, double height) {
  const auto [first, count] = chain;
  const Point start = polygon_[first];
  const Point end = polygon_[(first + count) % size()];
  const Point along = minus(end, start);
  const Point outwards = {along.y / length(along), -along.x / length(along)};
  const auto lifted = [&](Point p) {
    const Point d = minus(p, start);
    const double t = (d.x / length(along)) * (along.x / length(along)) +
                     (d.y / length(along)) * (along.y / length(along));
    const double h = height * 4 * t * (1 - t);
    return Point{p.x + h * outwards.x, p.y + h * outwards.y};
  };

  std::vector<Point> arc;  // edge point, cap, edge point, cap, ..., edge point
  for (std::size_t k = 0, j = first; k < count; ++k, j = after(j)) {
    if (k > 0) arc.push_back(lifted(polygon_[j]));
    arc.push_back(lifted(along_edge(polygon_[j], polygon_[after(j)], 4)));
  }

  std::vector<Point> turn = {edge_place_[before(first)].value_or(polygon_[before(first)]), start};
  turn.insert(turn.end(), arc.begin(), arc.end());
  const std::size_t beyond = (first + count) % size();
  turn.push_back(end);
  turn.push_back(edge_place_[beyond].value_or(polygon_[after(beyond)]));
  if (!std::all_of(turn.begin(), turn.end(), is_finite)) return false;
  for (std::size_t k = 2; k < turn.size(); ++k) {
    if (!turns_left(turn[k - 2], turn[k - 1], turn[k])) return false;
  }
  for (std::size_t k = 1, j = after(first); k < count; ++k, j = after(j)) {
    const Point m = arc[2 * k - 2], cap = arc[2 * k - 1], n = arc[2 * k], u = polygon_[j];
    if (!turns_left(u, m, cap) || !turns_left(cap, n, u) || !turns_left(n, u, m)) return false;
  }

  for (std::size_t k = 0, j = first; k < count; ++k, j = after(j)) {
    edge_place_[j] = arc[2 * k];
    if (k > 0) cap_[j] = arc[2 * k - 1];
  }
  return true;
}

}  // namespace quadloom::quadrangulate
