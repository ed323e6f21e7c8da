#include "io/picture_canvas.hpp"

#include <cairo-pdf.h>
#include <cairo-svg.h>

#include <algorithm>
#include <cctype>

#include "quadloom/io.hpp"

namespace quadloom::io {
namespace {

constexpr double kLargestSide = 32000;  // Cairo's images end at 32767

cairo_status_t append(void* bytes, const unsigned char* data, unsigned length) {
  static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

}  // namespace

std::string picture_format(const std::string& path) {
  const auto dot = path.rfind('.');
  std::string format = dot == std::string::npos ? "" : path.substr(dot + 1);
  std::transform(format.begin(), format.end(), format.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (format == "svg" || format == "png" || format == "pdf") return format;
  throw Error(ErrorCode::kBadOption, "cannot tell the kind of picture from the name '" + path +
                                         "': it must end in .svg, .png or .pdf");
}

Canvas::Canvas(const std::string& format, double width, double height, const std::string& title)
    : format_(format) {
  if (!(width >= 1 && height >= 1 && width <= kLargestSide && height <= kLargestSide)) {
    throw Error(ErrorCode::kBadOption,
                "a picture of " + std::to_string(static_cast<long long>(width)) + " x " +
                    std::to_string(static_cast<long long>(height)) + " is too large");
  }
  if (format == "svg") {
    surface_ = cairo_svg_surface_create_for_stream(append, &bytes_, width, height);
  } else if (format == "pdf") {
    surface_ = cairo_pdf_surface_create_for_stream(append, &bytes_, width, height);
    cairo_pdf_surface_set_metadata(surface_, CAIRO_PDF_METADATA_TITLE, title.c_str());
  } else {
    surface_ = cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(width),
                                          static_cast<int>(height));
  }
  cairo_ = cairo_create(surface_);
  cairo_set_line_join(cairo_, CAIRO_LINE_JOIN_ROUND);
  cairo_set_line_cap(cairo_, CAIRO_LINE_CAP_ROUND);
  set_colour(kPaper);
  cairo_paint(cairo_);
}

Canvas::~Canvas() {
  cairo_destroy(cairo_);
  cairo_surface_destroy(surface_);
}

void Canvas::set_colour(Colour c, double alpha) const {
  cairo_set_source_rgba(cairo_, c.r, c.g, c.b, alpha);
}

double Canvas::text(std::string_view line, double x, double y, double size, Colour colour,
                    Anchor anchor, double room, bool bold) const {
  const std::string s(line);
  cairo_select_font_face(cairo_, "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                         bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(cairo_, size);
  cairo_text_extents_t extents;
  cairo_text_extents(cairo_, s.c_str(), &extents);
  if (extents.x_advance > room) {
    cairo_set_font_size(cairo_, size * room / extents.x_advance);
    cairo_text_extents(cairo_, s.c_str(), &extents);
  }
  const double shift = anchor == Anchor::kLeft     ? 0
                       : anchor == Anchor::kCentre ? extents.x_advance / 2
                                                   : extents.x_advance;
  set_colour(colour);
  cairo_move_to(cairo_, x - shift, y);
  cairo_show_text(cairo_, s.c_str());
  return extents.x_advance;
}

double Canvas::text_width(std::string_view line, double size) const {
  cairo_select_font_face(cairo_, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(cairo_, size);
  cairo_text_extents_t extents;
  cairo_text_extents(cairo_, std::string(line).c_str(), &extents);
  return extents.x_advance;
}

const std::string& Canvas::finish(const std::string& what) {
  cairo_show_page(cairo_);
  if (format_ == "png") cairo_surface_write_to_png_stream(surface_, append, &bytes_);
  cairo_surface_finish(surface_);
  const cairo_status_t status = std::max(cairo_status(cairo_), cairo_surface_status(surface_));
  if (status != CAIRO_STATUS_SUCCESS) {
    throw Error(ErrorCode::kFile, "cannot make " + what + ": " + cairo_status_to_string(status));
  }
  return bytes_;
}

}  // namespace quadloom::io
