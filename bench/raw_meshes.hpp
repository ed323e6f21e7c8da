// Quadloom's types in the files of doubles that measure.hpp speaks of.
//
//   NAME.points      x y        NAME.triangles  three indices      NAME.dual   from to weight
//   NAME.segments    from to    NAME.quads      four indices       NAME.strip  indices, with restarts
#pragma once

#include <filesystem>

#include "measure.hpp"
#include "quadloom/core.hpp"
#include "quadloom/kernel.hpp"

namespace bench {

inline std::vector<quadloom::Point> read_points(const std::string& name) {
  const std::vector<double> values = read_doubles(name + ".points");
  std::vector<quadloom::Point> points(values.size() / 2);
  for (std::size_t i = 0; i < points.size(); ++i) points[i] = {values[2 * i], values[2 * i + 1]};
  return points;
}

inline void write_points(const std::string& name, const std::vector<quadloom::Point>& points) {
  std::vector<double> values;
  values.reserve(2 * points.size());
  for (const quadloom::Point& p : points) values.insert(values.end(), {p.x, p.y});
  write_doubles(name + ".points", values);
}

inline std::vector<quadloom::VertexId> read_indices(const std::string& path) {
  const std::vector<double> values = read_doubles(path);
  return {values.begin(), values.end()};
}

inline quadloom::PlanarInput read_planar(const std::string& name) {
  quadloom::PlanarInput input;
  input.points = read_points(name);
  const std::vector<quadloom::VertexId> ends = read_indices(name + ".segments");
  for (std::size_t i = 0; i < ends.size(); i += 2) input.segments.push_back({ends[i], ends[i + 1]});
  return input;
}

inline void write_triangles(const std::string& name, const std::vector<quadloom::Point>& points,
                            const std::vector<quadloom::VertexId>& corners) {
  write_points(name, points);
  write_doubles(name + ".triangles", corners);
}

inline void write_quads(const std::string& name, const quadloom::Quadrangulation& mesh) {
  write_triangles(name, mesh.points, mesh.tri_vertex);
  write_doubles(name + ".quads", mesh.quad_vertex);
}

/// A mesh of NAME.quads and NAME.triangles, of which one may be missing.
inline quadloom::PolygonMesh read_mesh(const std::string& name) {
  quadloom::PolygonMesh mesh;
  mesh.points = read_points(name);
  for (const auto& [ending, corners] : {std::pair(".quads", 4), std::pair(".triangles", 3)}) {
    if (!std::filesystem::exists(name + ending)) continue;
    const std::vector<quadloom::VertexId> index = read_indices(name + ending);
    for (std::size_t i = 0; i < index.size(); i += corners)
      mesh.add_face({index.data() + i, std::size_t(corners)});
  }
  return mesh;
}

}  // namespace bench
