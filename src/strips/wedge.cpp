#include "strips/wedge.hpp"

#include <algorithm>

namespace quadloom::strips {

void sort_into_cells(std::vector<Place>& places, Range range, std::span<const std::uint32_t> cell,
                     std::size_t cells, std::vector<std::uint32_t>& begin,
                     std::vector<Place>& buffer) {
  begin.assign(cells + 2, 0);
  for (const std::uint32_t c : cell) ++begin[c + 2];
  begin[0] = begin[1] = range.begin;
  for (std::size_t c = 2; c < begin.size(); ++c) begin[c] += begin[c - 1];
  buffer.assign(places.begin() + range.begin, places.begin() + range.end);
  for (std::size_t i = 0; i < buffer.size(); ++i) places[begin[cell[i] + 1]++] = buffer[i];
  begin.pop_back();
}

void sort_along(std::vector<Place>& places, Range range) {
  std::sort(places.begin() + range.begin, places.begin() + range.end,
            [](const Place& a, const Place& b) { return lex_less(a.at, b.at); });
}

}  // namespace quadloom::strips
