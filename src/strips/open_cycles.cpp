// Cycles of triangles made into paths.
//
// Steps: settle_ways (a use that the neighbour does not share is none), mark_cycles (what cannot be
// reached from an end), then for each cycle: best_opening (over its triangles c and the triangle x
// beside c), apply.
//
//      cycle  |  path              cycle  |  path
//       c'____c   x____             c'    c---x____       an edge less and an edge more: the cycle
//       |     |           becomes   |     |               costs nothing
//       |_____|                     |_____|
//
// What is a path's inner triangle beside c is left alone: it would cost that path an edge. Cost: O(n).
#include "strips/open_cycles.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <span>

namespace quadloom::strips {
namespace {

Way way_of_uses(bool u0, bool u1, bool u2) {
  constexpr std::array<Way, 8> kWay = {kNoWay, 3, 4, 2, 5, 1, 0, kNoWay};
  return kWay[u0 + 2 * u1 + 4 * u2];
}

std::vector<Way> settle_ways(const DualGraph& graph, const std::vector<Way>& way) {
  const std::vector<std::uint8_t> used = used_edges(graph, way);
  std::vector<Way> out(way.size());
  for (TriangleId t = 0; t < way.size(); ++t) {
    out[t] = way_of_uses(used[3 * t] != 0, used[3 * t + 1] != 0, used[3 * t + 2] != 0);
  }
  return out;
}

bool uses(Way way, HalfedgeId h) { return kUseOfWay[way][h % 3] != kUnused; }
bool is_inner(Way way) { return way < 3; }

Way with_edge(Way way, HalfedgeId h) {
  const auto use = [&](HalfedgeId i) { return uses(way, i) || i == h % 3; };
  return way_of_uses(use(0), use(1), use(2));
}

Way without_edge(Way way, HalfedgeId h) {
  const auto use = [&](HalfedgeId i) { return uses(way, i) && i != h % 3; };
  return way_of_uses(use(0), use(1), use(2));
}

/// Edges to drop and one to add, kNone: none.
struct Opening {
  HalfedgeId drop = kNone, drop_beside = kNone, add = kNone;
  int gain = 0;
};

class Opener {
 public:
  Opener(const DualGraph& graph, const WayTables& tables, std::vector<Way>& way)
      : graph_(graph), tables_(tables), way_(way), cycle_(way.size(), kCycle) {}

  void mark_cycles() {
    for (TriangleId t = 0; t < way_.size(); ++t) {
      if (!is_inner(way_[t]) && cycle_[t] != kPath) leave_cycle(t);
    }
  }

  void open(TriangleId t) {
    if (cycle_[t] == kPath) return;
    Opening best;
    best.gain = std::numeric_limits<int>::min();
    HalfedgeId leave = next_halfedge(3 * t + way_[t]);
    const HalfedgeId start = leave;
    do {
      cycle_[triangle_of(leave)] = kThisCycle;
      leave = other_use(graph_.twin[leave]);
    } while (leave != start);
    do {
      consider(leave, best);
      leave = other_use(graph_.twin[leave]);
    } while (leave != start);
    apply(best);
    leave_cycle(t);
  }

 private:
  enum : std::uint8_t { kPath = 0, kCycle = 1, kThisCycle = 2 };

  /// The other edge that the triangle of h, which has two, uses.
  HalfedgeId other_use(HalfedgeId h) const {
    const HalfedgeId next = next_halfedge(h);
    return uses(way_[triangle_of(h)], next) ? next : previous_halfedge(h);
  }

  /// Follows the path from its end or, opened, from any triangle: it is a cycle no longer.
  void leave_cycle(TriangleId from) {
    cycle_[from] = kPath;
    for (HalfedgeId h = 3 * from; h < 3 * from + 3; ++h) {
      if (!uses(way_[from], h)) continue;
      HalfedgeId entry = graph_.twin[h];
      while (cycle_[triangle_of(entry)] != kPath) {
        const TriangleId t = triangle_of(entry);
        cycle_[t] = kPath;
        if (!is_inner(way_[t])) break;
        entry = graph_.twin[other_use(entry)];
      }
    }
  }

  /// All openings at the triangle of `leave`, one of the cycle's halfedges.
  void consider(HalfedgeId leave, Opening& best) {
    const TriangleId c = triangle_of(leave);
    const HalfedgeId aside = 3 * c + way_[c];
    try_opening({leave, kNone, kNone, 0}, best);
    if (graph_.twin[aside] == kNone) return;
    const TriangleId x = graph_.across(aside);
    for (const HalfedgeId drop : {leave, other_use(leave)}) {
      if (!is_inner(way_[x])) {
        try_opening({drop, kNone, aside, 0}, best);
      } else if (cycle_[x] == kCycle) {
        const HalfedgeId beside = next_halfedge(graph_.twin[aside]);
        for (const HalfedgeId second : {beside, other_use(beside)}) {
          try_opening({drop, second, aside, 0}, best);
        }
      }
    }
  }

  void try_opening(Opening opening, Opening& best) {
    std::array<TriangleId, 6> around;
    std::size_t count = 0;
    for (const HalfedgeId h : {opening.drop, opening.drop_beside, opening.add}) {
      if (h == kNone) continue;
      for (const TriangleId t : {triangle_of(h), graph_.across(h)}) {
        if (std::find(around.begin(), around.begin() + count, t) == around.begin() + count) {
          around[count++] = t;
        }
      }
    }
    const std::span<const TriangleId> triangles(around.data(), count);
    std::array<Way, 6> before;
    for (std::size_t i = 0; i < count; ++i) before[i] = way_[around[i]];
    opening.gain = -worth_around(triangles);
    apply(opening);
    opening.gain += worth_around(triangles);
    for (std::size_t i = 0; i < count; ++i) way_[around[i]] = before[i];
    if (opening.drop_beside != kNone) opening.gain += tables_.worth(kAlone, kAlone);
    if (opening.gain > best.gain) best = opening;
  }

  void apply(const Opening& opening) {
    for (const HalfedgeId h : {opening.drop, opening.drop_beside}) {
      if (h == kNone) continue;
      for (const HalfedgeId side : {h, graph_.twin[h]}) {
        way_[triangle_of(side)] = without_edge(way_[triangle_of(side)], side);
      }
    }
    if (opening.add == kNone) return;
    for (const HalfedgeId side : {opening.add, graph_.twin[opening.add]}) {
      way_[triangle_of(side)] = with_edge(way_[triangle_of(side)], side);
    }
  }

  /// The worth of the edges of some triangles.
  int worth_around(std::span<const TriangleId> triangles) const {
    int worth = 0;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      for (HalfedgeId h = 3 * triangles[i]; h < 3 * triangles[i] + 3; ++h) {
        const HalfedgeId twin = graph_.twin[h];
        if (twin == kNone) continue;
        const auto earlier = triangles.first(i);
        if (std::find(earlier.begin(), earlier.end(), triangle_of(twin)) != earlier.end()) continue;
        worth += tables_.worth(kUseOfWay[way_[triangles[i]]][h % 3],
                               kUseOfWay[way_[triangle_of(twin)]][twin % 3]);
      }
    }
    return worth;
  }

  const DualGraph& graph_;
  const WayTables& tables_;
  std::vector<Way>& way_;
  std::vector<std::uint8_t> cycle_;
};

}  // namespace

std::vector<std::uint8_t> used_edges(const DualGraph& graph, const std::vector<Way>& way) {
  std::vector<std::uint8_t> used(graph.twin.size());
  for (HalfedgeId h = 0; h < used.size(); ++h) {
    const HalfedgeId twin = graph.twin[h];
    used[h] = twin != kNone && uses(way[triangle_of(h)], h) && uses(way[triangle_of(twin)], twin);
  }
  return used;
}

void open_cycles(const DualGraph& graph, const WayTables& tables, std::vector<Way>& way) {
  way = settle_ways(graph, way);
  Opener opener(graph, tables, way);
  opener.mark_cycles();
  for (TriangleId t = 0; t < way.size(); ++t) opener.open(t);
}

}  // namespace quadloom::strips
