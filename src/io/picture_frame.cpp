#include "io/picture_frame.hpp"

#include <algorithm>
#include <cmath>

namespace quadloom::io {
namespace {

constexpr double kHighest = 2.5;  // height over width
constexpr double kFlattest = 0.2;

// (v - low) * 2^-exponent, where v - low itself may overflow.
double scaled(double v, double low, int exponent) {
  return std::ldexp(v / 2 - low / 2, 1 - exponent);
}

}  // namespace

Frame::Frame(std::span<const Point> points, std::span<const Polyline> overlay) {
  bool any = false;
  Point high;
  const auto include = [&](Point p) {
    low_ = any ? Point{std::min(low_.x, p.x), std::min(low_.y, p.y)} : p;
    high = any ? Point{std::max(high.x, p.x), std::max(high.y, p.y)} : p;
    any = true;
  };
  for (const Point& p : points) include(p);
  for (const Polyline& line : overlay) {
    for (const Point& p : line.points) include(p);
  }

  const double half = std::max(high.x / 2 - low_.x / 2, high.y / 2 - low_.y / 2);
  if (half > 0) std::frexp(half, &exponent_);
  width_ = scaled(high.x, low_.x, exponent_);
  height_ = scaled(high.y, low_.y, exponent_);
  if (width_ == 0) width_ = height_ == 0 ? 1 : height_;
  if (height_ == 0) height_ = width_ * kFlattest;
  const double truth = height_ / width_;
  ratio_ = std::clamp(truth, kFlattest, kHighest);
  stretch_ = ratio_ / truth;
}

Point Frame::place(Point p, const PageRect& page) const {
  const double u = scaled(p.x, low_.x, exponent_) / width_;
  const double v = scaled(p.y, low_.y, exponent_) / height_;
  return {page.x + u * page.width, page.y + (1 - v) * page.height};
}

}  // namespace quadloom::io
