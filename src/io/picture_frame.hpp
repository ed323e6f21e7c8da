// From the coordinates of a mesh, of any size, to a rectangle of the page.
#pragma once

#include <span>

#include "quadloom/io.hpp"

namespace quadloom::io {

struct PageRect {
  double x = 0, y = 0, width = 0, height = 0;
};

/// The bounding box of what is drawn. x and y have one scale unless the box is very long or very
/// high; then the long side is compressed and the picture says so.
class Frame {
 public:
  Frame(std::span<const Point> points, std::span<const Polyline> overlay);

  /// Height over width on the page.
  double ratio() const { return ratio_; }
  /// How many times longer a unit of y is than one of x on the page; 1 for a true picture.
  double stretch() const { return stretch_; }

  /// The place on the page, y downwards.
  Point place(Point p, const PageRect& page) const;

 private:
  Point low_;
  int exponent_ = 0;  // coordinates are scaled by 2^-exponent_ first, so that nothing overflows
  double width_ = 1, height_ = 1;  // after that scaling
  double ratio_ = 1, stretch_ = 1;
};

}  // namespace quadloom::io
