// include/quadloom/quadrangulate.hpp: points, triangles and polygons to quadrilaterals.
#include "quadloom/quadrangulate.hpp"

#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>

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
  bind_words<PointMethod>(
      m, "PointMethod", "How a point set becomes quads.",
      {{PointMethod::kDelaunay, "delaunay",
        "Delaunay-shaped: pairs by shape, left-over triangles walked together"},
       {PointMethod::kSpiral, "spiral",
        "Bose and Toussaint's spiraling rotating calipers: long thin quads, no flips"},
       {PointMethod::kInsertion, "insertion", "Bose and Toussaint's sequential insertion"},
       {PointMethod::kSubdivide, "subdivide",
        "de Berg's conversion: every Delaunay triangle into three, all strictly convex"}});
  bind_words<OddBoundary>(
      m, "OddBoundary",
      "What to do when an odd number of points lies on the hull, so that no mesh of quads alone "
      "exists.",
      {{OddBoundary::kOutside, "outside",
        "one Steiner point just outside the hull; on a hull edge where outside is impossible"},
       {OddBoundary::kOnEdge, "on-edge",
        "one Steiner point on a hull edge (its quad has a flat corner there)"},
       {OddBoundary::kTriangle, "triangle", "no point: one triangle stays"}});
  bind_words<TriangleMethod>(
      m, "TriangleMethod", "How a triangulation becomes quads.",
      {{TriangleMethod::kPair, "pair", "pairs of triangles; what is left over as `leftover` says"},
       {TriangleMethod::kPercolate, "percolate",
        "Ramaswami, Ramos and Toussaint, theorem 3.3: the fewest outer Steiner points that this "
        "triangulation allows"},
       {TriangleMethod::kFans, "fans",
        "theorem 2.1: fans of a three-coloured polygon, at most n/3 outer points"},
       {TriangleMethod::kQPercolate, "q-percolate",
        "theorem 3.4: at most one inner point for two triangles, at most one outer one"},
       {TriangleMethod::kQuarter, "quarter",
        "the full paper's bound: at most one inner point for four triangles"},
       {TriangleMethod::kSubdivide, "subdivide",
        "de Berg's conversion: a triangle into three, a given quad into four"}});
  bind_words<Leftover>(
      m, "Leftover", "What `pair` does with triangles that are left over.",
      {{Leftover::kError, "error", "an Error (guarantee), with Tutte and Berge's witness"},
       {Leftover::kTriangle, "triangle", "they stay"},
       {Leftover::kWalk, "walk", "walked together; where that is impossible, as `steiner`"},
       {Leftover::kSteiner, "steiner", "inner Steiner points, without a change of other edges"}});
  bind_words<PairKind>(m, "PairKind", "Which pairs `pair` may make.",
                       {{PairKind::kAuto, "auto",
                         "any; when left-over triangles walk, quads that are not strictly convex "
                         "are parted again, for "
                         "walks do better"},
                        {PairKind::kConvex, "convex",
                         "strictly convex quads alone, as many as possible, then weight"},
                        {PairKind::kAny, "any", "as many pairs as possible, then weight"}});
  bind_words<PairWeight>(
      m, "PairWeight", "What the matching maximises.",
      {{PairWeight::kShape, "shape", "quad_shape"},
       {PairWeight::kConvexity, "convexity", "the number of strictly convex quads"},
       {PairWeight::kGiven, "given", "halfedge_weight"}});
  bind_words<MatchingEffort>(
      m, "MatchingEffort", "How good the matching is.",
      {{MatchingEffort::kExact, "exact", "the best one"},
       {MatchingEffort::kNear, "near", "60 % of the time for about 1 % of the weight"}});
}

void bind_statistics(nb::module_& m) {
  using P = PointStatistics;
  Fields<P>(m, "PointStatistics", "What a run did; a count that a method does not have is 0.")
      .value("hull_points", &P::hull_points, "Points on the hull, those inside its edges included.")
      .value("unmatched_greedy", &P::unmatched_greedy, "Triangles left over by the pairing.")
      .value("walks", &P::walks, "Walks that merged two left-over triangles (or reached the hull).")
      .value("walk_steps", &P::walk_steps, "Pentagons re-cut by these walks.")
      .value("slides", &P::slides, "Edges slid between two quads to improve their shapes.")
      .value("fell_back_to_spiral", &P::fell_back_to_spiral,
             "The method asked for could not finish; the mesh is the spiral's.")
      .done();
  using T = TriangleStatistics;
  Fields<T>(m, "TriangleStatistics",
            "What a conversion did; a count that a method does not have is 0.")
      .value("triangles", &T::triangles, "Of the source.")
      .value("boundary_edges", &T::boundary_edges, "Of the source.")
      .value("parts", &T::parts, "Of the source: connected without crossing edges to keep.")
      .value("odd_parts", &T::odd_parts, "Parts with an odd number of border edges.")
      .value("unmatched", &T::unmatched, "Triangles left over by the matching.")
      .value("parted", &T::parted, "Pairs parted again, see PairKind.AUTO.")
      .value("walks", &T::walks, "Walks that merged two left-over triangles.")
      .value("walk_steps", &T::walk_steps, "Pentagons re-cut by these walks.")
      .value("crossings", &T::crossings, "Quads crossed with an inner Steiner point each.")
      .value("crowded", &T::crowded,
             "`quarter`: no double for one point among five triangles or more, so that there are "
             "two or "
             "three.")
      .value("weight_gap", &T::weight_gap,
             "MatchingEffort.NEAR: at most this share of the weight is lost.")
      .done();
}

// ---- Points. ----

void bind_point_results(nb::module_& m) {
  using P = Made<PointResult>;
  Fields<P, Mesh>(m, "PointResult", "The quadrilaterals of a point set.")
      .array("input_to_vertex", &PointResult::input_to_vertex,
             "One per input point, uint32 (n,): the vertex that it is; repeated points are one.")
      .value("statistics", &PointResult::statistics, "What the run did.");
  using K = Made<KAngulationResult>;
  Fields<K, Mesh>(m, "KAngulationResult", "A mesh of faces with k corners each.")
      .array("input_to_vertex", &KAngulationResult::input_to_vertex,
             "One per input point: the vertex that it is.")
      .array(
          "face_begin", [](const K& r) -> const auto& { return r.mesh.face_begin; },
          "Face f has the corners face_vertex[face_begin[f] : face_begin[f + 1]].")
      .array(
          "face_vertex", [](const K& r) -> const auto& { return r.mesh.face_vertex; },
          "The corners of all faces, one face after the other.");
  using S = Made<SerpentineResult>;
  Fields<S, Mesh>(
      m, "SerpentineResult",
      "The serpentine triangulation of the convex spiral, triangles in the order of a path.")
      .array("spiral", &SerpentineResult::spiral, "All vertices in the order of the spiral.")
      .array("input_to_vertex", &SerpentineResult::input_to_vertex,
             "One per input point: the vertex that it is.");
}

PointOptions point_options(const Choice<PointMethod>& method,
                           const Choice<OddBoundary>& odd_boundary, std::uint64_t seed) {
  PointOptions o;
  o.method = method.get("method");
  o.odd_boundary = odd_boundary.get("odd_boundary");
  o.seed = seed;
  return o;
}

Made<PointResult>* py_quadrangulate_points(const PointsLike& points,
                                           const Choice<PointMethod>& method,
                                           const Choice<OddBoundary>& odd_boundary,
                                           std::uint64_t seed, const ProgressLike& progress) {
  const Points input(points);
  PointOptions o = point_options(method, odd_boundary, seed);
  auto* const out = made(
      run(progress, o, [&](const auto& with) { return quadrangulate_points(input.xy(), with); }));
  carry_heights(input, *out);
  out->guarantee = guarantee_of(*out, o);
  return out;
}

Made<KAngulationResult>* py_k_angulate_points(const PointsLike& points, std::size_t k,
                                              const Choice<OddBoundary>& odd_boundary,
                                              std::uint64_t seed, const ProgressLike& progress) {
  const Points input(points);
  PointOptions o;
  o.odd_boundary = odd_boundary.get("odd_boundary");
  o.seed = seed;
  auto* const out = made(
      run(progress, o, [&](const auto& with) { return k_angulate_points(input.xy(), k, with); }));
  carry_heights(input, *out);
  out->guarantee = guarantee_of(*out, k);
  return out;
}

void bind_points(nb::module_& m) {
  bind_point_results(m);
  m.def(
      "quadrangulate_points", &py_quadrangulate_points, "points"_a, nb::kw_only(),
      "method"_a = "delaunay", "odd_boundary"_a = "outside", "seed"_a = 1,
      "progress"_a = nb::none(),
      R"(A quadrangulation of a point set: every point a vertex, all faces simple quads that tile the convex hull.

Points (n, 2) or (n, 3); heights are carried along. Collinear, repeated and cocircular points are welcome.

Guarantee (Bose and Toussaint, theorems 3.1, 4.2, 4.3): no Steiner point if the number of points on the hull is
even; if odd one, or one triangle, as `odd_boundary` says. Method "subdivide": 3 quads a triangle, one point an edge
and one a triangle. The same input and seed give the same mesh.

Raises Error: not-finite, too-few-points, all-collinear, too-many-points, cancelled; guarantee if the odd point
has no place among the doubles.)");
  m.def(
      "has_quadrangulation",
      [](const PointsLike& points) {
        const Points input(points);
        return without_gil([&] { return has_quadrangulation(input.xy()); });
      },
      "points"_a,
      R"(True if and only if the set has a quadrangulation without Steiner points: the number of points on its hull
is even (Bose and Toussaint, theorem 3.1) and they are not all collinear. Repeated points count once.

Raises Error: not-finite, too-many-points. O(n log n).)");
  m.def(
      "serpentine_triangulation",
      [](const PointsLike& points, const ProgressLike& progress) {
        const Points input(points);
        auto* const out = made(run(
            progress, [&](const Progress& p) { return serpentine_triangulation(input.xy(), p); }));
        carry_heights(input, *out);
        return out;
      },
      "points"_a, nb::kw_only(), "progress"_a = nb::none(),
      R"(The serpentine triangulation of the convex spiral (Bose and Toussaint, lemma 4.1): triangles in the order of
the dual path, consecutive ones share an edge; 2n - 2 - h triangles.

Raises Error: not-finite, too-few-points, all-collinear, too-many-points. O(n log n).)");
  m.def(
      "k_angulate_points", &py_k_angulate_points, "points"_a, "k"_a, nb::kw_only(),
      "odd_boundary"_a = "outside", "seed"_a = 1, "progress"_a = nb::none(),
      R"(A mesh of simple k-gons (Bose and Toussaint, corollary 4.1), k >= 4, as a rule at most k - 3 Steiner points.

Raises Error as quadrangulate_points; bad-option for k < 4.)");
}

// ---- Triangulations and polygons. ----

void bind_triangle_results(nb::module_& m) {
  bind_triangle_fields<Made<TriangleResult>>(m, "TriangleResult",
                                             "The quadrilaterals of a triangulation.");
  bind_triangle_fields<Made<PlanarQuads>>(m, "PlanarResult",
                                          "The quadrilaterals of polygons, segments and points.")
      .array(
          "input_to_vertex",
          [](const PlanarQuads& r) -> const auto& { return r.source->input_to_vertex; },
          "One per input point, the polygons' corners first: the vertex that it is, NONE outside.")
      .get(
          "triangulation", [](const Made<PlanarQuads>& r) { return r.source; },
          "The constrained Delaunay triangulation that the quads were made from.");
}

Made<PlanarQuads>* planar_quads(const PlanarArgument& input, const TriangleOptions& options,
                                const ProgressLike& progress) {
  PlanarResult result = run(progress, options, [&](const auto& with) {
    return quadrangulate_polygons(input.input, with);
  });
  PlanarQuads quads{std::move(result.quads),
                    std::make_shared<Made<ConstrainedResult>>(std::move(result.triangulation))};
  auto* const out = made(std::move(quads));
  carry_heights(input.z, out->source->input_to_vertex, *out);
  out->guarantee = guarantee_of(*out, options);
  return out;
}

Made<TriangleResult>* triangle_quads(const TriangleMeshArgument& input,
                                     const TriangleOptions& options, const ProgressLike& progress) {
  auto* const out = made(run(progress, options, [&](const auto& with) {
    return quadrangulate_triangles(input.mesh(), with);
  }));
  name_source_faces(input.source_face(), *out);
  carry_heights(input, *out);
  out->guarantee = guarantee_of(*out, options);
  return out;
}

void bind_triangles(nb::module_& m) {
  bind_triangle_results(m);
  m.def(
      "quadrangulate_triangles",
      [](const MeshLike& mesh, const nb::object& triangles, const Choice<TriangleMethod>& method,
         const Choice<Leftover>& leftover, const Choice<PairKind>& pairs,
         const Choice<PairWeight>& weight, const Choice<MatchingEffort>& effort, double min_quality,
         const NumbersLike& halfedge_weight, const Choice<OddBoundary>& odd_boundary,
         const ProgressLike& progress) {
        const TriangleOptionsArgument options(method, leftover, pairs, weight, effort, min_quality,
                                              halfedge_weight, odd_boundary);
        return triangle_quads(TriangleMeshArgument(mesh, triangles), options.options, progress);
      },
      "mesh"_a, "triangles"_a = nb::none(), nb::kw_only(), "method"_a = "pair",
      "leftover"_a = "walk", "pairs"_a = "auto", "weight"_a = "shape", "effort"_a = "near",
      "min_quality"_a = 0.0, "halfedge_weight"_a = nb::none(), "odd_boundary"_a = "on-edge",
      "progress"_a = nb::none(),
      R"(A quadrangulation of a given triangulation: every vertex stays, faces tile the same region (outer Steiner
points add to it), no face reaches over an edge to keep or from one region into another.

The mesh: points (n, 2), or (n, 3) for a surface or for heights, and triangles (t, 3); or a TriangleMesh, or any mesh
of triangles and quads, which goes through connect_triangles.

The boundary stays as it is but for outer Steiner points and, where a part has an odd number of border edges, what
`odd_boundary` says: no mesh of quads alone has an odd border. "subdivide": every edge gets one point; all quads are
strictly convex. "percolate", "fans": planar meshes, all points outside whatever `odd_boundary` says. "q-percolate",
"quarter": an odd part needs a boundary edge. `halfedge_weight` (t, 3), for weight "given": >= 0, the greater, the
sooner gone. The bounds are those of Ramaswami, Ramos and Toussaint, see TriangleMethod.

Raises Error: bad-mesh (a mesh that is none, or that the method is not for), bad-option, guarantee (leftover "error";
no place for a Steiner point among the doubles; "percolate", "fans" with triangles that no boundary is near),
index-out-of-range, not-finite, too-many-points, cancelled.)");
  m.def(
      "quadrangulate_polygons",
      [](const PolygonsLike& polygons, const PointsLike& points, const NumbersLike& segments,
         const PointsLike& holes, const PointsLike& regions, const Choice<TriangleMethod>& method,
         const Choice<Leftover>& leftover, const Choice<PairKind>& pairs,
         const Choice<PairWeight>& weight, const Choice<MatchingEffort>& effort, double min_quality,
         const NumbersLike& halfedge_weight, const Choice<OddBoundary>& odd_boundary,
         const ProgressLike& progress) {
        const TriangleOptionsArgument options(method, leftover, pairs, weight, effort, min_quality,
                                              halfedge_weight, odd_boundary);
        return planar_quads(PlanarArgument(polygons, points, segments, holes, regions),
                            options.options, progress);
      },
      "polygons"_a = nb::none(), "points"_a = nb::none(), "segments"_a = nb::none(),
      "holes"_a = nb::none(), "regions"_a = nb::none(), nb::kw_only(), "method"_a = "pair",
      "leftover"_a = "walk", "pairs"_a = "auto", "weight"_a = "shape", "effort"_a = "near",
      "min_quality"_a = 0.0, "halfedge_weight"_a = nb::none(), "odd_boundary"_a = "on-edge",
      "progress"_a = nb::none(),
      R"(Polygons with holes, segments and inner points into quadrilaterals: quadrangulate_triangles on their
constrained Delaunay triangulation. Segments and the borders between polygons are edges to keep.

The input is that of constrained_delaunay, the options are those of quadrangulate_triangles.

Raises Error as constrained_delaunay and quadrangulate_triangles.)");
}

}  // namespace

void bind_quadrangulate(nb::module_& m) {
  bind_options(m);
  bind_statistics(m);
  bind_points(m);
  bind_triangles(m);
}

}  // namespace quadloom::python
