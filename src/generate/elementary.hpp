// Elementary functions that give the same doubles on every platform, and a shuffle.
//
// The C library's sin, log and exp2 differ in the last bit between platforms, and a point set that
// differs in the last bit can have another triangulation. These use only +, -, *, / and sqrt, which
// IEEE 754 fixes (the build turns contraction off), and power series that are summed far enough for
// a relative error of a few units in the last place.
#pragma once

#include <utility>
#include <vector>

#include "core/random.hpp"
#include "quadloom/core.hpp"

namespace quadloom::generate {

/// The point of the unit circle at `turns` whole turns from (1, 0), counter-clockwise; any finite
/// value. Multiples of a quarter turn are exact.
Point on_unit_circle(double turns);

/// The natural logarithm of x > 0.
double natural_log(double x);

/// 2 to the power x, for |x| <= 1000.
double power_of_two(double x);

template <typename T>
void shuffle(std::vector<T>& v, Random& random) {
  for (std::size_t i = v.size(); i > 1; --i) {
    std::swap(v[i - 1], v[static_cast<std::size_t>(random.below(i))]);
  }
}

}  // namespace quadloom::generate
