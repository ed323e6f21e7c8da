// Point sets that every algorithm refuses.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "quadloom/core.hpp"

namespace quadloom::testing {

/// `run` takes points; gtest failures if it does not refuse too few, collinear and infinite ones with
/// the right code.
template <class Run>
void expect_bad_points_refused(const Run& run) {
  const auto code_of = [&](const std::vector<Point>& points) {
    try {
      run(points);
    } catch (const Error& error) {
      return error.code();
    }
    return ErrorCode::kCancelled;
  };
  EXPECT_EQ(code_of({}), ErrorCode::kTooFewPoints);
  EXPECT_EQ(code_of({{0, 0}, {1, 1}, {0, 0}}), ErrorCode::kTooFewPoints);
  EXPECT_EQ(code_of({{0, 0}, {1, 1}, {2, 2}, {3, 3}}), ErrorCode::kAllCollinear);
  EXPECT_EQ(code_of({{0, 0}, {1, 1}, {2, std::nan("")}}), ErrorCode::kNotFinite);
  EXPECT_EQ(code_of({{0, 0}, {1, 1}, {2, HUGE_VAL}}), ErrorCode::kNotFinite);
  EXPECT_EQ(code_of({{0, 0}, {1, HUGE_VAL}, {2, 0}}), ErrorCode::kNotFinite);
}

}  // namespace quadloom::testing
