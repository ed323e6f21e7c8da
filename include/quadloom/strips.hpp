// Triangles in order: Hamiltonian and sequential triangulations, strips, spiral polygons.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "quadloom/convex.hpp"
#include "quadloom/core.hpp"
#include "quadloom/dual.hpp"
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
  Splitter splitter = Splitter::kRandom;  // about a third of the time of the other
  std::uint64_t seed = 1;                 // same seed, same triangles
  std::size_t work_at_most = 10'000'000;  // triangles tried where a search is needed, of up to 16
                                          // points; a second or two
  Progress progress = {};
};

/// What a run did, for reports; 0 in a path.
struct HamiltonianStatistics {
  std::size_t hull_points = 0;  ///< points on the hull, those inside its edges included
  std::size_t centres = 0;    ///< inner points joined to hull points; 1 in general position, 0: the
                              ///< cycle was found by search
  std::size_t levels = 0;     ///< how deeply split triangles are nested
  std::size_t locations = 0;  ///< how often a point was looked for in the parts of a triangle
  std::size_t chains = 0;     ///< splitters that came with others on their line
};

struct HamiltonianResult {
  Triangulation mesh;                  ///< triangles in order, each beside the one before
  OrderKind order = OrderKind::kPath;  ///< kCycle or kPath
  Answer cycle = Answer::kUnknown;     ///< has the set such a cycle? kYes: here it is; kNo: proved
  std::vector<VertexId> input_to_vertex;  ///< duplicates merged
  HamiltonianStatistics statistics;
};

/// A triangulation of the points whose triangles are in the order of a cycle (Arkin, Held, Mitchell and
/// Skiena, theorem 3.1); or of a path, where no point is inside the hull, or where points are on so
/// many lines that no cycle was found. Up to 16 points that is a proof that there is none, unless the
/// work runs out. 2n - 2 - h triangles. Throws Error kNotFinite, kTooFewPoints, kAllCollinear, kTooManyPoints, kCancelled. The bounds of Splitter hold for
/// points in general position; what many points on lines cost, see docs/algorithms/hamiltonian.md.
HamiltonianResult hamiltonian_cycle_triangulation(std::span<const Point> input,
                                                  const HamiltonianOptions& options = {});

struct SequentialOptions {
  std::uint64_t work_at_most = 100'000'000;  // triangles tried; up to half a minute
  Progress progress = {};
};

struct SequentialResult {
  Answer answer = Answer::kUnknown;       ///< is there a sequential triangulation?
  Triangulation mesh;                     ///< kYes: one, triangles in order
  std::vector<VertexId> sequence;         ///< kYes: triangle i has its vertices i, i + 1, i + 2
  std::vector<VertexId> input_to_vertex;  ///< duplicates merged
  std::size_t inner_points = 0;           ///< strictly inside the hull
  std::uint64_t work = 0;
};

/// A triangulation of the points whose triangles are in an order with alternating left and right turns
/// (Arkin, Held, Mitchell and Skiena, section 4). With at most two points inside the hull the answer is
/// exact, in O(n log n), and yes in general position (lemma 4.2). With more, up to 32 points, it is
/// searched for: kNo is proved by exhaustion (practical for about 12 points), kUnknown if the work runs
/// out. More points: kUnknown. Throws Error kNotFinite, kTooFewPoints, kAllCollinear, kTooManyPoints,
/// kCancelled.
SequentialResult sequential_triangulation(std::span<const Point> input,
                                          const SequentialOptions& options = {});

struct SpiralPolygonStatistics {
  std::size_t iterations = 0;  ///< turns of the algorithm's loop, at most 2 n
};

struct SpiralPolygon {
  /// Every vertex once, counter-clockwise from the lowest point (of those the one farthest right).
  std::vector<VertexId> ring;
  /// Of the polygon: n - 2 triangles in the order of a path, each beside the one before.
  Triangulation mesh;
  std::vector<VertexId> input_to_vertex;  ///< duplicates merged
  SpiralPolygonStatistics statistics;
};

/// A simple polygon with all the points as corners whose reflex corners are one chain at most, with a
/// serpentine triangulation (Iwerks and Mitchell, theorem 2.5). Of points that the turning ray meets at
/// once the nearest is taken; collinear ones become flat corners. Throws Error kNotFinite,
/// kTooFewPoints, kAllCollinear, kTooManyPoints, kCancelled. O(n log n).
SpiralPolygon spiral_polygon(std::span<const Point> input, const Progress& progress = {});

// ---- Polygons. ----

/// The triangles of a polygon in an order. `input_to_vertex` has an entry a corner of the rings, ring by
/// ring (as PlanarInput numbers them), repeated ones merged; added points follow the input's vertices.
struct PolygonOrder {
  Triangulation mesh;  ///< triangle i + 1 shares an edge with triangle i
  OrderKind order = OrderKind::kPath;
  std::vector<VertexId> input_to_vertex;
  std::size_t input_vertices = 0;     ///< the others are added points
  std::vector<SteinerPoint> steiner;  ///< all inside
  std::size_t parts = 0;           ///< with added points: convex parts that it was made from, see
  std::size_t parts_at_least = 0;  ///< ConvexDecomposition
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

struct DecompositionOptions {
  std::size_t exact_steps =
      20'000'000;  // how much the search for the fewest may look at: some seconds;
                   // 0: none
};

/// A polygon cut along chords into convex parts, flat corners allowed.
struct ConvexDecomposition {
  PolygonMesh parts;  ///< over the polygon's vertices
  std::vector<VertexId> input_to_vertex;
  std::size_t at_least = 1;  ///< proven: no cut along chords has fewer parts

  /// Whether no cut along chords has fewer parts.
  bool is_fewest() const { return parts.face_count() == at_least; }
};

/// Cuts a polygon into convex parts without added points. Hertel and Mehlhorn's merging of triangles gives
/// at most four times as many as there must be; with holes no such bound is known, and at_least says
/// what is. If these may not be the fewest, there are no holes and the search is within
/// DecompositionOptions::exact_steps: the fewest (Keil's dynamic programme). Cost: merging O(n log n); the search O(r n^2 log n) at worst for r reflex
/// corners, near O(n log n) where corners see few others. Throws as constrained_delaunay.
ConvexDecomposition convex_decomposition(const Polygon& polygon,
                                         const DecompositionOptions& options = {});

/// A triangulation of a polygon, holes allowed, whose triangles are a path or a cycle, with added points
/// inside (Arkin, Held, Mitchell and Skiena, theorem 2.3). From a decomposition into k > 1 convex parts: at
/// most k - 1 points for a cycle, k - 2 for a path, which some polygons need; a point that sees several parts
/// saves some. A convex polygon has a path without points and a cycle with one.
///
/// Flat corners may cost one point more, as they must: a cycle has up to k points if at each common side of
/// two parts one of them goes straight on at one end and the other at the other end, a path up to k - 1 if
/// at each common side one of the two goes straight on at both ends. Throws Error kGuarantee if a point has
/// no place among the doubles, kBadPolygon for an inside in parts, kBadOption for kSequential, and as
/// constrained_delaunay. O(n log n) after convex_decomposition.
PolygonOrder hamiltonian_triangulation_with_points(const Polygon& polygon, OrderKind order,
                                                   const DecompositionOptions& options = {});

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

/// Paths of triangles, each triangle in one: path p is leave[begin[p] .. begin[p + 1]), a halfedge of
/// each of its triangles, the one by which the path leaves it for the next. The last triangle of a
/// path has any of its halfedges but the one by which the path came in.
struct PathPartition {
  std::vector<HalfedgeId> leave;
  std::vector<std::uint32_t> begin = {0};

  std::size_t count() const { return begin.size() - 1; }
  std::span<const HalfedgeId> path(std::size_t p) const {
    return {leave.data() + begin[p], leave.data() + begin[p + 1]};
  }
};

/// Whether each node of the graph is in one path, and paths follow its edges. O(n).
bool is_path_partition(const DualGraph& graph, const PathPartition& partition);

/// The fewest paths that part a forest, such as the dual graph of a triangulated simple polygon
/// (Arkin, Held, Mitchell and Skiena, lemma 5.1). Throws Error kBadMesh if the graph has a cycle.
/// O(n).
PathPartition minimum_path_partition(const DualGraph& forest);

enum class PathGoal {
  kFewestPaths,   ///< for strips whose turns cost nothing
  kFewestIndices  ///< three for each path but the first, one for two turns the same way in a row
};

/// How long to look for something better; figures: docs/algorithms/strips.md.
enum class PathEffort {
  kFast,      ///< strips that alternate, taken one after the other
  kStandard,  ///< and two rounds of improvement: half a microsecond a triangle
  kThorough,  ///< sixteen rounds
};

struct PathOptions {
  PathGoal goal = PathGoal::kFewestPaths;
  PathEffort effort = PathEffort::kStandard;
  std::uint64_t seed = 1;  // which of many equal choices; the same seed gives the same paths
  Progress progress;
};

/// Few paths for any graph (fewest is NP-hard); for a forest and kFewestPaths the fewest. Throws
/// Error kCancelled. O(n) for a given effort.
PathPartition path_partition(const DualGraph& graph, const PathOptions& options = {});

/// How triangles become a sequence of vertices. A vertex makes a triangle with the two before it; the
/// first triangle of a strip turns as it is sent, every other one the other way around. A triangle
/// that has a vertex twice is empty and is not drawn.
enum class StripEncoding {
  kSwap,     ///< a bit with each vertex: the two vertices before it change places (and the turn
             ///< stays); kStripRestart begins a new strip
  kRepeat,   ///< one strip; vertices sent again make empty triangles (GL_TRIANGLE_STRIP)
  kRestart,  ///< the same, and kStripRestart begins a new strip (primitive restart)
};

inline constexpr VertexId kStripRestart = kNone;

struct StripCode {
  StripEncoding encoding = StripEncoding::kRestart;
  std::vector<VertexId> index;
  std::vector<std::uint8_t> swap;  ///< kSwap: per index, != 0 swaps; else empty
};

struct StripOptions {
  StripEncoding encoding = StripEncoding::kRestart;
  PathEffort effort = PathEffort::kStandard;
  std::uint64_t seed = 1;
  Progress progress;
};

/// A code, and how it was made.
struct StripResult {
  StripCode code;
  std::size_t triangles = 0;
  std::size_t strips = 0;    ///< paths of triangles that share edges
  std::size_t swaps = 0;     ///< two turns the same way in a row: an index more (kSwap: a bit)
  std::size_t joined = 0;    ///< strips that begin at a vertex where the strip before ended
  std::size_t restarts = 0;  ///< kStripRestart in the code
};

/// The triangles as strips: decode_strips gives each of them once, the same way around. The paths are
/// path_partition's: for kSwap the fewest, else those of the fewest indices. Unless effort is kFast,
/// meshes of at most 12 triangles get the shortest code of all, those of up to 200 the best of several
/// ways, that of theorem 5.3 among them. The mesh may be any that
/// triangles_with_twins gives. Throws Error kBadMesh (twins that do not agree, a triangle with a
/// corner twice), kCancelled. O(n log n) for a given effort, the logarithm for sorting ends of strips.
StripResult encode_strips(const Triangulation& mesh, const StripOptions& options = {});

/// The code of given paths. Throws Error kBadOption if they are not a partition of the mesh.
StripResult encode_paths(const Triangulation& mesh, const PathPartition& paths,
                         StripEncoding encoding);

/// The triangles that a code draws, three vertices each, in its order. Any sequence is a code. Throws
/// Error kBadOption if `swap` has not the size it should have. O(n).
std::vector<VertexId> decode_strips(const StripCode& code);

/// Whether two lists of triangles are the same but for their order and where each begins; each
/// counts as often as it is there. O(n log n).
bool same_triangles(std::span<const VertexId> a, std::span<const VertexId> b);

/// Triangles as they are, of any kind (surfaces, clockwise ones, edges with many triangles): twins are
/// two triangles that have an edge in opposite directions, if no third one has it in either. Throws
/// Error kBadMesh (a triangle with a corner twice, or a number of corners that is not 3 t),
/// kIndexOutOfRange (culprits: triangle, index), kTooManyPoints. O(n).
Triangulation triangles_with_twins(std::vector<Point> points, std::vector<VertexId> tri_vertex);

}  // namespace quadloom
