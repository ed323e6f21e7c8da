// include/quadloom/strips.hpp: triangles in order. Strips and their encodings are in strip_codes.cpp.
#include "quadloom/strips.hpp"

#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

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

void bind_words_of_orders(nb::module_& m) {
  bind_words<Splitter>(
      m, "Splitter", "Which point inside a triangle splits it.",
      {{Splitter::kRandom, "random", "any: O(n log n) expected"},
       {Splitter::kBalanced, "balanced",
        "Avis and ElGindy's: at most 2/3 of the points in each part, O(n log n) always"}});
  bind_words<Closure>(m, "Closure", "Whether the last triangle of an order is beside the first.",
                      {{Closure::kOpen, "open", "no"},
                       {Closure::kCycle, "cycle", "they share an edge"},
                       {Closure::kSequentialCycle, "sequential-cycle",
                        "so, and the left and right turns go on alternating across it"}});
  bind_words<NoOrder>(
      m, "NoOrder", "Why a mesh has no Hamiltonian order.",
      {{NoOrder::kNoReason, "no-reason", "it has one, or it is not known"},
       {NoOrder::kTooFew, "too-few", "a cycle takes three triangles"},
       {NoOrder::kComponents, "components", "it does not hang together over edges"},
       {NoOrder::kEars, "ears",
        "triangles with one neighbour: more than two, or any where a cycle is asked for"},
       {NoOrder::kBridges, "bridges",
        "an edge to cross twice, or parts that three of such edges lead away from"},
       {NoOrder::kPairing, "pairing",
        "too many triangles are left over by any pairing of neighbours"},
       {NoOrder::kExhausted, "exhausted", "the search went through all possibilities"}});
}

// ---- Point sets. ----

void bind_point_results(nb::module_& m) {
  using HS = HamiltonianStatistics;
  Fields<HS>(m, "HamiltonianStatistics", "What a run did; 0 in a path.")
      .value("hull_points", &HS::hull_points,
             "Points on the hull, those inside its edges included.")
      .value("centres", &HS::centres,
             "Inner points joined to hull points; 1 in general position, 0: the cycle was found by "
             "search.")
      .value("levels", &HS::levels, "How deeply split triangles are nested.")
      .value("locations", &HS::locations,
             "How often a point was looked for in the parts of a triangle.")
      .value("chains", &HS::chains, "Splitters that came with others on their line.")
      .done();
  using H = HamiltonianResult;
  Fields<Made<H>, Mesh>(m, "HamiltonianResult", "Triangles in order, each beside the one before.")
      .value("order", &H::order, "cycle or path.")
      .value("cycle", &H::cycle, "Has the set such a cycle? yes: here it is; no: proved.")
      .array("input_to_vertex", &H::input_to_vertex, "One per input point: the vertex that it is.")
      .value("statistics", &H::statistics, "What the run did.");
  using S = SequentialResult;
  Fields<Made<S>, Mesh>(
      m, "SequentialResult",
      "A sequential triangulation, triangles in order; no faces unless the answer is yes.")
      .value("answer", &S::answer, "Is there one?")
      .array("sequence", &S::sequence, "yes: triangle i has its vertices i, i + 1, i + 2.")
      .array("input_to_vertex", &S::input_to_vertex, "One per input point: the vertex that it is.")
      .value("inner_points", &S::inner_points, "Strictly inside the hull.")
      .value("work", &S::work, "Triangles tried.");
  Fields<SpiralPolygonStatistics>(m, "SpiralPolygonStatistics", "What a run of spiral_polygon did.")
      .value("iterations", &SpiralPolygonStatistics::iterations,
             "Turns of the algorithm's loop, at most 2 n.")
      .done();
  using P = SpiralPolygon;
  Fields<Made<P>, Mesh>(
      m, "SpiralPolygon",
      "A simple polygon through points, and its triangles in the order of a path.")
      .array("ring", &P::ring,
             "Every vertex once, counter-clockwise from the lowest point (of those the one "
             "farthest right).")
      .array("input_to_vertex", &P::input_to_vertex, "One per input point: the vertex that it is.")
      .value("statistics", &P::statistics, "What the run did.");
}

Made<HamiltonianResult>* py_hamiltonian_cycle(const PointsLike& points,
                                              const Choice<Splitter>& splitter, std::uint64_t seed,
                                              std::size_t work_at_most,
                                              const ProgressLike& progress) {
  const Points input(points);
  HamiltonianOptions o;
  o.splitter = splitter.get("splitter");
  o.seed = seed;
  o.work_at_most = work_at_most;
  auto* const out = made(run(progress, o, [&](const auto& with) {
    return hamiltonian_cycle_triangulation(input.xy(), with);
  }));
  carry_heights(input, *out);
  return out;
}

Made<SequentialResult>* py_sequential(const PointsLike& points, std::uint64_t work_at_most,
                                      const ProgressLike& progress) {
  const Points input(points);
  SequentialOptions o;
  o.work_at_most = work_at_most;
  auto* const out = made(run(
      progress, o, [&](const auto& with) { return sequential_triangulation(input.xy(), with); }));
  if (!out->mesh.points.empty()) carry_heights(input, *out);
  return out;
}

void bind_point_orders(nb::module_& m) {
  bind_point_results(m);
  m.def(
      "hamiltonian_cycle_triangulation", &py_hamiltonian_cycle, "points"_a, nb::kw_only(),
      "splitter"_a = "random", "seed"_a = 1, "work_at_most"_a = HamiltonianOptions().work_at_most,
      "progress"_a = nb::none(),
      R"(A triangulation of the points whose triangles are in the order of a cycle (Arkin, Held, Mitchell and Skiena,
theorem 3.1); or of a path, where no point is inside the hull, or where points are on so many lines that no cycle was
found. Up to 16 points that is a proof that there is none, unless the work runs out. 2n - 2 - h triangles.

Raises Error: not-finite, too-few-points, all-collinear, too-many-points, cancelled.)");
  m.def(
      "sequential_triangulation", &py_sequential, "points"_a, nb::kw_only(),
      "work_at_most"_a = SequentialOptions().work_at_most, "progress"_a = nb::none(),
      R"(A triangulation of the points whose triangles are in an order with alternating left and right turns (Arkin, Held,
Mitchell and Skiena, section 4). With at most two points inside the hull the answer is exact, in O(n log n), and yes in
general position (lemma 4.2). With more, up to 32 points, it is searched for: "no" is proved by exhaustion (practical
for about 12 points), "unknown" if the work (triangles tried) runs out. More points: "unknown".

Raises Error: not-finite, too-few-points, all-collinear, too-many-points, cancelled.)");
  m.def(
      "spiral_polygon",
      [](const PointsLike& points, const ProgressLike& progress) {
        const Points input(points);
        auto* const out =
            made(run(progress, [&](const Progress& p) { return spiral_polygon(input.xy(), p); }));
        carry_heights(input, *out);
        return out;
      },
      "points"_a, nb::kw_only(), "progress"_a = nb::none(),
      R"(A simple polygon with all the points as corners whose reflex corners are one chain at most, with a serpentine
triangulation (Iwerks and Mitchell, theorem 2.5). Of points that the turning ray meets at once the nearest is taken;
collinear ones become flat corners.

Raises Error: not-finite, too-few-points, all-collinear, too-many-points. O(n log n).)");
}

// ---- Polygons. ----

using OrderOrNone = std::optional<PolygonOrder>;

// The result, or None.
nb::object order_or_none(OrderOrNone&& order) {
  if (!order) return nb::none();
  return nb::cast(made(std::move(*order)), nb::rv_policy::take_ownership);
}

void bind_polygon_orders(nb::module_& m) {
  using P = PolygonOrder;
  Fields<Made<P>, Mesh>(m, "PolygonOrder",
                        "The triangles of a polygon in an order; added points are all inside.")
      .value("order", &P::order, "What it promises.")
      .array("input_to_vertex", &P::input_to_vertex,
             "One per corner of the rings, ring by ring: the vertex that it is.")
      .value("parts", &P::parts, "With added points: convex parts that it was made from.")
      .value("parts_at_least", &P::parts_at_least,
             "Proven: there are no fewer, see ConvexDecomposition.");
  m.def(
      "hamiltonian_triangulation",
      [](const PolygonsLike& polygon) {
        const Polygon given = polygon_from(polygon);
        return order_or_none(without_gil([&] { return hamiltonian_triangulation(given); }));
      },
      "polygon"_a,
      nb::sig("def hamiltonian_triangulation(polygon: quadloom._inputs.PolygonsLike) -> "
              "PolygonOrder | None"),
      R"(A triangulation of a simple polygon, without added points, whose triangles are a path; None if there is no such
triangulation (Arkin, Held, Mitchell and Skiena, theorem 2.1). Of a polygon no order of triangles is a cycle. Flat
corners are welcome; a ring may touch itself as long as the inside is one piece without holes.

Raises Error: bad-polygon (holes: an NP-complete question, not answered here; an inside in parts), and as
constrained_delaunay. O(E log n) and O(E) space, E the pairs of corners that see each other, after their visibility
graph.)");
  m.def(
      "sequential_triangulation",
      [](const PolygonAlone& polygon) {
        const Polygon given = polygon_from(polygon);
        return order_or_none(without_gil([&] { return sequential_triangulation(given); }));
      },
      "polygon"_a,
      nb::sig("def sequential_triangulation(polygon: quadloom._inputs.PolygonsLike) -> "
              "PolygonOrder | None"),
      "The same as hamiltonian_triangulation for a sequential triangulation (theorem 4.4): left "
      "and right turns "
      "alternate. The polygon is a list of rings, [ring]: an array (k, 2) by itself is taken for "
      "points. O(n) "
      "space.");
  using D = ConvexDecomposition;
  Fields<Made<D>, Mesh>(
      m, "ConvexDecomposition",
      "A polygon cut along chords into convex parts, flat corners allowed: the faces.")
      .array(
          "face_begin", [](const D& d) -> const auto& { return d.parts.face_begin; },
          "Part i has the corners face_vertex[face_begin[i] : face_begin[i + 1]].")
      .array(
          "face_vertex", [](const D& d) -> const auto& { return d.parts.face_vertex; },
          "The corners of all parts, one part after the other.")
      .array("input_to_vertex", &D::input_to_vertex,
             "One per corner of the rings: the vertex that it is.")
      .value("at_least", &D::at_least, "Proven: no cut along chords has fewer parts.")
      .get(
          "is_fewest", [](const Made<D>& d) { return d.is_fewest(); },
          "Whether no cut along chords has fewer parts.");
  m.def(
      "convex_decomposition",
      [](const PolygonsLike& polygon, std::size_t exact_steps) {
        const Polygon given = polygon_from(polygon);
        return made(without_gil([&] { return convex_decomposition(given, {exact_steps}); }));
      },
      "polygon"_a, nb::kw_only(), "exact_steps"_a = DecompositionOptions().exact_steps,
      R"(Cuts a polygon into convex parts without added points. Hertel and Mehlhorn's merging of triangles gives at most four
times as many as there must be; with holes no such bound is known, and at_least says what is. If these may not be the
fewest, there are no holes and the search is within `exact_steps`: the fewest (Keil's dynamic programme).

Raises Error as constrained_delaunay.)");
  m.def(
      "hamiltonian_triangulation_with_points",
      [](const PolygonsLike& polygon, const Choice<OrderKind>& order, std::size_t exact_steps) {
        const Polygon given = polygon_from(polygon);
        const OrderKind kind = order.get("order");
        return made(without_gil(
            [&] { return hamiltonian_triangulation_with_points(given, kind, {exact_steps}); }));
      },
      "polygon"_a, "order"_a, nb::kw_only(), "exact_steps"_a = DecompositionOptions().exact_steps,
      R"(A triangulation of a polygon, holes allowed, whose triangles are a path or a cycle, with added points inside (Arkin,
Held, Mitchell and Skiena, theorem 2.3). From a decomposition into k > 1 convex parts: at most k - 1 points for a
cycle, k - 2 for a path, which some polygons need; a point that sees several parts saves some. A convex polygon has a
path without points and a cycle with one. Flat corners may cost one point more.

Raises Error: guarantee if a point has no place among the doubles, bad-polygon for an inside in parts, bad-option for
"sequential", and as constrained_delaunay. O(n log n) after convex_decomposition.)");
}

// ---- Triangulations. ----

void bind_mesh_orders(nb::module_& m) {
  m.def(
      "reorder_triangles",
      [](const MeshLike& mesh, const NumbersLike& order) {
        const MeshArgument given(mesh);
        const Triangulation& triangles = given.triangulation();
        auto* const out = made(reorder_triangles(triangles, indices_from(order, "order")));
        out->heights.assign(given.mesh().z().begin(), given.mesh().z().end());
        return out;
      },
      "mesh"_a, "order"_a,
      "The same triangulation, its triangle order[i] now triangle i; the corners keep their turn. "
      "Raises Error: "
      "bad-option if `order` has not each triangle once. O(n).");
  Fields<SequentialOrder>(
      m, "SequentialOrder",
      "An order of all triangles of a mesh such that left and right turns alternate.")
      .array("order", &SequentialOrder::order, "The triangles.")
      .array("sequence", &SequentialOrder::sequence,
             "Two more than triangles: triangle order[i] has the vertices sequence[i], sequence[i "
             "+ 1], "
             "sequence[i + 2].")
      .value("closure", &SequentialOrder::closure, "How it closes.")
      .done();
  m.def(
      "sequential_order",
      [](const MeshLike& mesh) {
        const MeshArgument given(mesh);
        const Triangulation& triangles = given.triangulation();
        return without_gil([&] { return sequential_order(triangles); });
      },
      "mesh"_a,
      R"(Decides whether a triangulation, in the plane or of a surface, is sequential (Arkin, Held, Mitchell and Skiena,
theorem 4.3), and gives an order if it is: of all there are one that closes best, in a tie the first found from
triangle 0; else None. Only the connectivity is looked at. Raises Error: bad-mesh. O(n).)");
  using H = HamiltonianOrder;
  Fields<H>(m, "HamiltonianOrder",
            "An order of all triangles, each beside the one before, or why there is none.")
      .value("answer", &H::answer, "Is there one?")
      .array("order", &H::order, "yes: all triangles.")
      .value("reason", &H::reason, "no: why.")
      .array("culprits", &H::culprits,
             "ears: those; components: one of each; bridges: the two triangles at it, or those of "
             "the part.")
      .value("work", &H::work, "States of the search.")
      .done();
  m.def(
      "hamiltonian_order",
      [](const MeshLike& mesh, const Choice<OrderKind>& kind, std::uint64_t work_at_most,
         const ProgressLike& progress) {
        const MeshArgument given(mesh);
        const Triangulation& triangles = given.triangulation();
        OrderSearchOptions o;
        o.kind = kind.get("kind");
        o.work_at_most = work_at_most;
        return run(progress, o,
                   [&](const auto& with) { return hamiltonian_order(triangles, with); });
      },
      "mesh"_a, nb::kw_only(), "kind"_a = "path",
      "work_at_most"_a = OrderSearchOptions().work_at_most, "progress"_a = nb::none(),
      R"(Whether the triangles, as they are, can be put in an order such that each is beside the one before, and the first
beside the last if kind is "cycle": an NP-complete question (Arkin, Held, Mitchell and Skiena, section 5), so the
answer is "unknown" when the work (states of the search) runs out. Only the connectivity is looked at.

Raises Error: bad-option for "sequential" (see sequential_order), too-few-points (no triangles), bad-mesh, cancelled.)");
}

void bind_refinement(nb::module_& m) {
  using R = HamiltonianRefinement;
  Fields<Made<R>, Mesh>(
      m, "HamiltonianRefinement",
      "A refined mesh whose triangles stand in the order of Hamiltonian cycles, one for each "
      "component of the input. It may be given where a TriangleMesh is expected.")
      .array("cycle_begin", &R::cycle_begin,
             "Cycle i is the triangles cycle_begin[i] : cycle_begin[i + 1].")
      .array("source_triangles", &R::source,
             "Per triangle, uint32 (t, 2): what it was cut from; the second NONE, but for those on "
             "both sides "
             "of a flip.")
      .value("flips", &R::flips, "Edges flipped.")
      .value("midpoints", &R::midpoints, "Added on edges that must stay.")
      .value("moved", &R::moved, "Inner points that could not be at the incentre.")
      .value("min_angle_before", &R::min_angle_before, "Degrees, in floating point.")
      .value("min_angle_after", &R::min_angle_after, "Degrees, in floating point.");
  m.def(
      "hamiltonian_refinement",
      [](const MeshLike& mesh, const nb::object& triangles, const ProgressLike& progress) {
        const TriangleMeshArgument given(mesh, triangles);
        auto* const out = made(run(progress, [&](const Progress& p) {
          return hamiltonian_refinement(given.mesh(), RefinementOptions{p});
        }));
        name_source_faces(given.source_face(), out->source);
        carry_heights(given, *out);
        return out;
      },
      "mesh"_a, "triangles"_a = nb::none(), nb::kw_only(), "progress"_a = nb::none(),
      R"(Makes a triangulation, in the plane or of a surface, Hamiltonian (Arkin, Held, Mitchell and Skiena, theorem 2.4): k
triangles become 3 k, by a point in each and flips along a spanning tree of the dual graph. Vertices and boundary stay.
Edges to keep and those between regions stay as well; where a component hangs together over such edges alone, as few of
them as possible get a midpoint (as rounded), and two triangles more.

Guarantee: in the plane no angle is smaller than half the smallest angle of the input, up to rounding, if `moved` is 0;
on a surface it is measured only. Raises Error: guarantee (a triangle without a double inside, or one that hangs on an
edge that can be neither flipped nor split), as quadrangulate_triangles for a mesh whose parts do not agree,
too-many-points, cancelled. O(k log k).)");
}

}  // namespace

void bind_strips(nb::module_& m) {
  bind_words_of_orders(m);
  bind_polygon_orders(m);  // before points: a polygon by itself is asked for first
  bind_point_orders(m);
  bind_mesh_orders(m);
  bind_refinement(m);
  bind_strip_codes(m);
}

}  // namespace quadloom::python
