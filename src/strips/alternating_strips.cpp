// Strips that alternate, one after the other, as stripifiers take them (SGI's; Akeley and others).
//
// Steps, for each triangle that is not yet on a path: follow (both ways, for each of its three pairs
// of edges, until a path or the boundary is met), keep (the longest of the three).
//
// Cost: O(n), since what is followed in vain is at most twice what is kept.
#include "strips/alternating_strips.hpp"

#include <array>

namespace quadloom::strips {
namespace {

/// The way over the edges of two halfedges of a triangle.
Way way_over(HalfedgeId a, HalfedgeId b) { return static_cast<Way>(3 - a % 3 - b % 3); }

class Strips {
 public:
  explicit Strips(const DualGraph& graph)
      : graph_(graph), way_(graph.node_count(), kNoWay), seen_(graph.node_count(), kNone) {}

  void take_from(TriangleId t) {
    if (way_[t] != kNoWay) return;
    std::size_t best = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      follow(t, i, strip_[i]);
      if (strip_[i].rank() > strip_[best].rank()) best = i;
    }
    keep(t, best, strip_[best]);
  }

  std::vector<Way> ways() && { return std::move(way_); }

 private:
  struct Strip {
    std::vector<HalfedgeId> ahead, behind;  // by which the triangles are entered
    /// Long ones first, then those that may begin even at one of their ends: t turns right, and a
    /// strip begins even if its first turn, seen from there, is a left one.
    std::size_t rank() const {
      const bool odd = behind.size() % 2 == 1 && ahead.size() % 2 == 0;
      return 2 * (ahead.size() + behind.size()) + (odd ? 0 : 1);
    }
  };

  //      ______
  //     /\  t /\        ahead: out by the edge before `omitted`, then left, right, ...
  //    /  \  /  \       behind: out by the one after it, then right, left, ...
  //   /____\/____\      .
  void follow(TriangleId t, std::size_t omitted, Strip& strip) {
    const HalfedgeId skip = 3 * t + static_cast<HalfedgeId>(omitted);
    seen_[t] = ++stamp_;
    walk(previous_halfedge(skip), false, strip.ahead);
    walk(next_halfedge(skip), true, strip.behind);
  }

  void walk(HalfedgeId leave, bool right, std::vector<HalfedgeId>& entries) {
    entries.clear();
    for (;;) {
      const HalfedgeId entry = graph_.twin[leave];
      if (entry == kNone) return;
      const TriangleId t = triangle_of(entry);
      if (way_[t] != kNoWay || seen_[t] == stamp_) return;
      seen_[t] = stamp_;
      entries.push_back(entry);
      leave = right ? next_halfedge(entry) : previous_halfedge(entry);
      right = !right;
    }
  }

  void keep(TriangleId t, std::size_t omitted, const Strip& strip) {
    const HalfedgeId skip = 3 * t + static_cast<HalfedgeId>(omitted);
    for (const auto* entries : {&strip.ahead, &strip.behind}) {
      for (std::size_t i = 0; i < entries->size(); ++i) {
        const HalfedgeId entry = (*entries)[i];
        way_[triangle_of(entry)] = i + 1 < entries->size()
                                       ? way_over(entry, graph_.twin[(*entries)[i + 1]])
                                       : static_cast<Way>(3 + entry % 3);
      }
    }
    if (!strip.ahead.empty() && !strip.behind.empty()) {
      way_[t] = static_cast<Way>(omitted);
    } else {
      way_[t] = static_cast<Way>(
          3 + (strip.ahead.empty() ? next_halfedge(skip) : previous_halfedge(skip)) % 3);
    }
  }

  const DualGraph& graph_;
  std::vector<Way> way_;
  std::vector<std::uint32_t> seen_;
  std::uint32_t stamp_ = 0;
  std::array<Strip, 3> strip_;
};

}  // namespace

std::vector<Way> alternating_strips(const DualGraph& graph) {
  Strips strips(graph);
  for (TriangleId t = 0; t < graph.node_count(); ++t) strips.take_from(t);
  return std::move(strips).ways();
}

}  // namespace quadloom::strips
