// What every mesh that Python is given can do: quadloom.Mesh, the base of all results that are meshes.
#pragma once

#include <nanobind/nanobind.h>

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "quadloom/core.hpp"
#include "quadloom/io.hpp"
#include "quadloom/quadrangulate.hpp"

namespace quadloom::python {

/// Where a mesh keeps what all meshes have.
struct Parts {
  std::span<const Point> points = {};
  std::span<const VertexId> quads = {};  ///< flat; so triangles, unless there are `faces`
  std::span<const VertexId> triangles = {};
  const PolygonMesh* faces = nullptr;            ///< faces of any size
  const Triangulation* triangulation = nullptr;  ///< triangles with twins
  const TriangleMesh* triangle_mesh = nullptr;   ///< with regions and edges to keep
  std::size_t input_vertices = 0;                ///< the others are added points
  std::span<const SteinerPoint> steiner = {};
  std::span<const double> z = {};  ///< of a surface
};

class Mesh {
 public:
  Mesh() = default;
  Mesh(const Mesh&) = delete;
  Mesh& operator=(const Mesh&) = delete;
  virtual ~Mesh() = default;
  virtual Parts parts() const = 0;

  /// Per vertex, or empty: a surface's, or else the heights that were carried along.
  std::span<const double> z() const;
  PolygonMesh polygons() const;
  /// With heights, and "added" per vertex where points were added.
  io::MeshFile file() const;
  std::vector<VertexId> added() const;
  std::size_t face_count() const;

  std::vector<double> heights;  ///< carried along beside a planar mesh
  std::string guarantee;        ///< what was promised and is met

  // Made when they are first asked for.
  mutable std::vector<double> xyz;
  mutable std::vector<std::uint8_t> is_steiner;
  mutable std::vector<VertexId> quads_of_faces, triangles_of_faces;
};

/// "12,345 quads", "1 quad".
std::string counted(std::size_t n, const std::string& singular, const std::string& plural = "");

}  // namespace quadloom::python
