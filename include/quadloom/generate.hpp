// Named point sets for tests, benchmarks and teaching.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "quadloom/core.hpp"

namespace quadloom {

struct Generator {
  std::string_view name;
  std::string_view what;  ///< one line for a help text
  std::vector<Point> (*make)(std::size_t n, std::uint64_t seed);
};

/// All generators, in the order of a help text.
std::span<const Generator> generators();

/// n points (as near to n as the kind allows) of the kind of that name. Throws Error kBadOption for
/// an unknown name (the sentence lists the names) or an n that is too small for the kind.
std::vector<Point> generate_points(std::string_view kind, std::size_t n, std::uint64_t seed = 1);

}  // namespace quadloom
