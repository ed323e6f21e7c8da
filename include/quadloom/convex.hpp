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
/// for kSpiral, and n / 6,000 on uniform points for kDelaunay. If an odd number of points is on the hull: with OddBoundary::kOutside one Steiner point
/// outside the hull where there is a place for it, else one triangle stays; kTriangle: one triangle
/// stays. Throws Error kNotFinite, kTooFewPoints, kAllCollinear, kTooManyPoints, kCancelled;
/// kBadOption for OddBoundary::kOnEdge. O(n log n).
ConvexResult convex_quadrangulation(std::span<const Point> input,
                                    const ConvexOptions& options = {});

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

}  // namespace quadloom
