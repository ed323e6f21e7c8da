// Strictly convex quadrilaterals: every corner turns, none is flat or reflex.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "quadloom/core.hpp"
#include "quadloom/quadrangulate.hpp"

namespace quadloom {

/// A small polygon in strictly convex quads that tile it, counter-clockwise. Its points are numbered:
/// the corners as given, an inner point that was given, then the Steiner points, which lie strictly
/// inside. The quads' edges along the polygon are the polygon's.
struct ConvexPatch {
  std::vector<Point> steiner;
  std::vector<std::array<VertexId, 4>> quads;
  std::string
      case_name;  ///< the paper's, as in "rcrccc-1": reflex and convex corners up to rotation
                  ///< and reflection, flat ones counting as reflex; Steiner points
};

/// A hexagon, theorem 3.2 of Bremner, Hurtado, Ramaswami and Sacristan: at most 0 Steiner points for
/// cccccc, 2 for rccccc, rrcccc and rccrcc, 3 for the others, as few as are found (no more than
/// necessary where none is enough, or one whose place is wider than rounding). None if its doubles are
/// so close that no places were found; never a wrong patch, each is checked exactly. Throws Error
/// kNotFinite, kBadPolygon (not simple, or clockwise). Constant time.
std::optional<ConvexPatch> convexify_hexagon(const std::array<Point, 6>& corners);

/// The same for a quad with a point strictly inside (theorem 3.8): 3 Steiner points, which is the
/// fewest. Throws also kBadPolygon for a point that is not inside.
std::optional<ConvexPatch> convexify_quad_with_point(const std::array<Point, 4>& corners,
                                                     Point inner);

/// The same for a quad: no Steiner points if it is strictly convex, else 4, which is the fewest.
std::optional<ConvexPatch> convexify_quad(const std::array<Point, 4>& corners);

// ---- Point sets. ----

/// How a point set becomes strictly convex quads.
enum class ConvexMethod {
  kDelaunay,  ///< Delaunay-shaped: pairs, walks, and patches around what is not convex; almost no
              ///< Steiner points (the default)
  kSpiral,  ///< Bremner, Hurtado, Ramaswami and Sacristan: the path of the spiral's triangles, cut
            ///< into quads and pairs of quads such that few Steiner points are added
  kPentagons,  ///< Ramaswami, Ramos and Toussaint, theorem 4.2: six triangles of that path at a time,
               ///< two pentagons with a Steiner point between them
};

struct ConvexOptions {
  ConvexMethod method = ConvexMethod::kDelaunay;     // the fewest points, the best shapes
  OddBoundary odd_boundary = OddBoundary::kOutside;  // all quads; kOnEdge would make a flat corner
  std::uint64_t seed = 1;  // kDelaunay: of the wandering; the same seed, the same mesh
  Progress progress = {};
};

/// How quads that were not strictly convex were mended (kDelaunay, and triangle meshes).
struct MendStatistics {
  std::size_t bad = 0;              ///< quads that were not strictly convex
  std::size_t bad_after_moves = 0;  ///< that were left when moves without added points ended
  std::size_t clusters = 0;         ///< groups of quads that were parted anew
  std::size_t stars = 0;            ///< groups that one added point, or several, mended
  std::size_t cases = 0;            ///< unions of two quads mended as in the paper's cases
  std::size_t settled = 0;          ///< added points that were taken out again
  std::size_t left = 0;             ///< quads that could not be mended among the doubles
};

/// What a run did, for reports; a count that a method does not have is 0.
struct ConvexStatistics {
  std::size_t hull_points = 0;  ///< points on the hull, those inside its edges included
  std::size_t kept = 0;         ///< quads of two triangles that were strictly convex
  std::size_t patches = 0;      ///< unions of two quads, or lone quads, that were made so
  std::array<std::size_t, 5> patches_by_points = {};  ///< patches with 0 to 4 Steiner points
  MendStatistics mending;
};

struct ConvexResult {
  Quadrangulation mesh;                   ///< distinct input points first, then Steiner points
  std::vector<VertexId> input_to_vertex;  ///< one per input point, duplicates merged
  std::size_t input_vertices = 0;
  std::vector<SteinerPoint> steiner;  ///< inner ones: parents are a triangle that they are in
  std::vector<QuadId> not_convex;     ///< quads that had to stay as they are, since no doubles were
                                      ///< found for their Steiner points; none but for points that
                                      ///< are as near to each other as doubles get
  ConvexStatistics statistics;
};

/// A quadrangulation of a point set in which all quads are strictly convex (but for `not_convex`).
///
/// Guarantee (theorem 3.1): at most 3 floor(n / 2) inner Steiner points; as a rule about a third of that
/// for kSpiral, and n / 4,000 on uniform points for kDelaunay, which gives kSpiral's mesh where that has
/// fewer, and the sets of mesh_of_bhrs_line and mesh_of_bhrs_ring theirs. kPentagons: at most
/// 7 ceil((2n - 2 - h) / 6) (Ramaswami, Ramos and Toussaint, theorem 4.2). If an odd number of points is
/// on the hull: with OddBoundary::kOutside one Steiner point outside the hull where there is a place for it, else one triangle stays; kTriangle: one triangle
/// stays. Throws Error kNotFinite, kTooFewPoints, kAllCollinear, kTooManyPoints, kCancelled;
/// kBadOption for OddBoundary::kOnEdge. O(n log n).
ConvexResult convex_quadrangulation(std::span<const Point> input,
                                    const ConvexOptions& options = {});

/// The most Steiner points that convex_quadrangulation may add to that many distinct points.
std::size_t steiner_bound(std::size_t points, const ConvexStatistics& statistics,
                          const ConvexOptions& options);

// ---- Triangulations and polygons. ----

struct ConvexMeshResult {
  TriangleResult quads;
  std::vector<QuadId> not_convex;  ///< as in ConvexResult
  MendStatistics mending;
};

/// quadrangulate_triangles by TriangleMethod::kPair for a planar mesh, with all quads strictly convex (but
/// for `not_convex`): what is not is mended inside its part, with inner Steiner points where that is
/// needed. Boundary, edges to keep and regions stay as there. `seed` as in ConvexOptions. Throws as
/// quadrangulate_triangles; kBadMesh for a surface in space, kBadOption for another method and for
/// Leftover::kTriangle and kError.
ConvexMeshResult convex_quadrangulation(const TriangleMesh& input,
                                        const TriangleOptions& options = {},
                                        std::uint64_t seed = 1);

// ---- Small point sets, exactly. ----

enum class Answer { kNo, kYes, kUnknown };

struct ExactConvexOptions {
  std::size_t points_at_most = 16;          // more can take seconds; 20 at most
  std::uint64_t work_at_most = 50'000'000;  // faces tried; about ten seconds
  Progress progress = {};
};

/// What is known of all quadrangulations of a point set without Steiner points: all distinct points
/// are vertices, those inside hull edges too; the faces are simple quads, of any shape, and if an odd
/// number of points is on the hull, one triangle.
struct ExactConvexResult {
  Answer convex = Answer::kUnknown;        ///< is there one in which all quads are strictly convex?
  std::optional<std::size_t> most_convex;  ///< the greatest number of strictly convex quads in one;
                                           ///< none: unknown
  std::size_t quads = 0;                   ///< in each one: n - 1 - h / 2, rounded down if h is odd
  std::size_t hull_points = 0;
  Quadrangulation mesh;  ///< one with most_convex such quads; empty if that is unknown
  std::vector<VertexId> input_to_vertex;  ///< one per input point, duplicates merged
  std::uint64_t work = 0;                 ///< faces tried
};

/// The answers by exhaustive search; exact predicates decide. kUnknown and none if the work ran out.
/// Throws Error kBadOption for points_at_most above 20 and for more distinct points than that;
/// kNotFinite, kTooFewPoints, kAllCollinear, kCancelled. Exponential in n.
ExactConvexResult exact_convex_quadrangulation(std::span<const Point> input,
                                               const ExactConvexOptions& options = {});

// ---- The sets that need the most Steiner points known, and their meshes. ----

/// The mesh of theorem 2.2 of Bremner, Hurtado, Ramaswami and Sacristan for their set that needs
/// ceil(m / 2) - 1 Steiner points: m + 1 points in order on a line, then one on its left and one on its
/// right such that the hull has four corners, as generate_points("bhrs-line", m + 3) gives them. All
/// quads strictly convex, inner Steiner points after the points given: for m >= 3 m / 2 + 1,
/// (m + 3) / 2, m / 2 + 2, (m + 1) / 2 of them for m mod 4 = 0, 1, 2, 3; 3 for m = 2, 0 for m = 1.
/// Throws Error kBadOption if the points are not such a set, kGuarantee if no doubles are in a place
/// that a Steiner point needs, kNotFinite. O(n log n).
Quadrangulation mesh_of_bhrs_line(std::span<const Point> points);

/// The mesh of theorem 2.4 for their set that needs n / 4: k = n / 2 >= 3 points in strictly convex
/// position, counter-clockwise, then one for each hull edge a(i) a(i + 1), so near to it that no other
/// point is on its side of the lines to the edge's ends, as generate_points("bhrs-ring", n) gives
/// them. All faces but one triangle for odd k are strictly convex quads; n / 4 + 1 inner Steiner points
/// for even k, ceil(n / 4) for odd k. Throws as mesh_of_bhrs_line; kGuarantee also if the mean of the
/// hull's corners cannot be the central Steiner point. O(n log n).
Quadrangulation mesh_of_bhrs_ring(std::span<const Point> points);

}  // namespace quadloom
