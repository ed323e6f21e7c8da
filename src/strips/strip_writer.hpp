// Writes strips vertex by vertex.
#pragma once

#include <array>
#include <span>
#include <utility>

#include "quadloom/strips.hpp"

namespace quadloom::strips {

/// The next triangle of a strip stands on an edge: the last two vertices sent, and whether the
/// triangle turns as it is sent (even) or the other way around (odd).
struct StripState {
  VertexId before = kNone, last = kNone;
  bool odd = false;
  friend bool operator==(const StripState&, const StripState&) = default;
};

/// The state after drawing the triangle with that apex.
inline StripState after(StripState s, VertexId apex) { return {s.last, apex, !s.odd}; }

/// An end of a path as the strip's beginning: the state {apex, side, odd} from which its triangle is
/// drawn, to be left by the edge that does not have the apex. Seen from the other side the same strip
/// ends in the state turned(end).
using StripEnd = StripState;
inline StripState turned(StripState s) { return {s.last, s.before, s.odd}; }

/// Vertices to send that lead from one state to another through empty triangles alone; kStripRestart
/// among them where the encoding allows it and it saves one. The fewest there are, unless the two
/// states have vertices in common in a way that paths do not leave.
struct Bridge {
  std::array<VertexId, 6> vertex = {};
  std::size_t size = 0;
  std::span<const VertexId> span() const { return {vertex.data(), size}; }
};
Bridge bridge(StripState from, StripState to, StripEncoding encoding);

/// A code that grows.
class StripWriter {
 public:
  StripWriter(StripEncoding encoding, std::size_t triangles);

  /// Goes to a state (kSwap: always with a restart).
  void go_to(StripState to);
  /// Draws the triangle with that third vertex.
  void draw(VertexId apex);
  /// The last triangle is to be left by its other edge at the apex.
  void swap();

  const StripState& state() const { return state_; }
  std::size_t swaps() const { return swaps_; }
  std::size_t restarts() const { return restarts_; }
  StripCode take() && { return std::move(code_); }

 private:
  void send(VertexId v);

  StripCode code_;
  StripState state_;         // {kNone, kNone}: nothing sent
  VertexId corner_ = kNone;  // of the last triangle, that the state's edge has not
  bool swap_next_ = false;   // kSwap: the next vertex has the bit
  std::size_t swaps_ = 0, restarts_ = 0;
};

}  // namespace quadloom::strips
