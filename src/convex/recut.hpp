// A small polygon with points inside in strictly convex quads, with few added points: a search.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "convex/cluster.hpp"

namespace quadloom::convex {

inline constexpr std::size_t kMostRecutPoints = 32;  // of all three kinds

/// Which recut is found first, if there are several.
enum class RecutOrder : std::uint8_t {
  kShape,   ///< good shapes first
  kRandom,  ///< any: the search begins anew elsewhere each time
};

struct Recut {
  std::vector<ClusterQuad> quads;    ///< corners, then points inside, then added points
  std::vector<std::uint8_t> places;  ///< which of the places each added point is at
};

/// The search, for one polygon. All of it exact.
class RecutSearch {
 public:
  /// O(N^3) for N points in all, at most kMostRecutPoints.
  RecutSearch(std::span<const Point> corner, std::span<const Point> inside,
              std::span<const Point> places);

  /// Quads that are strictly convex and tile the polygon, each point inside a vertex, at most so many places in use. None
  /// if the search found none within its steps (quads placed): with few places this says little. It takes the open edge
  /// with the fewest quads that fit, again and again. O(N^2) a step or so.
  std::optional<Recut> find(std::size_t most_added, std::size_t steps, RecutOrder order,
                            Random& random);

 private:
  using Set = std::uint32_t;  // of points, one bit each

  /// What is left to be cut.
  struct State {
    std::array<Set, kMostRecutPoints> free{};  // free[a]: b if a new quad may have the side a -> b
    std::array<Set, kMostRecutPoints> open{};  // open[a]: b if it has to
    Set vertices = 0;                          // corners, points inside, and added points so far
    std::size_t added = 0;
  };
  struct Quad {
    std::array<std::uint8_t, 4> corner{};
    double score = 0;
  };
  using Quads = std::vector<Quad>;

  Set left(std::size_t a, std::size_t b) const { return left_[a * kMostRecutPoints + b]; }
  Set all_given() const { return given_ < 32 ? (Set{1} << given_) - 1 : ~Set{0}; }

  void find_lefts();
  void find_edges();
  bool inside_at(std::size_t i, std::size_t j) const;
  bool is_edge(std::size_t a, std::size_t b) const;
  bool between(std::size_t a, std::size_t k, std::size_t b) const;
  State start() const;
  bool search(const State& state);
  bool fewest_quads(const State& state, Quads& out);
  template <class Call>
  bool quads_at(const State& state, std::size_t a, std::size_t b, Call&& call) const;
  void place(State& state, const Quad& quad) const;
  void close_off(State& state, std::size_t a, std::size_t b) const;
  Recut result() const;

  const std::size_t corners_, given_, n_;
  std::array<Point, kMostRecutPoints> p_;
  std::array<Set, kMostRecutPoints * kMostRecutPoints> left_{};
  std::array<Set, kMostRecutPoints> edge_{};

  std::size_t most_added_ = 0, steps_left_ = 0;
  RecutOrder order_ = RecutOrder::kShape;
  Random* random_ = nullptr;
  std::vector<Quad> placed_;
};

/// Whether the counts of edges and of corners that need one leave room for so many added points; false is certain.
bool may_be_recut(std::span<const Point> corner, std::size_t inside, std::size_t added);

}  // namespace quadloom::convex
