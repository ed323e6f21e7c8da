// Dynamic programme over chains of corners: the best parting of the polygon that the chain from corner
// i to corner j and the diagonal j-i enclose, for all odd j - i. The face at the diagonal is a quad
// i, a, b, j, or a hexagon with a star in it, and leaves three or five shorter chains.
#include "convex/best_parting.hpp"

#include <algorithm>
#include <array>

#include "convex/star.hpp"
#include "kernel/predicates_inline.hpp"
#include "kernel/squareness.hpp"

namespace quadloom::convex {
namespace {

constexpr double kImpossible = 1e18;

class Programme {
 public:
  Programme(std::span<const Point> polygon, const std::function<double(double)>& price_of)
      : p_(polygon), n_(polygon.size()), price_of_(price_of) {
    find_turns();
    find_diagonals();
  }

  std::optional<Parting> run(double limit, Stars stars) {
    fill(limit, Stars::kNone);
    if (stars == Stars::kAllowed && best(0, n_ - 1).cost >= kBadQuad) fill(limit, stars);
    if (best(0, n_ - 1).cost >= std::min(limit, kImpossible)) return std::nullopt;
    Parting out;
    out.cost = best(0, n_ - 1).cost;
    collect(out);
    return out;
  }

 private:
  /// The face at the diagonal of a chain; c and d are 0 if it is a quad.
  struct Best {
    double cost = kImpossible;
    std::uint8_t a = 0, b = 0, c = 0, d = 0;
    Point centre;
  };

  std::size_t index(std::size_t i, std::size_t j, std::size_t k) const {
    return (i * n_ + j) * n_ + k;
  }
  int turn(std::size_t i, std::size_t j, std::size_t k) const { return turn_[index(i, j, k)]; }
  Best& best(std::size_t i, std::size_t j) { return best_[i * n_ + j]; }
  bool side_or_diagonal(std::size_t i, std::size_t j) const {
    return j == i + 1 || (i == 0 && j == n_ - 1) || diagonal_[i * n_ + j] != 0;
  }

  void find_turns();
  void find_diagonals();
  bool inside_at(std::size_t i, std::size_t j) const;
  bool between(std::size_t i, std::size_t k, std::size_t j) const;
  bool is_diagonal(std::size_t i, std::size_t j) const;
  void fill(double limit, Stars stars);
  void try_quads(std::size_t i, std::size_t j);
  void try_stars(std::size_t i, std::size_t j, double limit);
  double quad_cost(std::size_t i, std::size_t a, std::size_t b, std::size_t j);
  void collect(Parting& out);

  std::span<const Point> p_;
  std::size_t n_;
  const std::function<double(double)>& price_of_;
  std::array<std::int8_t, kMostCorners * kMostCorners * kMostCorners> turn_;
  std::array<std::uint8_t, kMostCorners* kMostCorners> diagonal_ = {};
  std::array<Best, kMostCorners * kMostCorners> best_;
  std::array<std::uint8_t, kMostCorners* kMostCorners> star_parity_ = {};
};

void Programme::find_turns() {
  for (std::size_t i = 0; i < n_; ++i) {
    for (std::size_t j = i + 1; j < n_; ++j) {
      for (std::size_t k = j + 1; k < n_; ++k) {
        const auto sign = static_cast<std::int8_t>(kernel::orient(p_[i], p_[j], p_[k]));
        turn_[index(i, j, k)] = turn_[index(j, k, i)] = turn_[index(k, i, j)] = sign;
        turn_[index(i, k, j)] = turn_[index(k, j, i)] = turn_[index(j, i, k)] =
            static_cast<std::int8_t>(-sign);
      }
    }
  }
}

void Programme::find_diagonals() {
  for (std::size_t i = 0; i < n_; ++i) {
    for (std::size_t j = i + 3; j < n_; j += 2) {
      diagonal_[i * n_ + j] = (i != 0 || j != n_ - 1) && is_diagonal(i, j) ? 1 : 0;
    }
  }
}

/// Whether the direction from corner i to corner j points into the polygon.
bool Programme::inside_at(std::size_t i, std::size_t j) const {
  const std::size_t before = (i + n_ - 1) % n_, after = (i + 1) % n_;
  if (turn(before, i, after) > 0) return turn(i, j, before) > 0 && turn(i, after, j) > 0;
  return !(turn(i, j, after) >= 0 && turn(i, before, j) >= 0);
}

/// For collinear corners: whether k is between i and j.
bool Programme::between(std::size_t i, std::size_t k, std::size_t j) const {
  return (lex_less(p_[i], p_[k]) && lex_less(p_[k], p_[j])) ||
         (lex_less(p_[j], p_[k]) && lex_less(p_[k], p_[i]));
}

bool Programme::is_diagonal(std::size_t i, std::size_t j) const {
  if (!inside_at(i, j) || !inside_at(j, i)) return false;
  for (std::size_t k = 0; k < n_; ++k) {
    if (k == i || k == j) continue;
    if (turn(i, j, k) == 0 && between(i, k, j)) return false;
    const std::size_t next = (k + 1) % n_;
    if (next == i || next == j) continue;
    if (turn(i, j, k) * turn(i, j, next) < 0 && turn(k, next, i) * turn(k, next, j) < 0) {
      return false;
    }
  }
  return true;
}

void Programme::fill(double limit, Stars stars) {
  for (std::size_t i = 0; i + 1 < n_; ++i) best(i, i + 1) = {0, 0, 0, 0, 0, {}};
  for (std::size_t length = 3; length < n_; length += 2) {
    for (std::size_t i = 0; i + length < n_; ++i) {
      const std::size_t j = i + length;
      if (stars == Stars::kNone) best(i, j) = {};
      if (!side_or_diagonal(i, j)) continue;
      try_quads(i, j);
      if (stars == Stars::kAllowed && best(i, j).cost >= kBadQuad) try_stars(i, j, limit);
    }
  }
}

double Programme::quad_cost(std::size_t i, std::size_t a, std::size_t b, std::size_t j) {
  const bool convex =
      turn(j, i, a) > 0 && turn(i, a, b) > 0 && turn(a, b, j) > 0 && turn(b, j, i) > 0;
  if (!convex) return kBadQuad;
  return price_of_(kernel::squareness(p_[i], p_[a], p_[b], p_[j]));
}

void Programme::try_quads(std::size_t i, std::size_t j) {
  for (std::size_t a = i + 1; a < j; a += 2) {
    const double first = best(i, a).cost;
    if (first >= best(i, j).cost) continue;
    for (std::size_t b = a + 1; b < j; b += 2) {
      const double rest = first + best(a, b).cost + best(b, j).cost;
      if (rest >= best(i, j).cost) continue;
      const double cost = rest + quad_cost(i, a, b, j);
      if (cost < best(i, j).cost) {
        best(i, j) = {cost, static_cast<std::uint8_t>(a), static_cast<std::uint8_t>(b), 0, 0, {}};
      }
    }
  }
}

void Programme::try_stars(std::size_t i, std::size_t j, double limit) {
  for (std::size_t a = i + 1; a < j; a += 2) {
    for (std::size_t b = a + 1; b < j; b += 2) {
      for (std::size_t c = b + 1; c < j; c += 2) {
        const double first = best(i, a).cost + best(a, b).cost + best(b, c).cost + kStar;
        if (first >= std::min(best(i, j).cost, limit)) continue;
        for (std::size_t d = c + 1; d < j; d += 2) {
          const double rest = first + best(c, d).cost + best(d, j).cost;
          if (rest >= std::min(best(i, j).cost, limit)) continue;
          const std::array<Point, 6> hexagon = {p_[i], p_[a], p_[b], p_[c], p_[d], p_[j]};
          const auto star = place_star(hexagon);
          if (!star) continue;
          const double cost = rest + star->cost;
          if (cost >= best(i, j).cost) continue;
          const auto byte = [](std::size_t k) { return static_cast<std::uint8_t>(k); };
          best(i, j) = {cost, byte(a), byte(b), byte(c), byte(d), star->centre};
          star_parity_[i * n_ + j] = star->parity;
        }
      }
    }
  }
}

void Programme::collect(Parting& out) {
  std::vector<std::pair<std::size_t, std::size_t>> todo = {{0, n_ - 1}};
  const auto byte = [](std::size_t k) { return static_cast<std::uint8_t>(k); };
  while (!todo.empty()) {
    const auto [i, j] = todo.back();
    todo.pop_back();
    if (j == i + 1) continue;
    const Best& at = best(i, j);
    if (at.c == 0) {
      out.quads.push_back({byte(i), at.a, at.b, byte(j)});
      todo.insert(todo.end(), {{i, at.a}, {at.a, at.b}, {at.b, j}});
      continue;
    }
    const std::array<std::uint8_t, 6> corner = {byte(i), at.a, at.b, at.c, at.d, byte(j)};
    const auto centre = byte(n_ + out.added.size());
    out.added.push_back(at.centre);
    for (std::size_t k = star_parity_[i * n_ + j]; k < 6; k += 2) {
      out.quads.push_back({centre, corner[k], corner[(k + 1) % 6], corner[(k + 2) % 6]});
    }
    for (std::size_t k = 0; k < 5; ++k) todo.emplace_back(corner[k], corner[k + 1]);
  }
}

}  // namespace

std::optional<Parting> best_parting(std::span<const Point> polygon, double limit, Stars stars,
                                    const std::function<double(double)>& price_of) {
  return Programme(polygon, price_of).run(limit, stars);
}

}  // namespace quadloom::convex
