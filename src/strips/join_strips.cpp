// Which strip goes on where another one ended.
//
// An end {apex, side, odd} and another one make a bridge of two vertices if they have the same apex
// and are both even or both odd; of three if one is odd, and they have the apex in common or the one's
// apex is the other's side. Otherwise it takes four or five, or a restart, which takes three, four for
// a strip that begins odd.
//
// Steps: join_alike (two vertices), join_unlike (three: where that saves something), then the chains
// of strips in order: those between even ends, those from even to odd, those between odd ends, so
// that (kRepeat) the end of one and the beginning of the next are alike; with restarts they stay in
// place and begin with an even end if they have one.
//
// Both steps take ends vertex by vertex and pair them first come, first served, but never the two
// ends of one chain. Cost: O(s log s) for sorting.
#include "strips/join_strips.hpp"

#include <algorithm>

namespace quadloom::strips {
namespace {

using EndId = std::uint32_t;  // 2 s and 2 s + 1 are the ends of strip s

class Chains {
 public:
  Chains(std::span<const std::array<StripEnd, 2>> ends, StripEncoding encoding)
      : ends_(ends), encoding_(encoding), link_(2 * ends.size(), kNone), far_(2 * ends.size()) {
    for (EndId e = 0; e < far_.size(); ++e) far_[e] = e ^ 1U;
  }

  void join_alike() {
    const std::vector<Entry> entries = entries_by_vertex(false);
    std::array<std::vector<EndId>, 2> waiting;  // by odd
    for (std::size_t i = 0; i < entries.size(); ++i) {
      if (i > 0 && entries[i].vertex != entries[i - 1].vertex) {
        for (auto& w : waiting) w.clear();
      }
      const EndId e = entries[i].end();
      if (!join_one(e, waiting[odd(e)])) waiting[odd(e)].push_back(e);
    }
  }

  void join_unlike() {
    const std::vector<Entry> entries = entries_by_vertex(true);
    std::array<std::array<std::vector<EndId>, 2>, 2> waiting;  // by odd; 0: apex, 1: side
    for (std::size_t i = 0; i < entries.size(); ++i) {
      if (i > 0 && entries[i].vertex != entries[i - 1].vertex) {
        for (auto& parity : waiting) {
          for (auto& w : parity) w.clear();
        }
      }
      const EndId e = entries[i].end();
      if (link_[e] != kNone) continue;
      auto& others = waiting[1 - odd(e)];
      if (join_one(e, others[0]) || (!entries[i].is_side() && join_one(e, others[1]))) continue;
      waiting[odd(e)][entries[i].is_side()].push_back(e);
    }
  }

  StripOrder order() && {
    if (encoding_ == StripEncoding::kRepeat) {
      send_alike();
    } else {
      for (EndId e = 0; e < link_.size(); ++e) {
        if (is_open(e)) send(odd(e) && !odd(far_[e]) ? far_[e] : e);
      }
    }
    return std::move(order_);
  }

 private:
  struct Entry {
    VertexId vertex;
    std::uint64_t id;  // 2 e, 2 e + 1 for the side
    EndId end() const { return static_cast<EndId>(id / 2); }
    bool is_side() const { return id % 2 == 1; }
  };

  StripEnd end(EndId e) const { return ends_[e / 2][e % 2]; }
  std::size_t odd(EndId e) const { return end(e).odd ? 1 : 0; }

  std::vector<Entry> entries_by_vertex(bool sides) const {
    std::vector<Entry> entries;
    for (EndId e = 0; e < link_.size(); ++e) {
      if (link_[e] != kNone) continue;
      entries.push_back({end(e).before, std::uint64_t{2} * e});
      if (sides) entries.push_back({end(e).last, std::uint64_t{2} * e + 1});
    }
    std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
      return a.vertex < b.vertex || (a.vertex == b.vertex && a.id < b.id);
    });
    return entries;
  }

  /// Joins e to one of the last that wait, if it may be; those joined elsewhere are thrown out.
  bool join_one(EndId e, std::vector<EndId>& waiting) {
    constexpr std::size_t kTries = 4;
    for (std::size_t i = waiting.size(), tried = 0; i-- > 0 && tried < kTries; ++tried) {
      const EndId other = waiting[i];
      const bool gone = link_[other] != kNone;
      if (!gone && !saves(e, other)) continue;
      waiting.erase(waiting.begin() + static_cast<std::ptrdiff_t>(i));
      if (gone) continue;
      join(e, other);
      return true;
    }
    return false;
  }

  /// Whether the chains of two ends are better joined.
  bool saves(EndId a, EndId b) const {
    if (far_[a] == b) return false;
    if (encoding_ == StripEncoding::kRepeat || odd(a) == odd(b)) return true;
    // Three vertices are what a restart takes: only for a chain that would begin odd, and so that
    // the new one does not.
    if (odd(b) != 0) std::swap(a, b);
    return odd(far_[a]) != 0 && odd(far_[b]) == 0;
  }

  void join(EndId a, EndId b) {
    link_[a] = b;
    link_[b] = a;
    const EndId x = far_[a], y = far_[b];
    far_[x] = y;
    far_[y] = x;
    ++order_.joined;
  }

  bool is_open(EndId e) const { return link_[e] == kNone; }

  /// Sends the chain that begins with e.
  void send(EndId e) {
    const EndId last = far_[e];
    for (;;) {
      order_.strip.push_back(e);
      const EndId on = link_[e ^ 1U];
      link_[e] = link_[e ^ 1U] = e;  // sent
      if ((e ^ 1U) == last) return;
      e = on;
    }
  }

  void send_alike() {
    std::array<std::vector<EndId>, 3> chains;  // both even, both odd, one of each: the even one
    for (EndId e = 0; e < link_.size(); ++e) {
      if (!is_open(e) || far_[e] < e) continue;
      if (odd(e) == odd(far_[e])) {
        chains[odd(e)].push_back(e);
      } else {
        chains[2].push_back(odd(e) != 0 ? far_[e] : e);
      }
    }
    for (const EndId e : chains[0]) send(e);
    for (std::size_t i = 0; i < std::max<std::size_t>(chains[2].size(), 1); ++i) {
      if (i < chains[2].size()) send(i % 2 == 0 ? chains[2][i] : far_[chains[2][i]]);
      if (i > 0) continue;
      for (const EndId e : chains[1]) send(e);
    }
  }

  std::span<const std::array<StripEnd, 2>> ends_;
  StripEncoding encoding_;
  std::vector<EndId> link_;  // the end with which a bridge joins it
  std::vector<EndId> far_;   // of the end of a chain: its other end
  StripOrder order_;
};

}  // namespace

StripOrder join_strips(std::span<const std::array<StripEnd, 2>> ends, StripEncoding encoding) {
  Chains chains(ends, encoding);
  if (encoding != StripEncoding::kSwap) {
    chains.join_alike();
    chains.join_unlike();
  }
  return std::move(chains).order();
}

}  // namespace quadloom::strips
