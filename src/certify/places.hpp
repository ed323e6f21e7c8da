// Which vertex is at a given place: a hash table of points, equal if their coordinates are (-0.0
// is 0.0).
#pragma once

#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "quadloom/core.hpp"

namespace quadloom::certify {

/// Holds indices into `points`, which must outlive it. Linear probing, at most half full.
class Places {
 public:
  explicit Places(std::span<const Point> points) : points_(points) {}

  /// Empties the table and makes room for `count` points; call it before anything else.
  void reserve(std::size_t count) { slot_.assign(std::bit_ceil(2 * count + 2), kNone); }

  /// Whether it was never given room.
  bool empty() const { return slot_.empty(); }

  /// The vertex that is already at the place of v, or v itself, which is then put there.
  VertexId insert(VertexId v) {
    VertexId& slot = slot_[seek(points_[v])];
    if (slot == kNone) slot = v;
    return slot;
  }

  /// The vertex at p, kNone if there is none.
  VertexId find(Point p) const { return slot_[seek(p)]; }

 private:
  static std::uint64_t hash(Point p) {
    auto h = std::bit_cast<std::uint64_t>(p.x + 0.0) * 0x9e3779b97f4a7c15U;
    h = (std::rotl(h, 29) ^ std::bit_cast<std::uint64_t>(p.y + 0.0)) * 0xbf58476d1ce4e5b9U;
    h = (h ^ (h >> 32)) * 0x94d049bb133111ebU;
    return h ^ (h >> 29);
  }

  std::size_t seek(Point p) const {
    const std::size_t mask = slot_.size() - 1;
    std::size_t i = hash(p) & mask;
    while (slot_[i] != kNone && points_[slot_[i]] != p) i = (i + 1) & mask;
    return i;
  }

  std::span<const Point> points_;
  std::vector<VertexId> slot_;
};

}  // namespace quadloom::certify
