// A round of many points on several threads, with the same result for any number of them.
//
// Steps:
//   1. find_seeds    for each leg of the curve a triangle to start from
//   2. insert_range  the curve is cut into ranges; each inserts its points within itself
//                    (DelaunayInserter) and puts off those that would reach out of it
//   3. insert_rest   those that were put off, one after the other
//
// Why it is sound: ranges have no vertex in common, so their cavities do not touch, and insertions
// that do not touch may be done in any order. Which points are put off depends on the points and the
// cuts alone, and each point has its own two fresh triangles, by its place in the order. Any of them may
// be put off, and where a walk starts changes the numbers of triangles at most.
//
// Cost: of 90,000 random points one in 11 is put off, of a million one in 29, of ten million one in 90.
// What is tried twice and what lies farther apart in memory costs one thread a few hundredths of the
// time. On rows nearly all points are put off, most of them untried, so they take as long as one by one.
#include "kernel/delaunay_ranges.hpp"

#include <algorithm>
#include <span>
#include <vector>

#include "core/parallel.hpp"

namespace quadloom::kernel {
namespace {

// More ranges have longer borders, fewer do not share out as well.
constexpr std::uint32_t kRanges = 8;
/// So many vertices are a leg, where a range looks for a new start if the last point was put off: a walk
/// that has gone astray fails until then. An eighth of them are there before the round.
constexpr std::uint32_t kLeg = 128;
/// After so many points one after the other were put off, as where they lie on rows, the others of the
/// leg are put off untried.
constexpr int kInVain = 24;

class RangedRound {
 public:
  RangedRound(DelaunayMesh& mesh, std::span<const std::uint32_t> order, std::size_t begin,
              std::size_t end)
      : mesh_(mesh),
        order_(order),
        begin_(begin),
        end_(end),
        range_(((mesh.ghost - 1) / (kRanges * kLeg) + 1) * kLeg) {}

  void find_seeds();
  std::vector<std::uint32_t> insert_range(std::uint32_t begin, std::uint32_t end) const;
  std::vector<std::uint32_t> insert_ranges() const;
  void insert_rest(std::span<const std::uint32_t> rest, DelaunayInserter& anywhere) const;

 private:
  std::size_t place_of(std::uint32_t vertex) const;
  static std::uint32_t near(std::uint32_t place);
  void prefetch_triangle(std::uint32_t place) const;
  void prefetch_points(std::uint32_t place) const;

  DelaunayMesh& mesh_;
  std::span<const std::uint32_t> order_;
  std::size_t begin_, end_;
  std::uint32_t range_;  // how many vertices each has, whole legs
  std::vector<std::uint32_t> seed_;
};

/// For each leg a triangle in its range with the first corner in the leg, if there is one.
void RangedRound::find_seeds() {
  seed_.assign(kRanges * (range_ / kLeg), kNone);
  for (std::uint32_t t = 0; t < DelaunayMesh::triangles_of(begin_); ++t) {
    const auto& v = mesh_.triangles[t].v;
    if (mesh_.is_ghost(mesh_.triangles[t])) continue;
    const std::uint32_t range = v[0] / range_;
    if (v[1] / range_ == range && v[2] / range_ == range) seed_[v[0] / kLeg] = t;
  }
}

/// Of the first point of the round that is not before the vertex.
std::size_t RangedRound::place_of(std::uint32_t vertex) const {
  const std::span<const std::uint32_t> round = order_.subspan(begin_, end_ - begin_);
  const auto at = std::lower_bound(round.begin(), round.end(), vertex);
  return begin_ + static_cast<std::size_t>(at - round.begin());
}

/// Returns the places of those that it puts off.
std::vector<std::uint32_t> RangedRound::insert_range(std::uint32_t begin, std::uint32_t end) const {
  std::vector<std::uint32_t> put_off;
  DelaunayInserter within(mesh_, begin, end);
  bool started = false;
  int in_vain = 0;  // since the last point that was inserted, or the begin of the leg
  std::uint32_t next_leg = begin;
  for (std::size_t i = place_of(begin), stop = place_of(end); i < stop; ++i) {
    const std::uint32_t p = order_[i];
    if (p >= next_leg) {
      const std::uint32_t leg = p / kLeg;
      next_leg = (leg + 1) * kLeg;
      if ((!started || in_vain > 0) && seed_[leg] != kNone) {
        within.start_at(seed_[leg]);
        started = true;
      }
      in_vain = 0;
    }
    if (started && in_vain < kInVain && within.insert_within(p, DelaunayMesh::triangles_of(i))) {
      in_vain = 0;
    } else {
      ++in_vain;
      put_off.push_back(static_cast<std::uint32_t>(i));
    }
  }
  return put_off;
}

/// What all ranges put off, in the order of the curve.
std::vector<std::uint32_t> RangedRound::insert_ranges() const {
  std::vector<std::vector<std::uint32_t>> of_range(kRanges);
  parallel_tasks(kRanges, [&](std::size_t i) {
    const std::uint32_t begin = static_cast<std::uint32_t>(i) * range_;
    of_range[i] = insert_range(begin, std::min(begin + range_, mesh_.ghost));
  });
  std::vector<std::uint32_t> all;
  for (const auto& put_off : of_range) all.insert(all.end(), put_off.begin(), put_off.end());
  return all;
}

/// The triangle that came with the point before, or what has become of it: not far from it, if maybe no
/// longer at it.
std::uint32_t RangedRound::near(std::uint32_t place) {
  return DelaunayMesh::triangles_of(place - 1);
}

void RangedRound::prefetch_triangle(std::uint32_t place) const {
  __builtin_prefetch(&mesh_.triangles[near(place)]);
  __builtin_prefetch(&mesh_.points[order_[place]]);
}

void RangedRound::prefetch_points(std::uint32_t place) const {
  const DelaunayMesh::Triangle& t = mesh_.triangles[near(place)];
  for (std::size_t i = 0; i < 3; ++i) {
    __builtin_prefetch(&mesh_.points[t.v[i]]);
    __builtin_prefetch(&mesh_.triangles[t.twin[i] >> 2]);
  }
}

// They lie farther apart than others, so the memory of the next ones is fetched ahead.
void RangedRound::insert_rest(std::span<const std::uint32_t> rest,
                              DelaunayInserter& anywhere) const {
  constexpr std::size_t kAhead = 4;
  std::uint32_t before = kNone;
  for (std::size_t i = 0; i < rest.size(); ++i) {
    if (i + 2 * kAhead < rest.size()) prefetch_triangle(rest[i + 2 * kAhead]);
    if (i + kAhead < rest.size()) prefetch_points(rest[i + kAhead]);
    const std::uint32_t place = rest[i];
    const bool follows = place - 1 == before;  // then the walk starts at that very point
    if (!follows && !mesh_.is_ghost(mesh_.triangles[near(place)])) anywhere.start_at(near(place));
    anywhere.insert(order_[place], DelaunayMesh::triangles_of(place));
    before = place;
  }
}

}  // namespace

std::size_t insert_in_ranges(DelaunayMesh& mesh, const InsertionOrder& order, std::size_t begin,
                             std::size_t end, DelaunayInserter& anywhere) {
  RangedRound round(mesh, order.point, begin, end);
  round.find_seeds();
  const std::vector<std::uint32_t> rest = round.insert_ranges();
  round.insert_rest(rest, anywhere);
  return rest.size();
}

}  // namespace quadloom::kernel
