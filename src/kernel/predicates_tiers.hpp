// The tiers of the predicates behind the filters of predicates_inline.hpp.
//
//   filter   proven floating point; decides nearly every call
//   wide     the exact differences as 62-bit integers over a common power of two, the determinant
//            in 128 or 256 bits; for any magnitude as long as the differences span at most 61 bits
//            from the largest's exponent to the last non-zero bit: grids, maps, circles
//   big      integers of any length
//
// Each tier is exact where it answers. Integers rather than floating-point expansions in the second
// tier: a handful of multiplications without branches, and nothing to prove about rounding.
#pragma once

#include <optional>

#include "quadloom/core.hpp"

namespace quadloom::kernel {

std::optional<int> cross_wide(Point a, Point b, Point c, Point d);
std::optional<int> dot_wide(Point a, Point b, Point c, Point d);
std::optional<int> incircle_wide(Point a, Point b, Point c, Point d);

int cross_big(Point a, Point b, Point c, Point d);
int dot_big(Point a, Point b, Point c, Point d);
int incircle_big(Point a, Point b, Point c, Point d);

/// The tiers behind the filter: wide, then big.
int cross_exact(Point a, Point b, Point c, Point d);
int dot_exact(Point a, Point b, Point c, Point d);
int incircle_exact(Point a, Point b, Point c, Point d);

}  // namespace quadloom::kernel
