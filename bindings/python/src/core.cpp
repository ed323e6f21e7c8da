// include/quadloom/core.hpp: meshes, error codes, threads.
#include "quadloom/core.hpp"

#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <memory>
#include <new>
#include <string>

#include "bind.hpp"
#include "choice.hpp"
#include "conversions.hpp"
#include "fields.hpp"
#include "inputs.hpp"
#include "parts.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace quadloom::python {
namespace {

void bind_words_of_core(nb::module_& m) {
  bind_words<ErrorCode>(
      m, "ErrorCode", "What is wrong: the code of a quadloom.Error.",
      {{ErrorCode::kBadOption, "bad-option",
        "an option out of its range, or an argument of the wrong shape"},
       {ErrorCode::kNotFinite, "not-finite",
        "a coordinate is NaN or infinite; culprits: the point"},
       {ErrorCode::kTooFewPoints, "too-few-points", "fewer than three distinct points"},
       {ErrorCode::kAllCollinear, "all-collinear", "all points on one line"},
       {ErrorCode::kTooManyPoints, "too-many-points", "more than the 32-bit indices can number"},
       {ErrorCode::kIndexOutOfRange, "index-out-of-range",
        "a face names a vertex that is not there; culprits: face, index"},
       {ErrorCode::kBadMesh, "bad-mesh",
        "not a manifold mesh; culprits: the edge's vertices or the face"},
       {ErrorCode::kCrossing, "crossing",
        "input edges that cross or overlap; culprits: the two edges"},
       {ErrorCode::kBadPolygon, "bad-polygon",
        "rings that bound no region; culprits: two edges, or the ring"},
       {ErrorCode::kParse, "parse", "unreadable text; culprits: the line"},
       {ErrorCode::kFile, "file", "a file cannot be opened, read or written"},
       {ErrorCode::kGuarantee, "guarantee", "what was asked for does not exist for this input"},
       {ErrorCode::kCancelled, "cancelled", "the progress callback returned False"}});
  bind_words<OrderKind>(
      m, "OrderKind",
      "What the order of a mesh's triangles promises: in all of them consecutive triangles share "
      "an "
      "edge.",
      {{OrderKind::kPath, "path", "no more than that: a Hamiltonian path of the dual graph"},
       {OrderKind::kCycle, "cycle", "the last triangle and the first share an edge, too"},
       {OrderKind::kSequential, "sequential", "left and right turns alternate"}});
}

// ---- Any faces. ----

PolygonMesh faces_of(const Points& points, const nb::args& groups) {
  PolygonMesh out;
  out.points.assign(points.xy().begin(), points.xy().end());
  for (const nb::handle group : groups) add_faces_from(group, out);
  return out;
}

void bind_polygon_mesh(nb::module_& m) {
  nb::class_<Made<PolygonMesh>, Mesh>(
      m, "PolygonMesh", "Any mesh of polygons: what files hold, and what the certificates judge.")
      .def(
          "__init__",
          [](Made<PolygonMesh>* self, const PointsLike& points, const nb::args& faces) {
            const Points given(points);
            PolygonMesh mesh = faces_of(given, faces);
            (new (self) Made<PolygonMesh>(std::move(mesh)))->heights = given.z();
          },
          "points"_a, "faces"_a,
          "Points (n, 2) or (n, 3), and faces: integers (m, k), or a list of faces of different "
          "sizes; as many such arguments as there are kinds. Nothing is checked but the shapes.")
      .def_prop_ro(
          "face_begin", [](const Made<PolygonMesh>& self) { return view(self.face_begin); },
          "Face f has the corners face_vertex[face_begin[f] : face_begin[f + 1]].")
      .def_prop_ro(
          "face_vertex", [](const Made<PolygonMesh>& self) { return view(self.face_vertex); },
          "The corners of all faces, one face after the other.");
}

// ---- Triangles. ----

void bind_triangulation(nb::module_& m) {
  nb::class_<Made<Triangulation>, Mesh> c(
      m, "Triangulation",
      "Triangles that know their neighbours. All results that have triangles only "
      "may be given where one is expected, and so may (points, triangles).");
  c.def(
      "__init__",
      [](Made<Triangulation>* self, const MeshLike& mesh, const nb::object& triangles) {
        const MeshArgument given(mesh, triangles);
        Triangulation copy = given.triangulation();
        const auto z = given.mesh().z();
        (new (self) Made<Triangulation>(std::move(copy)))->heights.assign(z.begin(), z.end());
      },
      "mesh"_a, "triangles"_a = nb::none(),
      "Of another mesh, or of points and triangles (t, 3), as they are: see triangles_with_twins.");
  c.def_prop_ro(
      "twin", [](const Made<Triangulation>& self) { return view<3>(self.twin); },
      "Per halfedge, uint32 (t, 3): the same edge in the neighbouring triangle, as the number 3 t "
      "+ i of "
      "its halfedge; NONE on the boundary. Halfedge i of a triangle goes from corner i to the "
      "next.");
}

template <typename T>
std::vector<T> checked(std::vector<T> values, std::size_t size, const char* name) {
  if (values.empty() || values.size() == size) return values;
  throw Error(ErrorCode::kBadOption, std::string(name) + " has " + counted(values.size(), "value") +
                                         ", not " + std::to_string(size));
}

void bind_triangle_mesh(nb::module_& m) {
  using Self = Made<TriangleMesh>;
  nb::class_<Self, Mesh> c(m, "TriangleMesh",
                           "A mesh of triangles that is to be converted, and what must stay of it. "
                           "connect_triangles makes one from any faces.");
  c.def(
      "__init__",
      [](Self* self, const MeshLike& mesh, const nb::object& triangles, const NumbersLike& region,
         const NumbersLike& keep) {
        const TriangleMeshArgument given(mesh, triangles);
        TriangleMesh copy = given.mesh();
        const std::size_t count = copy.mesh.triangle_count();
        if (!region.is_none())
          copy.region = checked(indices_from(region, "region"), count, "region");
        if (!keep.is_none()) copy.keep = checked(flags_from(keep, "keep"), 3 * count, "keep");
        carry_heights(given, *new (self) Self(std::move(copy)));
      },
      "mesh"_a, "triangles"_a = nb::none(), nb::kw_only(), "region"_a = nb::none(),
      "keep"_a = nb::none(),
      "Of another mesh, or of points and triangles (t, 3). `region` (t,): a label each; no face "
      "reaches from one label into another. `keep` (t, 3): true for the halfedges of edges that "
      "stay.");
  c.def_prop_ro(
      "twin", [](const Self& self) { return view<3>(self.mesh.twin); },
      "Per halfedge, uint32 (t, 3): as in Triangulation.");
  c.def_prop_rw(
      "region", [](const Self& self) { return view(self.region); },
      [](Self& self, const NumbersLike& given) {
        self.region = checked(indices_from(given, "region"), self.mesh.triangle_count(), "region");
      },
      nb::for_getter(nb::sig("def region(self) -> numpy.typing.NDArray[numpy.uint32]")),
      "Per triangle: a label; empty: one region.");
  c.def_prop_rw(
      "keep", [](const Self& self) { return view<3>(self.keep); },
      [](Self& self, const NumbersLike& given) {
        self.keep = checked(flags_from(given, "keep"), self.mesh.tri_vertex.size(), "keep");
      },
      nb::for_getter(nb::sig("def keep(self) -> numpy.typing.NDArray[numpy.uint8]")),
      "Per halfedge, (t, 3): not 0 on either side is an edge that stays; empty: none.");
  c.def_prop_ro(
      "given_pair", [](const Self& self) { return view(self.given_pair); },
      "Per triangle: the halfedge inside its quad, where the source had a quad, else NONE.");
}

// ---- Threads. ----

struct LimitInWith {
  std::size_t threads = 0;
  std::size_t within = 0;  // so many `with`, of which the last ends the limit
  std::unique_ptr<ThreadLimit> limit;
};

void bind_thread_limit(nb::module_& m) {
  nb::class_<LimitInWith>(
      m, "thread_limit",
      "``with quadloom.thread_limit(2): ...``: meanwhile the library works on at "
      "most so many threads in all of the process; of several limits the least "
      "holds. Without one it takes all cores. Results do not depend on it.")
      .def(
          "__init__",
          [](LimitInWith* self, std::size_t threads) {
            ThreadLimit valid(threads);
            new (self) LimitInWith{threads, 0, nullptr};
          },
          "threads"_a, "At least 1.")
      .def(
          "__enter__",
          [](LimitInWith& self) {
            if (self.within == 0) self.limit = std::make_unique<ThreadLimit>(self.threads);
            ++self.within;
          },
          "The limit begins.")
      .def(
          "__exit__",
          [](LimitInWith& self, const nb::args&) {
            if (self.within > 0 && --self.within == 0) self.limit.reset();
          },
          "The limit ends.")
      .def_prop_ro(
          "holds", [](const LimitInWith& self) { return self.limit != nullptr; },
          "Whether it is within a ``with``.");
}

}  // namespace

void bind_core(nb::module_& m) {
  m.attr("NONE") = kNone;
  m.attr("MAX_POINTS") = kMaxPoints;
  bind_words_of_core(m);
  bind_polygon_mesh(m);
  bind_triangulation(m);
  bind_triangle_mesh(m);
  nb::class_<Made<Quadrangulation>, Mesh>(
      m, "Quadrangulation", "A mesh of quadrilaterals, and of triangles that were left over.");
  bind_thread_limit(m);
  m.def(
      "to_polygon_mesh",
      [](const MeshLike& mesh, const nb::object& faces) {
        const MeshArgument given(mesh, faces);
        auto* const out = made(given.mesh().polygons());
        out->heights.assign(given.mesh().z().begin(), given.mesh().z().end());
        return out;
      },
      "mesh"_a, "faces"_a = nb::none(), "The same mesh as polygons: quads first, then triangles.");
}

}  // namespace quadloom::python
