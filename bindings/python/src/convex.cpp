// include/quadloom/convex.hpp: strictly convex quadrilaterals.
#include "quadloom/convex.hpp"

#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <algorithm>

#include "bind.hpp"
#include "choice.hpp"
#include "conversions.hpp"
#include "fields.hpp"
#include "guarantee.hpp"
#include "inputs.hpp"
#include "parts.hpp"
#include "progress.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace quadloom::python {
namespace {

void bind_options(nb::module_& m) {
  bind_words<ConvexMethod>(
      m, "ConvexMethod", "How a point set becomes strictly convex quads.",
      {{ConvexMethod::kDelaunay, "delaunay",
        "Delaunay-shaped: pairs, walks, and patches around what is not convex; almost no Steiner "
        "points"},
       {ConvexMethod::kSpiral, "spiral",
        "Bremner, Hurtado, Ramaswami and Sacristan: the path of the spiral's triangles, cut into "
        "quads "
        "and pairs of quads such that few Steiner points are added"},
       {ConvexMethod::kPentagons, "pentagons",
        "Ramaswami, Ramos and Toussaint, theorem 4.2: six triangles of that path at a time, two "
        "pentagons with a Steiner point between them"}});
  bind_words<Answer>(m, "Answer", "The answer to a question that may be too hard.",
                     {{Answer::kNo, "no", "proved"},
                      {Answer::kYes, "yes", "and here it is"},
                      {Answer::kUnknown, "unknown", "the work that was allowed ran out"}});
}

void bind_statistics(nb::module_& m) {
  using M = MendStatistics;
  Fields<M>(m, "MendStatistics", "How quads that were not strictly convex were mended.")
      .value("bad", &M::bad, "Quads that were not strictly convex.")
      .value("bad_after_moves", &M::bad_after_moves,
             "That were left when moves without added points ended.")
      .value("clusters", &M::clusters, "Groups of quads that were parted anew.")
      .value("stars", &M::stars, "Groups that one added point, or several, mended.")
      .value("cases", &M::cases, "Unions of two quads mended as in the paper's cases.")
      .value("settled", &M::settled, "Added points that were taken out again.")
      .value("left", &M::left, "Quads that could not be mended among the doubles.")
      .done();
  using C = ConvexStatistics;
  Fields<C>(m, "ConvexStatistics", "What a run did; a count that a method does not have is 0.")
      .value("hull_points", &C::hull_points, "Points on the hull, those inside its edges included.")
      .value("kept", &C::kept, "Quads of two triangles that were strictly convex.")
      .value("patches", &C::patches, "Unions of two quads, or lone quads, that were made so.")
      .value("patches_by_points", &C::patches_by_points, "Patches with 0 to 4 Steiner points.")
      .value("mending", &C::mending, "How the others were mended.")
      .done();
}

// ---- Small polygons. ----

template <std::size_t N>
std::array<Point, N> corners_from(const PointsLike& given) {
  const Points corners(given);
  if (corners.xy().size() != N) {
    throw Error(ErrorCode::kBadOption, std::to_string(N) + " corners are wanted, not " +
                                           std::to_string(corners.xy().size()));
  }
  std::array<Point, N> out;
  std::copy(corners.xy().begin(), corners.xy().end(), out.begin());
  return out;
}

void bind_patches(nb::module_& m) {
  Fields<ConvexPatch>(
      m, "ConvexPatch",
      "A small polygon in strictly convex quads that tile it, counter-clockwise. Its points "
      "are numbered: the corners as given, an inner point that was given, then the Steiner "
      "points, which lie strictly inside.")
      .array("steiner", &ConvexPatch::steiner, "The added points, float64 (k, 2).")
      .array("quads", &ConvexPatch::quads, "uint32 (m, 4).")
      .value("case_name", &ConvexPatch::case_name,
             "The paper's, as in \"rcrccc-1\": reflex and convex corners up to rotation and "
             "reflection, "
             "flat ones counting as reflex; Steiner points.")
      .done();
  m.def(
      "convexify_hexagon",
      [](const PointsLike& corners) { return convexify_hexagon(corners_from<6>(corners)); },
      "corners"_a,
      R"(A hexagon (6, 2), counter-clockwise, in strictly convex quads; theorem 3.2 of Bremner, Hurtado, Ramaswami and
Sacristan: at most 0 Steiner points for cccccc, 2 for rccccc, rrcccc and rccrcc, 3 for the others, as few as are found
(no more than necessary where none is enough, or one whose place is wider than rounding). None if its numbers are so
close that no places were found; never a wrong patch, each is checked exactly.

Raises Error: not-finite, bad-polygon (not simple, or clockwise). Constant time.)");
  m.def(
      "convexify_quad_with_point",
      [](const PointsLike& corners, const PointsLike& inner) {
        return convexify_quad_with_point(corners_from<4>(corners), point_from(inner));
      },
      "corners"_a, "inner"_a,
      R"(The same for a quad (4, 2) with a point (2,) strictly inside (theorem 3.8): 3 Steiner points, which is the
fewest. Raises Error also for a point that is not inside: bad-polygon.)");
  m.def(
      "convexify_quad",
      [](const PointsLike& corners) { return convexify_quad(corners_from<4>(corners)); },
      "corners"_a,
      "The same for a quad (4, 2): no Steiner points if it is strictly convex, else 4, which is "
      "the "
      "fewest.");
}

// ---- Triangulations and point sets. ----

void bind_results(nb::module_& m) {
  Fields<Made<ConvexResult>, Mesh>(m, "ConvexResult",
                                   "The strictly convex quadrilaterals of a point set.")
      .array("input_to_vertex", &ConvexResult::input_to_vertex,
             "One per input point, uint32 (n,): the vertex that it is; repeated points are one.")
      .array("not_convex", &ConvexResult::not_convex,
             "Quads that had to stay as they are, since no doubles were found for their Steiner "
             "points; "
             "none but for points that are as near to each other as doubles get.")
      .value("statistics", &ConvexResult::statistics, "What the run did.");
  bind_triangle_fields<Made<ConvexQuads>>(m, "ConvexMeshResult",
                                          "The strictly convex quadrilaterals of a triangulation.")
      .array("not_convex", &ConvexQuads::not_convex, "As in ConvexResult.")
      .value("mending", &ConvexQuads::mending,
             "How quads that were not strictly convex were mended.");
  using X = ExactConvexResult;
  Fields<Made<X>, Mesh>(
      m, "ExactConvexResult",
      "What is known of all quadrangulations of a point set without Steiner points, and "
      "the one with the most strictly convex quads; no faces if that is unknown.")
      .value("convex", &X::convex, "Is there one in which all quads are strictly convex?")
      .value("most_convex", &X::most_convex,
             "The greatest number of strictly convex quads in one; None: unknown.")
      .value("quad_count", &X::quads, "In each one: n - 1 - h / 2, rounded down if h is odd.")
      .value("hull_points", &X::hull_points, "Points on the hull, those inside its edges included.")
      .array("input_to_vertex", &X::input_to_vertex, "One per input point: the vertex that it is.")
      .value("work", &X::work, "Faces tried.");
}

Made<ConvexQuads>* convex_mesh(const TriangleMeshArgument& input, const TriangleOptions& options,
                               std::uint64_t seed, const ProgressLike& progress) {
  ConvexMeshResult result = run(progress, options, [&](const auto& with) {
    return convex_quadrangulation(input.mesh(), with, seed);
  });
  std::string guarantee = guarantee_of(result);
  name_source_faces(input.source_face(), result.quads);
  auto* const out =
      made(ConvexQuads{std::move(result.quads), std::move(result.not_convex), result.mending});
  carry_heights(input, *out);
  out->guarantee = std::move(guarantee);
  return out;
}

void bind_meshes(nb::module_& m) {
  m.def(
      "convex_quadrangulation",
      [](const MeshAlone& mesh, const nb::object& triangles, const Choice<Leftover>& leftover,
         const Choice<PairKind>& pairs, const Choice<PairWeight>& weight,
         const Choice<MatchingEffort>& effort, double min_quality,
         const NumbersLike& halfedge_weight, const Choice<OddBoundary>& odd_boundary,
         std::uint64_t seed, const ProgressLike& progress) {
        const TriangleOptionsArgument options({nb::str("pair")}, leftover, pairs, weight, effort,
                                              min_quality, halfedge_weight, odd_boundary);
        return convex_mesh(TriangleMeshArgument(mesh, triangles), options.options, seed, progress);
      },
      "mesh"_a, "triangles"_a = nb::none(), nb::kw_only(), "leftover"_a = "walk",
      "pairs"_a = "auto", "weight"_a = "shape", "effort"_a = "near", "min_quality"_a = 0.0,
      "halfedge_weight"_a = nb::none(), "odd_boundary"_a = "on-edge", "seed"_a = 1,
      "progress"_a = nb::none(),
      R"(quadrangulate_triangles by "pair" for a planar mesh, with all quads strictly convex (but for `not_convex`):
what is not is mended inside its part, with inner Steiner points where that is needed. Boundary, edges to keep and
regions stay as there. For polygons: give what constrained_delaunay makes of them.

Raises Error as quadrangulate_triangles; bad-mesh for a surface in space, bad-option for leftover "triangle" and
"error".)");
  m.def(
      "convex_quadrangulation",
      [](const PointsLike& points, const Choice<ConvexMethod>& method,
         const Choice<OddBoundary>& odd_boundary, std::uint64_t seed,
         const ProgressLike& progress) {
        const Points input(points);
        ConvexOptions o;
        o.method = method.get("method");
        o.odd_boundary = odd_boundary.get("odd_boundary");
        o.seed = seed;
        auto* const out = made(run(progress, o, [&](const auto& with) {
          return convex_quadrangulation(input.xy(), with);
        }));
        carry_heights(input, *out);
        out->guarantee = guarantee_of(*out, o);
        return out;
      },
      "points"_a, nb::kw_only(), "method"_a = "delaunay", "odd_boundary"_a = "outside",
      "seed"_a = 1, "progress"_a = nb::none(),
      R"(A quadrangulation of a point set in which all quads are strictly convex (but for `not_convex`).

Points (n, 2) or (n, 3); heights are carried along.

Guarantee (Bremner, Hurtado, Ramaswami and Sacristan, theorem 3.1): at most 3 floor(n / 2) inner Steiner points; as a
rule about a third of that for "spiral", and n / 6,000 on uniform points for "delaunay". "pentagons": at most
7 ceil((2n - 2 - h) / 6) (Ramaswami, Ramos and Toussaint, theorem 4.2). If an odd number of points is on the hull:
with odd_boundary "outside" one Steiner point outside the hull where there is a place for it, else one triangle stays;
"triangle": one triangle stays.

Raises Error: not-finite, too-few-points, all-collinear, too-many-points, cancelled; bad-option for odd_boundary
"on-edge". O(n log n).)");
}

void bind_exact(nb::module_& m) {
  m.def(
      "exact_convex_quadrangulation",
      [](const PointsLike& points, std::size_t points_at_most, std::uint64_t work_at_most,
         const ProgressLike& progress) {
        const Points input(points);
        ExactConvexOptions o;
        o.points_at_most = points_at_most;
        o.work_at_most = work_at_most;
        auto* const out = made(run(progress, o, [&](const auto& with) {
          return exact_convex_quadrangulation(input.xy(), with);
        }));
        carry_heights(input, *out);
        return out;
      },
      "points"_a, nb::kw_only(), "points_at_most"_a = ExactConvexOptions().points_at_most,
      "work_at_most"_a = ExactConvexOptions().work_at_most, "progress"_a = nb::none(),
      R"(Whether a small point set has a quadrangulation without Steiner points in which all quads are strictly convex,
and the one with the most such quads, by exhaustive search; exact predicates decide. "unknown" and None if the work
(faces tried; the default is about ten seconds) ran out.

Raises Error: bad-option for points_at_most above 20 and for more distinct points than that; not-finite,
too-few-points, all-collinear, cancelled. Exponential in n.)");
  m.def(
      "mesh_of_bhrs_line",
      [](const PointsLike& points) {
        const Points input(points);
        return made(without_gil([&] { return mesh_of_bhrs_line(input.xy()); }));
      },
      "points"_a,
      R"(The mesh of theorem 2.2 of Bremner, Hurtado, Ramaswami and Sacristan for their set that needs ceil(m / 2) - 1
Steiner points, as generate_points("bhrs-line", m + 3) gives it: m + 1 points in order on a line, then one on its left
and one on its right such that the hull has four corners. All quads strictly convex, inner Steiner points after the
points given.

Raises Error: bad-option if the points are not such a set, guarantee if no doubles are in a place that a Steiner point
needs, not-finite. O(n log n).)");
  m.def(
      "mesh_of_bhrs_ring",
      [](const PointsLike& points) {
        const Points input(points);
        return made(without_gil([&] { return mesh_of_bhrs_ring(input.xy()); }));
      },
      "points"_a,
      R"(The mesh of theorem 2.4 for their set that needs n / 4, as generate_points("bhrs-ring", n) gives it: k = n / 2
>= 3 points in strictly convex position, counter-clockwise, then one for each hull edge. All faces but one triangle for
odd k are strictly convex quads; n / 4 + 1 inner Steiner points for even k, ceil(n / 4) for odd k.

Raises Error as mesh_of_bhrs_line; guarantee also if the mean of the hull's corners cannot be the central Steiner
point. O(n log n).)");
}

}  // namespace

void bind_convex(nb::module_& m) {
  bind_options(m);
  bind_statistics(m);
  bind_patches(m);
  bind_results(m);
  bind_meshes(m);
  bind_exact(m);
}

}  // namespace quadloom::python
