// Which strip goes on where another one ended.
#pragma once

#include <array>
#include <vector>

#include "strips/strip_writer.hpp"

namespace quadloom::strips {

/// Strips in the order in which they are sent: strip s from its end 0 to its end 1 is 2 s, the other
/// way around 2 s + 1.
struct StripOrder {
  std::vector<std::uint32_t> strip;
  std::size_t joined = 0;  ///< that begin at a vertex of the edge with which the one before ended
};

/// An order with cheap bridges (strip_writer.hpp). ends[s] are the two ends of strip s. O(s log s).
StripOrder join_strips(std::span<const std::array<StripEnd, 2>> ends, StripEncoding encoding);

}  // namespace quadloom::strips
