// Triangles in order: Hamiltonian and sequential triangulations, strips, spiral polygons.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "quadloom/convex.hpp"
#include "quadloom/core.hpp"
#include "quadloom/kernel.hpp"
#include "quadloom/quadrangulate.hpp"

namespace quadloom {

// ---- Point sets. ----

/// Which point inside a triangle splits it.
enum class Splitter {
  kRandom,    ///< any: O(n log n) expected
  kBalanced,  ///< Avis and ElGindy's: at most 2/3 of the points in each part, O(n log n) always
};

struct HamiltonianOptions {
  Splitter splitter = Splitter::kRandom;  // about two thirds of the time of the other
  std::uint64_t seed = 1;                 // same seed, same triangles
  Progress progress = {};
};

/// What a run did, for reports; 0 in a path.
struct HamiltonianStatistics {
  std::size_t hull_points = 0;  ///< points on the hull, those inside its edges included
  std::size_t centres = 0;  ///< inner points that are joined to hull points; 1 in general position
  std::size_t levels = 0;   ///< how deeply split triangles are nested
  std::size_t locations = 0;  ///< how often a point was looked for in the parts of a triangle
  std::size_t chains = 0;     ///< splitters that came with others on their line
};

struct HamiltonianResult {
  Triangulation mesh;                     ///< triangles in order, each beside the one before
  OrderKind order = OrderKind::kPath;     ///< kCycle or kPath
  std::vector<VertexId> input_to_vertex;  ///< duplicates merged
  HamiltonianStatistics statistics;
};

/// A triangulation of the points whose triangles are in the order of a cycle (Arkin, Held, Mitchell and
/// Skiena, theorem 3.1); or of a path, where no point is inside the hull, or where points are on so
/// many lines that no cycle was found (of some sets there is none). 2n - 2 - h triangles. Throws Error
/// kNotFinite, kTooFewPoints, kAllCollinear, kTooManyPoints, kCancelled. The bounds of Splitter hold for
/// points in general position; what many points on lines cost, see docs/algorithms/hamiltonian.md.
HamiltonianResult hamiltonian_cycle_triangulation(std::span<const Point> input,
                                                  const HamiltonianOptions& options = {});

// ---- Polygons. ----

/// The triangles of a polygon in an order. `input_to_vertex` has an entry a corner of the rings, ring by
/// ring (as PlanarInput numbers them), repeated ones merged; added points follow the input's vertices.
struct PolygonOrder {
  Triangulation mesh;  ///< triangle i + 1 shares an edge with triangle i
  OrderKind order = OrderKind::kPath;
  std::vector<VertexId> input_to_vertex;
  std::size_t input_vertices = 0;  ///< the others, to the end of mesh.points, are added points
};

/// A triangulation of a simple polygon, without added points, whose triangles are a path; none if there
/// is no such triangulation (Arkin, Held, Mitchell and Skiena, theorem 2.1). Of a polygon no order of
/// triangles is a cycle. Flat corners are welcome; a ring may touch itself as for constrained_delaunay as
/// long as the inside is one piece without holes. Of several such triangulations one is taken that does
/// not depend on anything but the input.
///
/// Throws Error kBadPolygon (holes: an NP-complete question, not answered here; an inside in parts), and
/// as constrained_delaunay. O(E log n) and O(E) space, E the pairs of corners that see each other, after
/// their visibility graph, which takes O(n^2) at worst and about O(E) as a rule.
std::optional<PolygonOrder> hamiltonian_triangulation(const Polygon& polygon);

/// The same for a sequential triangulation (theorem 4.4): left and right turns alternate. O(n) space.
std::optional<PolygonOrder> sequential_triangulation(const Polygon& polygon);

// ---- Triangulations. ----

/// The same triangulation, its triangle order[i] now triangle i; the corners keep their turn. Throws
/// Error kBadOption if `order` has not each triangle once. O(n).
Triangulation reorder_triangles(const Triangulation& mesh, std::span<const TriangleId> order);

/// Whether the last triangle of an order is beside the first.
enum class Closure {
  kOpen,
  kCycle,           ///< they share an edge
  kSequentialCycle  ///< so, and the left and right turns go on alternating across it
};

/// An order of all triangles of a mesh such that left and right turns alternate.
struct SequentialOrder {
  std::vector<TriangleId> order;
  std::vector<VertexId> sequence;  ///< two more than triangles: triangle order[i] has the vertices
                                   ///< sequence[i], sequence[i + 1], sequence[i + 2]
  Closure closure = Closure::kOpen;
};

/// Decides whether a triangulation, in the plane or of a surface, is sequential (Arkin, Held, Mitchell
/// and Skiena, theorem 4.3), and gives an order if it is: of all there are one that closes best, in a tie
/// the first found from triangle 0. Only tri_vertex and twin are looked at. Throws Error kBadMesh for
/// twins that do not agree. O(n).
std::optional<SequentialOrder> sequential_order(const Triangulation& mesh);

struct OrderSearchOptions {
  OrderKind kind = OrderKind::kPath;        // or kCycle
  std::uint64_t work_at_most = 30'000'000;  // states of the search; about five seconds
  Progress progress = {};
};

/// Why a mesh has no Hamiltonian order.
enum class NoOrder {
  kNoReason,    ///< it has one, or it is not known
  kTooFew,      ///< a cycle takes three triangles
  kComponents,  ///< it does not hang together over edges
  kEars,        ///< triangles with one neighbour: more than two, or any where a cycle is asked for
  kBridges,     ///< an edge to cross twice, or parts that three of such edges lead away from
  kPairing,     ///< too many triangles are left over by any pairing of neighbours
  kExhausted,   ///< the search went through all possibilities
};

struct HamiltonianOrder {
  Answer answer = Answer::kUnknown;
  std::vector<TriangleId> order;        ///< kYes: all triangles
  NoOrder reason = NoOrder::kNoReason;  ///< kNo
  std::vector<TriangleId> culprits;  ///< kEars: those; kComponents: one of each; kBridges: the two
                                     ///< triangles at it, or those of the part
  std::uint64_t work = 0;
};

/// Whether the triangles, as they are, can be put in an order such that each is beside the one before,
/// and the first beside the last if OrderKind::kCycle is asked for: an NP-complete question (Arkin,
/// Held, Mitchell and Skiena, section 5), so the answer is kUnknown when the work runs out. Only
/// tri_vertex and twin are looked at. Throws Error kBadOption for OrderKind::kSequential (see
/// sequential_order), kTooFewPoints (no triangles), kBadMesh for twins that do not agree, kCancelled.
HamiltonianOrder hamiltonian_order(const Triangulation& mesh,
                                   const OrderSearchOptions& options = {});

struct RefinementOptions {
  Progress progress = {};
};

/// A refined mesh whose triangles stand in the order of Hamiltonian cycles, one for each component of
/// the input.
struct HamiltonianRefinement {
  TriangleMesh mesh;  ///< with the input's regions and edges to keep; no given_pair
  std::vector<std::uint32_t> cycle_begin = {0};  ///< cycle i is the triangles cycle_begin[i] ..
                                                 ///< cycle_begin[i + 1]
  std::size_t input_vertices = 0;                ///< which come first, with their numbers
  std::vector<std::array<TriangleId, 2>>
      source;                         ///< per triangle: what it was cut from; the second
                                      ///< kNone, but for those on both sides of a flip
  std::vector<SteinerPoint> steiner;  ///< one in each triangle, then the midpoints
  std::size_t flips = 0;
  std::size_t midpoints = 0;    ///< added on edges that must stay
  std::size_t moved = 0;        ///< inner points that could not be at the incentre
  double min_angle_before = 0;  ///< degrees, in floating point
  double min_angle_after = 0;

  std::size_t cycle_count() const { return cycle_begin.size() - 1; }
};

/// Makes a triangulation, in the plane or of a surface, Hamiltonian (Arkin, Held, Mitchell and Skiena,
/// theorem 2.4): k triangles become 3 k, by a point in each and flips along a spanning tree of the dual
/// graph. Vertices and boundary stay. Edges to keep and those between regions stay as well; where a
/// component hangs together over such edges alone, as few of them as possible get a midpoint (as rounded),
/// and two triangles more.
///
/// Guarantee: in the plane no angle is smaller than half the smallest angle of the input, up to
/// rounding, if `moved` is 0; on a surface it is measured only. Throws Error kGuarantee (a triangle
/// without a double inside, or one that hangs on an edge that can be neither flipped nor split), as
/// quadrangulate_triangles for a mesh whose parts do not agree, kTooManyPoints, kCancelled.
/// O(k log k).
HamiltonianRefinement hamiltonian_refinement(const TriangleMesh& input,
                                             const RefinementOptions& options = {});

// ---- Strips and their encodings. ----

}  // namespace quadloom
