// The middle third of a sequence, in linear time.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>

namespace quadloom::strips {

namespace selection {

template <class T, class Less>
void insertion_sort(std::span<T> items, const Less& less) {
  for (std::size_t i = 1; i < items.size(); ++i) {
    for (std::size_t j = i; j > 0 && less(items[j], items[j - 1]); --j) {
      std::swap(items[j], items[j - 1]);
    }
  }
}

/// The middle one of three items.
template <class T, class Less>
T median_of_three(std::span<T> items, const Less& less) {
  T a = items.front(), b = items[items.size() / 2], c = items.back();
  if (less(b, a)) std::swap(a, b);
  if (less(c, b)) std::swap(b, c);
  return less(b, a) ? a : b;
}

}  // namespace selection

/// Orders the items so that item `rank` is where sorting would put it, none before it is greater and
/// none after it is less. O(n) comparisons in the worst case: quickselect, which after 4 n items goes
/// on with medians of medians as pivots (Blum, Floyd, Pratt, Rivest and Tarjan 1973; nested as deep as
/// log5 n).
template <class T, class Less>
void select(std::span<T> items, std::size_t rank, const Less& less) {
  constexpr std::size_t kGroup = 5;
  const std::size_t allowed = 4 * items.size();
  std::size_t seen = 0;
  while (items.size() > kGroup) {
    T pivot;
    if (seen < allowed) {
      pivot = selection::median_of_three(items, less);
    } else {  // at least three tenths of the items are not greater, and as many not less
      const std::size_t groups = items.size() / kGroup;
      for (std::size_t g = 0; g < groups; ++g) {
        selection::insertion_sort(items.subspan(kGroup * g, kGroup), less);
        std::swap(items[g], items[kGroup * g + kGroup / 2]);
      }
      select(items.first(groups), groups / 2, less);
      pivot = items[groups / 2];
    }
    seen += items.size();
    // Three parts, so that many equal items do no harm.
    std::size_t lower = 0, equal_end = 0, upper = items.size();
    while (equal_end < upper) {
      if (less(items[equal_end], pivot)) {
        std::swap(items[lower++], items[equal_end++]);
      } else if (less(pivot, items[equal_end])) {
        std::swap(items[equal_end], items[--upper]);
      } else {
        ++equal_end;
      }
    }
    if (rank < lower) {
      items = items.first(lower);
    } else if (rank < upper) {
      return;
    } else {
      rank -= upper;
      items = items.subspan(upper);
    }
  }
  selection::insertion_sort(items, less);
}

/// Puts the items with the ranks n / 3 to 2 n / 3, rounded up, into their places and returns them: at
/// least a third, and at most 2 n / 3 are less than any of them, as many greater. O(n).
template <class T, class Less>
std::span<T> middle_third(std::span<T> items, const Less& less) {
  const std::size_t low = items.size() / 3;
  const std::size_t high = (2 * items.size() + 2) / 3;
  select(items, low, less);
  const std::span<T> rest = items.subspan(low);
  if (high < items.size()) select(rest, high - low, less);
  return rest.first(high - low);
}

}  // namespace quadloom::strips
