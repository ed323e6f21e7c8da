// What the fuzzers and the corpus test ask of a reader: any text is read or refused with an Error,
// and what was read can be written, judged and measured.
#pragma once

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>

#include "io/mesh_formats.hpp"
#include "io/planar_readers.hpp"
#include "io/point_readers.hpp"
#include "io/strip_readers.hpp"
#include "quadloom/certify.hpp"

namespace quadloom::test {

inline void require(bool holds, const char* what) {
  if (holds) return;
  std::fputs(what, stderr);
  std::abort();
}

/// True if the text was read.
inline bool try_points(std::string_view format, std::string_view text) {
  try {
    const auto table = io::read_points_text({"input", text}, std::string(format));
    require(!table.points.empty(), "no points and no error");
    require(table.z.empty() || table.z.size() == table.points.size(), "not a height a point");
    require(format == "geojson" || table.line.size() == table.points.size(), "not a line a point");
    for (const Point p : table.points) {
      require(std::isfinite(p.x) && std::isfinite(p.y), "a point that is not finite");
    }
    return true;
  } catch (const Error&) {
    return false;
  }
}

/// The files beside an .ele, from one text: TRIANGLES \f NODES \f EDGES \f POLY. The nodes are a square
/// if they are not there.
inline std::optional<std::string> part_of(std::string_view text, std::string_view extension) {
  const std::size_t part = extension == "node" ? 1 : extension == "edge" ? 2 : 3;
  for (std::size_t i = 0; i < part; ++i) {
    const auto end = text.find('\f');
    if (end == std::string_view::npos) {
      if (extension == "node") return "4 2\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n";
      return {};
    }
    text.remove_prefix(end + 1);
  }
  return std::string(text.substr(0, text.find('\f')));
}

/// True if the text was read.
inline bool try_mesh(std::string_view format, std::string_view text) {
  for (const auto& known : io::mesh_formats()) {
    if (known.name != format) continue;
    io::MeshFile file;
    try {
      const bool parts = format == "ele";
      file = known.read({"input", parts ? text.substr(0, text.find('\f')) : text,
                         [&](std::string_view extension) { return part_of(text, extension); }});
    } catch (const Error&) {
      return false;
    }
    io::check_writable(file);
    certify_points(file.mesh, file.mesh.points);
    measure_quality(file.mesh);
    return true;
  }
  require(false, "no such format");
  return false;
}

/// True if the text was read. What was read is triangulated, or refused with an Error; the result is
/// judged.
inline bool try_planar(std::string_view format, std::string_view text) {
  io::PlanarFile file;
  try {
    file = io::read_planar_text({"input", text}, std::string(format),
                                [] { return std::string("3 2\n1 0 0\n2 1 0\n3 0 1\n"); });
  } catch (const Error&) {
    return false;
  }
  try {
    const ConstrainedResult result = constrained_delaunay(file.input);
    if (file.input.polygons.empty()) return true;
    CertifyOptions options;
    options.corners = 3;
    const auto verdict =
        certify_polygons(to_polygon_mesh(result.mesh), file.input.polygons, {}, options);
    require(verdict.ok(), verdict.sentence.c_str());
  } catch (const Error&) {
  }
  return true;
}

/// True if the text was read. What was read decodes, and encodes again to the same triangles.
inline bool try_strips(std::string_view text) {
  io::StripFile file;
  try {
    file = io::read_strips_text({"input", text});
  } catch (const Error&) {
    return false;
  }
  const std::vector<VertexId> triangles = decode_strips(file.code);
  require(triangles.size() <= 3 * file.code.index.size(), "more triangles than indices");
  StripOptions options;
  options.encoding = file.code.encoding;
  const StripResult again = encode_strips(triangles_with_twins(file.points, triangles), options);
  require(same_triangles(triangles, decode_strips(again.code)), "other triangles");
  return true;
}

}  // namespace quadloom::test
