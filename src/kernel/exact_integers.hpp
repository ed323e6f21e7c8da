// Doubles as big integers over a common power of two: the last tier of the predicates, for any
// exponents.
#pragma once

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>

namespace quadloom::kernel {

using BigInteger = boost::multiprecision::cpp_int;

/// Integers in the exact ratios of the given finite doubles: value[i] * 2^s for one common s.
template <std::size_t N>
std::array<BigInteger, N> common_integers(const std::array<double, N>& values) {
  std::array<long long, N> mantissa{};
  std::array<int, N> exponent{};
  int least = 2000;
  for (std::size_t i = 0; i < N; ++i) {
    mantissa[i] = static_cast<long long>(std::ldexp(std::frexp(values[i], &exponent[i]), 53));
    if (mantissa[i] != 0) least = std::min(least, exponent[i]);
  }
  std::array<BigInteger, N> out;
  for (std::size_t i = 0; i < N; ++i) {
    if (mantissa[i] == 0) continue;
    out[i] = mantissa[i];
    out[i] <<= static_cast<unsigned>(exponent[i] - least);
  }
  return out;
}

}  // namespace quadloom::kernel
