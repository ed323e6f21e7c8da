// The tables of the dynamic programme over trees of triangles.
//
// Steps: close_messages (from those of fixed triangles, until there is no new one), choose (the best
// way for each three messages). Equal choices: ways over two edges first, since their neighbours may
// then join them later; among these at random, with several variants of the table, since moves
// between equals are what lets ends of paths wander until two of them meet.
//
// Cost: constant, about 10^5 operations.
#include "strips/way_tables.hpp"

#include <algorithm>
#include <span>

#include "core/random.hpp"

namespace quadloom::strips {

int worth_of(EdgeWorth worth, EdgeUse a, EdgeUse b) {
  if (a == kUnused || b == kUnused) return 0;
  const bool same =
      (a == kKeepsPrevious && b == kKeepsNext) || (a == kKeepsNext && b == kKeepsPrevious);
  return same ? worth.same_side : worth.other_side;
}

WayTables::WayTables(EdgeWorth worth, std::uint64_t seed) {
  for (std::size_t a = 0; a < kUses; ++a) {
    for (std::size_t b = 0; b < kUses; ++b) {
      worth_[a][b] = worth_of(worth, static_cast<EdgeUse>(a), static_cast<EdgeUse>(b));
    }
    message_[messages_++] = worth_[a];
  }
  close_messages();
  choose(seed);
}

/// Of the edge with the given messages over the edges after and before it.
WayTables::Message WayTables::combine(const Message& next, const Message& previous) const {
  std::array<int, kUses> most;  // by the triangle's own use
  most[kUnused] =
      std::max({next[kKeepsNext] + previous[kKeepsPrevious], next[kAlone], previous[kAlone]});
  most[kKeepsPrevious] = previous[kKeepsNext];
  most[kKeepsNext] = next[kKeepsPrevious];
  most[kAlone] = 0;
  Message out = {};
  for (std::size_t theirs = 0; theirs < kUses; ++theirs) {
    out[theirs] = most[0] + worth_[0][theirs];
    for (std::size_t ours = 1; ours < kUses; ++ours) {
      out[theirs] = std::max(out[theirs], most[ours] + worth_[ours][theirs]);
    }
  }
  for (std::size_t theirs = kUses; theirs-- > 0;) out[theirs] -= out[0];
  return out;
}

std::uint8_t WayTables::number_of(const Message& message) {
  const std::span<const Message> known(message_.data(), messages_);
  const auto found = std::find(known.begin(), known.end(), message);
  const auto number = static_cast<std::uint8_t>(found - known.begin());
  if (found == known.end()) message_[messages_++] = message;
  return number;
}

void WayTables::close_messages() {
  for (std::size_t known = 0; known != messages_;) {
    known = messages_;
    for (std::size_t next = 0; next < known; ++next) {
      for (std::size_t previous = 0; previous < known; ++previous) {
        upward_[next * kMost + previous] = number_of(combine(message_[next], message_[previous]));
      }
    }
  }
}

void WayTables::choose(std::uint64_t seed) {
  Random random(seed);
  const auto best_way = [&](const std::array<std::size_t, 3>& number) {
    int most = -1;
    Way best = 0;
    std::uint64_t bits = random.next();
    for (Way way = 0; way < kWays; ++way, bits >>= 4) {
      int worth = 0;
      for (std::size_t e = 0; e < 3; ++e) worth += message_[number[e]][kUseOfWay[way][e]];
      const int rank = 64 * worth + (way < 3 ? 32 : 0) + static_cast<int>(bits & 15);
      if (rank <= most) continue;
      most = rank;
      best = way;
    }
    return best;
  };
  for (std::size_t variant = 0; variant < kVariants; ++variant) {
    for (std::size_t a = 0; a < messages_; ++a) {
      for (std::size_t b = 0; b < messages_; ++b) {
        Way* row = &best_[((variant * kMost + a) * kMost + b) * kMost];
        for (std::size_t c = 0; c < messages_; ++c) row[c] = best_way({a, b, c});
      }
    }
  }
}

}  // namespace quadloom::strips
