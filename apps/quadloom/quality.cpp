// quadloom quality: the shape figures of any mesh file.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <memory>

#include "exit_codes.hpp"
#include "facts.hpp"
#include "options.hpp"
#include "report.hpp"
#include "verbs.hpp"

namespace quadloom::app {
namespace {

struct QualityVerbOptions {
  std::string mesh, format;
  Space space = Space::kAuto;
  bool json = false;
};

// One line of a histogram: the range, a bar, the count.
void print_bin(const std::string& range, std::size_t count, std::size_t most) {
  constexpr double kWidest = 40;
  const auto length = static_cast<int>(kWidest * static_cast<double>(count) /
                                           static_cast<double>(std::max<std::size_t>(1, most)) +
                                       0.5);
  fmt::print("  {:>9}  {:#<{}}{} {}\n", range, "", count > 0 ? std::max(1, length) : 0, "", count);
}

void print_shapes(const Quality& q) {
  const std::size_t most = *std::max_element(q.shape_histogram.begin(), q.shape_histogram.end());
  fmt::print("quads by shape (1: rectangle, 0: not strictly convex)\n");
  for (std::size_t i = 0; i < q.shape_histogram.size(); ++i) {
    print_bin(fmt::format("{:.1f}-{:.1f}", 0.1 * static_cast<double>(i),
                          0.1 * static_cast<double>(i + 1)),
              q.shape_histogram[i], most);
  }
}

// 30 degrees a line, so that it fits a screen.
void print_angles(const Quality& q) {
  std::array<std::size_t, 12> bins = {};
  for (std::size_t i = 0; i < q.angle_histogram.size(); ++i) bins[i / 3] += q.angle_histogram[i];
  const std::size_t most = *std::max_element(bins.begin(), bins.end());
  fmt::print("corners by angle in degrees\n");
  for (std::size_t i = 0; i < bins.size(); ++i) {
    print_bin(fmt::format("{}-{}", 30 * i, 30 * i + 30), bins[i], most);
  }
}

void print_table(const Quality& q) {
  fmt::print("{}, {}, {}\n", counted(q.quads, "quad"), counted(q.triangles, "triangle"),
             counted(q.other_faces, "other face"));
  fmt::print("quads: {} strictly convex, {} flat-cornered, {} not convex\n", q.strictly_convex,
             q.flat_cornered, q.non_convex);
  fmt::print("angles: {:.3f} to {:.3f} degrees\n", q.min_angle, q.max_angle);
  fmt::print("shape: mean {:.4f}, least {:.4f}\n", q.mean_shape, q.min_shape);
  fmt::print("aspect (longest edge over shortest): median {:.3f}, most {:.6g}\n", q.median_aspect,
             q.max_aspect);
  fmt::print("edges: {:.6g} to {:.6g}, mean {:.6g}\n", q.min_edge, q.max_edge, q.mean_edge);
  print_shapes(q);
  print_angles(q);
}

// A surface is measured in space; heights and depths over the plane are data.
Quality measure(const io::MeshFile& file, Space space) {
  if (space == Space::kAuto) {
    space = file.z_is_data ? Space::kPlane : space_of(file.mesh, file.z);
  }
  const bool surface = space == Space::kSurface && !file.z.empty();
  return surface ? measure_quality(file.mesh, file.z) : measure_quality(file.mesh);
}

int quality(const QualityVerbOptions& o) {
  const Quality q = measure(io::read_mesh(o.mesh, o.format), o.space);
  if (o.json) {
    fmt::print("{}\n", quality_json(q).dump(2));
  } else {
    print_table(q);
  }
  return kDone;
}

}  // namespace

void add_quality(CLI::App& app, Run& run) {
  CLI::App* verb = app.add_subcommand("quality", "Shape figures of a mesh");
  verb->footer(
      "\n  quadloom quality mesh.obj\n"
      "  quadloom quality mesh.vtu --json > quality.json");
  const auto o = std::make_shared<QualityVerbOptions>();
  verb->add_option("MESH", o->mesh,
                   "The mesh: .obj, .off, .ply, .stl, .vtu, .msh, .14, .ele, .geojson, or -")
      ->required();
  verb->add_option("--mesh-format", o->format, "Format of the mesh if not by the name");
  add_space(
      *verb, o->space,
      "What z is: data over the plane or a surface in space, whose angles are those in space");
  verb->add_flag("--json", o->json, "Print JSON");
  verb->callback([o, &run] { run = [o] { return quality(*o); }; });
}

}  // namespace quadloom::app
