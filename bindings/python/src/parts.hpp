// Where the library's meshes and results keep what every mesh has.
#pragma once

#include "mesh.hpp"
#include "quadloom/convex.hpp"
#include "quadloom/io.hpp"
#include "quadloom/quadrangulate.hpp"
#include "quadloom/strips.hpp"

namespace quadloom::python {

inline Parts parts_of(const Triangulation& m) {
  return {.points = m.points,
          .triangles = m.tri_vertex,
          .triangulation = &m,
          .input_vertices = m.points.size()};
}
inline Parts parts_of(const Quadrangulation& m) {
  return {.points = m.points,
          .quads = m.quad_vertex,
          .triangles = m.tri_vertex,
          .input_vertices = m.points.size()};
}
inline Parts parts_of(const PolygonMesh& m) {
  return {.points = m.points, .faces = &m, .input_vertices = m.points.size()};
}
inline Parts parts_of(const TriangleMesh& m) {
  Parts parts = parts_of(m.mesh);
  parts.triangle_mesh = &m;
  parts.z = m.z;
  return parts;
}
inline Parts parts_of(const ConnectedMesh& m) { return parts_of(m.triangles); }
inline Parts parts_of(const ConvexDecomposition& r) { return parts_of(r.parts); }

/// What has a `mesh`: with the added points and the heights that stand beside it.
template <typename Result>
requires requires(const Result& r) { r.mesh; }
Parts parts_of(const Result& r) {
  Parts parts = parts_of(r.mesh);
  if constexpr (requires {
                  r.steiner;
                  r.input_vertices;
                }) {
    parts.steiner = r.steiner;
    parts.input_vertices = r.input_vertices;
  }
  if constexpr (requires { r.z; }) parts.z = r.z;
  return parts;
}

/// A result of the library with its Mesh side; `parts_of(const Result&)` says where its parts are.
template <typename Result>
struct Made : Mesh, Result {
  Made() = default;
  explicit Made(Result&& result) : Result(std::move(result)) {}
  Parts parts() const override { return parts_of(static_cast<const Result&>(*this)); }
};

template <typename Result>
Made<Result>* made(Result&& result) {
  return new Made<Result>(std::move(result));
}

}  // namespace quadloom::python
