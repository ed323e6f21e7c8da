// Arguments: what Python gives, as the library reads it. What is no array of the right layout goes through
// quadloom._inputs, which knows lists, other arrays, and the objects of other packages.
#pragma once

#include <nanobind/nanobind.h>

#include <cstdint>
#include <span>
#include <vector>

#include "mesh.hpp"
#include "quadloom/core.hpp"
#include "quadloom/kernel.hpp"

namespace quadloom::python {

inline bool anything(PyObject*) { return true; }

class PointsLike : public nanobind::object {
  NB_OBJECT_DEFAULT(PointsLike, nanobind::object, "numpy.typing.ArrayLike", anything)
};
class NumbersLike : public nanobind::object {
  NB_OBJECT_DEFAULT(NumbersLike, nanobind::object, "numpy.typing.ArrayLike", anything)
};
class MeshLike : public nanobind::object {
  NB_OBJECT_DEFAULT(MeshLike, nanobind::object, "quadloom._inputs.MeshLike", anything)
};
/// What is a mesh by itself and no points (quadloom._inputs.is_mesh).
class MeshAlone : public nanobind::object {
  NB_OBJECT_DEFAULT(MeshAlone, nanobind::object, "quadloom._inputs.MeshLike", is_mesh)
 private:
  static bool is_mesh(PyObject* given);
};
class PolygonsLike : public nanobind::object {
  NB_OBJECT_DEFAULT(PolygonsLike, nanobind::object, "quadloom._inputs.PolygonsLike", anything)
};

/// What is a polygon by itself and no points (quadloom._inputs.is_polygon).
class PolygonAlone : public PolygonsLike {
  NB_OBJECT_DEFAULT(PolygonAlone, PolygonsLike, "quadloom._inputs.PolygonsLike", is_polygon)
 private:
  static bool is_polygon(PyObject* given);
};

/// Points (n, 2) or (n, 3). C-contiguous float64 of shape (n, 2) is read where it is, anything else is
/// converted once. Throws Error kBadOption for what are no points.
class Points {
 public:
  explicit Points(const PointsLike& given);
  std::span<const Point> xy() const { return xy_; }
  const std::vector<double>& z() const { return z_; }  ///< empty for (n, 2)

 private:
  nanobind::object keep_;
  std::vector<Point> own_;
  std::span<const Point> xy_;
  std::vector<double> z_;
};

/// Throws Error kNotFinite, as the library does; for functions that leave it to their caller.
std::span<const Point> check_finite(std::span<const Point> points);
/// The same for functions that leave it to their caller that points are finite and distinct. Throws Error
/// kNotFinite, kTooManyPoints, kBadOption (a point twice).
std::span<const Point> checked_points(const Points& given);

/// One point: two numbers.
Point point_from(const PointsLike& given);

/// Numbers of that type, (n,) or of any shape with as many of them; empty for None. Throws Error
/// kBadOption (not whole, out of range).
std::vector<double> doubles_from(const NumbersLike& given, const char* name);
std::vector<std::uint32_t> indices_from(const NumbersLike& given, const char* name);
std::vector<std::int32_t> weights_from(const NumbersLike& given);
std::vector<std::uint8_t> flags_from(const NumbersLike& given, const char* name);
/// Two numbers each; throws Error kBadOption also where one is left over.
std::vector<Segment> segments_from(const NumbersLike& given, const char* name);

/// A mesh: a quadloom.Mesh, or what quadloom._inputs.mesh makes one of. `faces`, if not None, are those over
/// the points `given`.
class MeshArgument {
 public:
  explicit MeshArgument(const nanobind::object& given, const nanobind::object& faces = {});
  const Mesh& mesh() const { return *mesh_; }
  /// As triangles with twins, in their order, as they are (triangles_with_twins) if it has none yet.
  const Triangulation& triangulation() const;

 private:
  nanobind::object keep_;
  const Mesh* mesh_ = nullptr;
  mutable Triangulation own_;
};

/// Throws Error kIndexOutOfRange for a face that names a vertex that is not there, kNotFinite.
void check_faces(const PolygonMesh& mesh);

/// A mesh of triangles to convert: a TriangleMesh or ConnectedMesh as it is, a triangulation, a constrained
/// one with its segments and polygons' borders kept; other meshes through connect_triangles.
class TriangleMeshArgument {
 public:
  explicit TriangleMeshArgument(const nanobind::object& given, const nanobind::object& faces = {});
  const TriangleMesh& mesh() const { return *mesh_; }
  /// Per vertex, or empty: z of what was given, be it a surface or not.
  std::span<const double> heights() const { return given_.mesh().z(); }
  /// Per triangle the face of what was given; empty: they are the same.
  const std::vector<std::uint32_t>& source_face() const { return source_face_; }

 private:
  MeshArgument given_;
  TriangleMesh own_;
  const TriangleMesh* mesh_ = nullptr;
  std::vector<std::uint32_t> source_face_;
};

/// Appends faces: integers (m, k), or a list of faces of different sizes.
void add_faces_from(nanobind::handle given, PolygonMesh& mesh);

/// Polygons in the nesting of GeoJSON: a ring, the rings of a polygon, or several polygons; those of a PlanarFile; or what
/// quadloom._inputs.polygons makes of another object.
/// Heights, where the corners have some, are appended to `z`.
std::vector<Polygon> polygons_from(const PolygonsLike& given, std::vector<double>* z = nullptr);
/// The same for one polygon; throws Error kBadOption for several.
Polygon polygon_from(const PolygonsLike& given);

}  // namespace quadloom::python
