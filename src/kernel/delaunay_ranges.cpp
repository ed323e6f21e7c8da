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
// cuts alone, and each point has its own two fresh triangles, by its place in the order.
//
// Cost: of a million random points one in 25 is put off, of ten million one in 80. What is tried twice
// and what lies farther apart in memory costs one thread a few hundredths of the time.
#include "kernel/delaunay_ranges.hpp"

#include <algorithm>
#include <span>
#include <vector>

#include "core/parallel.hpp"

namespace quadloom::kernel {
namespace {

// More ranges have longer borders, fewer do not share out as well. A leg is what a range looks for a
// new start for after a point that was put off: without legs twice as many are.
constexpr std::uint32_t kRanges = 8;
constexpr std::uint32_t kLegs = 32;  // of each range
/// Where more than half of the points are put off, as where they lie on rows, the rest is put off untried.
constexpr std::size_t kFewPutOff = 100;

/// A point by its place in the order, and a triangle near it, or kNone.
struct PutOff {
  std::uint32_t place, near;
};

class RangedRound {
 public:
  RangedRound(DelaunayMesh& mesh, std::span<const std::uint32_t> order, std::size_t begin,
              std::size_t end)
      : mesh_(mesh),
        order_(order),
        begin_(begin),
        end_(end),
        leg_((mesh.ghost - 1) / (kRanges * kLegs) + 1),
        range_(kLegs * leg_) {}

  void find_seeds();
  std::vector<PutOff> insert_range(std::uint32_t begin, std::uint32_t end) const;
  std::vector<PutOff> insert_ranges() const;
  bool is_nearer(std::uint32_t near, std::uint32_t p, std::uint32_t before) const;
  void insert_rest(std::span<const PutOff> rest, DelaunayInserter& anywhere) const;

 private:
  std::size_t place_of(std::uint32_t vertex) const;
  void prefetch_triangle(const PutOff& p) const;
  void prefetch_points(const PutOff& p) const;

  DelaunayMesh& mesh_;
  std::span<const std::uint32_t> order_;
  std::size_t begin_, end_;
  std::uint32_t leg_, range_;  // how many vertices each has
  std::vector<std::uint32_t> seed_;
};

/// For each leg a triangle in its range with the first corner in the leg, if there is one.
void RangedRound::find_seeds() {
  seed_.assign(kRanges * kLegs, kNone);
  for (std::uint32_t t = 0; t < DelaunayMesh::triangles_of(begin_); ++t) {
    const auto& v = mesh_.triangles[t].v;
    if (mesh_.is_ghost(mesh_.triangles[t])) continue;
    const std::uint32_t range = v[0] / range_;
    if (v[1] / range_ == range && v[2] / range_ == range) seed_[v[0] / leg_] = t;
  }
}

/// Of the first point of the round that is not before the vertex.
std::size_t RangedRound::place_of(std::uint32_t vertex) const {
  const std::span<const std::uint32_t> round = order_.subspan(begin_, end_ - begin_);
  const auto at = std::lower_bound(round.begin(), round.end(), vertex);
  return begin_ + static_cast<std::size_t>(at - round.begin());
}

/// Returns what it puts off.
std::vector<PutOff> RangedRound::insert_range(std::uint32_t begin, std::uint32_t end) const {
  std::vector<PutOff> put_off;
  DelaunayInserter within(mesh_, begin, end);
  bool started = false, inserted = false;
  std::uint32_t next_leg = begin;
  const std::size_t first = place_of(begin), last = place_of(end);
  for (std::size_t i = first; i < last; ++i) {
    const std::uint32_t p = order_[i];
    if (p >= next_leg) {
      const std::uint32_t leg = p / leg_;
      next_leg = (leg + 1) * leg_;
      if (!inserted && seed_[leg] != kNone) {
        within.start_at(seed_[leg]);
        started = true;
      }
    }
    const bool in_vain = put_off.size() > kFewPutOff + (i - first) / 2;
    inserted = started && !in_vain && within.insert_within(p, DelaunayMesh::triangles_of(i));
    if (inserted) continue;
    put_off.push_back(
        {static_cast<std::uint32_t>(i), started && !in_vain ? within.stopped_at() : kNone});
  }
  return put_off;
}

/// What all ranges put off, in the order of the curve.
std::vector<PutOff> RangedRound::insert_ranges() const {
  std::vector<std::vector<PutOff>> of_range(kRanges);
  parallel_tasks(kRanges, [&](std::size_t i) {
    const std::uint32_t begin = static_cast<std::uint32_t>(i) * range_;
    of_range[i] = insert_range(begin, std::min(begin + range_, mesh_.ghost));
  });
  std::vector<PutOff> all;
  for (const auto& put_off : of_range) all.insert(all.end(), put_off.begin(), put_off.end());
  return all;
}

void RangedRound::prefetch_triangle(const PutOff& p) const {
  if (p.near != kNone) __builtin_prefetch(&mesh_.triangles[p.near]);
  __builtin_prefetch(&mesh_.points[order_[p.place]]);
}

void RangedRound::prefetch_points(const PutOff& p) const {
  if (p.near == kNone) return;
  const DelaunayMesh::Triangle& t = mesh_.triangles[p.near];
  for (std::size_t i = 0; i < 3; ++i) {
    __builtin_prefetch(&mesh_.points[t.v[i]]);
    __builtin_prefetch(&mesh_.triangles[t.twin[i] >> 2]);
  }
}

/// Whether the walk to p should start at the triangle `near`, not at the point before: on rows of points a range puts off
/// nearly all, and the triangle where it stopped may be far from them.
bool RangedRound::is_nearer(std::uint32_t near, std::uint32_t p, std::uint32_t before) const {
  if (near == kNone || mesh_.is_ghost(mesh_.triangles[near])) return false;
  if (before == kNone) return true;
  const auto distance = [&](std::uint32_t v) {
    const double x = mesh_.points[v].x - mesh_.points[p].x;
    const double y = mesh_.points[v].y - mesh_.points[p].y;
    return x * x + y * y;
  };
  return distance(mesh_.triangles[near].v[0]) < distance(before);
}

// They lie farther apart than others, so the memory of the next ones is fetched ahead.
void RangedRound::insert_rest(std::span<const PutOff> rest, DelaunayInserter& anywhere) const {
  constexpr std::size_t kAhead = 4;
  std::uint32_t before = kNone;
  for (std::size_t i = 0; i < rest.size(); ++i) {
    if (i + 2 * kAhead < rest.size()) prefetch_triangle(rest[i + 2 * kAhead]);
    if (i + kAhead < rest.size()) prefetch_points(rest[i + kAhead]);
    const auto [place, near] = rest[i];
    if (is_nearer(near, order_[place], before)) anywhere.start_at(near);
    anywhere.insert(order_[place], DelaunayMesh::triangles_of(place));
    before = order_[place];
  }
}

}  // namespace

std::size_t insert_in_ranges(DelaunayMesh& mesh, const InsertionOrder& order, std::size_t begin,
                             std::size_t end, DelaunayInserter& anywhere) {
  RangedRound round(mesh, order.point, begin, end);
  round.find_seeds();
  const std::vector<PutOff> rest = round.insert_ranges();
  round.insert_rest(rest, anywhere);
  return rest.size();
}

}  // namespace quadloom::kernel
