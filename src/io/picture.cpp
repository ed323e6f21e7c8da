// Pictures of meshes: a title, the mesh, a legend; one or several on a page.
//
//    +-----------------------------+
//    | title                       |
//    | +-------------------------+ |
//    | |          mesh           | |
//    | +-------------------------+ |
//    | legend                      |
//    +-----------------------------+
#include <algorithm>
#include <cmath>

#include "io/picture_layers.hpp"

namespace quadloom::io {
namespace {

constexpr int kSmallestWidth = 100;

// A panel with its sizes, before it has a place on the page.
struct Layout {
  const MeshFile* mesh;
  const DrawOptions* options;
  Frame frame;
  FaceFigures figures;
  double width, font, margin, title_height, legend_height, height;
};

bool has_legend(const Layout& l) {
  return l.options->colour != ColourBy::kNone || !l.options->steiner.empty() ||
         l.frame.stretch() != 1;
}

Layout lay_out(const Panel& panel) {
  if (panel.options.width < kSmallestWidth) {
    throw Error(ErrorCode::kBadOption, "a picture must be at least " +
                                           std::to_string(kSmallestWidth) + " wide, not " +
                                           std::to_string(panel.options.width));
  }
  const DrawOptions& options = panel.options;
  Layout l{panel.mesh,
           &options,
           Frame(panel.mesh->mesh.points, options.overlay),
           measure_faces(panel.mesh->mesh, options.colour),
           static_cast<double>(options.width),
           0,
           0,
           0,
           0,
           0};
  if (options.colour == ColourBy::kGroup) add_groups(l.figures, options.group);
  l.font = std::clamp(l.width / 72, 9.0, 44.0);
  l.margin = 2 * l.font;
  l.title_height = options.title.empty() ? 0 : 2.2 * l.font;
  l.legend_height = has_legend(l) ? 2.6 * l.font : 0;
  l.height = std::ceil((l.width - 2 * l.margin) * l.frame.ratio() + 2 * l.margin + l.title_height +
                       l.legend_height);
  return l;
}

// ---- Legend: entries from the left, each paints itself at x and gives the x behind it. ----

std::string with_count(std::string_view name, std::size_t count) {
  const std::string digits = std::to_string(count);
  std::string out(name);
  out += "  ";
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0) out += ',';
    out += digits[i];
  }
  return out;
}

class Legend {
 public:
  Legend(const Canvas& canvas, double x, double baseline, double font)
      : canvas_(canvas), x_(x), baseline_(baseline), font_(font) {}

  void swatch(Colour colour, const std::string& label) {
    cairo_rectangle(canvas_.cairo(), x_, baseline_ - 0.85 * font_, font_, font_);
    canvas_.set_colour(colour);
    cairo_fill(canvas_.cairo());
    x_ += 1.45 * font_;
    write(label);
  }

  void ramp(const std::string& label) {
    const double width = 11 * font_;
    x_ += canvas_.text("0", x_, baseline_, font_, kQuietInk) + 0.4 * font_;
    cairo_pattern_t* pattern = cairo_pattern_create_linear(x_, 0, x_ + width, 0);
    for (int i = 0; i <= 32; ++i) {
      const Colour c = ramp_colour(i / 32.0);
      cairo_pattern_add_color_stop_rgb(pattern, i / 32.0, c.r, c.g, c.b);
    }
    cairo_rectangle(canvas_.cairo(), x_, baseline_ - 0.85 * font_, width, font_);
    cairo_set_source(canvas_.cairo(), pattern);
    cairo_fill(canvas_.cairo());
    cairo_pattern_destroy(pattern);
    x_ += width + 0.4 * font_;
    x_ += canvas_.text("1", x_, baseline_, font_, kQuietInk) + 0.8 * font_;
    write(label);
  }

  void ring(const std::string& label) {
    paint_added_mark(canvas_, {x_ + 0.5 * font_, baseline_ - 0.35 * font_}, 0.42 * font_);
    x_ += 1.45 * font_;
    write(label);
  }

  void write(const std::string& label) {
    x_ += canvas_.text(label, x_, baseline_, font_, kInk) + 1.8 * font_;
  }

 private:
  const Canvas& canvas_;
  double x_, baseline_, font_;
};

void paint_legend(const Canvas& canvas, const Layout& l, double x, double baseline, bool rings) {
  Legend legend(canvas, x, baseline, l.font);
  const auto count = [&](FaceKind kind) { return l.figures.count[static_cast<int>(kind)]; };
  if (l.options->colour == ColourBy::kQuality &&
      l.figures.kind.size() > count(FaceKind::kTriangle)) {
    legend.ramp(with_count(
        l.figures.quads_only ? "shape of quads (1: rectangle)" : "shape of faces (1: equal angles)",
        l.figures.kind.size() - count(FaceKind::kTriangle)));
  }
  if (l.options->colour == ColourBy::kConvexity) {
    const auto entry = [&](FaceKind kind, Colour colour, const char* name) {
      if (count(kind) > 0) legend.swatch(colour, with_count(name, count(kind)));
    };
    entry(FaceKind::kStrictlyConvex, kConvexFill, "strictly convex");
    entry(FaceKind::kFlatCornered, kFlatFill, "flat corner");
    entry(FaceKind::kNonConvex, kNonConvexFill, "not convex");
  }
  if (l.options->colour == ColourBy::kGroup) {
    for (std::size_t g = 0; g < std::min(kMostGroups, l.options->group_names.size()); ++g) {
      if (l.figures.group_count[g] == 0) continue;
      legend.swatch(group_colour(g),
                    with_count(l.options->group_names[g], l.figures.group_count[g]));
    }
    return;
  }
  if (l.options->colour != ColourBy::kNone && count(FaceKind::kTriangle) > 0) {
    legend.swatch(kTriangleFill, with_count("triangles", count(FaceKind::kTriangle)));
  }
  if (!l.options->steiner.empty()) {
    const std::string entry = with_count("added points", l.options->steiner.size());
    rings ? legend.ring(entry) : legend.write(entry);
  }
  if (l.frame.stretch() != 1) legend.write("x and y not to the same scale");
}

void paint_panel(const Canvas& canvas, const Layout& l, double x, double y) {
  const PageRect page = {x + l.margin, y + l.margin + l.title_height, l.width - 2 * l.margin,
                         l.height - 2 * l.margin - l.title_height - l.legend_height};
  if (!l.options->title.empty()) {
    canvas.text(l.options->title, page.x, y + l.margin + 0.9 * l.font, 1.35 * l.font, kInk,
                Anchor::kLeft, page.width, true);
  }
  const PlacedMesh placed = place_mesh(l.mesh->mesh, l.frame, page);
  paint_faces(canvas, placed, l.figures, l.options->colour);
  paint_edges(canvas, placed, l.options->colour);
  paint_overlay(canvas, l.frame, page, l.options->overlay);
  paint_points(canvas, placed, l.options->steiner);
  if (l.legend_height > 0) {
    paint_legend(canvas, l, page.x, page.y + page.height + 2.4 * l.font,
                 added_mark_radius(placed, l.options->steiner.size()) > 0);
  }
}

// The bytes of a sheet in that format; `what` is for messages.
std::string paint_sheet(const std::string& format, std::span<const Panel> panels, int columns,
                        const std::string& what) {
  if (panels.empty() || columns < 1) {
    throw Error(ErrorCode::kBadOption, "a picture sheet needs a picture and a column");
  }
  std::vector<Layout> layouts;
  for (const Panel& panel : panels) layouts.push_back(lay_out(panel));

  const auto per_row = std::min(static_cast<std::size_t>(columns), layouts.size());
  const auto row_begin = [&](std::size_t i) { return i / per_row * per_row; };
  double width = 0, height = 0;
  std::vector<Point> corner(layouts.size());
  for (std::size_t i = 0, row = 0; i < layouts.size(); i = row) {
    row = std::min(row_begin(i) + per_row, layouts.size());
    double x = 0, tallest = 0;
    for (std::size_t j = i; j < row; ++j) {
      corner[j] = {x, height};
      x += layouts[j].width;
      tallest = std::max(tallest, layouts[j].height);
    }
    width = std::max(width, x);
    height += tallest;
  }

  Canvas canvas(format, width, height, panels[0].options.title);
  for (std::size_t i = 0; i < layouts.size(); ++i) {
    paint_panel(canvas, layouts[i], corner[i].x, corner[i].y);
  }
  return canvas.finish(what);
}

}  // namespace

void draw_mesh(const std::string& path, const MeshFile& mesh, const DrawOptions& options) {
  const Panel panel{&mesh, options};
  draw_sheet(path, {&panel, 1}, 1);
}

void draw_sheet(const std::string& path, std::span<const Panel> panels, int columns) {
  write_text(path,
             paint_sheet(picture_format(path), panels, columns, "the picture '" + path + "'"));
}

std::string draw_picture(const std::string& format, const MeshFile& mesh,
                         const DrawOptions& options) {
  const Panel panel{&mesh, options};
  return paint_sheet(picture_format("." + format), {&panel, 1}, 1, "a picture");
}

}  // namespace quadloom::io
