// Vertices and faces by the numbers that a file gives them, where it may choose any.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

namespace quadloom::io {

/// Collects numbers in the order of what they name, then finds them: add all, sort once, find.
class NumberMap {
 public:
  void add(std::uint64_t number) {
    entries_.push_back({number, static_cast<std::uint32_t>(entries_.size())});
  }

  /// Returns a number that was added twice, if there is one.
  std::optional<std::uint64_t> sort() {
    std::ranges::sort(entries_, {}, &Entry::number);
    const auto same = [](const Entry& a, const Entry& b) { return a.number == b.number; };
    const auto twice = std::ranges::adjacent_find(entries_, same);
    if (twice == entries_.end()) return {};
    return twice->number;
  }

  /// Which one has this number. Numbers without gaps are found at once, others in O(log n).
  std::optional<std::uint32_t> find(std::uint64_t number) const {
    if (entries_.empty()) return {};
    const std::uint64_t offset = number - entries_[0].number;
    if (offset < entries_.size() && entries_[offset].number == number) {
      return entries_[offset].index;
    }
    const auto at = std::ranges::lower_bound(entries_, number, {}, &Entry::number);
    if (at == entries_.end() || at->number != number) return {};
    return at->index;
  }

 private:
  struct Entry {
    std::uint64_t number;
    std::uint32_t index;
  };
  std::vector<Entry> entries_;
};

}  // namespace quadloom::io
