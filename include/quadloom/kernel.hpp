// Exact predicates and the constructions on them: hull, convex layers, spiral, Delaunay.
#pragma once

#include <span>
#include <vector>

#include "quadloom/core.hpp"

namespace quadloom {

// ---- Predicates: the exact sign (-1, 0, +1) of a determinant of the given finite doubles. ----

/// +1 if a, b, c turn left (counter-clockwise), -1 if right, 0 if they are collinear.
int orient2d(Point a, Point b, Point c);

/// For a, b, c counter-clockwise: +1 if d is inside their circle, -1 if outside, 0 if on it. For a,
/// b, c clockwise the sign is the opposite.
int incircle(Point a, Point b, Point c, Point d);

/// The sign of (b - a) x (d - c): +1 if the direction c->d is counter-clockwise of a->b (by less
/// than half a turn), 0 if they are parallel, equal or opposite.
int cross_sign(Point a, Point b, Point c, Point d);

/// The sign of (b - a) . (d - c): +1 if the directions make an acute angle, 0 a right one, -1
/// obtuse.
int dot_sign(Point a, Point b, Point c, Point d);

// ---- Shape: figures for ranking, in plain floating point; no decision rests on them. ----

/// The shape of a counter-clockwise quad: 1 - (2/pi) max |pi/2 - angle| over its corners, 1 for a
/// rectangle, 0 for one that is not strictly convex (Remacle et al., Blossom-Quad).
double quad_shape(Point a, Point b, Point c, Point d);

// ---- The input at the public door. ----

/// Distinct points in the order of their first occurrence; input_to_vertex[i] is where input i
/// went.
struct DistinctPoints {
  std::vector<Point> points;
  std::vector<VertexId> input_to_vertex;
};

/// Throws Error kNotFinite (the first culprit) and kTooManyPoints. O(n log n).
DistinctPoints distinct_points(std::span<const Point> input);

/// A permutation of the points along a Hilbert curve; equal points are neighbours, ordered by
/// index. The same on every platform. O(n) in practice.
std::vector<VertexId> spatial_order(std::span<const Point> points);

// ---- Hull, layers, spiral. Points must be finite and distinct. ----

/// The convex hull, counter-clockwise from the lexicographically smallest point, every point on a
/// hull edge included. If all points lie on one line: the points in order along it. O(n log n).
std::vector<VertexId> convex_hull(std::span<const Point> points);

/// Convex layers from the outside in: layer i is vertex[begin[i] .. begin[i + 1]), each as
/// convex_hull gives it. The last layer may be one point or a segment's points in order. Throws Error
/// kCancelled.
struct ConvexLayers {
  std::vector<VertexId> vertex;
  std::vector<std::uint32_t> begin = {0};

  std::size_t count() const { return begin.size() - 1; }
  std::span<const VertexId> layer(std::size_t i) const {
    return {vertex.data() + begin[i], vertex.data() + begin[i + 1]};
  }
};
ConvexLayers convex_layers(std::span<const Point> points, const Progress& progress = {});

/// The convex spiral (Bose and Toussaint, section 4): every point once, from `start` (a corner of
/// the hull; kNone: the lexicographically smallest point) clockwise around the hull and on inwards,
/// collinear points in order. O(n log n).
std::vector<VertexId> convex_spiral(std::span<const Point> points, VertexId start = kNone);
std::vector<VertexId> convex_spiral(std::span<const Point> points, const ConvexLayers& layers,
                                    VertexId start = kNone);

// ---- Meshes of triangles, as files hold them. ----

/// What the third coordinate of a mesh means.
enum class Space {
  kAuto,   ///< kPlane if all vertices are at one height, or if the faces, seen from above, all turn
           ///< the same way and no two of their vertices are above each other; else kSurface
  kPlane,  ///< heights or depths are data: decisions and shapes are those of the plane
  kSurface,  ///< a surface in space: shapes are measured in space
};

/// What kAuto takes a mesh of any faces for. `z` is empty or one a vertex. Throws Error kBadMesh if
/// sizes do not agree. O(n log n).
Space space_of(const PolygonMesh& mesh, std::span<const double> z);

/// What to do with faces that turn the other way than their neighbours, and faces without area.
enum class FaultyFaces { kRepair, kRefuse };

/// What to do with vertices at exactly the same place.
enum class EqualVertices { kKeep, kMerge };

struct ConnectOptions {
  Space space = Space::kAuto;                  // what people mean by most files
  FaultyFaces faulty = FaultyFaces::kRepair;   // said in the result; many scanners turn some
  EqualVertices equal = EqualVertices::kKeep;  // seams may be meant
};

/// The mesh as its triangles, and what was found on the way.
struct ConnectedMesh {
  TriangleMesh triangles;  ///< vertices as given (or merged); a quad is two triangles, a given_pair
  std::vector<VertexId> input_to_vertex;   ///< equal vertices merged, if asked for
  std::vector<std::uint32_t> source_face;  ///< per triangle: the face of the input
  Space space = Space::kPlane;             ///< kPlane or kSurface
  std::size_t turned_faces = 0;            ///< faces given the other way around
  std::size_t flat_faces = 0;              ///< repaired: triangles without area
  std::size_t unused_vertices = 0;
  std::size_t components = 0;       ///< of triangles connected over edges
  std::size_t boundary_cycles = 0;  ///< closed: 0
  std::size_t boundary_edges = 0;
};

/// Connects triangles and quads over their edges and checks them: each edge has at most two faces,
/// one on each side; no triangle is without area. Vertices keep their numbers, used or not, unless
/// they are merged (in the plane whatever their heights, which TriangleMesh::z then does not have).
/// Bow-ties (two fans of triangles at one vertex) are allowed. Whether faces lie over each other is
/// not looked at.
///
/// Quads are cut by a diagonal that is inside, so are two triangles with a given_pair. In the plane
/// faces are turned counter-clockwise, and used vertices must be at different places. On a surface the
/// faces of a component are turned as most of them were given, in a tie as its first. A triangle
/// without area (exactly: its corners are on a line) is flipped into its neighbour across its longest
/// edge, whose side then has a vertex more (a given quad there is one no longer), or left out if that
/// edge is on the boundary. FaultyFaces::kRefuse refuses both, but not a planar mesh that is clockwise
/// as a whole. A corner that repeats the one before counts once: quads become triangles, triangles
/// are without area.
///
/// Throws Error kBadMesh (sizes that do not agree, a face of other than three or four corners, a
/// corner twice, an edge with three faces or with two on one side, a surface with one side, a quad
/// that is not simple, two vertices at one place in the plane, a triangle without area that cannot be
/// repaired, or what `faulty` refuses; culprits, as numbers of the input: the edge's vertices, the two
/// vertices, or the face), kIndexOutOfRange (culprits: face, index), kNotFinite (the vertex),
/// kTooFewPoints (no faces with an area), kTooManyPoints. O(n log n).
ConnectedMesh connect_triangles(const PolygonMesh& mesh, std::span<const double> z = {},
                                const ConnectOptions& options = {});

/// Adds to the edges to keep (TriangleMesh::keep) those where the normals of the two triangles differ
/// by more than `degrees` (0 to 180, else Error kBadOption), in floating point; returns how many
/// edges do. The diagonals of given quads are none. In the plane there are none. O(n).
std::size_t keep_sharp_edges(TriangleMesh& mesh, double degrees);

// ---- Delaunay. ----

struct DelaunayResult {
  Triangulation mesh;  ///< over the distinct points, in the order of first occurrence
  std::vector<VertexId> input_to_vertex;  ///< duplicates merged
};

/// The Delaunay triangulation, exact. Cocircular points are triangulated the same way whatever the
/// input order (in the lattice's squares all diagonals are parallel). Its boundary is the hull with
/// every collinear point. Throws Error kNotFinite, kTooFewPoints, kAllCollinear, kTooManyPoints.
/// O(n log n) expected.
DelaunayResult delaunay(std::span<const Point> input);

// ---- Constrained Delaunay: polygons with holes, segments, inner points. ----

/// A polygon with holes: the first ring is the outer one, the others are its holes. Rings may be
/// given either way around, with or without the first corner again at the end.
struct Polygon {
  std::vector<std::vector<Point>> rings;
};

/// Two of PlanarInput::points.
struct Segment {
  VertexId from = kNone;
  VertexId to = kNone;
};

/// What constrained_delaunay triangulates. The input points are numbered with the polygons' corners
/// first, ring by ring, then `points`; the input edges likewise: edge i of a ring starts at input
/// point i, the segments follow.
struct PlanarInput {
  std::vector<Polygon> polygons;
  std::vector<Point> points;  ///< inner points, ends of segments
  std::vector<Segment> segments;
  std::vector<Point> holes;    ///< without polygons: a place in each enclosed part to leave out
  std::vector<Point> regions;  ///< without polygons: a place in each part that shall have a name
};

enum class Extent {
  kInside,  ///< the inside of the polygons; if there are none, what the segments enclose
  kHull,    ///< the convex hull of everything
};

struct ConstrainedResult {
  Triangulation mesh;                     ///< vertices in the order of first occurrence
  std::vector<VertexId> input_to_vertex;  ///< duplicates merged; kNone: outside, left out
  std::vector<std::uint32_t> edge;        ///< per halfedge: the input edge it is on, or kNone
  std::vector<std::uint32_t> part;  ///< per triangle: the polygon or else the region, or kNone
};

/// The constrained Delaunay triangulation, exact, without new points: every input edge is an edge of
/// it, or a chain of edges where points lie on it, and every other edge is locally Delaunay. Ties as
/// in delaunay(), so the triangles do not depend on the order of the input. Two polygons may share
/// whole edges, a segment may repeat an edge; the edge then counts as the first one. Where an input
/// point is on two edges they meet there and do not cross. Rings may touch
/// at corners, others or themselves, as long as each edge has the inside of its polygon on its inner
/// side and no part is in two polygons. Throws Error kCrossing (edges that cross or overlap, named
/// by number), kBadPolygon (a ring of fewer than three places, rings that are not nested as outer
/// ring and holes, polygons that overlap, nothing inside), kIndexOutOfRange (culprits: segment,
/// index), kBadOption (holes or regions beside polygons, or on an edge), kCancelled, and as delaunay(). Polygons
/// and segments of n corners: O(n log n) expected, and the edges that the segments cross.
ConstrainedResult constrained_delaunay(const PlanarInput& input, Extent extent = Extent::kInside,
                                       const Progress& progress = {});
ConstrainedResult constrained_delaunay(const Polygon& polygon, std::span<const Point> inner = {});

}  // namespace quadloom
