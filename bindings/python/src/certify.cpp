// include/quadloom/certify.hpp: the independent check, and the quality figures.
#include "quadloom/certify.hpp"

#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include "bind.hpp"
#include "choice.hpp"
#include "fields.hpp"
#include "inputs.hpp"
#include "parts.hpp"
#include "progress.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace quadloom::python {
namespace {

void bind_faults(nb::module_& m) {
  bind_words<Fault>(
      m, "Fault", "What is wrong with a mesh.",
      {{Fault::kNoFault, "no-fault", "nothing"},
       {Fault::kNoFaces, "no-faces", "there are none"},
       {Fault::kIndexOutOfRange, "index-out-of-range", "a face names a vertex that is not there"},
       {Fault::kRepeatedCorner, "repeated-corner", "a face has a corner twice"},
       {Fault::kCornerCount, "corner-count", "a face of another number of corners"},
       {Fault::kNotFinite, "not-finite", "a used vertex with a NaN or infinite coordinate"},
       {Fault::kNotSimple, "not-simple",
        "not a simple counter-clockwise polygon of positive area; on a surface: all corners on one "
        "line"},
       {Fault::kNotStrictlyConvex, "not-strictly-convex", "a face with a flat or reflex corner"},
       {Fault::kRepeatedEdge, "repeated-edge", "a directed edge in two faces"},
       {Fault::kRepeatedVertex, "repeated-vertex", "two used vertices at the same place"},
       {Fault::kMissingPoint, "missing-point", "an input point that is no vertex of a face"},
       {Fault::kBoundary, "boundary",
        "boundary not one simple, weakly convex cycle that goes around once; or not that of the "
        "polygons or the source"},
       {Fault::kTooManyTriangles, "too-many-triangles", "more than are allowed"},
       {Fault::kTooManySteiner, "too-many-steiner", "more added points than are allowed"},
       {Fault::kSteinerOnBoundary, "steiner-on-boundary", "an added point on the boundary"},
       {Fault::kFans, "fans",
        "surfaces: the faces at a vertex hang together otherwise than in the source"},
       {Fault::kTopology, "topology",
        "surfaces: other components, or one of another Euler characteristic"},
       {Fault::kOrder, "order",
        "neighbours in an order of triangles that share no edge; a cycle that is not closed"},
       {Fault::kTurns, "turns", "an order of triangles that is not sequential"},
       {Fault::kReflexChains, "reflex-chains",
        "a ring whose reflex corners are more than one chain"}});
}

void bind_certificate(nb::module_& m) {
  Fields<Certificate> c(
      m, "Certificate",
      "The verdict of a check with its figures, counted up to the fault. True if there "
      "is no fault.");
  c.get(
       "ok", [](const Certificate& self) { return self.ok(); }, "Whether there is no fault.")
      .value("fault", &Certificate::fault, "What is wrong.")
      .value("sentence", &Certificate::sentence, "The same for people; empty if nothing is.")
      .value(
          "culprits", &Certificate::culprits,
          "Faces for face faults, vertices for vertex and edge faults, input indices for missing "
          "points.")
      .value("points", &Certificate::points, "Distinct input points that are vertices.")
      .value("faces", &Certificate::faces, "How many there are.")
      .value("triangles", &Certificate::triangles, "Faces of three corners.")
      .value("boundary", &Certificate::boundary, "Vertices on the boundary cycle.")
      .value("steiner", &Certificate::steiner, "Vertices that are no input points.")
      .value("strictly_convex", &Certificate::strictly_convex,
             "Of the faces with `corners` corners; so the next two.")
      .value("flat_cornered", &Certificate::flat_cornered, "Convex, with a flat corner.")
      .value("non_convex", &Certificate::non_convex, "With a reflex corner.");
  c.def("__bool__", &Certificate::ok);
  c.done();
}

void bind_quality(nb::module_& m) {
  Fields<Quality>(
      m, "Quality",
      "Shape figures of a mesh. Angles in degrees; an edge between two faces counts once.")
      .value("quads", &Quality::quads, "How many.")
      .value("triangles", &Quality::triangles, "How many.")
      .value("other_faces", &Quality::other_faces, "How many.")
      .value("strictly_convex", &Quality::strictly_convex, "Of the quads; decided exactly.")
      .value("flat_cornered", &Quality::flat_cornered, "Of the quads: convex, with a flat corner.")
      .value("non_convex", &Quality::non_convex, "Of the quads: with a reflex corner.")
      .value("min_angle", &Quality::min_angle, "Over all corners of all faces.")
      .value("max_angle", &Quality::max_angle, "Over all corners of all faces.")
      .value("angle_histogram", &Quality::angle_histogram,
             "Corners by angle, 10 degrees a bin, [0, 360).")
      .value("mean_shape", &Quality::mean_shape, "quad_shape over the quads.")
      .value("min_shape", &Quality::min_shape, "The least quad_shape.")
      .value("shape_histogram", &Quality::shape_histogram, "Quads by shape, a tenth a bin.")
      .value("max_aspect", &Quality::max_aspect, "Longest over shortest edge of a quad.")
      .value("median_aspect", &Quality::median_aspect, "The median of the same.")
      .value("edges", &Quality::edges, "How many; one between two faces counts once.")
      .value("min_edge", &Quality::min_edge, "The shortest edge.")
      .value("max_edge", &Quality::max_edge, "The longest edge.")
      .value("mean_edge", &Quality::mean_edge, "Their mean.")
      .done();
}

// Whether heights make a surface of the mesh, and are not data over the plane.
bool is_surface(const Mesh& mesh, const PolygonMesh& faces) {
  const auto* const file = dynamic_cast<const Made<io::MeshFile>*>(&mesh);
  if (file != nullptr && file->z_is_data) return false;
  const Parts parts = mesh.parts();
  if (parts.faces == nullptr && !parts.z.empty()) return true;
  return space_of(faces, mesh.z()) == Space::kSurface;
}

CertifyOptions certify_options(std::size_t corners, std::size_t triangles_allowed,
                               std::optional<std::size_t> steiner_at_most, bool steiner_inside,
                               bool outer_steiner, bool strictly_convex) {
  CertifyOptions o;
  o.corners = corners;
  o.triangles_allowed = triangles_allowed;
  o.steiner_at_most = steiner_at_most.value_or(o.steiner_at_most);
  o.steiner_inside = steiner_inside;
  o.outer_steiner = outer_steiner;
  o.strictly_convex = strictly_convex;
  return o;
}

// m.def of a certificate of a mesh against sources: f(mesh, sources..., options).
template <typename... Source, typename F, typename... Arg>
void def_certificate(nb::module_& m, const char* name, const char* doc, F f, const Arg&... arg) {
  m.def(
      name,
      [f](const MeshLike& mesh, const Source&... sources, std::size_t corners,
          std::size_t triangles_allowed, std::optional<std::size_t> steiner_at_most,
          bool steiner_inside, bool outer_steiner, bool strictly_convex) {
        return f(MeshArgument(mesh), sources...,
                 certify_options(corners, triangles_allowed, steiner_at_most, steiner_inside,
                                 outer_steiner, strictly_convex));
      },
      "mesh"_a, arg..., nb::kw_only(), "corners"_a = 4, "triangles_allowed"_a = 0,
      "steiner_at_most"_a = nb::none(), "steiner_inside"_a = false, "outer_steiner"_a = false,
      "strictly_convex"_a = false, doc);
}

void bind_certificates(nb::module_& m) {
  def_certificate<PointsLike>(
      m, "certify_points",
      R"(Proves from the faces alone, exactly, that the mesh tiles the convex region within its boundary once and that
every input point is a vertex of it. No points ask for none: every used vertex then counts as an input point.

`corners`: of every face but the allowed triangles. `steiner_at_most`: None for any number. `steiner_inside`: no
Steiner point on the boundary. `strictly_convex`: every face of `corners` corners turns strictly left everywhere.

Returns the Certificate with the first fault found. Raises Error: bad-option for fewer than three corners. Near-linear.)",
      [](const MeshArgument& mesh, const PointsLike& points, const CertifyOptions& options) {
        const Points input(points);
        const PolygonMesh faces = mesh.mesh().polygons();
        return without_gil([&] { return certify_points(faces, input.xy(), options); });
      },
      "points"_a);
  def_certificate<PolygonsLike, PointsLike>(
      m, "certify_polygons",
      R"(The same for polygons: the mesh's boundary must be their rings (an edge may be split by vertices on it,
`steiner_inside` forbids Steiner points there; edges that two polygons share are none of the boundary), it must wind
around its inside once, and corners and inner points must be vertices. With `outer_steiner` an edge may be replaced by
two. Raises Error: too-few-points for no polygons. O(n + b log b), b the edges of the boundary.)",
      [](const MeshArgument& mesh, const PolygonsLike& polygons, const PointsLike& inner,
         const CertifyOptions& options) {
        const std::vector<Polygon> rings = polygons_from(polygons);
        const std::optional<Points> points =
            inner.is_none() ? std::nullopt : std::optional<Points>(inner);
        const PolygonMesh faces = mesh.mesh().polygons();
        return without_gil([&] {
          return certify_polygons(faces, rings, points ? points->xy() : std::span<const Point>(),
                                  options);
        });
      },
      "polygons"_a, "inner"_a = nb::none());
  def_certificate<MeshLike>(
      m, "certify_mesh",
      R"(The same for a planar mesh that was made from another: the boundary must be the source's and the vertices that
the source uses must be vertices. Raises Error: bad-mesh, index-out-of-range (a source that is no mesh),
too-few-points.)",
      [](const MeshArgument& mesh, const MeshLike& source, const CertifyOptions& options) {
        const PolygonMesh faces = mesh.mesh().polygons();
        const PolygonMesh from = MeshArgument(source).mesh().polygons();
        return without_gil([&] { return certify_mesh(faces, from, options); });
      },
      "source"_a);
  def_certificate<MeshLike>(
      m, "certify_surface",
      R"(For a surface in space that was made from another, heights being those of the meshes' points. What can be said
of it is combinatorial, and vertices are known by number: each vertex that the source uses is the vertex with the same
number, at the same place, in a face; the others are Steiner points. Faces have distinct corners, not all on one line,
each directed edge is in one face; the faces at a vertex make as many fans as in the source (a Steiner point: one); the
boundary is the source's, an edge in one piece or replaced by a chain through Steiner points, which without
`outer_steiner` are in the box that the edge spans; the components are the source's and have its Euler characteristics.
`strictly_convex`: in the coordinate plane that the face is nearest to. Whether faces cut each other in space is not
looked at. Raises Error: bad-mesh, index-out-of-range, too-few-points, bad-option. O(n log n).)",
      [](const MeshArgument& mesh, const MeshLike& source, const CertifyOptions& options) {
        const MeshArgument from(source);
        const PolygonMesh faces = mesh.mesh().polygons(), source_faces = from.mesh().polygons();
        return without_gil([&] {
          return certify_surface(faces, mesh.mesh().z(), source_faces, from.mesh().z(), options);
        });
      },
      "source"_a);
}

}  // namespace

void bind_certify(nb::module_& m) {
  bind_faults(m);
  bind_certificate(m);
  bind_quality(m);
  bind_certificates(m);
  m.def(
      "certify_order",
      [](const MeshLike& mesh, const Choice<OrderKind>& kind) {
        const OrderKind order = kind.get("kind");
        const PolygonMesh faces = MeshArgument(mesh).mesh().polygons();
        return without_gil([&] { return certify_order(faces, order); });
      },
      "mesh"_a, "kind"_a,
      R"(Proves that the order of the faces, all of them triangles, is of that kind: consecutive ones have an edge in
opposite directions, and what OrderKind says. That no triangle stands there twice, and that they tile something, is
for the other certificates. Culprits: the two faces; for "turns" the first face that no sequence of vertices reaches.
Linear.)");
  m.def(
      "certify_spiral_polygon",
      [](const PointsLike& ring, const PointsLike& points) {
        const Points corners(ring), input(points);
        return without_gil([&] { return certify_spiral_polygon(corners.xy(), input.xy()); });
      },
      "ring"_a, "points"_a,
      R"(Proves that a ring of corners (k, 2), the first not again at the end, is a spiral polygon through the points:
simple, without touching itself; counter-clockwise; its corners are the points, each distinct one once; and of its
reflex corners no two have convex ones between them on both sides. O(n log n).)");
  m.def(
      "measure_quality",
      [](const MeshLike& mesh, const nb::object& faces) {
        const MeshArgument given(mesh, faces);
        const PolygonMesh polygons = given.mesh().polygons();
        return without_gil([&] {
          const Quality flat = measure_quality(polygons);  // first: space_of trusts the faces
          return is_surface(given.mesh(), polygons) ? measure_quality(polygons, given.mesh().z())
                                                    : flat;
        });
      },
      "mesh"_a, "faces"_a = nb::none(),
      R"(Shape figures of a mesh, of a surface in space if it is one (see space_of); heights over the plane are not
looked at. Faces should be counter-clockwise. A mesh without faces has zeros everywhere.

Raises Error: bad-mesh (a face of fewer than three corners), index-out-of-range, not-finite. Near-linear.)");
}

}  // namespace quadloom::python
