// A face of k corners is k - 2 consecutive triangles of the path, a point added on an inner diagonal
// gives one corner to each of the two faces there, and one on the hull edge of the first triangle
// gives one to the first face.
//
//   1. measure_reach   how many triangles from each place on have a simple polygon as their union:
//                      as long as no vertex repeats. A vertex comes twice, as a corner of the
//                      corridor's inner side and one turn of the spiral later of its outer side; a
//                      group of more than one turn would touch itself
//   2. where no group could touch itself: full groups, and the points that are missing go to the
//      hull edge. The rest of the path, from `begin` on:
//   3. search          the fewest points over all groupings (dynamic programme over the place and
//                      the number of points on the diagonal there); if that is too large a table,
//   4. group_backwards from the end, each group as long as possible
//
// Cost: O(t) without step 3; step 3 is bounded by kMostSteps.
#include "quadrangulate/path_groups.hpp"

#include <algorithm>

namespace quadloom::quadrangulate {
namespace {

constexpr std::size_t kMostStates = 5'000'000;
constexpr std::size_t kMostSteps = 100'000'000;
constexpr std::uint32_t kNever = 0xffffffffU;

/// reach[t]: the most triangles (up to full) from t on without a repeated vertex.
std::vector<std::uint32_t> measure_reach(const Serpentine& path, std::size_t full) {
  const std::size_t size = path.size();
  std::vector<std::uint32_t> reach(size);
  std::vector<std::uint32_t> uses(path.spiral.size(), 0);
  std::size_t end = 0;  // the corners of [begin, end) are counted
  for (std::size_t begin = 0; begin < size; ++begin) {
    if (end == begin) {
      ++uses[path.outer(begin)];
      ++uses[path.inner(begin)];
    }
    while (end < size && end - begin < full && uses[path.apex(end)] == 0) ++uses[path.apex(end++)];
    reach[begin] = static_cast<std::uint32_t>(end - begin);
    const bool outer_goes = begin + 1 == size || path.replaced(begin) == Replaced::kOuter;
    if (end == begin + 1) {
      uses[path.outer(begin)] = uses[path.inner(begin)] = uses[path.apex(begin)] = 0;
    } else {
      --uses[outer_goes ? path.outer(begin) : path.inner(begin)];
    }
  }
  return reach;
}

/// The fewest added points from a place (with points on its entering diagonal) to the end.
class Search {
 public:
  Search(const std::vector<std::uint32_t>& reach, const std::vector<char>& closed,
         std::size_t begin, std::size_t full)
      : reach_(reach), closed_(closed), begin_(begin), full_(full) {
    const std::size_t places = reach.size() - begin;
    cost_.assign(places * full, kNever);
    best_.assign(places * full, 0);
    choices_ = std::max<std::size_t>(2, kMostSteps / std::max<std::size_t>(1, places * full));
    for (std::size_t place = reach.size(); place-- > begin;) {
      for (std::size_t points = 0; points < full; ++points) solve(place, points);
    }
  }

  std::uint32_t cost(std::size_t place, std::size_t points) const {
    if (place == reach_.size()) return points == 0 ? 0 : kNever;
    if (points > 0 && closed_[place]) return kNever;
    return cost_[index(place, points)];
  }

  void append_groups(std::size_t place, std::size_t points, std::vector<PathGroup>& groups) const {
    while (place < reach_.size()) {
      const std::uint32_t triangles = best_[index(place, points)];
      groups.push_back({triangles, static_cast<std::uint32_t>(points)});
      points = full_ - points - triangles;
      place += triangles;
    }
  }

 private:
  std::size_t index(std::size_t place, std::size_t points) const {
    return (place - begin_) * full_ + points;
  }

  void solve(std::size_t place, std::size_t points) {
    std::uint32_t& cost_here = cost_[index(place, points)];
    const std::size_t most = std::min<std::size_t>(reach_[place], full_ - points);
    for (std::size_t g = most; g > 0 && most - g < choices_; --g) {
      const std::size_t leaving = full_ - points - g;
      const std::uint32_t rest = cost(place + g, leaving);
      if (rest == kNever) continue;
      const auto total = static_cast<std::uint32_t>(leaving) + rest;
      if (total < cost_here) {
        cost_here = total;
        best_[index(place, points)] = static_cast<std::uint32_t>(g);
      }
    }
  }

  const std::vector<std::uint32_t>& reach_;
  const std::vector<char>& closed_;
  std::size_t begin_;
  std::size_t full_;
  std::size_t choices_;
  std::vector<std::uint32_t> cost_, best_;
};

/// Always succeeds: what is missing at a group's front is added there and counts for the group
/// before it as well.
std::vector<PathGroup> group_backwards(const std::vector<std::uint32_t>& reach, std::size_t full) {
  std::vector<PathGroup> groups;
  std::size_t leaving = 0;
  for (std::size_t end = reach.size(); end > 0;) {
    std::size_t begin = end - 1;
    while (begin > 0 && end - begin < full - leaving && begin - 1 + reach[begin - 1] >= end)
      --begin;
    const std::size_t triangles = end - begin;
    leaving = full - leaving - triangles;
    groups.push_back({static_cast<std::uint32_t>(triangles), static_cast<std::uint32_t>(leaving)});
    end = begin;
  }
  std::reverse(groups.begin(), groups.end());
  return groups;
}

}  // namespace

std::vector<PathGroup> group_path(const Serpentine& path, std::size_t full,
                                  const std::vector<char>& closed) {
  const std::vector<std::uint32_t> reach = measure_reach(path, full);
  const std::size_t size = reach.size();
  std::size_t short_of = 0;  // the first place from which a full group would touch itself
  while (short_of < size && reach[short_of] == std::min(full, size - short_of)) ++short_of;
  const std::size_t begin = short_of == size ? size : short_of - std::min(short_of, 2 * full);
  if (size - begin > kMostStates / full) return group_backwards(reach, full);

  const Search search(reach, closed, begin, full);
  const auto place_of = [&](std::size_t on_hull) {  // the first group boundary from `begin` on
    if (begin == 0) return std::size_t{0};
    const std::size_t first = full - on_hull;
    return first >= begin ? first : first + (begin - first + full - 1) / full * full;
  };
  std::size_t best_on_hull = 0;
  std::size_t best = kNever;
  for (std::size_t on_hull = 0; on_hull < full; ++on_hull) {
    const std::size_t place = place_of(on_hull);
    if (place > size) continue;
    const std::uint32_t rest = search.cost(place, begin == 0 ? on_hull : 0);
    if (rest != kNever && on_hull + rest < best) {
      best = on_hull + rest;
      best_on_hull = on_hull;
    }
  }
  if (best == kNever) return group_backwards(reach, full);
  std::vector<PathGroup> groups;
  const std::size_t place = place_of(best_on_hull);
  for (std::size_t at = 0; at < place;) {
    const std::size_t entering = at == 0 ? best_on_hull : 0;
    groups.push_back(
        {static_cast<std::uint32_t>(full - entering), static_cast<std::uint32_t>(entering)});
    at += full - entering;
  }
  search.append_groups(place, begin == 0 ? best_on_hull : 0, groups);
  return groups;
}

}  // namespace quadloom::quadrangulate
