// Triangle's .poly: points (or none, then they are in the .node file of the same name), segments,
// places of holes, places of regions.

#include <fmt/format.h>

#include "io/planar_readers.hpp"
#include "io/triangle_nodes.hpp"

namespace quadloom::io {
namespace {

Point read_place(TriangleLines& lines, std::string_view what) {
  lines.integer(what);
  const double x = lines.finite("x"), y = lines.finite("y");
  return {x, y};
}

void read_holes(TriangleLines& lines, PlanarFile& out) {
  lines.require("the number of holes");
  const auto holes = lines.count("the number of holes");
  for (std::uint64_t i = 0; i < holes; ++i) {
    lines.require(fmt::format("hole {} of {}", i + 1, holes));
    out.input.holes.push_back(read_place(lines, "the number of the hole"));
  }
}

/// The last section may be left out.
void read_regions(TriangleLines& lines, PlanarFile& out) {
  if (!lines.next()) return;
  const auto regions = lines.count("the number of regions");
  if (regions > 0) out.region_data = {{"attribute", {}}, {"area", {}}};
  for (std::uint64_t i = 0; i < regions; ++i) {
    lines.require(fmt::format("region {} of {}", i + 1, regions));
    out.input.regions.push_back(read_place(lines, "the number of the region"));
    out.region_data[0].values.push_back(lines.finite("the attribute"));
    out.region_data[1].values.push_back(lines.has_word() ? lines.finite("the area") : -1);
  }
}

}  // namespace

PlanarFile read_poly(const Source& source, const std::function<std::string()>& read_nodes) {
  TriangleLines lines(source);
  TriangleNodes nodes = read_triangle_nodes(lines);
  if (nodes.points.empty()) {
    const std::string text = read_nodes();
    const Source node_source{fmt::format("the .node of {}", source.name), text};
    TriangleLines node_lines(node_source);
    nodes = read_triangle_nodes(node_lines);
  }
  if (nodes.points.empty()) fail_in(source, "no points", ErrorCode::kTooFewPoints);
  PlanarFile out;
  out.input.points = std::move(nodes.points);
  out.point_data = std::move(nodes.data);
  auto segments = read_triangle_segments(lines, nodes.first, out.input.points.size());
  out.input.segments = std::move(segments.segments);
  if (segments.has_markers) out.segment_data.push_back({"marker", std::move(segments.marker)});
  read_holes(lines, out);
  read_regions(lines, out);
  return out;
}

}  // namespace quadloom::io
