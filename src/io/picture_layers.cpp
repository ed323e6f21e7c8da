#include "io/picture_layers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace quadloom::io {
namespace {

constexpr std::size_t kShades = 64;  // shapes are rounded to so many colours; one path each
constexpr double kSmoothFrom = 8;

double distance(Point a, Point b) { return std::hypot(b.x - a.x, b.y - a.y); }

double face_spacing(const PlacedMesh& placed, std::size_t f) {
  const auto face = placed.mesh->face(f);
  double area = 0, perimeter = 0;
  for (std::size_t i = 0; i < face.size(); ++i) {
    const Point o = placed.at[face[0]], a = placed.at[face[i]];
    const Point b = placed.at[face[(i + 1) % face.size()]];
    area += ((a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x)) / 2;
    perimeter += distance(a, b);
  }
  return perimeter > 0 ? 4 * std::fabs(area) / perimeter : 0;
}

double typical_spacing(const PlacedMesh& placed) {
  std::vector<float> sorted = placed.spacing;
  if (sorted.empty()) {
    const auto n = static_cast<double>(std::max<std::size_t>(1, placed.at.size()));
    return 0.6 * std::sqrt(placed.page.width * placed.page.height / n);
  }
  const auto quartile = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 4);
  std::nth_element(sorted.begin(), quartile, sorted.end());
  return *quartile;
}

// ---- Faces. ----

void trace_face(cairo_t* cr, const PlacedMesh& placed, std::size_t f) {
  bool first = true;
  for (const VertexId v : placed.mesh->face(f)) {
    const Point p = placed.at[v];
    first ? cairo_move_to(cr, p.x, p.y) : cairo_line_to(cr, p.x, p.y);
    first = false;
  }
  cairo_close_path(cr);
}

// A face's colour as a number: the four kinds first, then the shades of the ramp; or
// the groups.
std::size_t paint_number(const FaceFigures& figures, std::size_t f, ColourBy colour) {
  const auto kind = static_cast<std::size_t>(figures.kind[f]);
  if (colour == ColourBy::kGroup) return figures.group[f];
  if (colour != ColourBy::kQuality || figures.kind[f] == FaceKind::kTriangle) return kind;
  const float shape = figures.shape[f];  // may be NaN where coordinates overflow
  if (!(shape > 0)) return 4;
  return 4 + std::min(kShades - 1, static_cast<std::size_t>(shape * float{kShades}));
}

Colour paint_colour(std::size_t number, ColourBy colour) {
  constexpr std::array<Colour, 4> kKinds = {kTriangleFill, kConvexFill, kFlatFill, kNonConvexFill};
  if (colour == ColourBy::kGroup) return group_colour(number);
  if (number >= 4) return ramp_colour((static_cast<double>(number - 4) + 0.5) / kShades);
  return colour == ColourBy::kNone ? kPlainFill : kKinds[number];
}

// ---- Edges. ----

struct Edge {
  VertexId from, to;  // from < to
  float spacing;      // the narrower face's
  bool boundary;      // in one face only
};

std::vector<Edge> unique_edges(const PlacedMesh& placed) {
  std::vector<Edge> edges;
  edges.reserve(placed.mesh->face_vertex.size());
  for (std::size_t f = 0; f < placed.mesh->face_count(); ++f) {
    const auto face = placed.mesh->face(f);
    for (std::size_t i = 0; i < face.size(); ++i) {
      const auto [a, b] = std::minmax(face[i], face[(i + 1) % face.size()]);
      edges.push_back({a, b, placed.spacing[f], true});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
    return a.from != b.from ? a.from < b.from : a.to != b.to ? a.to < b.to : a.spacing < b.spacing;
  });
  std::size_t kept = 0;
  for (const Edge& e : edges) {
    if (kept > 0 && edges[kept - 1].from == e.from && edges[kept - 1].to == e.to) {
      edges[kept - 1].boundary = false;
    } else {
      edges[kept++] = e;
    }
  }
  edges.resize(kept);
  return edges;
}

// Widths in steps, widest first, so that the edges of one step are one path; below the thinnest
// nothing is drawn.
constexpr double kStep = 1.5;
constexpr double kThinnest = 0.1;

std::vector<double> width_steps(double widest) {
  std::vector<double> steps;
  for (double width = widest; width > kThinnest; width /= kStep) steps.push_back(width);
  return steps;
}

std::size_t width_step(double spacing, std::span<const double> steps) {
  std::size_t step = 0;
  while (step < steps.size() && steps[step] > 0.075 * spacing) ++step;
  return step;
}

void stroke_edges(const Canvas& canvas, const PlacedMesh& placed,
                  std::span<const Edge* const> edges, double width, Colour colour) {
  for (const Edge* e : edges) {
    const Point a = placed.at[e->from], b = placed.at[e->to];
    cairo_move_to(canvas.cairo(), a.x, a.y);
    cairo_line_to(canvas.cairo(), b.x, b.y);
  }
  canvas.set_colour(colour);
  cairo_set_line_width(canvas.cairo(), width);
  cairo_stroke(canvas.cairo());
}

// ---- Overlay. ----

void trace_line(cairo_t* cr, const Frame& frame, const PageRect& page, const Polyline& line,
                std::size_t begin, std::size_t end) {
  for (std::size_t i = begin; i < end; ++i) {
    const Point p = frame.place(line.points[i], page);
    i == begin ? cairo_move_to(cr, p.x, p.y) : cairo_line_to(cr, p.x, p.y);
  }
  if (line.closed) cairo_close_path(cr);
}

void paint_along(const Canvas& canvas, const Frame& frame, const PageRect& page,
                 const Polyline& line) {
  const std::size_t n = line.points.size();
  const std::size_t pieces = std::min<std::size_t>(256, n - 1);
  for (std::size_t k = 0; k < pieces; ++k) {
    canvas.set_colour(ramp_colour(0.92 * static_cast<double>(k) / static_cast<double>(pieces)));
    trace_line(canvas.cairo(), frame, page, line, k * (n - 1) / pieces,
               (k + 1) * (n - 1) / pieces + 1);
    cairo_stroke(canvas.cairo());
  }
}

}  // namespace

Colour group_colour(std::size_t group) {
  constexpr std::array<Colour, kMostGroups> kGroups = {kPlainFill, kNonConvexFill, kFlatFill,
                                                       kConvexFill};
  return kGroups[group];
}

PlacedMesh place_mesh(const PolygonMesh& mesh, const Frame& frame, const PageRect& page) {
  PlacedMesh placed;
  placed.mesh = &mesh;
  placed.page = page;
  placed.at.reserve(mesh.points.size());
  for (const Point& p : mesh.points) placed.at.push_back(frame.place(p, page));
  placed.spacing.reserve(mesh.face_count());
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    placed.spacing.push_back(static_cast<float>(face_spacing(placed, f)));
  }
  placed.typical = typical_spacing(placed);
  return placed;
}

void paint_faces(const Canvas& canvas, const PlacedMesh& placed, const FaceFigures& figures,
                 ColourBy colour) {
  const std::size_t faces = placed.mesh->face_count();
  std::vector<std::vector<std::uint32_t>> by_paint(4 + kShades);
  for (std::size_t f = 0; f < faces; ++f) {
    by_paint[paint_number(figures, f, colour)].push_back(static_cast<std::uint32_t>(f));
  }
  // Smoothing leaves seams between neighbours, which only the edges hide.
  if (placed.typical < kSmoothFrom) cairo_set_antialias(canvas.cairo(), CAIRO_ANTIALIAS_NONE);
  for (std::size_t number = 0; number < by_paint.size(); ++number) {
    if (by_paint[number].empty()) continue;
    for (const std::uint32_t f : by_paint[number]) trace_face(canvas.cairo(), placed, f);
    canvas.set_colour(paint_colour(number, colour));
    cairo_fill(canvas.cairo());
  }
  cairo_set_antialias(canvas.cairo(), CAIRO_ANTIALIAS_DEFAULT);
}

void paint_edges(const Canvas& canvas, const PlacedMesh& placed, ColourBy colour) {
  const double widest = std::max(0.6, placed.page.width / 900);
  const std::vector<double> steps = width_steps(widest);
  std::vector<std::vector<const Edge*>> by_step(steps.size() + 1);
  std::vector<const Edge*> boundary;
  const std::vector<Edge> edges = unique_edges(placed);
  for (const Edge& e : edges) {
    (e.boundary ? boundary : by_step[width_step(e.spacing, steps)]).push_back(&e);
  }
  const Colour inner = colour == ColourBy::kQuality ? kPaper : kInk;
  for (std::size_t step = 0; step < steps.size(); ++step) {
    stroke_edges(canvas, placed, by_step[step], steps[step], inner);
  }
  stroke_edges(canvas, placed, boundary, widest * 0.8, kInk);
}

void paint_overlay(const Canvas& canvas, const Frame& frame, const PageRect& page,
                   std::span<const Polyline> overlay) {
  double highest = 0;
  std::size_t points = 1;
  for (const Polyline& line : overlay) {
    highest = std::max(highest, line.value);
    points += line.points.size();
  }
  const double spacing = std::sqrt(page.width * page.height / static_cast<double>(points));
  cairo_set_line_width(canvas.cairo(), std::clamp(0.07 * spacing, 0.3, page.width / 600));
  for (const Polyline& line : overlay) {
    if (line.points.size() < 2) continue;
    if (!line.closed && highest == 0) {
      paint_along(canvas, frame, page, line);
      continue;
    }
    canvas.set_colour(ramp_colour(highest > 0 ? 0.92 * line.value / highest : 0));
    trace_line(canvas.cairo(), frame, page, line, 0, line.points.size());
    cairo_stroke(canvas.cairo());
  }
}

void paint_added_mark(const Canvas& canvas, Point at, double radius) {
  cairo_t* cr = canvas.cairo();
  for (const bool halo : {true, false}) {
    cairo_new_sub_path(cr);
    cairo_arc(cr, at.x, at.y, radius, 0, 2 * std::numbers::pi);
    canvas.set_colour(halo ? kPaper : kAddedPoint);
    cairo_set_line_width(cr, radius * (halo ? 0.75 : 0.4));
    cairo_stroke(cr);
  }
}

double added_mark_radius(const PlacedMesh& placed, std::size_t count) {
  const double largest = placed.page.width / 230;
  const double radius = count <= 20 ? largest : std::min(largest, 0.2 * placed.typical);
  return radius < 1 ? 0 : radius;
}

void paint_points(const Canvas& canvas, const PlacedMesh& placed,
                  std::span<const VertexId> steiner) {
  cairo_t* cr = canvas.cairo();
  const double radius = std::min(placed.page.width / 320, 0.11 * placed.typical);
  if (radius >= 1) {
    for (const Point& p : placed.at) {
      cairo_new_sub_path(cr);
      cairo_arc(cr, p.x, p.y, radius, 0, 2 * std::numbers::pi);
    }
    canvas.set_colour(kInk);
    cairo_fill_preserve(cr);
    canvas.set_colour(kPaper);
    cairo_set_line_width(cr, radius * 0.35);
    cairo_stroke(cr);
  }
  const double ring = added_mark_radius(placed, steiner.size());
  if (ring == 0) return;
  for (const VertexId v : steiner) {
    if (v < placed.at.size()) paint_added_mark(canvas, placed.at[v], ring);
  }
}

}  // namespace quadloom::io
