// Point sets, triangulations and polygons to quadrilaterals.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "quadloom/core.hpp"
#include "quadloom/kernel.hpp"

namespace quadloom {

/// How a point set becomes quads.
enum class PointMethod {
  kDelaunay,   ///< Delaunay-shaped: pairs by shape, left-over triangles walked together (the
               ///< default)
  kSpiral,     ///< Bose and Toussaint's spiraling rotating calipers: long thin quads, no flips
  kInsertion,  ///< Bose and Toussaint's sequential insertion
  kSubdivide,  ///< de Berg's conversion: every Delaunay triangle into three, all strictly convex
};

/// What to do when an odd number of points lies on the hull, so that no mesh of quads alone exists.
enum class OddBoundary {
  kOutside,   ///< one Steiner point just outside the hull; on a hull edge where outside is
              ///< impossible
  kOnEdge,    ///< one Steiner point on a hull edge (its quad has a flat corner there)
  kTriangle,  ///< no point: one triangle stays
};

enum class SteinerKind { kOutside, kOnEdge, kInner };

/// An added point: the vertex, where it lies, and the vertices it was made from (an edge's ends or
/// a triangle's corners; kNone where there are fewer than three), from which attributes can be
/// interpolated.
struct SteinerPoint {
  VertexId vertex = kNone;
  SteinerKind kind = SteinerKind::kInner;
  std::array<VertexId, 3> parents = {kNone, kNone, kNone};
};

struct PointOptions {
  PointMethod method = PointMethod::kDelaunay;       // the best shapes
  OddBoundary odd_boundary = OddBoundary::kOutside;  // all quads, none with a flat corner
  std::uint64_t seed = 1;                            // order of insertion; same seed, same mesh
  Progress progress = {};
};

/// What a run did, for reports; a count that a method does not have is 0.
struct PointStatistics {
  std::size_t hull_points = 0;       ///< points on the hull, those inside its edges included
  std::size_t unmatched_greedy = 0;  ///< triangles left over by the pairing
  std::size_t walks = 0;       ///< walks that merged two left-over triangles (or reached the hull)
  std::size_t walk_steps = 0;  ///< pentagons re-cut by these walks
  std::size_t slides = 0;      ///< edges slid between two quads to improve their shapes
  bool fell_back_to_spiral =
      false;  ///< the method asked for could not finish; the mesh is the spiral's
};

struct PointResult {
  Quadrangulation mesh;                   ///< distinct input points first, then Steiner points
  std::vector<VertexId> input_to_vertex;  ///< one per input point, duplicates merged
  std::size_t input_vertices = 0;  ///< distinct input points = vertices that are no Steiner points
  std::vector<SteinerPoint> steiner;
  PointStatistics statistics;
};

/// A quadrangulation of a point set: every point a vertex, all faces simple quads that tile the
/// convex hull.
///
/// Guarantee (Bose and Toussaint, theorems 3.1, 4.2, 4.3): no Steiner point if the number of points
/// on the hull is even; if odd one, or one triangle, as `odd_boundary` says (kSubdivide: 3 quads a
/// triangle, one point an edge and one a triangle). Collinear, repeated and cocircular points are
/// welcome. Throws Error kNotFinite, kTooFewPoints, kAllCollinear, kTooManyPoints, kCancelled;
/// kGuarantee if the odd point has no place among the doubles.
PointResult quadrangulate_points(std::span<const Point> input, const PointOptions& options = {});

/// The most Steiner points that quadrangulate_points may add for a set with that many points on its hull.
std::size_t steiner_bound(const PointStatistics& statistics, const PointOptions& options);

/// True if and only if the set has a quadrangulation without Steiner points: the number of points
/// on its hull is even (theorem 3.1) and they are not all collinear. Duplicates count once.
/// Throws Error kNotFinite, kTooManyPoints. O(n log n).
bool has_quadrangulation(std::span<const Point> input);

/// The serpentine triangulation of the convex spiral (Bose and Toussaint, lemma 4.1): triangles in
/// the order of the dual path, consecutive ones share an edge; the first one has the hull edge from
/// the spiral's start to its clockwise end. 2n - 2 - h triangles. Throws Error kNotFinite,
/// kTooFewPoints, kAllCollinear, kTooManyPoints, kCancelled. O(n log n).
struct SerpentineResult {
  Triangulation mesh;
  std::vector<VertexId> spiral;           ///< all vertices in the order of the spiral
  std::vector<VertexId> input_to_vertex;  ///< duplicates merged
};
SerpentineResult serpentine_triangulation(std::span<const Point> input,
                                          const Progress& progress = {});

struct KAngulationResult {
  PolygonMesh mesh;  ///< every face has k corners
  std::vector<VertexId> input_to_vertex;
  std::size_t input_vertices = 0;
  std::vector<SteinerPoint>
      steiner;  ///< as a rule at most k - 3, see docs/algorithms/k-angulation.md
};

/// A mesh of simple k-gons (Bose and Toussaint, corollary 4.1), k >= 4, as a rule at most k - 3 Steiner
/// points. Throws as quadrangulate_points; kBadOption for k < 4.
KAngulationResult k_angulate_points(std::span<const Point> input, std::size_t k,
                                    const PointOptions& options = {});

// ---- Triangulations and polygons. ----

/// How a triangulation becomes quads.
enum class TriangleMethod {
  kPair,        ///< pairs of triangles; what is left over as `leftover` says (the default)
  kPercolate,   ///< Ramaswami, Ramos and Toussaint, theorem 3.3: the fewest outer Steiner points
                ///< that this triangulation allows
  kFans,        ///< theorem 2.1: fans of a three-coloured polygon, at most n/3 outer points
  kQPercolate,  ///< theorem 3.4: at most one inner point for two triangles, at most one outer one
  kQuarter,     ///< the full paper's bound: at most one inner point for four triangles
  kSubdivide,   ///< de Berg's conversion: a triangle into three, a given quad into four
};

/// What kPair does with triangles that are left over.
enum class Leftover {
  kError,     ///< Error kGuarantee, with Tutte and Berge's witness
  kTriangle,  ///< they stay
  kWalk,      ///< walked together (see PointMethod::kDelaunay); where that is impossible, kSteiner
  kSteiner,   ///< inner Steiner points, without a change of other edges
};

/// Which pairs kPair may make.
enum class PairKind {
  kAuto,    ///< kAny; for Leftover::kWalk quads that are not strictly convex are parted again, for
            ///< walks do better
  kConvex,  ///< strictly convex quads alone, as many as possible, then weight
  kAny,     ///< as many pairs as possible (a perfect matching if there is one), then weight
};

/// What the matching maximises.
enum class PairWeight {
  kShape,      ///< quad_shape
  kConvexity,  ///< the number of strictly convex quads
  kGiven,      ///< TriangleOptions::halfedge_weight
};

/// Whether the matching is the best one or near it (see near_maximum_weight_matching).
enum class MatchingEffort { kExact, kNear };

struct TriangleOptions {
  TriangleMethod method = TriangleMethod::kPair;  // the fewest changes
  Leftover leftover = Leftover::kWalk;            // all quads
  PairKind pairs = PairKind::kAuto;               // see there
  PairWeight weight = PairWeight::kShape;         // what solvers want
  MatchingEffort effort = MatchingEffort::kNear;  // 60% of the time for 1% of the weight
  double min_quality = 0;                         // the matching makes none of a lesser quad_shape
  std::span<const double> halfedge_weight = {};   // kGiven: >= 0; the greater, the sooner gone
  OddBoundary odd_boundary = OddBoundary::kOnEdge;  // the shape of the region stays
  Progress progress = {};
};

/// What a conversion did, for reports; a count that a method does not have is 0.
struct TriangleStatistics {
  std::size_t triangles = 0;       ///< of the source
  std::size_t boundary_edges = 0;  ///< of the source
  std::size_t parts = 0;           ///< of the source: connected without crossing edges to keep
  std::size_t odd_parts = 0;       ///< parts with an odd number of border edges
  std::size_t unmatched = 0;       ///< triangles left over by the matching
  std::size_t parted = 0;          ///< pairs parted again, see PairKind::kAuto
  std::size_t walks = 0;           ///< walks that merged two of them
  std::size_t walk_steps = 0;      ///< pentagons re-cut by these walks
  std::size_t crossings = 0;       ///< quads crossed with an inner Steiner point each
  std::size_t crowded = 0;         ///< kQuarter: no double for one point among five triangles or
                                   ///< more, so that there are two or three
  double weight_gap = 0;  ///< MatchingEffort::kNear: at most this share of the weight is lost
};

struct TriangleResult {
  Quadrangulation mesh;   ///< the source's vertices with their numbers, then Steiner points
  std::vector<double> z;  ///< as the source has it
  std::size_t input_vertices = 0;
  std::vector<SteinerPoint> steiner;
  /// Per quad the source triangles that it is made of: both, or one and kNone. Where walks re-cut
  /// pentagons each source triangle goes to the face that took most of its sides over.
  std::vector<std::array<TriangleId, 2>> quad_source;
  std::vector<TriangleId> triangle_source;  ///< per left-over triangle
  std::vector<TriangleId> barrier;          ///< why no more pairs are possible, see
                                            ///< MaximumMatching; empty if none is missing
  TriangleStatistics statistics;
};

/// A quadrangulation of a given triangulation: every vertex stays, faces tile the same region (outer
/// Steiner points add to it), no face reaches over an edge to keep or from one region into another.
///
/// The boundary stays as it is but for outer Steiner points and, where a part has an odd number of
/// border edges, what `odd_boundary` says: no mesh of quads alone has an odd border. kSubdivide: every
/// edge gets one point, on the boundary exactly on it or just outside; all quads are strictly convex.
/// kPercolate, kFans: planar meshes, all points outside whatever `odd_boundary` says. kQPercolate, kQuarter: an odd part needs a boundary edge.
///
/// Throws Error kBadMesh (twins, sizes or given pairs that do not agree; a mesh that the method is
/// not for), kBadOption, kGuarantee (Leftover::kError; no place for a Steiner point among the
/// doubles; kPercolate, kFans with triangles that no boundary is near), kTooManyPoints, kCancelled.
TriangleResult quadrangulate_triangles(const TriangleMesh& input,
                                       const TriangleOptions& options = {});

/// The most Steiner points that the method may add for such a source: its theorem's bound, none (the
/// greatest number) where there is no theorem.
std::size_t steiner_bound(const TriangleStatistics& statistics, const TriangleOptions& options);

struct PlanarResult {
  ConstrainedResult triangulation;  ///< parts and input edges of the source triangles
  TriangleResult quads;
};

/// Polygons with holes, segments and inner points: quadrangulate_triangles on their constrained
/// Delaunay triangulation. Segments and the borders between polygons are edges to keep. Throws also as
/// constrained_delaunay.
PlanarResult quadrangulate_polygons(const PlanarInput& input, const TriangleOptions& options = {});

// ---- Numbers of vertices, carried over to added points. ----

/// The parents of an added point with their shares, which sum up to 1; kNone where there are fewer
/// than three.
struct Blend {
  VertexId vertex = kNone;
  std::array<VertexId, 3> parent = {kNone, kNone, kNone};
  std::array<double, 3> share = {0, 0, 0};
};

/// Where the added points lie between their parents: barycentric coordinates for a point in a
/// triangle, the place along it (at its projection) for one made from an edge, in the plane (z
/// empty) or in space. In the order of `steiner`, each after its parents.
std::vector<Blend> blends(std::span<const SteinerPoint> steiner, std::span<const Point> points,
                          std::span<const double> z = {});

/// Sets the values of the added points; those of the others are given.
void interpolate(std::span<const Blend> blends, std::span<double> values);

struct CarriedValues {
  std::vector<double> values;  ///< per vertex
  std::size_t differing =
      0;  ///< repeated points whose value differs from the first one's, which is kept
};

/// Values per input point as values per vertex; all but the values are of one result, so `input` and
/// `input_to_vertex` are equally long. Input points without a vertex (kNone) are left out.
CarriedValues carry_values(std::span<const double> input, std::span<const VertexId> input_to_vertex,
                           std::span<const Point> points, std::span<const SteinerPoint> steiner);

}  // namespace quadloom
