// quadloom layers: the convex layers and the convex spiral of a point set.
#include <fmt/format.h>

#include <cstdio>
#include <memory>

#include "exit_codes.hpp"
#include "facts.hpp"
#include "options.hpp"
#include "quadloom/kernel.hpp"
#include "timer.hpp"
#include "verbs.hpp"

namespace quadloom::app {
namespace {

struct LayersVerbOptions {
  InputOptions input;
  std::string output, spiral, picture;
};

io::Polyline polyline(std::span<const Point> points, std::span<const VertexId> vertices) {
  io::Polyline line;
  line.points.reserve(vertices.size());
  for (const VertexId v : vertices) line.points.push_back(points[v]);
  return line;
}

// Layers as rings with their depth, 0 outermost; the innermost may be a segment or a point.
std::vector<io::Polyline> rings(std::span<const Point> points, const ConvexLayers& layers) {
  std::vector<io::Polyline> out;
  for (std::size_t i = 0; i < layers.count(); ++i) {
    io::Polyline ring = polyline(points, layers.layer(i));
    const auto straight = [&ring] {
      for (const Point& p : ring.points) {
        if (orient2d(ring.points[0], ring.points[1], p) != 0) return false;
      }
      return true;
    };
    ring.closed = ring.points.size() > 2 && !straight();
    ring.value = static_cast<double>(i);
    out.push_back(std::move(ring));
  }
  return out;
}

void write_picture(const LayersVerbOptions& o, std::vector<Point> points,
                   const std::vector<io::Polyline>& rings, const io::Polyline& spiral) {
  io::DrawOptions draw;
  draw.colour = io::ColourBy::kNone;
  draw.title =
      fmt::format("{}: {}", short_name(o.input.path),
                  o.spiral.empty() ? counted(rings.size(), "convex layer") : "convex spiral");
  draw.overlay = o.spiral.empty() ? rings : std::vector<io::Polyline>{spiral};
  io::MeshFile file;
  file.mesh.points = std::move(points);
  io::draw_mesh(o.picture, file, draw);
}

int layers(const LayersVerbOptions& o) {
  require_writable(o.output);
  require_writable(o.spiral);
  require_picture(o.picture);
  const io::PointTable table = io::read_points(o.input.path, o.input.reading);
  const Timer timer;
  DistinctPoints distinct = distinct_points(table.points);
  const ConvexLayers convex = convex_layers(distinct.points);
  io::Polyline spiral;
  if (!o.spiral.empty()) spiral = polyline(distinct.points, convex_spiral(distinct.points, convex));
  const double seconds = timer.seconds();

  const std::vector<io::Polyline> lines = rings(distinct.points, convex);
  io::write_polylines(o.output, lines, "depth");
  if (!o.spiral.empty()) io::write_polylines(o.spiral, {&spiral, 1}, "spiral");
  fmt::print(o.output == "-" || o.spiral == "-" ? stderr : stdout,
             "{}, {}, {} on the hull, {:.2f} s\n", counted(distinct.points.size(), "point"),
             counted(convex.count(), "convex layer"), convex.layer(0).size(), seconds);
  if (!o.picture.empty()) write_picture(o, std::move(distinct.points), lines, spiral);
  return kDone;
}

}  // namespace

void add_layers(CLI::App& app, Run& run) {
  CLI::App* verb =
      app.add_subcommand("layers", "Convex layers (onion) and the convex spiral of points");
  verb->footer(
      "\nEvery layer is a ring with its depth, 0 for the hull; points inside a layer's edges "
      "belong\n"
      "to it. The picture shows the spiral if --spiral is given, else the layers.\n"
      "\n"
      "  quadloom layers points.csv -o layers.geojson --picture layers.png\n"
      "  quadloom layers points.csv -o layers.geojson --spiral spiral.geojson --picture "
      "spiral.svg");
  const auto o = std::make_shared<LayersVerbOptions>();
  add_input(*verb, o->input);
  verb->add_option("-o,--output", o->output, "The layers as .geojson, or - for standard output")
      ->required();
  verb->add_option("--spiral", o->spiral, "Also write the convex spiral as .geojson");
  verb->add_option("--picture", o->picture, "Also draw them: .svg, .png or .pdf");
  verb->callback([o, &run] { run = [o] { return layers(*o); }; });
}

}  // namespace quadloom::app
