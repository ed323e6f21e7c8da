// Figures of two meshes of the same shapes.
#pragma once

#include <gtest/gtest.h>

#include "quadloom/certify.hpp"

namespace quadloom::test {

/// The counts of faces by kind, and the histograms.
inline void expect_same_counts(const Quality& q, const Quality& wanted) {
  EXPECT_EQ(q.quads, wanted.quads);
  EXPECT_EQ(q.triangles, wanted.triangles);
  EXPECT_EQ(q.strictly_convex, wanted.strictly_convex);
  EXPECT_EQ(q.non_convex, wanted.non_convex);
  EXPECT_EQ(q.angle_histogram, wanted.angle_histogram);
  EXPECT_EQ(q.shape_histogram, wanted.shape_histogram);
}

}  // namespace quadloom::test
