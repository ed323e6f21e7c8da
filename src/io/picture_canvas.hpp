// A page to paint on with Cairo, kept in memory until it is written whole.
#pragma once

#include <cairo.h>

#include <string>
#include <string_view>

#include "io/picture_palette.hpp"

namespace quadloom::io {

enum class Anchor { kLeft, kCentre, kRight };

class Canvas {
 public:
  /// A white page; `format` is svg, png or pdf. Throws Error kBadOption for another format or a
  /// page that is too large for Cairo.
  Canvas(const std::string& format, double width, double height, const std::string& title);
  ~Canvas();
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  cairo_t* cairo() const { return cairo_; }
  void set_colour(Colour c, double alpha = 1) const;

  /// One line of text with its baseline at y, shrunk if it is wider than `room`. Returns its width.
  double text(std::string_view line, double x, double y, double size, Colour colour,
              Anchor anchor = Anchor::kLeft, double room = 1e9, bool bold = false) const;
  double text_width(std::string_view line, double size) const;

  /// Finishes the page: the bytes of the picture. Throws Error kFile, naming `what`.
  const std::string& finish(const std::string& what);

 private:
  std::string format_;
  std::string bytes_;  // what Cairo has streamed so far
  cairo_surface_t* surface_ = nullptr;
  cairo_t* cairo_ = nullptr;
};

/// The picture format of a file name: svg, png or pdf. Throws Error kBadOption for any other.
std::string picture_format(const std::string& path);

}  // namespace quadloom::io
