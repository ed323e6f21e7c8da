// The independent check, and the quality figures.
#pragma once

#include <array>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "quadloom/core.hpp"
#include "quadloom/kernel.hpp"

namespace quadloom {

struct CertifyOptions {
  std::size_t corners = 4;  // of every face but the allowed triangles
  std::size_t triangles_allowed = 0;
  std::size_t steiner_at_most = std::numeric_limits<std::size_t>::max();
  bool steiner_inside = false;  // no Steiner point on the boundary
  bool outer_steiner = false;   // an edge a-b of the given boundary may be a-s-b, s a Steiner point
  bool strictly_convex = false;  // every face of `corners` corners turns strictly left everywhere
};

/// What is wrong with a mesh; kNoFault if nothing is.
enum class Fault {
  kNoFault,
  kNoFaces,
  kIndexOutOfRange,
  kRepeatedCorner,
  kCornerCount,
  kNotFinite,  ///< a used vertex with a NaN or infinite coordinate
  kNotSimple,  ///< not a simple counter-clockwise polygon of positive area; on a surface: all
               ///< corners on one line
  kNotStrictlyConvex,
  kRepeatedEdge,    ///< a directed edge in two faces
  kRepeatedVertex,  ///< two used vertices at the same place
  kMissingPoint,    ///< an input point that is no vertex of a face
  kBoundary,        ///< boundary not one simple, weakly convex cycle that goes around once; or not
                    ///< that of the polygons or the source
  kTooManyTriangles,
  kTooManySteiner,
  kSteinerOnBoundary,
  kFans,      ///< surfaces: the faces at a vertex hang together otherwise than in the source
  kTopology,  ///< surfaces: other components, or one of another Euler characteristic
  kOrder,  ///< neighbours in an order of triangles that share no edge; a cycle that is not closed
  kTurns,  ///< an order of triangles that is not sequential
  kReflexChains,  ///< a ring whose reflex corners are more than one chain
};

/// The verdict with its figures (counted up to the fault) and, for a fault, a sentence and the
/// culprits (faces for face faults, vertices for vertex and edge faults, input indices for missing
/// points).
struct Certificate {
  Fault fault = Fault::kNoFault;
  std::string sentence;
  std::vector<std::size_t> culprits;

  std::size_t points = 0;  ///< distinct input points that are vertices
  std::size_t faces = 0;
  std::size_t triangles = 0;
  std::size_t boundary = 0;  ///< vertices on the boundary cycle
  std::size_t steiner = 0;
  std::size_t strictly_convex = 0;  ///< of the faces with `corners` corners; so the next two
  std::size_t flat_cornered = 0;
  std::size_t non_convex = 0;

  bool ok() const { return fault == Fault::kNoFault; }
};

/// Proves from the faces alone, exactly, that the mesh tiles the convex region within its boundary
/// once and that every input point is a vertex of it (see docs/algorithms/certify.md). An empty
/// input asks for no points: every used vertex then counts as an input point. Vertices that no face
/// uses are not looked at. The first fault found is reported. Throws Error kBadOption for fewer
/// than three corners, kTooManyPoints for 2^31 vertices or more, as do the others. Near-linear.
Certificate certify_points(const PolygonMesh& mesh, std::span<const Point> input,
                           const CertifyOptions& options = {});

/// The same for polygons: the mesh's boundary must be their rings (an edge may be split by vertices
/// on it, steiner_inside forbids Steiner points there; edges that two polygons share are none of the
/// boundary), it must wind around its inside once, and corners and inner points must be vertices.
/// With outer_steiner an edge may be replaced by two. `boundary` counts its edges. Throws Error
/// kTooFewPoints for no polygons. O(n + b log b), b the edges of the boundary.
Certificate certify_polygons(const PolygonMesh& mesh, std::span<const Polygon> polygons,
                             std::span<const Point> inner = {}, const CertifyOptions& options = {});

/// The same for a planar mesh that was made from another: the boundary must be the source's and the
/// vertices that the source uses must be vertices. Throws Error kBadMesh, kIndexOutOfRange (a source
/// that is no mesh), kTooFewPoints.
Certificate certify_mesh(const PolygonMesh& mesh, const PolygonMesh& source,
                         const CertifyOptions& options = {});

/// For a surface in space that was made from another; heights are one a vertex or empty (0). What
/// can be said of it is combinatorial, and vertices are known by number: each vertex that the source
/// uses is the vertex with the same number, at the same place, in a face; the others are Steiner
/// points. Faces have distinct corners, not all on one line, each directed edge is in one face; the
/// faces at a vertex make as many fans as in the source (a Steiner point: one); the boundary is the
/// source's, an edge in one piece or replaced by a chain through Steiner points, which without
/// outer_steiner are in the box that the edge spans; the components are the source's and have its
/// Euler characteristics. strictly_convex: in the coordinate plane that the face is nearest to.
/// Whether faces cut each other in space, and whether a closed surface is inside out, is not looked
/// at. Throws Error kBadMesh, kIndexOutOfRange, kTooFewPoints as certify_mesh, kBadOption. O(n log n).
Certificate certify_surface(const PolygonMesh& mesh, std::span<const double> z,
                            const PolygonMesh& source, std::span<const double> source_z,
                            const CertifyOptions& options = {});

/// Proves that the order of the faces, all of them triangles, is of that kind: consecutive ones have an
/// edge in opposite directions, and what OrderKind says. That no triangle stands there twice, and that
/// they tile something, is for the other certificates. Culprits: the two faces; for kTurns the first
/// face that no sequence of vertices reaches. Also kNoFaces, kCornerCount, kIndexOutOfRange,
/// kRepeatedCorner. Linear.
Certificate certify_order(const PolygonMesh& mesh, OrderKind kind);

/// Proves that a ring of corners (the first not again at the end) is a spiral polygon through the
/// points: simple, without touching itself; counter-clockwise; its corners are the points, each distinct
/// one once; and of its reflex corners no two have convex ones between them on both sides. Flat corners,
/// where the ring goes straight on, are neither reflex nor convex and may be anywhere. Culprits: corners,
/// the first of each reflex chain; for kMissingPoint the point. The certificate counts the corners: in
/// all (boundary), convex (strictly_convex), flat (flat_cornered), reflex (non_convex). Also kCornerCount,
/// kNotFinite, kNotSimple, kTooManySteiner (a corner that is no point). O(n log n).
Certificate certify_spiral_polygon(std::span<const Point> ring, std::span<const Point> points);

/// Shape figures of a mesh. Angles in degrees; an edge between two faces counts once.
struct Quality {
  std::size_t quads = 0;
  std::size_t triangles = 0;
  std::size_t other_faces = 0;
  std::size_t strictly_convex = 0;  ///< of the quads; decided exactly
  std::size_t flat_cornered = 0;
  std::size_t non_convex = 0;
  double min_angle = 0;  ///< over all corners of all faces
  double max_angle = 0;
  std::array<std::size_t, 36> angle_histogram =
      {};                 ///< corners by angle, 10 degrees a bin, [0, 360)
  double mean_shape = 0;  ///< quad_shape over the quads
  double min_shape = 0;
  std::array<std::size_t, 10> shape_histogram = {};
  double max_aspect = 0;  ///< longest over shortest edge of a quad
  double median_aspect = 0;
  std::size_t edges = 0;
  double min_edge = 0;
  double max_edge = 0;
  double mean_edge = 0;
};

/// Faces should be counter-clockwise. A mesh without faces has zeros everywhere. Throws Error
/// kBadMesh (a face of fewer than three corners), kIndexOutOfRange, kNotFinite, kTooManyPoints (2^31
/// vertices). Near-linear.
Quality measure_quality(const PolygonMesh& mesh);
/// The same for a surface in space, z one a vertex (empty: as above): lengths and angles are those in
/// space. What turns in and out, and so which quads are convex, is seen (exactly) in the coordinate
/// plane that the face is nearest to: a corner that turns out there has 360 degrees less its angle,
/// and the shape of a quad is 1 - (2/pi) max |pi/2 - angle| if it is strictly convex there, else 0.
/// Throws also Error kBadMesh if the size of z is wrong.
Quality measure_quality(const PolygonMesh& mesh, std::span<const double> z);

}  // namespace quadloom
