#include "inputs.hpp"

#include <nanobind/ndarray.h>
#include <nanobind/stl/string.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include "arrays.hpp"
#include "parts.hpp"
#include "progress.hpp"
#include "quadloom/strips.hpp"

namespace nb = nanobind;

namespace quadloom::python {
namespace {

template <typename... Shape>
using Contiguous = nb::ndarray<Shape..., nb::c_contig, nb::device::cpu, nb::ro>;

nb::object conversions() { return nb::module_::import_("quadloom._inputs"); }

// Whether the conversions take it for one; what they cannot make out is none. Overloads are chosen by this, where
// nothing may be thrown.
bool is_one(PyObject* given, const char* question) {
  try {
    return nb::cast<bool>(conversions().attr(question)(nb::handle(given)));
  } catch (nb::python_error&) {
    return false;
  }
}

template <typename T>
std::vector<T> numbers_from(const NumbersLike& given, const char* name, const char* converter) {
  if (!given.is_valid() || given.is_none()) return {};
  const nb::object flat = conversions().attr(converter)(given, name);
  const auto array = nb::cast<Contiguous<T, nb::shape<-1>>>(flat);
  return {array.data(), array.data() + array.shape(0)};
}

}  // namespace

std::span<const Point> check_finite(std::span<const Point> points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (std::isfinite(points[i].x) && std::isfinite(points[i].y)) continue;
    throw Error(ErrorCode::kNotFinite,
                "point " + std::to_string(i) + " has a coordinate that is not a finite number",
                {i});
  }
  return points;
}

bool MeshAlone::is_mesh(PyObject* given) {
  return nb::isinstance<Mesh>(given) || is_one(given, "is_mesh");
}

bool PolygonAlone::is_polygon(PyObject* given) { return is_one(given, "is_polygon"); }

Points::Points(const PointsLike& given) : keep_(given) {
  using Plane = Contiguous<double, nb::shape<-1, 2>>;
  Plane plane;
  const auto readable = [&] {
    return nb::try_cast<Plane>(keep_, plane, false) &&
           (plane.shape(0) == 0 ||
            reinterpret_cast<std::uintptr_t>(plane.data()) % alignof(double) == 0);
  };
  if (!readable()) {
    keep_ = conversions().attr("points")(given);
    if (!readable()) {
      const auto space = nb::cast<Contiguous<double, nb::shape<-1, 3>>>(keep_);
      const double* row = space.data();
      own_.reserve(space.shape(0));
      z_.reserve(space.shape(0));
      for (std::size_t i = 0; i < space.shape(0); ++i, row += 3) {
        own_.push_back({row[0], row[1]});
        z_.push_back(row[2]);
      }
      xy_ = own_;
      return;
    }
  }
  xy_ = {reinterpret_cast<const Point*>(plane.data()), plane.shape(0)};
}

std::span<const Point> checked_points(const Points& given) {
  const std::vector<VertexId> vertex = distinct_points(given.xy()).input_to_vertex;
  for (std::size_t i = 0; i < vertex.size(); ++i) {
    if (vertex[i] == i) continue;
    const auto first = static_cast<std::size_t>(std::find(vertex.begin(), vertex.end(), vertex[i]) -
                                                vertex.begin());
    throw Error(ErrorCode::kBadOption,
                "point " + std::to_string(i) + " is point " + std::to_string(first) +
                    " again: distinct points are wanted, see distinct_points",
                {first, i});
  }
  return given.xy();
}

Point point_from(const PointsLike& given) {
  const Points one(nb::borrow<PointsLike>(conversions().attr("operand")(given)));
  if (one.xy().size() == 1) return one.xy()[0];
  throw Error(ErrorCode::kBadOption, "one point is wanted, not " + std::to_string(one.xy().size()));
}

std::vector<double> doubles_from(const NumbersLike& given, const char* name) {
  return numbers_from<double>(given, name, "numbers");
}

std::vector<std::uint32_t> indices_from(const NumbersLike& given, const char* name) {
  return numbers_from<std::uint32_t>(given, name, "indices");
}

std::vector<std::int32_t> weights_from(const NumbersLike& given) {
  return numbers_from<std::int32_t>(given, "weight", "weights");
}

std::vector<std::uint8_t> flags_from(const NumbersLike& given, const char* name) {
  return numbers_from<std::uint8_t>(given, name, "flags");
}

std::vector<Segment> segments_from(const NumbersLike& given, const char* name) {
  const std::vector<std::uint32_t> ends = indices_from(given, name);
  if (ends.size() % 2 != 0) {
    throw Error(ErrorCode::kBadOption, std::string(name) + " needs two numbers each, not " +
                                           std::to_string(ends.size()) + " in all");
  }
  std::vector<Segment> out;
  out.reserve(ends.size() / 2);
  for (std::size_t i = 0; i < ends.size(); i += 2) out.push_back({ends[i], ends[i + 1]});
  return out;
}

MeshArgument::MeshArgument(const nb::object& given, const nb::object& faces) : keep_(given) {
  const bool has_faces = faces.is_valid() && !faces.is_none();
  if (has_faces || !nb::isinstance<Mesh>(given)) {
    keep_ = conversions().attr("mesh")(given, has_faces ? faces : nb::none());
  }
  mesh_ = nb::cast<const Mesh*>(keep_);
}

const Triangulation& MeshArgument::triangulation() const {
  const Parts parts = mesh_->parts();
  if (parts.triangulation != nullptr) return *parts.triangulation;
  const PolygonMesh faces = mesh_->polygons();
  for (std::size_t f = 0; f < faces.face_count(); ++f) {
    if (faces.face(f).size() == 3) continue;
    throw Error(ErrorCode::kBadMesh,
                "face " + std::to_string(f) + " has " + counted(faces.face(f).size(), "corner") +
                    ", a triangle has 3",
                {f});
  }
  check_finite(faces.points);
  own_ = triangles_with_twins(faces.points, faces.face_vertex);
  return own_;
}

void check_faces(const PolygonMesh& mesh) {
  check_finite(mesh.points);
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    for (const VertexId v : mesh.face(f)) {
      if (v < mesh.points.size()) continue;
      throw Error(ErrorCode::kIndexOutOfRange,
                  "face " + std::to_string(f) + " names vertex " + std::to_string(v) + " of " +
                      std::to_string(mesh.points.size()),
                  {f, v});
    }
  }
}

TriangleMeshArgument::TriangleMeshArgument(const nb::object& given, const nb::object& faces)
    : given_(given, faces) {
  const Parts parts = given_.mesh().parts();
  if (parts.triangle_mesh != nullptr) {
    mesh_ = parts.triangle_mesh;
    return;
  }
  mesh_ = &own_;
  const bool of_any_kind = dynamic_cast<const Made<Triangulation>*>(&given_.mesh()) != nullptr;
  if (parts.triangulation != nullptr && !of_any_kind) {
    own_.mesh = *parts.triangulation;
    if (const auto* constrained = dynamic_cast<const Made<ConstrainedResult>*>(&given_.mesh())) {
      own_.region = constrained->part;
      for (const std::uint32_t e : constrained->edge) own_.keep.push_back(e != kNone ? 1 : 0);
    }
    return;
  }
  ConnectedMesh connected =
      without_gil([&] { return connect_triangles(given_.mesh().polygons(), given_.mesh().z()); });
  own_ = std::move(connected.triangles);
  source_face_ = std::move(connected.source_face);
}

void add_faces_from(nb::handle given, PolygonMesh& mesh) {
  for (const nb::handle group : conversions().attr("faces")(given)) {
    const auto rows = nb::cast<Contiguous<std::uint32_t, nb::shape<-1, -1>>>(group);
    for (std::size_t f = 0; f < rows.shape(0); ++f) {
      mesh.add_face({rows.data() + f * rows.shape(1), rows.shape(1)});
    }
  }
}

std::vector<Polygon> polygons_from(const PolygonsLike& given, std::vector<double>* z) {
  const io::PlanarFile* file = nullptr;
  if (nb::try_cast(given, file) && file != nullptr) return file->input.polygons;
  std::vector<Polygon> out;
  for (const nb::handle rings : conversions().attr("polygons")(given)) {
    Polygon& polygon = out.emplace_back();
    for (const nb::handle ring : rings) {
      const Points points(nb::borrow<PointsLike>(ring));
      polygon.rings.emplace_back(points.xy().begin(), points.xy().end());
      if (z != nullptr) z->insert(z->end(), points.z().begin(), points.z().end());
    }
  }
  return out;
}

Polygon polygon_from(const PolygonsLike& given) {
  std::vector<Polygon> polygons = polygons_from(given);
  if (polygons.size() != 1) {
    throw Error(ErrorCode::kBadOption,
                "one polygon is wanted, not " + std::to_string(polygons.size()));
  }
  return std::move(polygons.front());
}

}  // namespace quadloom::python
