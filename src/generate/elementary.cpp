#include "generate/elementary.hpp"

#include <cmath>
#include <numbers>

namespace quadloom::generate {
namespace {

// The sum over k of (-z)^k / ((first + 1) ... (first + 2k)), by Horner from the last term:
// cos(a) with first = 0, sin(a) / a with first = 1, for z = a^2 <= (pi / 4)^2.
double alternating_series(double z, int first) {
  double sum = 1;
  for (int k = 10; k >= 1; --k) {
    const auto factor = static_cast<double>((first + 2 * k - 1) * (first + 2 * k));
    sum = 1 - z / factor * sum;
  }
  return sum;
}

}  // namespace

Point on_unit_circle(double turns) {
  const double quarters = 4 * (turns - std::floor(turns));
  const double nearest = std::floor(quarters + 0.5);
  const double angle = (quarters - nearest) * (std::numbers::pi / 2);
  const double c = alternating_series(angle * angle, 0);
  const double s = angle * alternating_series(angle * angle, 1);
  switch (static_cast<int>(nearest) & 3) {
    case 0:
      return {c, s};
    case 1:
      return {-s, c};
    case 2:
      return {-c, -s};
    default:
      return {s, -c};
  }
}

double natural_log(double x) {
  int exponent = 0;
  double m = std::frexp(x, &exponent);
  if (m < std::numbers::sqrt2 / 2) {
    m *= 2;
    --exponent;
  }
  // log m = 2 atanh(t), t = (m - 1) / (m + 1), |t| < 0.172
  const double t = (m - 1) / (m + 1);
  double sum = 0;
  for (int k = 23; k >= 1; k -= 2) sum = 1.0 / k + t * t * sum;
  return 2 * t * sum + exponent * std::numbers::ln2;
}

double power_of_two(double x) {
  const double whole = std::floor(x + 0.5);
  const double a = (x - whole) * std::numbers::ln2;
  double sum = 1;
  for (int k = 18; k >= 1; --k) sum = 1 + a / k * sum;
  return std::ldexp(sum, static_cast<int>(whole));
}

}  // namespace quadloom::generate
