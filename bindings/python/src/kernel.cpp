// include/quadloom/kernel.hpp but for the predicates: hull, layers, spiral, Delaunay, meshes of triangles.
#include "quadloom/kernel.hpp"

#include <nanobind/stl/string.h>

#include "bind.hpp"
#include "choice.hpp"
#include "conversions.hpp"
#include "fields.hpp"
#include "inputs.hpp"
#include "parts.hpp"
#include "progress.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace quadloom::python {
namespace {

void bind_words_of_kernel(nb::module_& m) {
  bind_words<Space>(
      m, "Space", "What the third coordinate of a mesh means.",
      {{Space::kAuto, "auto",
        "plane if all vertices are at one height, or if the faces, seen from above, all turn the "
        "same "
        "way and no two of their vertices are above each other; else surface"},
       {Space::kPlane, "plane",
        "heights or depths are data: decisions and shapes are those of the plane"},
       {Space::kSurface, "surface", "a surface in space: shapes are measured in space"}});
  bind_words<FaultyFaces>(
      m, "FaultyFaces",
      "What to do with faces that turn the other way than their neighbours, and faces without "
      "area.",
      {{FaultyFaces::kRepair, "repair", "turn, flip or leave them out, and count them"},
       {FaultyFaces::kRefuse, "refuse", "an Error"}});
  bind_words<EqualVertices>(m, "EqualVertices",
                            "What to do with vertices at exactly the same place.",
                            {{EqualVertices::kKeep, "keep", "seams may be meant"},
                             {EqualVertices::kMerge, "merge", "they become one"}});
  bind_words<Extent>(m, "Extent", "What constrained_delaunay covers.",
                     {{Extent::kInside, "inside",
                       "the inside of the polygons; if there are none, what the segments enclose"},
                      {Extent::kHull, "hull", "the convex hull of everything"}});
}

// ---- Points. ----

void bind_points(nb::module_& m) {
  Fields<DistinctPoints>(m, "DistinctPoints",
                         "Distinct points in the order of their first occurrence.")
      .array("points", &DistinctPoints::points, "float64 (m, 2).")
      .array("input_to_vertex", &DistinctPoints::input_to_vertex,
             "One per input point, uint32 (n,): where it went.")
      .done();
  m.def(
      "distinct_points",
      [](const PointsLike& points) {
        const Points input(points);
        return without_gil([&] { return distinct_points(input.xy()); });
      },
      "points"_a,
      "The distinct points. Raises Error: not-finite (the first culprit), too-many-points. O(n log "
      "n).");
  m.def(
      "spatial_order",
      [](const PointsLike& points) {
        const Points input(points);
        return own(without_gil([&] { return spatial_order(input.xy()); }));
      },
      "points"_a,
      "A permutation of the points along a Hilbert curve, uint32 (n,); equal points are "
      "neighbours, ordered "
      "by index. The same on every platform. O(n) in practice.");
  m.def(
      "convex_hull",
      [](const PointsLike& points) {
        const Points input(points);
        return own(without_gil([&] { return convex_hull(checked_points(input)); }));
      },
      "points"_a,
      R"(The convex hull of distinct points as numbers of them, uint32 (h,): counter-clockwise from the lexicographically
smallest point, every point on a hull edge included. If all points lie on one line: the points in order along it.

Raises Error: not-finite; bad-option for a point that is there twice (see distinct_points). O(n log n).)");
}

void bind_layers(nb::module_& m) {
  Fields<ConvexLayers> layers(m, "ConvexLayers", "Convex layers from the outside in.");
  layers.array("vertex", &ConvexLayers::vertex, "The points of all layers, uint32 (n,).")
      .array("begin", &ConvexLayers::begin, "Layer i is vertex[begin[i] : begin[i + 1]].")
      .done();
  layers.def("__len__", &ConvexLayers::count);
  layers.def(
      "layer",
      [](const ConvexLayers& self, std::size_t i) {
        if (i >= self.count()) throw nb::index_error("there is no such layer");
        return view(self.layer(i));
      },
      nb::rv_policy::reference_internal, "i"_a,
      "Layer i as convex_hull gives it; the last one may be one point or a segment's points in "
      "order.");
  m.def(
      "convex_layers",
      [](const PointsLike& points, const ProgressLike& progress) {
        const Points input(points);
        return run(progress,
                   [&](const Progress& p) { return convex_layers(checked_points(input), p); });
      },
      "points"_a, nb::kw_only(), "progress"_a = nb::none(),
      "The convex layers of distinct points: each is the hull of what those before it leave. "
      "Raises Error as "
      "convex_hull. O(n log n).");
  m.def(
      "convex_spiral",
      [](const PointsLike& points, VertexId start, const ProgressLike& progress) {
        const Points input(points);
        if (start != kNone && start >= input.xy().size()) {
          throw Error(ErrorCode::kIndexOutOfRange,
                      "start: there is no point " + std::to_string(start), {start});
        }
        return own(run(progress, [&](const Progress& p) {
          const auto distinct = checked_points(input);
          return convex_spiral(distinct, convex_layers(distinct, p), start);
        }));
      },
      "points"_a, "start"_a = kNone, nb::kw_only(), "progress"_a = nb::none(),
      R"(The convex spiral of distinct points (Bose and Toussaint, section 4), uint32 (n,): every point once, from `start`
(a corner of the hull; NONE: the lexicographically smallest point) clockwise around the hull and on inwards, collinear
points in order. Raises Error as convex_hull. O(n log n).)");
}

// ---- Meshes of triangles. ----

void bind_connected(nb::module_& m) {
  using C = ConnectedMesh;
  Fields<Made<C>, Mesh>(m, "ConnectedMesh",
                        "A mesh as its triangles, and what was found on the way. It may be "
                        "given where a TriangleMesh is expected.")
      .get(
          "triangle_mesh",
          [](const Made<C>& self) {
            TriangleMesh copy = self.triangles;
            auto* const out = made(std::move(copy));
            out->heights = self.heights;
            return out;
          },
          "The triangles as a TriangleMesh, a copy: to give it regions, or edges to keep.")
      .array("input_to_vertex", &C::input_to_vertex,
             "One per vertex given: equal ones merged, if asked for.")
      .array("source_face", &C::source_face, "Per triangle: the face of the input.")
      .value("space", &C::space, "plane or surface.")
      .value("turned_faces", &C::turned_faces, "Faces given the other way around.")
      .value("flat_faces", &C::flat_faces, "Repaired: triangles without area.")
      .value("unused_vertices", &C::unused_vertices, "Vertices of no face.")
      .value("components", &C::components, "Of triangles connected over edges.")
      .value("boundary_cycles", &C::boundary_cycles, "Closed: 0.")
      .value("boundary_edges", &C::boundary_edges, "Edges of one triangle.");
  m.def(
      "space_of",
      [](const MeshLike& mesh, const nb::object& faces) {
        const MeshArgument given(mesh, faces);
        const PolygonMesh polygons = given.mesh().polygons();
        return without_gil([&] { return space_of(polygons, given.mesh().z()); });
      },
      "mesh"_a, "faces"_a = nb::none(),
      "What Space.AUTO takes a mesh of any faces for. Raises Error: bad-mesh. O(n log n).");
  m.def(
      "connect_triangles",
      [](const MeshLike& mesh, const nb::object& faces, const Choice<Space>& space,
         const Choice<FaultyFaces>& faulty, const Choice<EqualVertices>& equal) {
        const MeshArgument given(mesh, faces);
        ConnectOptions o{space.get("space"), faulty.get("faulty"), equal.get("equal")};
        const PolygonMesh polygons = given.mesh().polygons();
        const std::span<const double> z = given.mesh().z();
        auto* const out = made(without_gil([&] { return connect_triangles(polygons, z, o); }));
        if (out->triangles.z.empty()) carry_heights(z, out->input_to_vertex, *out);
        return out;
      },
      "mesh"_a, "faces"_a = nb::none(), nb::kw_only(), "space"_a = "auto", "faulty"_a = "repair",
      "equal"_a = "keep",
      R"(Connects triangles and quads over their edges and checks them: each edge has at most two faces, one on each side;
no triangle is without area. Vertices keep their numbers, used or not, unless they are merged. Bow-ties (two fans of
triangles at one vertex) are allowed. Whether faces lie over each other is not looked at.

Quads are cut by a diagonal that is inside. In the plane faces are turned counter-clockwise, and used vertices must be
at different places. On a surface the faces of a component are turned as most of them were given, in a tie as its
first. A triangle without area (exactly: its corners are on a line) is flipped into its neighbour across its longest
edge, or left out if that edge is on the boundary. faulty "refuse" refuses both, but not a planar mesh that is
clockwise as a whole. A corner that repeats the one before counts once.

Raises Error: bad-mesh (a face of other than three or four corners, a corner twice, an edge with three faces or with
two on one side, a surface with one side, a quad that is not simple, two vertices at one place in the plane, a triangle
without area that cannot be repaired, or what `faulty` refuses; culprits: the edge's vertices, the two vertices, or the
face), index-out-of-range (culprits: face, index), not-finite (the vertex), too-few-points (no faces with an area),
too-many-points. O(n log n).)");
  m.def(
      "keep_sharp_edges",
      [](Made<TriangleMesh>& mesh, double degrees) { return keep_sharp_edges(mesh, degrees); },
      "mesh"_a, "degrees"_a,
      R"(Adds to the edges to keep of a TriangleMesh those where the normals of the two triangles differ by more than
`degrees` (0 to 180), in floating point; returns how many edges do. The diagonals of given quads are none. In the plane
there are none. Raises Error: bad-option. O(n).)");
}

// ---- Delaunay. ----

void bind_delaunay(nb::module_& m) {
  using D = DelaunayResult;
  Fields<Made<D>, Mesh>(m, "DelaunayResult", "The Delaunay triangulation of a point set.")
      .array<3>(
          "twin", [](const Made<D>& r) -> const auto& { return r.mesh.twin; },
          "Per halfedge, uint32 (t, 3): as in Triangulation.")
      .array("input_to_vertex", &D::input_to_vertex,
             "One per input point, uint32 (n,): the vertex that it is; repeated points are one.");
  m.def(
      "delaunay",
      [](const PointsLike& points) {
        const Points input(points);
        auto* const out = made(without_gil([&] { return delaunay(input.xy()); }));
        carry_heights(input, *out);
        out->guarantee = "no point is inside the circle of a triangle, exactly";
        return out;
      },
      "points"_a,
      R"(The Delaunay triangulation, exact. Cocircular points are triangulated the same way whatever the input order. Its
boundary is the hull with every collinear point.

Raises Error: not-finite, too-few-points, all-collinear, too-many-points. O(n log n) expected.)");
  using C = ConstrainedResult;
  Fields<Made<C>, Mesh>(
      m, "ConstrainedResult",
      "A constrained Delaunay triangulation. It may be given where a TriangleMesh is "
      "expected: input edges then stay, parts are regions.")
      .array<3>(
          "twin", [](const Made<C>& r) -> const auto& { return r.mesh.twin; },
          "Per halfedge, uint32 (t, 3): as in Triangulation.")
      .array("input_to_vertex", &C::input_to_vertex,
             "One per input point, the polygons' corners first: the vertex that it is; NONE: "
             "outside, left "
             "out.")
      .array<3>("edge", &C::edge,
                "Per halfedge, uint32 (t, 3): the input edge that it is on, or NONE.")
      .array("part", &C::part, "Per triangle: the polygon or else the region, or NONE.");
  m.def(
      "constrained_delaunay",
      [](const PolygonsLike& polygons, const PointsLike& points, const NumbersLike& segments,
         const PointsLike& holes, const PointsLike& regions, const Choice<Extent>& extent,
         const ProgressLike& progress) {
        const PlanarArgument given(polygons, points, segments, holes, regions);
        const Extent covered = extent.get("extent");
        auto* const out = made(run(progress, [&](const Progress& p) {
          return constrained_delaunay(given.input, covered, p);
        }));
        carry_heights(given.z, out->input_to_vertex, *out);
        out->guarantee =
            "every input edge is an edge or a chain of edges, every other edge is locally "
            "Delaunay, exactly";
        return out;
      },
      "polygons"_a = nb::none(), "points"_a = nb::none(), "segments"_a = nb::none(),
      "holes"_a = nb::none(), "regions"_a = nb::none(), nb::kw_only(), "extent"_a = "inside",
      "progress"_a = nb::none(),
      R"(The constrained Delaunay triangulation, exact, without new points: every input edge is an edge of it, or a chain
of edges where points lie on it, and every other edge is locally Delaunay.

`polygons`: a ring (k, 2), or a list of rings, the outer one first and the others its holes, or several such polygons;
rings either way around, with or without the first corner again at the end; None for none. `points`: inner points and
ends of segments. `segments` (s, 2): numbers of `points`. `holes`, without polygons: a place in each enclosed part to
leave out; `regions`: a place in each part that shall have a name. Input points are numbered with the polygons' corners
first, ring by ring, then `points`; edge i of a ring starts at input point i, the segments follow.

Two polygons may share whole edges, a segment may repeat an edge; the edge then counts as the first one. Where an input
point is on two edges they meet there and do not cross. Rings may touch at corners.

Raises Error: crossing (edges that cross or overlap, named by number), bad-polygon (a ring of fewer than three places,
rings that are not nested as outer ring and holes, polygons that overlap, nothing inside), index-out-of-range
(culprits: segment, index), bad-option (holes or regions beside polygons, or on an edge), and as delaunay.
O(n log n) expected, and the edges that the segments cross.)");
}

}  // namespace

void bind_kernel(nb::module_& m) {
  bind_predicates(m);
  bind_words_of_kernel(m);
  bind_points(m);
  bind_layers(m);
  bind_connected(m);
  bind_delaunay(m);
}

}  // namespace quadloom::python
